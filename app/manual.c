/* Man pages: umbra.1, short, and a page of each verb, from the tables that the help is made of. */
#include <stdlib.h>
#include <string.h>

#include "app/help.h"

/* A text as roff prints it; its line ends stay. begins: at the beginning of a line, where a dot or
 * an apostrophe would be a command. */
static void put(FILE *file, const char *text, bool begins)
{
  for (; *text != '\0'; text++) {
    if (begins && (*text == '.' || *text == '\'')) fputs("\\&", file);
    begins = *text == '\n';
    if (begins)
      fputs("\n.br\n", file);
    else if (*text == '\\')
      fputs("\\e", file);
    else if (*text == '-')
      fputs("\\-", file);
    else
      fputc(*text, file);
  }
}

static void line(FILE *file, const char *text)
{
  put(file, text, true);
  fputc('\n', file);
}

/* In bold ('B') or as something to be replaced ('I'). */
static void put_font(FILE *file, char font, const char *text)
{
  fprintf(file, "\\f%c", font);
  put(file, text, false);
  fputs("\\fR", file);
}

static void begin(FILE *file, const char *name, const char *summary)
{
  fputs(".TH \"", file);
  for (const char *c = name; *c != '\0'; c++)
    if (*c == '-')
      fputs("\\-", file);
    else
      fputc(*c >= 'a' && *c <= 'z' ? *c - 'a' + 'A' : *c, file);
  fputs("\" \"1\" \"\" \"umbra " UM_APP_VERSION "\" \"User Commands\"\n.SH NAME\n", file);
  put(file, name, true);
  fputs(" \\- ", file);
  line(file, summary);
}

static void option(FILE *file, const struct um_app_option *o, bool needed)
{
  char text[UM_APP_HELP_TEXT], name[64];
  fputs(".TP\n", file);
  if (o->letter != 0) {
    snprintf(name, sizeof name, "-%c", o->letter);
    put_font(file, 'B', name);
    fputs(", ", file);
  }
  snprintf(name, sizeof name, "--%s", o->name);
  put_font(file, 'B', name);
  if (o->argument != NULL) {
    fputc(' ', file);
    put_font(file, 'I', o->argument);
  }
  fputc('\n', file);
  um_app_option_text(o, needed, text);
  line(file, text);
  if (o->example == NULL) return;
  fputs(".br\nExample: ", file);
  put(file, o->example, false);
  fputc('\n', file);
}

static void options(FILE *file, const char *list, bool needed)
{
  const struct um_app_option *o;
  while ((o = um_app_option_next(&list)) != NULL) option(file, o, needed);
}

static void arguments(FILE *file, const char *list)
{
  char name[32], text[UM_APP_HELP_TEXT];
  bool optional;
  if (list[0] == '\0') return;
  fputs(".SH ARGUMENTS\n", file);
  while (um_app_argument_next(&list, name, &optional)) {
    fputs(".TP\n", file);
    put_font(file, 'I', name);
    fputc('\n', file);
    um_app_argument_text(name, text);
    line(file, text);
  }
}

static void examples(FILE *file, const char *lines)
{
  fputs(".SH EXAMPLES\n.nf\n", file);
  while (*lines != '\0') {
    char one[256];
    int n = (int)strcspn(lines, "\n");
    snprintf(one, sizeof one, "%.*s", n, lines);
    line(file, one);
    lines += n + (lines[n] == '\n' ? 1 : 0);
  }
  fputs(".fi\n", file);
}

#define EXIT(name, number, text) ".TP\n\\fB" #number "\\fR\n" text "\n"

static void exit_status(FILE *file)
{
  fputs(".SH \"EXIT STATUS\"\n", file);
  for (const char *c = UM_APP_EXITS(EXIT); *c != '\0'; c++)
    if (*c == '-')
      fputs("\\-", file);
    else
      fputc(*c, file);
  fputs(".TP\n\\fB" UM_APP_HELP_SIGNALS_NUMBERS "\\fR\n", file);
  line(file, UM_APP_HELP_SIGNALS);
}

/* What a verb lists behind its options, a line each. */
static void listed(FILE *file, const struct um_app_verb *verb)
{
  char *text = NULL;
  size_t size = 0;
  FILE *memory = verb->list != NULL ? open_memstream(&text, &size) : NULL;
  if (memory == NULL) return;
  verb->list(memory);
  if (fclose(memory) == 0) {
    fprintf(file, ".SH \"%s\"\n.nf\n", verb->listed);
    for (char *at = text, *end; at != NULL && *at != '\0'; at = end) {
      end = at + strcspn(at, "\n");
      if (*end == '\n') *end++ = '\0';
      line(file, at);
    }
    fputs(".fi\n", file);
  }
  free(text);
}

void um_app_manual_verb(FILE *file, const struct um_app_verb *verb)
{
  char name[64], text[UM_APP_HELP_TEXT];
  snprintf(name, sizeof name, "umbra-%s", verb->name);
  begin(file, name, verb->summary);
  fputs(".SH SYNOPSIS\n", file);
  char *usage = NULL;
  size_t size = 0;
  FILE *memory = open_memstream(&usage, &size);
  if (memory == NULL) return;
  um_app_usage(memory, verb);
  if (fclose(memory) == 0) line(file, usage);
  free(usage);
  fputs(".SH DESCRIPTION\n", file);
  um_app_verb_text(verb, text);
  line(file, text);
  arguments(file, verb->arguments);
  fputs(".SH OPTIONS\n", file);
  options(file, verb->needs, true);
  options(file, verb->accepts, false);
  options(file, um_app_verb_common(verb), false);
  listed(file, verb);
  examples(file, verb->examples);
  exit_status(file);
  fputs(".SH \"SEE ALSO\"\n\\fBumbra\\fR(1)\n", file);
}

static void verbs(FILE *file)
{
  fputs(".SH COMMANDS\n", file);
  for (int group = 0; group < UM_APP_GROUPS; group++) {
    fprintf(file, ".SS \"%s\"\n", um_app_group_name((enum um_app_group)group));
    for (size_t i = 0; i < um_app_verb_count(); i++) {
      const struct um_app_verb *verb = um_app_verb_at(i);
      char page[64];
      if (verb->group != (enum um_app_group)group) continue;
      snprintf(page, sizeof page, "umbra-%s", verb->name);
      fputs(".TP\n", file);
      put_font(file, 'B', page);
      fputs("(1)\n", file);
      line(file, verb->summary);
    }
  }
}

/* Folders and files, and what the environment changes: a name, and what it is. */
static const char *const files[][2] = {
    {"scenario.yaml", "what is computed; umbra list keys has its reference"},
    {"out/NAME", "results of a scenario of that name, where --out does not say. A folder appears "
                 "whole or not at all, and one that Umbra did not write is replaced with --force "
                 "alone"},
    {"share/umbra", "materials, filters, sensors and scenarios that come with the program, beside "
                    "it; umbra list says what they are"},
    {"share/doc/umbra/docs/files.md", "every file that is read or written, column by column"},
};
static const char *const environment[][2] = {
    {"UMBRA_DATA", "folder that holds materials/, scenarios/ and so on, in place of share/umbra"},
    {"UMBRA_CACHE", "folder where view factors are kept between runs"},
    {"OMP_NUM_THREADS", "worker threads where --threads does not say"},
};

static void pairs(FILE *file, const char *heading, const char *const (*pair)[2], size_t n)
{
  fprintf(file, ".SH %s\n", heading);
  for (size_t i = 0; i < n; i++) {
    fputs(".TP\n", file);
    put_font(file, 'B', pair[i][0]);
    fputc('\n', file);
    line(file, pair[i][1]);
  }
}

void um_app_manual(FILE *file)
{
  const char *command, *does;
  begin(file, "umbra", "light curves of satellites in the visible and the thermal infrared");
  fputs(".SH SYNOPSIS\n\\fBumbra\\fR \\fICOMMAND\\fR [\\fIARGUMENT\\fR]... [\\fIOPTION\\fR]...\n"
        ".SH DESCRIPTION\n",
        file);
  line(file, UM_APP_HELP_LEAD);
  fputs(".PP\nThe usual way:\n", file);
  for (size_t i = 0; um_app_path_at(i, &command, &does); i++) {
    fputs(".TP\n", file);
    put_font(file, 'B', command);
    fputc('\n', file);
    line(file, does);
  }
  fputs(".PP\nEvery command has a page of its own, umbra\\-COMMAND(1), with the content of\n"
        "\\fBumbra\\fR \\fICOMMAND\\fR \\fB\\-\\-help\\fR.\n",
        file);
  verbs(file);
  pairs(file, "FILES", files, sizeof files / sizeof files[0]);
  pairs(file, "ENVIRONMENT", environment, sizeof environment / sizeof environment[0]);
  exit_status(file);
}
