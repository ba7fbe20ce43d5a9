/* The umbra command: what its verbs share that work on models of the program themselves. */
#ifndef UMBRA_APP_APP_H
#define UMBRA_APP_APP_H

#include "app/client.h"
#include "base/core/context.h"
#include "base/core/json.h"
#include "model/build/model.h"

/* A command line, argv[1] the verb by its name of now or of before, parsed and run; a context of
 * its own or one in which nothing else is under way. Returns the exit status. */
int um_app_dispatch(struct um_context *context, int argc, char **argv);
/* Room for the options of argc arguments, of which no option comes more often; false: no memory. */
bool um_app_options_allocate(struct um_app_options *options, int argc);
void um_app_options_release(struct um_app_options *options);
/* What stands behind the verb. UM_APP_MISUSE: said what is wrong; -1: help was asked for and
 * printed. */
int um_app_options_parse(struct um_context *context, const struct um_app_verb *verb, int argc,
                         char **argv, struct um_app_options *options);
/* Was an option given? Of --threads not known: false. */
bool um_app_option_given(const struct um_app_option *option, const struct um_app_options *options);
/* Refuse options that do not go with what is asked: ids of a list, parted by blanks. why: "does not
 * go with --times". UM_APP_DONE: none was given; UM_APP_MISUSE: the first that was is named. */
int um_app_options_refuse(const struct um_app_options *options, const char *list, const char *why);
/* Insist on options of a list. UM_APP_DONE; UM_APP_MISUSE: all that are missing are named. */
int um_app_options_require(const struct um_app_options *options, const char *list);
/* Say what is wrong, with the usage of the verb, or NULL; returns UM_APP_MISUSE. format: a literal
 * with one %s for what. */
int um_app_misuse(const struct um_app_verb *verb, const char *format, const char *what);
/* Print the context's message as "umbra: message" on stderr; returns UM_APP_FAILED. */
int um_app_fail(struct um_context *context);
/* The part of the options that changes a scenario. */
struct um_model_options um_app_model_options(const struct um_app_options *options);
/* The folder that results go to: --out, else out/NAME, else, where the command line changes the
 * scenario, out/NAME--set-..., a folder of that variant's own. The caller frees *out. */
enum um_status um_app_out_folder(struct um_context *context, const struct um_app_options *options,
                                 const char *name, char **out);
/* The last lines of a command: "results in FOLDER", and where the folder holds a page to look at,
 * "to look at: FOLDER/report.html". */
void um_app_tell_results(const char *folder);
/* "REL" or "REL,FLOOR"; who takes the numbers checks their range. */
bool um_app_noise_parse(const char *text, double fallback_floor, double *relative, double *floor);
/* "MAG,X,Y"; false: it is something else. */
bool um_app_star_parse(const char *text, double out[3]);

#endif
