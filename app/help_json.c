/* umbra help --json: the commands, or one with its options and the schema of what it prints. */
#include <stdlib.h>
#include <string.h>

#include "app/answers.h"
#include "app/app.h"
#include "app/help.h"

static void put_commands(FILE *file)
{
  um_core_json_text(file, "{", "version", UM_APP_VERSION);
  fputs(",\n  \"commands\": [", file);
  for (size_t i = 0; i < um_app_verb_count(); i++) {
    const struct um_app_verb *verb = um_app_verb_at(i);
    um_core_json_text(file, i > 0 ? ",\n    {" : "\n    {", "name", verb->name);
    um_core_json_text(file, ", ", "group", um_app_group_name(verb->group));
    um_core_json_text(file, ", ", "summary", verb->summary);
    fputc('}', file);
  }
  fputs("]}\n", file);
}

static void put_arguments(FILE *file, const struct um_app_verb *verb)
{
  const char *list = verb->arguments, *between = "\n    {";
  char name[32], text[UM_APP_HELP_TEXT];
  bool optional;
  fputs(",\n  \"arguments\": [", file);
  for (; um_app_argument_next(&list, name, &optional); between = ",\n    {") {
    um_app_argument_text(name, text);
    um_core_json_text(file, between, "name", name);
    um_core_json_text(file, ", ", "text", text);
    um_core_json_bool(file, ", ", "optional", optional);
    fputc('}', file);
  }
  fputc(']', file);
}

/* *between: what stands before the next. */
static void put_options(FILE *file, const char *list, bool needed, const char **between)
{
  const struct um_app_option *o;
  for (; (o = um_app_option_next(&list)) != NULL; *between = ",\n    {") {
    const char letter[2] = {o->letter, '\0'};
    um_core_json_text(file, *between, "name", o->name);
    um_core_json_text(file, ", ", "letter", o->letter != 0 ? letter : NULL);
    um_core_json_text(file, ", ", "argument", o->argument);
    um_core_json_bool(file, ", ", "required", needed);
    um_core_json_bool(file, ", ", "repeated", o->takes == UM_APP_LIST);
    um_core_json_text(file, ", ", "default", o->default_value);
    um_core_json_text(file, ", ", "example", o->example);
    um_core_json_text(file, ", ", "text", o->help);
    fputc('}', file);
  }
}

static void put_examples(FILE *file, const struct um_app_verb *verb)
{
  char line[1024];
  const char *between = "";
  fputs("],\n  \"examples\": [", file);
  for (const char *at = verb->examples; *at != '\0'; between = ", ") {
    int n = (int)strcspn(at, "\n");
    snprintf(line, sizeof line, "%.*s", n, at);
    fputs(between, file);
    um_core_json_string(file, line);
    at += n + (at[n] == '\n' ? 1 : 0);
  }
  fputc(']', file);
}

/* false: no memory. */
static bool put_usage(FILE *file, const struct um_app_verb *verb)
{
  char *usage = NULL;
  size_t n;
  FILE *line = open_memstream(&usage, &n);
  if (line == NULL) return false;
  um_app_usage(line, verb);
  bool whole = fclose(line) == 0;
  if (whole) um_core_json_text(file, ",\n  ", "usage", usage);
  free(usage);
  return whole;
}

bool um_app_help_json(FILE *file, const struct um_app_verb *verb)
{
  char text[UM_APP_HELP_TEXT];
  const char *between = "\n    {";
  if (verb == NULL) {
    put_commands(file);
    return true;
  }
  um_app_verb_text(verb, text);
  um_core_json_text(file, "{", "name", verb->name);
  um_core_json_text(file, ", ", "group", um_app_group_name(verb->group));
  um_core_json_text(file, ",\n  ", "text", text);
  if (!put_usage(file, verb)) return false;
  put_arguments(file, verb);
  fputs(",\n  \"options\": [", file);
  put_options(file, verb->needs, true, &between);
  put_options(file, verb->accepts, false, &between);
  put_options(file, um_app_verb_common(verb), false, &between);
  put_examples(file, verb);
  fputs(",\n  \"answer\": ", file);
  um_app_answer_schema(file, verb->name);
  fputs("}\n", file);
  return true;
}
