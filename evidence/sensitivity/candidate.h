/* A candidate (effect x target) for what a scenario lacks, with its signature: how every
 * observation changes with each of its parameters. */
#ifndef UMBRA_SENSITIVITY_CANDIDATE_H
#define UMBRA_SENSITIVITY_CANDIDATE_H

#include <stdbool.h>
#include <stddef.h>

#include "effects/effect.h"

struct um_sensitivity_candidate {
  char *name; /* "emittance:sphere_paint", "albedo"; owned */
  const struct um_effect *effect;
  char *target;   /* owned; NULL: global */
  size_t ncolumn; /* of the signature: the free parameters; 1 for a core switch */
  size_t parameter[UM_EFFECT_PARAMETERS_MAX]; /* [ncolumn] of the effect's; of a switch: none */
  bool is_switch;                             /* no parameters: on, or not */
  /* parameters unidentified under the null, which do nothing while the others are null: fitted, not
   * tested */
  size_t nunidentified, unidentified[UM_EFFECT_PARAMETERS_MAX];
  /* [effect's nparameter]: the scenario's values; of shapes where a fit starts */
  double null_value[UM_EFFECT_PARAMETERS_MAX];
  /* [effect's nparameter]: the effect's own range, less where what the scenario states would not be
   * physical */
  double minimum[UM_EFFECT_PARAMETERS_MAX], maximum[UM_EFFECT_PARAMETERS_MAX];
  double step[UM_EFFECT_PARAMETERS_MAX]; /* [ncolumn] taken for the difference, signed */
  /* [ncolumn][nobservation] d(model)/d(parameter) at the null value, linear unit per parameter
   * unit; of a switch the whole change when it is turned on */
  double *signature;
  bool insensitive; /* no observation changes, or the effect refuses the target */
  char *why;        /* the refusal; NULL: no observation changes */
};

#endif
