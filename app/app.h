/* The umbra command: what its verbs share. */
#ifndef UMBRA_APP_APP_H
#define UMBRA_APP_APP_H

#include <stdbool.h>
#include <stdio.h>

#include "core/context.h"
#include "core/json.h"
#include "model/model.h"

#define UM_APP_VERSION "0.1.0"

/* Exit codes: 0 done, 1 failed, 2 misuse. */
enum um_app_exit { UM_APP_DONE = 0, UM_APP_FAILED = 1, UM_APP_MISUSE = 2 };

/* Options that verbs have in common, as parsed; texts borrowed from argv. */
struct um_app_options {
  const char *positional[4];
  int npositional;
  const char *out;  /* --out, -o */
  const char **set; /* --set KEY=VALUE */
  size_t nset;
  const char **with, **without;
  size_t nwith, nwithout;
  const char **effect_file; /* --effect-file */
  size_t neffect_file;
  const char *time_utc, *band; /* --time, --band */
  int width, samples;          /* --width, --samples */
  /* of synth: --noise, --seed, --temperatures, --temperature-sigma */
  const char *noise, *seed, *temperatures, *temperature_sigma;
  /* of diagnose and fit: --only, --exclude, --nuisance, --add, --level, --steps */
  const char **only, **exclude, **nuisance, **add;
  size_t nonly, nexclude, nnuisance, nadd;
  double level; /* 0: not said */
  int steps;    /* 0: not said */
  bool force, json, thermal, optics, no_plots;
  char *command; /* the command as typed */
};

struct um_app_verb {
  const char *name, *usage, *summary;
  int npositional_min, npositional_max;
  const char *accepts; /* long options it takes, space separated, beside --threads */
  /* UM_APP_MISUSE: said what is wrong; the usage line is printed behind it */
  int (*run)(struct um_context *context, const struct um_app_options *options);
};

/* Room for the options of argc arguments, of which no option comes more often; false: no memory. */
bool um_app_options_allocate(struct um_app_options *options, int argc);
void um_app_options_release(struct um_app_options *options);
/* What stands behind the verb. UM_APP_MISUSE: said what is wrong; -1: help was asked for and
 * printed. */
int um_app_options_parse(struct um_context *context, const struct um_app_verb *verb, int argc,
                         char **argv, struct um_app_options *options);
/* Say what is wrong, with the usage of the verb, or NULL; returns UM_APP_MISUSE. format: a literal
 * with one %s for what. */
int um_app_misuse(const struct um_app_verb *verb, const char *format, const char *what);
/* Print the context's message as "umbra: message" on stderr; returns UM_APP_FAILED. */
int um_app_fail(struct um_context *context);
/* The part of the options that changes a scenario. */
struct um_model_options um_app_model_options(const struct um_app_options *options);
/* "REL" or "REL,FLOOR"; who takes the numbers checks their range. */
bool um_app_noise_parse(const char *text, double fallback_floor, double *relative, double *floor);
/* A file that is to be written is not there, or may be replaced; said before the computing begins.
 */
enum um_status um_app_check_target(struct um_context *context, const char *out, bool force);

int um_app_run(struct um_context *context, const struct um_app_options *options);
int um_app_check(struct um_context *context, const struct um_app_options *options);
int um_app_passes(struct um_context *context, const struct um_app_options *options);
int um_app_materials(struct um_context *context, const struct um_app_options *options);
int um_app_effects(struct um_context *context, const struct um_app_options *options);
int um_app_render(struct um_context *context, const struct um_app_options *options);
int um_app_compare(struct um_context *context, const struct um_app_options *options);
int um_app_period(struct um_context *context, const struct um_app_options *options);
int um_app_import(struct um_context *context, const struct um_app_options *options);
int um_app_diagnose(struct um_context *context, const struct um_app_options *options);
int um_app_fit(struct um_context *context, const struct um_app_options *options);
int um_app_synth(struct um_context *context, const struct um_app_options *options);
int um_app_validate(struct um_context *context, const struct um_app_options *options);
int um_app_schema(struct um_context *context, const struct um_app_options *options);

#endif
