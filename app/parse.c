/* The command line of a verb, parsed by getopt_long from the table of options. */
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "app/app.h"
#include "base/core/csv.h"
#include "base/core/suggestions.h"
#include "base/core/text.h"

#define OPTIONS_MAX 32 /* of one verb */
#define FIRST_ID    256

int um_app_misuse(const struct um_app_verb *verb, const char *format, const char *what)
{
  char line[1024];
  snprintf(line, sizeof line, format, what); /* NOLINT: formats are literals */
  fputs("umbra: ", stderr);
  um_core_text_put(stderr, line);
  fputc('\n', stderr);
  if (verb != NULL) {
    fputs("usage: ", stderr);
    um_app_usage(stderr, verb);
    fputc('\n', stderr);
  } else {
    fputs("umbra --help lists the commands\n", stderr);
  }
  return UM_APP_MISUSE;
}

/* What getopt_long wants to know of a verb. */
struct grammar {
  const struct um_app_option *option[OPTIONS_MAX];
  struct option names[OPTIONS_MAX + 1]; /* val: FIRST_ID + index */
  char letters[2 * OPTIONS_MAX + 3];
  size_t count;
};

static void grammar_add(struct grammar *g, const char *list)
{
  const struct um_app_option *o;
  while (g->count < OPTIONS_MAX && (o = um_app_option_next(&list)) != NULL) {
    bool bare = o->argument == NULL;
    g->names[g->count] = (struct option){o->name, bare ? no_argument : required_argument, NULL,
                                         FIRST_ID + (int)g->count};
    g->option[g->count++] = o;
    size_t n = strlen(g->letters);
    if (o->letter != 0)
      snprintf(g->letters + n, sizeof g->letters - n, "%c%s", o->letter, bare ? "" : ":");
  }
}

/* "+": stop at what is no option; ":": a missing value is told from an unknown option. */
static void grammar_make(struct grammar *g, const struct um_app_verb *verb)
{
  *g = (struct grammar){.letters = "+:"};
  grammar_add(g, verb->needs);
  grammar_add(g, verb->accepts);
  grammar_add(g, um_app_verb_common(verb));
}

static const struct um_app_option *grammar_find(const struct grammar *g, int id)
{
  for (size_t i = 0; i < g->count; i++)
    if (id == FIRST_ID + (int)i || (id != 0 && id == g->option[i]->letter)) return g->option[i];
  return NULL;
}

static bool positive_integer(const char *text, int limit, int *out)
{
  double value;
  if (!um_core_number_parse(text, &value) || !(value >= 1.0 && value <= limit) ||
      value != (double)(int)value)
    return false;
  *out = (int)value;
  return true;
}

/* One option into the struct; false when its value is refused. */
static bool take(struct um_context *context, struct um_app_options *options,
                 const struct um_app_option *o, const char *value)
{
  void *at = (char *)options + o->at;
  size_t *count = (size_t *)(void *)((char *)options + o->count);
  int threads = 0;
  switch (o->takes) {
  case UM_APP_FLAG:
    *(bool *)at = true;
    return true;
  case UM_APP_TEXT:
    *(const char **)at = value;
    return true;
  case UM_APP_LIST:
    (*(const char ***)at)[(*count)++] = value;
    return strcmp(o->id, "set") != 0 || strchr(value, '=') != NULL;
  case UM_APP_NUMBER:
    return positive_integer(value, o->most, at);
  case UM_APP_SHARE:
    return um_core_number_parse(value, at) && *(double *)at > 0.0 && *(double *)at < 1.0;
  case UM_APP_THREADS:
    if (!positive_integer(value, o->most, &threads)) return false;
    um_core_context_set_threads(context, threads);
    return true;
  case UM_APP_HELP:
    break;
  }
  return true;
}

/* An option that getopt_long did not take: of another verb, without its value, with one it does not
 * take, or unknown. */
static int refuse_option(const struct um_app_verb *verb, const struct grammar *g, int id,
                         const char *typed)
{
  char what[200], name[64];
  const struct um_app_option *known = grammar_find(g, optopt);
  if (id == ':') return um_app_misuse(verb, "'%s' wants a value", typed);
  if (known != NULL && known->argument == NULL)
    return um_app_misuse(verb, "'%s': this option takes no value", typed);
  if (strncmp(typed, "--", 2) != 0) return um_app_misuse(verb, "unknown option '%s'", typed);
  snprintf(name, sizeof name, "%.*s", (int)strcspn(typed + 2, "="), typed + 2);
  if (um_app_option_find(name) != NULL)
    return um_app_misuse(verb, "this command does not take --%s", name);
  struct um_core_words_guess guess = {.written = name};
  for (size_t i = 0; i < g->count; i++) um_core_words_consider(&guess, g->option[i]->name);
  bool near = guess.nearest != NULL;
  snprintf(what, sizeof what, "'--%s'%s%s%s", name, near ? "; did you mean '--" : "",
           near ? guess.nearest : "", near ? "'?" : "");
  return um_app_misuse(verb, "unknown or ambiguous option %s", what);
}

/* The next option, -1 for a positional argument at optind; behind "--" there are only those. */
static int next_option(int argc, char **argv, const struct grammar *g, bool *literal)
{
  if (!*literal && optind < argc && strcmp(argv[optind], "--") == 0) {
    *literal = true;
    optind++;
  }
  return *literal ? -1 : getopt_long(argc, argv, g->letters, g->names, NULL);
}

/* How many positional arguments the verb takes and wants; the first that is missing. */
static int check_arguments(const struct um_app_verb *verb, const struct um_app_options *o)
{
  const char *list = verb->arguments;
  char name[32];
  bool optional;
  for (int i = 0; um_app_argument_next(&list, name, &optional); i++)
    if (i == o->npositional && !optional) return um_app_misuse(verb, "%s is missing", name);
  return UM_APP_DONE;
}

bool um_app_option_given(const struct um_app_option *option, const struct um_app_options *options)
{
  const char *base = (const char *)options;
  const void *at = base + option->at, *count = base + option->count;
  switch (option->takes) {
  case UM_APP_FLAG:
    return *(const bool *)at;
  case UM_APP_TEXT:
    return *(const char *const *)at != NULL;
  case UM_APP_LIST:
    return *(const size_t *)count > 0;
  case UM_APP_NUMBER:
    return *(const int *)at != 0;
  case UM_APP_SHARE:
    return *(const double *)at > 0.0;
  case UM_APP_THREADS:
  case UM_APP_HELP:
    break;
  }
  return false;
}

int um_app_options_refuse(const struct um_app_options *options, const char *list, const char *why)
{
  const struct um_app_option *o;
  while ((o = um_app_option_next(&list)) != NULL) {
    if (!um_app_option_given(o, options)) continue;
    fprintf(stderr, "umbra: --%s %s\n", o->name, why);
    return UM_APP_MISUSE;
  }
  return UM_APP_DONE;
}

/* All options of a list that are missing, as "--time UTC, -o FILE"; false: none is. */
static bool lacks(const struct um_app_options *o, const char *list, char out[200])
{
  const struct um_app_option *option;
  out[0] = '\0';
  while ((option = um_app_option_next(&list)) != NULL) {
    size_t n = strlen(out);
    const char *comma = n > 0 ? ", " : "";
    if (um_app_option_given(option, o)) continue;
    if (option->letter != '\0')
      snprintf(out + n, 200 - n, "%s-%c %s", comma, option->letter, option->argument);
    else
      snprintf(out + n, 200 - n, "%s--%s %s", comma, option->name, option->argument);
  }
  return out[0] != '\0';
}

int um_app_options_require(const struct um_app_options *options, const char *list)
{
  char missing[200];
  if (!lacks(options, list, missing)) return UM_APP_DONE;
  fprintf(stderr, "umbra: %s is missing\n", missing);
  return UM_APP_MISUSE;
}

/* Options without which the verb cannot work. */
static int check_needed(const struct um_app_verb *verb, const struct um_app_options *o)
{
  char missing[200];
  return lacks(o, verb->needs, missing) ? um_app_misuse(verb, "%s is missing", missing)
                                        : UM_APP_DONE;
}

static int arguments_most(const struct um_app_verb *verb)
{
  const char *list = verb->arguments;
  char name[32];
  bool optional;
  int n = 0;
  while (um_app_argument_next(&list, name, &optional)) n++;
  return n;
}

int um_app_options_parse(struct um_context *context, const struct um_app_verb *verb, int argc,
                         char **argv, struct um_app_options *o)
{
  struct grammar g;
  int id, most = arguments_most(verb);
  bool literal = false;
  grammar_make(&g, verb);
  opterr = 0;
  optind = 2;
  for (;;) {
    const char *typed = optind < argc ? argv[optind] : "";
    int first = optind;
    bool before = !literal;
    id = next_option(argc, argv, &g, &literal);
    if (before && literal) o->literal = first;
    if (id == -1 && optind >= argc) break;
    if (id == -1) { /* options may follow it */
      if (o->npositional == most && um_app_verb_takes_more(verb)) {
        o->more[o->nmore++] = argv[optind++];
        continue;
      }
      if (o->npositional == most)
        return um_app_misuse(verb, "too many arguments: '%s'", argv[optind]);
      o->positional[o->npositional++] = argv[optind++];
      continue;
    }
    const struct um_app_option *option = grammar_find(&g, id);
    if (option == NULL) return refuse_option(verb, &g, id, typed);
    for (int i = first; i < optind; i++) o->token[i] = option;
    if (option->takes == UM_APP_HELP) {
      um_app_help_verb(stdout, verb);
      return -1;
    }
    if (!take(context, o, option, optarg))
      return um_app_misuse(verb, "value of an option not understood: '%s'", optarg);
  }
  int code = check_arguments(verb, o);
  return code == UM_APP_DONE ? check_needed(verb, o) : code;
}

bool um_app_options_allocate(struct um_app_options *options, int argc)
{
  const char ***const list[] = {&options->set,         &options->with,     &options->without,
                                &options->effect_file, &options->picture,  &options->only,
                                &options->exclude,     &options->nuisance, &options->add,
                                &options->star,        &options->station,  &options->what_if,
                                &options->uncertain,   &options->more};
  size_t n = sizeof list / sizeof list[0];
  const char **text = calloc((size_t)argc * n, sizeof *text);
  for (size_t i = 0; text != NULL && i < n; i++) *list[i] = text + i * (size_t)argc;
  options->token = calloc((size_t)argc, sizeof *options->token);
  return text != NULL && options->token != NULL;
}

void um_app_options_release(struct um_app_options *options)
{
  free((void *)options->set);
  free((void *)options->token);
}
