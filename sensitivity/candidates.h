/* Candidates (effect x target) for what a scenario lacks, each with its signature: how every
 * observation changes with each of its parameters. */
#ifndef UMBRA_SENSITIVITY_CANDIDATES_H
#define UMBRA_SENSITIVITY_CANDIDATES_H

#include "sensitivity/forward.h"

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

struct um_sensitivity_candidates {
  size_t count, nobservation;
  struct um_sensitivity_candidate
      *candidate; /* [count], in the order of effects, then of targets */
  double *base;   /* [nobservation] model values without them */
};

struct um_sensitivity_candidates_options {
  const char *const *only; /* [nonly] "effect" or "effect:target"; none: every effect */
  size_t nonly;
  const char *const *exclude; /* [nexclude] likewise; taken out of what is left */
  size_t nexclude;
};

/* Every effect of the model on every target it may have there (parts, sides, materials, bands, or
 * everything), and core switches that are off. A parameter that does nothing while the others are
 * null stays at its default, or, where it is a temperature, at one that the target has. Two targets
 * that are the same thing (a part of one side) appear once. Steps are one-sided into the allowed
 * range, of the order of a fifth of the prior width, halved or doubled until the change of the
 * observations stands above the noise of the integration. additions: what the model already has
 * beside the scenario; they are not listed again. A switch that has values is listed with each of
 * them at its null value and at either end of its range. UM_ERR_INPUT: `only` or `exclude` name no
 * effect. Progress is reported. The caller destroys. */
enum um_status
um_sensitivity_candidates_create(struct um_context *context, struct um_sensitivity_forward *forward,
                                 const struct um_model_addition *addition, size_t naddition,
                                 const struct um_sensitivity_candidates_options *options,
                                 struct um_sensitivity_candidates **out);
void um_sensitivity_candidates_destroy(struct um_context *context,
                                       struct um_sensitivity_candidates **candidates);

#endif
