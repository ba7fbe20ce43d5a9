/* umbra help: usage lines and pages of the commands, from the tables of options and verbs. "umbra
 * help man" and "umbra help man-VERB" print man pages, for tools/write-manual. */
#include <string.h>

#include "app/app.h"
#include "app/help.h"

#define WIDTH       80 /* of a line */
#define COLUMN      26 /* where texts beside options begin */
#define PATH_COLUMN 38 /* .. beside commands of the usual way */
#define VERB_COLUMN 21 /* .. beside verbs */
#define PROGRAM     "umbra"

/* A text in lines of WIDTH that begin at `indent`; the first is `at` characters long already. Line
 * ends of the text stay. */
static void put_wrapped(FILE *file, const char *text, int indent, int at)
{
  while (*text != '\0') {
    int n = (int)strcspn(text, " \n");
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
    if (*text != '\n') continue;
    fputc('\n', file);
    at = 0;
    text++;
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

void um_app_option_text(const struct um_app_option *option, bool needed, char out[UM_APP_HELP_TEXT])
{
  size_t used =
      (size_t)snprintf(out, UM_APP_HELP_TEXT, "%s%s%s", needed ? "Required. " : "", option->help,
                       option->takes == UM_APP_LIST ? " May be given again." : "");
  if (option->default_value != NULL)
    snprintf(out + used, UM_APP_HELP_TEXT - used, " Default: %s.", option->default_value);
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
  char text[UM_APP_HELP_TEXT];
  um_app_option_text(o, needed, text);
  put_wrapped(file, text, COLUMN, at);
  if (o->example != NULL) fprintf(file, "%*sExample: %s\n", COLUMN, "", o->example);
}

static void help_options(FILE *file, const char *list, bool needed)
{
  const struct um_app_option *o;
  while ((o = um_app_option_next(&list)) != NULL) help_option(file, o, needed);
}

/* "materials: surfaces that parts are made of" and so on, a line each. */
static void things_text(char out[UM_APP_HELP_TEXT])
{
  const struct um_app_thing *thing;
  size_t used = 0;
  for (size_t i = 0; (thing = um_app_thing_at(i)) != NULL && used < UM_APP_HELP_TEXT; i++)
    used += (size_t)snprintf(out + used, UM_APP_HELP_TEXT - used, "%s%s: %s", i > 0 ? "\n" : "",
                             thing->word, thing->holds);
}

void um_app_argument_text(const char *name, char out[UM_APP_HELP_TEXT])
{
  static const char *const meaning[] = {
      [UM_APP_NOTHING] = "a name that is not taken yet",
      [UM_APP_SCENARIOS] = "a folder with scenario.yaml, or such a file",
      [UM_APP_VIEWS] = "a folder with scenario.yaml, such a file, or a picture in .nc",
      [UM_APP_STUDIES] = "a study.yaml; docs/files.md has its keys",
      [UM_APP_TABLES] = "CSV of measurements; docs/files.md lists its columns",
      [UM_APP_RESULTS] = "a folder of results with report.html, or such a file; up to 8",
      [UM_APP_REPLAYS] = "a folder of results with replay.json, or such a file",
      [UM_APP_FILES] = "a file: a table of any header, a track of a survey, frames in FITS",
      [UM_APP_EFFECTS] = "name of an effect; without it all are listed",
      [UM_APP_MATERIALS] = "name of a material; without it all are listed",
      [UM_APP_SENSORS] = "name of a sensor; without it all are listed",
      [UM_APP_SECTIONS] = "path of a key or section; without it all of the reference",
      [UM_APP_SHELLS] = "bash or zsh",
      [UM_APP_THINGS] = NULL, /* what the table has */
      [UM_APP_ONE] = "name of one, or the path of a key; without it all are listed",
      [UM_APP_EXPORTS] = "a kind of export",
      [UM_APP_VERBS] = "a command; without it all are listed"};
  enum um_app_offers offers = um_app_argument_offers(name);
  if (offers == UM_APP_THINGS)
    things_text(out);
  else
    snprintf(out, UM_APP_HELP_TEXT, "%s", meaning[offers]);
}

static void help_arguments(FILE *file, const struct um_app_verb *verb)
{
  const char *list = verb->arguments;
  char name[32], text[UM_APP_HELP_TEXT];
  bool optional;
  if (list[0] != '\0') fputs("\nArguments:\n", file);
  while (um_app_argument_next(&list, name, &optional)) {
    um_app_argument_text(name, text);
    put_wrapped(file, text, COLUMN, fprintf(file, "  %s  ", name));
  }
}

static void help_examples(FILE *file, const struct um_app_verb *verb)
{
  fputs("\nExamples:\n", file);
  for (const char *line = verb->examples; *line != '\0';) {
    int n = (int)strcspn(line, "\n");
    fprintf(file, "  %.*s\n", n, line);
    line += n + (line[n] == '\n' ? 1 : 0);
  }
}

#define EXIT_LINE(name, number, text) "  " #number "  " text "\n"
#define EXIT_STATUS                                                                                \
  UM_APP_EXITS(EXIT_LINE) "  " UM_APP_HELP_SIGNALS_NUMBERS "  " UM_APP_HELP_SIGNALS "\n"

void um_app_verb_text(const struct um_app_verb *verb, char out[UM_APP_HELP_TEXT])
{
  snprintf(out, UM_APP_HELP_TEXT, "%c%s.%s%s", verb->summary[0] - 'a' + 'A', verb->summary + 1,
           verb->about != NULL ? " " : "", verb->about != NULL ? verb->about : "");
}

void um_app_help_verb(FILE *file, const struct um_app_verb *verb)
{
  char text[UM_APP_HELP_TEXT];
  um_app_usage(file, verb);
  fputs("\n\n", file);
  um_app_verb_text(verb, text);
  put_wrapped(file, text, 0, 0);
  help_arguments(file, verb);
  fputs("\nOptions:\n", file);
  help_options(file, verb->needs, true);
  help_options(file, verb->accepts, false);
  help_options(file, um_app_verb_common(verb), false);
  if (verb->list != NULL) {
    fprintf(file, "\n%s:\n", verb->listed);
    verb->list(file);
  }
  help_examples(file, verb);
  fputs("\nExit status:\n" EXIT_STATUS, file);
}

static void title(FILE *file)
{
  fputs(PROGRAM " " UM_APP_VERSION
                ": light curves of satellites in the visible and the thermal infrared\n\n",
        file);
}

/* From nothing to a result that is held against measurements: what a newcomer types. */
static const struct {
  const char *command, *does;
} path[] = {
    {"umbra new NAME", "a scenario to begin with"},
    {"umbra check NAME --view", "the satellite, before anything is solved"},
    {"umbra run NAME", "light curves, temperatures, a page"},
    {"umbra compare SCENARIO MEASURED", "how far measurements are off"},
    {"umbra diagnose SCENARIO MEASURED", "which effect is missing"},
};

bool um_app_path_at(size_t index, const char **command, const char **does)
{
  if (index >= sizeof path / sizeof path[0]) return false;
  *command = path[index].command;
  *does = path[index].does;
  return true;
}

static void help_path(FILE *file)
{
  fputs("The usual way:\n", file);
  for (size_t i = 0; i < sizeof path / sizeof path[0]; i++)
    put_wrapped(file, path[i].does, PATH_COLUMN, fprintf(file, "  %s  ", path[i].command));
}

const char *um_app_group_name(enum um_app_group group)
{
  static const char *const name[UM_APP_GROUPS] = {[UM_APP_SIMULATE] = "Simulate",
                                                  [UM_APP_OBSERVE] = "Observe",
                                                  [UM_APP_COMPARE] = "Compare",
                                                  [UM_APP_EXPLORE] = "Explore",
                                                  [UM_APP_LOOK_UP] = "Look up"};
  return name[group];
}

void um_app_help(FILE *file)
{
  title(file);
  help_path(file);
  for (int group = 0; group < UM_APP_GROUPS; group++) {
    fprintf(file, "\n%s:\n", um_app_group_name((enum um_app_group)group));
    for (size_t i = 0; i < um_app_verb_count(); i++) {
      const struct um_app_verb *verb = um_app_verb_at(i);
      if (verb->group != (enum um_app_group)group) continue;
      int at = fprintf(file, "  " PROGRAM " %s  ", verb->name);
      put_wrapped(file, verb->summary, VERB_COLUMN, at);
    }
  }
  fputs("\n  umbra COMMAND --help   its arguments, options, examples\n"
        "  umbra list scenarios   scenarios that come with the program\n"
        "  umbra --version\n",
        file);
}

int um_app_help_command(struct um_context *context, const struct um_app_options *options)
{
  const char *name = options->npositional > 0 ? options->positional[0] : "";
  const struct um_app_old_name *old = um_app_old_name_find(name, 0, NULL);
  const struct um_app_verb *verb = um_app_verb_find(old != NULL ? old->verb : name);
  char unknown[UM_APP_UNKNOWN];
  (void)context;
  if (options->json && (verb != NULL || name[0] == '\0')) {
    if (!um_app_help_json(stdout, verb)) {
      fputs("umbra: out of memory\n", stderr);
      return UM_APP_FAILED;
    }
  } else if (verb != NULL) {
    um_app_help_verb(stdout, verb);
  } else if (name[0] == '\0') {
    um_app_help(stdout);
  } else if (strcmp(name, "man") == 0) {
    um_app_manual(stdout);
  } else if (strncmp(name, "man-", 4) == 0 && um_app_verb_find(name + 4) != NULL) {
    um_app_manual_verb(stdout, um_app_verb_find(name + 4));
  } else {
    um_app_verb_unknown(name, unknown);
    fprintf(stderr, "umbra: %s\n", unknown);
    return UM_APP_MISUSE;
  }
  return UM_APP_DONE;
}
