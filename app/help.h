/* Texts that the help on the terminal and the man pages have in common. */
#ifndef UMBRA_APP_HELP_H
#define UMBRA_APP_HELP_H

#include "app/client.h"

#define UM_APP_HELP_TEXT 1024 /* room for a text [byte] */
#define UM_APP_HELP_LEAD                                                                           \
  "Umbra computes what a telescope sees of a satellite, in the visible and at 8-12 um, from one "  \
  "physical state; it holds that against measurements and says which physical effect the model "   \
  "lacks, or that the measurements cannot tell."
#define UM_APP_HELP_SIGNALS_NUMBERS "130, 143"
#define UM_APP_HELP_SIGNALS         "ended by SIGINT (Ctrl-C), SIGTERM"

/* What a verb does: its summary as a sentence, and what there is about it. */
void um_app_verb_text(const struct um_app_verb *verb, char out[UM_APP_HELP_TEXT]);
/* What an argument is; a line for each thing that it may be. */
void um_app_argument_text(const char *name, char out[UM_APP_HELP_TEXT]);
/* What an option does, whether it is required, may come again, and its default. */
void um_app_option_text(const struct um_app_option *option, bool needed,
                        char out[UM_APP_HELP_TEXT]);
/* "Simulate" */
const char *um_app_group_name(enum um_app_group group);
/* A step of the usual way: a command and what it does. false behind the last. */
bool um_app_path_at(size_t index, const char **command, const char **does);

/* As JSON: the commands, or a verb with the schema of what it prints. false: no memory. Errors of
 * writing are the stream's. */
bool um_app_help_json(FILE *file, const struct um_app_verb *verb);

/* Man pages in roff: umbra.1, and a verb's own with the content of its help. */
void um_app_manual(FILE *file);
void um_app_manual_verb(FILE *file, const struct um_app_verb *verb);

#endif
