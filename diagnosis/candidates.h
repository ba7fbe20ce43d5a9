/* Candidates (effect x target) for what a scenario lacks, each with its signature: how every row
 * changes with each of its parameters. */
#ifndef UMBRA_DIAGNOSIS_CANDIDATES_H
#define UMBRA_DIAGNOSIS_CANDIDATES_H

#include "diagnosis/forward.h"

struct um_diagnosis_candidate {
  char *name; /* "emittance:sphere_paint", "albedo"; owned */
  const struct um_effect *effect;
  char *target;   /* owned; NULL: global */
  size_t ncolumn; /* of the signature: the free parameters; 1 for a core switch */
  size_t parameter[UM_EFFECT_PARAMETERS_MAX]; /* [ncolumn] of the effect's; of a switch: none */
  bool is_switch;                             /* no parameters: on, or not */
  /* parameters of shape, which do nothing while the others are null: fitted, not tested */
  size_t nshape, shape[UM_EFFECT_PARAMETERS_MAX];
  /* [effect's nparameter]: the scenario's values; of shapes where a fit starts */
  double null_value[UM_EFFECT_PARAMETERS_MAX];
  double step[UM_EFFECT_PARAMETERS_MAX]; /* [ncolumn] taken for the difference, signed */
  /* [ncolumn][nrow] d(model)/d(parameter) at the null value, linear unit per parameter unit; of a
   * switch the whole change when it is turned on */
  double *signature;
  bool dead; /* no row changes, or the effect refuses the target */
  char *why; /* the refusal; NULL: no row changes */
};

struct um_diagnosis_candidates {
  size_t count, nrow;
  struct um_diagnosis_candidate *candidate; /* [count], in the order of effects, then of targets */
  double *base;                             /* [nrow] model values without them */
};

struct um_diagnosis_candidates_options {
  const char *const *only; /* [nonly] "effect" or "effect:target"; none: every effect */
  size_t nonly;
  const char *const *exclude; /* [nexclude] likewise; taken out of what is left */
  size_t nexclude;
};

/* Every effect of the model on every target it may have there (parts, sides, materials, bands, or
 * everything), and core switches that are off. A parameter that does nothing while the others are
 * null stays at its default, or, where it is a temperature, at one that the target has. Two targets
 * that are the same thing (a part of one side) appear once. Steps are one-sided into the allowed
 * range, of the order of a fifth of the prior width, halved or doubled until the change of the rows
 * stands above the noise of the integration. additions: what the model already has beside the
 * scenario; they are not listed again. UM_ERR_INPUT: `only` or `exclude` name no effect. Progress
 * is reported. The caller destroys. */
enum um_status um_diagnosis_candidates_create(struct um_context *context,
                                              struct um_diagnosis_forward *forward,
                                              const struct um_diagnosis_addition *addition,
                                              size_t naddition,
                                              const struct um_diagnosis_candidates_options *options,
                                              struct um_diagnosis_candidates **out);
void um_diagnosis_candidates_destroy(struct um_context *context,
                                     struct um_diagnosis_candidates **candidates);
/* Signature of one candidate anew, at the scenario with these additions. */
enum um_status um_diagnosis_candidate_refresh(struct um_context *context,
                                              struct um_diagnosis_forward *forward,
                                              const struct um_diagnosis_addition *addition,
                                              size_t naddition, const double *base,
                                              struct um_diagnosis_candidate *candidate);

#endif
