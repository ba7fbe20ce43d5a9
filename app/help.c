/* umbra help: usage lines and pages of the commands, from the tables of options and verbs. */
#include <string.h>

#include "app/app.h"

#define WIDTH   80 /* of a line */
#define COLUMN  26 /* where texts beside options begin */
#define PROGRAM "umbra"

/* A text in lines of WIDTH that begin at `indent`; the first is `at` characters long already. */
static void put_wrapped(FILE *file, const char *text, int indent, int at)
{
  while (*text != '\0') {
    int n = (int)strcspn(text, " ");
    if (at > indent && at + 1 + n > WIDTH) {
      fputc('\n', file);
      at = 0;
    }
    if (at < indent)
      at += fprintf(file, "%*s", indent - at, "");
    else if (at > indent)
      at += fprintf(file, " ");
    at += fprintf(file, "%.*s", n, text);
    text += n + (int)strspn(text + n, " ");
  }
  fputc('\n', file);
}

/* "--out DIR", "-o FILE" where the letter is the usual way. */
static void put_option(FILE *file, const struct um_app_option *o)
{
  if (strcmp(o->id, "file") == 0)
    fprintf(file, "-%c", o->letter);
  else
    fprintf(file, "--%s", o->name);
  if (o->argument != NULL) fprintf(file, " %s", o->argument);
}

void um_app_usage(FILE *file, const struct um_app_verb *verb)
{
  const char *needs = verb->needs, *accepts = verb->accepts;
  const struct um_app_option *o;
  fprintf(file, PROGRAM " %s%s%s", verb->name, verb->arguments[0] != '\0' ? " " : "",
          verb->arguments);
  while ((o = um_app_option_next(&needs)) != NULL) {
    fputc(' ', file);
    put_option(file, o);
    if (o->takes == UM_APP_LIST) fputs("...", file);
  }
  while ((o = um_app_option_next(&accepts)) != NULL) {
    fputs(" [", file);
    put_option(file, o);
    fputs(o->takes == UM_APP_LIST ? "]..." : "]", file);
  }
}

/* "  -o, --out DIR        text", the text on a line of its own where the head is long. */
static void help_option(FILE *file, const struct um_app_option *o, bool needed)
{
  char head[96];
  snprintf(head, sizeof head, "  %c%c%s--%s%s%s", o->letter != 0 ? '-' : ' ',
           o->letter != 0 ? o->letter : ' ', o->letter != 0 ? ", " : "  ", o->name,
           o->argument != NULL ? " " : "", o->argument != NULL ? o->argument : "");
  int at = fprintf(file, "%s", head);
  if (at + 2 > COLUMN) {
    fputc('\n', file);
    at = 0;
  }
  char text[640];
  size_t used = (size_t)snprintf(text, sizeof text, "%s%s%s", needed ? "Required. " : "", o->help,
                                 o->takes == UM_APP_LIST ? " May be given again." : "");
  if (o->default_value != NULL)
    snprintf(text + used, sizeof text - used, " Default: %s.", o->default_value);
  put_wrapped(file, text, COLUMN, at);
  if (o->example != NULL) fprintf(file, "%*sExample: %s\n", COLUMN, "", o->example);
}

static void help_options(FILE *file, const char *list, bool needed)
{
  const struct um_app_option *o;
  while ((o = um_app_option_next(&list)) != NULL) help_option(file, o, needed);
}

/* "Options:", on the page of all commands "Options of umbra run:". */
static void heading(FILE *file, const char *what, const struct um_app_verb *verb, bool page)
{
  if (page)
    fprintf(file, "\n%s of " PROGRAM " %s:\n", what, verb->name);
  else
    fprintf(file, "\n%s:\n", what);
}

static void help_arguments(FILE *file, const struct um_app_verb *verb, bool page)
{
  static const char *const meaning[] = {
      [UM_APP_NOTHING] = "a name that is not taken yet",
      [UM_APP_SCENARIOS] = "a folder with scenario.yaml, or such a file",
      [UM_APP_STUDIES] = "a study.yaml; docs/files.md has its keys",
      [UM_APP_TABLES] = "CSV of measurements; docs/files.md lists its columns",
      [UM_APP_FILES] =
          "a file: a table of any header, a track of a survey, a picture of umbra render",
      [UM_APP_EFFECTS] = "name of an effect; without it all are listed",
      [UM_APP_MATERIALS] = "name of a material; without it all are listed",
      [UM_APP_SENSORS] = "name of a sensor; without it all are listed",
      [UM_APP_SECTIONS] = "path of a key or section; without it all of the reference",
      [UM_APP_SHELLS] = "bash or zsh",
      [UM_APP_EXPORTS] = "a kind of export",
      [UM_APP_VERBS] = "a command; without it all are listed"};
  const char *list = verb->arguments;
  char name[32];
  bool optional;
  if (list[0] != '\0') heading(file, "Arguments", verb, page);
  while (um_app_argument_next(&list, name, &optional)) {
    int at = fprintf(file, "  %s  ", name);
    put_wrapped(file, meaning[um_app_argument_offers(name)], COLUMN, at);
  }
}

static void help_examples(FILE *file, const struct um_app_verb *verb, bool page)
{
  heading(file, "Examples", verb, page);
  for (const char *line = verb->examples; *line != '\0';) {
    int n = (int)strcspn(line, "\n");
    fprintf(file, "  %.*s\n", n, line);
    line += n + (line[n] == '\n' ? 1 : 0);
    if (page && *line != '\0') fputc('\n', file); /* else help2man joins them */
  }
}

#define EXIT_LINE(name, number, text) "  " #number "  " text "\n"
#define EXIT_STATUS                   UM_APP_EXITS(EXIT_LINE) "  130, 143  ended by SIGINT (Ctrl-C), SIGTERM\n"

static void page_of(FILE *file, const struct um_app_verb *verb, bool page)
{
  char text[640];
  um_app_usage(file, verb);
  snprintf(text, sizeof text, "%c%s.%s%s", verb->summary[0] - 'a' + 'A', verb->summary + 1,
           verb->about != NULL ? " " : "", verb->about != NULL ? verb->about : "");
  fputs("\n\n", file);
  put_wrapped(file, text, 0, 0);
  help_arguments(file, verb, page);
  if (!page || verb->needs != NULL || verb->accepts != NULL) heading(file, "Options", verb, page);
  help_options(file, verb->needs, true);
  help_options(file, verb->accepts, false);
  if (!page) help_options(file, "threads help", false);
  if (verb->list != NULL) {
    heading(file, verb->listed, verb, page);
    verb->list(file);
  }
  help_examples(file, verb, page);
}

void um_app_help_verb(FILE *file, const struct um_app_verb *verb)
{
  page_of(file, verb, false);
  fputs("\nExit status:\n" EXIT_STATUS, file);
}

void um_app_help_all(FILE *file)
{
  fputs("Usage: " PROGRAM " COMMAND [ARGUMENT]... [OPTION]...\n\n", file);
  put_wrapped(file,
              "Umbra computes what a telescope sees of a satellite, in the visible and at 8-12 um, "
              "from one "
              "physical state; it holds that against measurements and says which physical effect "
              "the model lacks, or that the measurements cannot tell.",
              0, 0);
  fputs("\n*Options of every command*\n\n", file);
  help_options(file, "threads help", false);
  for (size_t i = 0; i < um_app_verb_count(); i++) {
    fprintf(file, "\n*" PROGRAM " %s*\n\n", um_app_verb_at(i)->name);
    page_of(file, um_app_verb_at(i), true);
  }
  fputs("\n*Exit status*\n\n" EXIT_STATUS "\nEnvironment:\n\n"
        "  UMBRA_DATA  folder that holds materials/ and scenarios/, in place of those that were "
        "installed\n\n"
        "  OMP_NUM_THREADS  worker threads where --threads does not say\n",
        file);
}

static void title(FILE *file)
{
  fputs(PROGRAM " " UM_APP_VERSION
                ": light curves of satellites in the visible and the thermal infrared\n\n",
        file);
}

void um_app_help(FILE *file)
{
  title(file);
  for (size_t i = 0; i < um_app_verb_count(); i++) {
    const struct um_app_verb *verb = um_app_verb_at(i);
    int at = fprintf(file, "  " PROGRAM " %s%s%s  ", verb->name,
                     verb->arguments[0] != '\0' ? " " : "", verb->arguments);
    put_wrapped(file, verb->summary, 2 + 6 + 28, at);
  }
  fputs("\n  umbra COMMAND --help   its options, their defaults, examples\n"
        "  umbra --version\n"
        "\nScenarios come with the program; umbra check NAME says where one lies.\n",
        file);
}

int um_app_help_command(struct um_context *context, const struct um_app_options *options)
{
  const char *name = options->npositional > 0 ? options->positional[0] : "";
  const struct um_app_verb *verb = um_app_verb_find(name);
  char unknown[UM_APP_UNKNOWN];
  (void)context;
  if (verb != NULL) {
    um_app_help_verb(stdout, verb);
  } else if (name[0] == '\0') {
    um_app_help(stdout);
  } else if (strcmp(name, "all") == 0) {
    um_app_help_all(stdout);
  } else {
    um_app_verb_unknown(name, unknown);
    fprintf(stderr, "umbra: %s\n", unknown);
    return UM_APP_MISUSE;
  }
  return UM_APP_DONE;
}
