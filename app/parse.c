/* The options of the command line, parsed once for all verbs. */
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "app/app.h"
#include "core/csv.h"

int um_app_misuse(const struct um_app_verb *verb, const char *format, const char *what)
{
  fputs("umbra: ", stderr);
  fprintf(stderr, format, what); /* NOLINT: formats are literals of this file */
  fputc('\n', stderr);
  if (verb != NULL)
    fprintf(stderr, "usage: %s\n", verb->usage);
  else
    fputs("umbra --help lists the commands\n", stderr);
  return UM_APP_MISUSE;
}

enum option_id {
  OUT = 256,
  SET,
  WITH,
  WITHOUT,
  EFFECT_FILE,
  TIME,
  BAND,
  WIDTH,
  SAMPLES,
  NOISE,
  SEED,
  TEMPERATURES,
  TEMPERATURE_SIGMA,
  ONLY,
  EXCLUDE,
  NUISANCE,
  ADD,
  LEVEL,
  STEPS,
  FORCE,
  JSON,
  THERMAL,
  OPTICS,
  NO_PLOTS,
  THREADS,
  HELP
};
static const struct option long_options[] = {
    {"out", required_argument, NULL, OUT},
    {"set", required_argument, NULL, SET},
    {"with", required_argument, NULL, WITH},
    {"without", required_argument, NULL, WITHOUT},
    {"effect-file", required_argument, NULL, EFFECT_FILE},
    {"time", required_argument, NULL, TIME},
    {"band", required_argument, NULL, BAND},
    {"width", required_argument, NULL, WIDTH},
    {"samples", required_argument, NULL, SAMPLES},
    {"noise", required_argument, NULL, NOISE},
    {"seed", required_argument, NULL, SEED},
    {"temperatures", required_argument, NULL, TEMPERATURES},
    {"temperature-sigma", required_argument, NULL, TEMPERATURE_SIGMA},
    {"only", required_argument, NULL, ONLY},
    {"exclude", required_argument, NULL, EXCLUDE},
    {"nuisance", required_argument, NULL, NUISANCE},
    {"add", required_argument, NULL, ADD},
    {"level", required_argument, NULL, LEVEL},
    {"steps", required_argument, NULL, STEPS},
    {"force", no_argument, NULL, FORCE},
    {"json", no_argument, NULL, JSON},
    {"thermal", no_argument, NULL, THERMAL},
    {"optics", no_argument, NULL, OPTICS},
    {"no-plots", no_argument, NULL, NO_PLOTS},
    {"threads", required_argument, NULL, THREADS},
    {"help", no_argument, NULL, HELP},
    {NULL, 0, NULL, 0}};

static bool accepted(const struct um_app_verb *verb, const char *name)
{
  size_t n = strlen(name);
  for (const char *at = verb->accepts; (at = strstr(at, name)) != NULL; at += n)
    if ((at == verb->accepts || at[-1] == ' ') && (at[n] == ' ' || at[n] == '\0')) return true;
  return strcmp(name, "threads") == 0 || strcmp(name, "help") == 0;
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
static bool take(struct um_context *context, struct um_app_options *o, int id, const char *value)
{
  int threads = 0;
  switch (id) {
  case OUT:
    o->out = value;
    return true;
  case SET:
    o->set[o->nset++] = value;
    return strchr(value, '=') != NULL;
  case WITH:
    o->with[o->nwith++] = value;
    return true;
  case WITHOUT:
    o->without[o->nwithout++] = value;
    return true;
  case EFFECT_FILE:
    o->effect_file[o->neffect_file++] = value;
    return true;
  case TIME:
    o->time_utc = value;
    return true;
  case BAND:
    o->band = value;
    return true;
  case WIDTH:
    return positive_integer(value, 8192, &o->width);
  case SAMPLES:
    return positive_integer(value, 65536, &o->samples);
  case NOISE:
    o->noise = value;
    return true;
  case SEED:
    o->seed = value;
    return true;
  case TEMPERATURES:
    o->temperatures = value;
    return true;
  case TEMPERATURE_SIGMA:
    o->temperature_sigma = value;
    return true;
  case ONLY:
    o->only[o->nonly++] = value;
    return true;
  case EXCLUDE:
    o->exclude[o->nexclude++] = value;
    return true;
  case NUISANCE:
    o->nuisance[o->nnuisance++] = value;
    return true;
  case ADD:
    o->add[o->nadd++] = value;
    return true;
  case LEVEL:
    return um_core_number_parse(value, &o->level) && o->level > 0.0 && o->level < 1.0;
  case STEPS:
    return positive_integer(value, 20, &o->steps);
  case FORCE:
    o->force = true;
    return true;
  case JSON:
    o->json = true;
    return true;
  case THERMAL:
    o->thermal = true;
    return true;
  case OPTICS:
    o->optics = true;
    return true;
  case NO_PLOTS:
    o->no_plots = true;
    return true;
  case THREADS:
    if (!positive_integer(value, 4096, &threads)) return false;
    um_core_context_set_threads(context, threads);
    return true;
  default:
    return true;
  }
}

/* The next option, -1 for a positional argument at optind; behind "--" there are only those. */
static int next_option(int argc, char **argv, bool *literal, int *index)
{
  if (!*literal && optind < argc && strcmp(argv[optind], "--") == 0) {
    *literal = true;
    optind++;
  }
  return *literal ? -1 : getopt_long(argc, argv, "+o:h", long_options, index);
}

/* The positional argument of that number, as the usage line calls it: behind "umbra verb ". */
static int missing(const struct um_app_verb *verb, int number)
{
  char name[64];
  const char *at = verb->usage + strlen("umbra ") + strlen(verb->name) + 1;
  for (int i = 0; i < number; i++) at += strcspn(at, " ") + 1;
  snprintf(name, sizeof name, "%.*s", (int)strcspn(at, " "), at);
  return um_app_misuse(verb, "%s is missing", name);
}

int um_app_options_parse(struct um_context *context, const struct um_app_verb *verb, int argc,
                         char **argv, struct um_app_options *o)
{
  int id, index = 0;
  bool literal = false;
  opterr = 0;
  optind = 2;
  while ((id = next_option(argc, argv, &literal, &index)) != -1 || optind < argc) {
    if (id == -1) { /* options may follow it */
      if (o->npositional == verb->npositional_max)
        return um_app_misuse(verb, "too many arguments: '%s'", argv[optind]);
      o->positional[o->npositional++] = argv[optind++];
      continue;
    }
    if (id == '?')
      return um_app_misuse(verb, "unknown option or missing value: '%s'", argv[optind - 1]);
    const char *name = id == 'o' ? "out" : id == 'h' ? "help" : long_options[index].name;
    if (id == 'h' || id == HELP) {
      printf("%s\n  %s\n", verb->usage, verb->summary);
      return -1;
    }
    if (!accepted(verb, name)) return um_app_misuse(verb, "this command does not take --%s", name);
    if (!take(context, o, id == 'o' ? OUT : id, optarg))
      return um_app_misuse(verb, "value of an option not understood: '%s'", optarg);
  }
  if (o->npositional < verb->npositional_min) return missing(verb, o->npositional);
  return UM_APP_DONE;
}

bool um_app_options_allocate(struct um_app_options *options, int argc)
{
  const char ***const list[] = {&options->set,         &options->with, &options->without,
                                &options->effect_file, &options->only, &options->exclude,
                                &options->nuisance,    &options->add};
  size_t n = sizeof list / sizeof list[0];
  const char **text = calloc((size_t)argc * n, sizeof *text);
  for (size_t i = 0; text != NULL && i < n; i++) *list[i] = text + i * (size_t)argc;
  return text != NULL;
}

void um_app_options_release(struct um_app_options *options) { free((void *)options->set); }
