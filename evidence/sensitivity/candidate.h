/* A candidate (effect x target) for what a scenario lacks, with its signature: how every
 * observation changes with each of its parameters. */
#ifndef UMBRA_SENSITIVITY_CANDIDATE_H
#define UMBRA_SENSITIVITY_CANDIDATE_H

#include <stdbool.h>
#include <stddef.h>

#include "effects/effect.h"

/* How a column was found. */
enum um_sensitivity_way {
  UM_SENSITIVITY_BY_NONE,    /* there is none: nothing changes, or the effect refuses */
  UM_SENSITIVITY_BY_BEHIND,  /* acts on light that has left the satellite: differences of that */
  UM_SENSITIVITY_BY_LIGHT,   /* heat stays: differences of light */
  UM_SENSITIVITY_BY_TANGENT, /* heat by a sensitivity, light by differences along it */
  UM_SENSITIVITY_BY_RUNS,    /* differences of runs whose heat is integrated anew */
  UM_SENSITIVITY_BY_MOTION,  /* the same of runs whose geometry is traced anew, too */
  UM_SENSITIVITY_BY_SWITCH,  /* no derivative: the whole change when it is turned on */
  UM_SENSITIVITY_WAYS
};

/* What is known of a column that was taken as a derivative (derivative.c). */
struct um_sensitivity_quality {
  enum um_sensitivity_way way;
  double step;  /* of the differences [parameter unit] */
  double error; /* of the column, estimated, of its largest value [1]: in each channel of light, and
                   in the temperatures together */
  double reach; /* how far from its null value the linear answer leaves a hundredth of every curve's
                   size, by what the first step showed [parameter unit]; INFINITY: no bend seen;
                   NaN: not known, since no heat was integrated for it */
};

struct um_sensitivity_candidate {
  char *name; /* "emittance:sphere_paint", "albedo", "albedo=off"; owned */
  const struct um_effect *effect;
  char *target;   /* owned; NULL: global */
  size_t ncolumn; /* of the signature: the free parameters; 1 for a core switch */
  size_t parameter[UM_EFFECT_PARAMETERS_MAX]; /* [ncolumn] of the effect's; of a switch: none */
  bool is_switch;                             /* no parameters: on, or not */
  bool off;                                   /* a switch that the scenario has on, turned off */
  /* parameters unidentified under the null, which do nothing while the others are null: fitted, not
   * tested */
  size_t nunidentified, unidentified[UM_EFFECT_PARAMETERS_MAX];
  /* null values of a rate were looked for in its range, where these observations speak for it most:
   * so many tests in one (scan_rates.c); 0: none was */
  size_t trials;
  /* [effect's nparameter]: the scenario's values; of shapes where a fit starts */
  double null_value[UM_EFFECT_PARAMETERS_MAX];
  /* [effect's nparameter]: the effect's own range, less where what the scenario states would not be
   * physical */
  double minimum[UM_EFFECT_PARAMETERS_MAX], maximum[UM_EFFECT_PARAMETERS_MAX];
  double step[UM_EFFECT_PARAMETERS_MAX]; /* [ncolumn] taken for the difference, signed */
  struct um_sensitivity_quality
      quality[UM_EFFECT_PARAMETERS_MAX]; /* [effect's nparameter] of derivatives; else zero */
  /* [ncolumn][nobservation] d(model)/d(parameter) at the null value, linear unit per parameter
   * unit; of a switch the whole change when it is turned */
  double *signature;
  bool insensitive; /* no observation changes, or the effect refuses the target */
  char *why;        /* the refusal; NULL: no observation changes */
};

/* Whether a temperature that is measured of `measured` is that of `target`: "body.+y" is also
 * measured as "+y". */
bool um_sensitivity_is_of(const char *measured, const char *target);

#endif
