/* Listing candidates and differencing them. Private to sensitivity/. */
#ifndef UMBRA_SENSITIVITY_CANDIDATES_IMPL_H
#define UMBRA_SENSITIVITY_CANDIDATES_IMPL_H

#include "sensitivity/candidates.h"

/* What an effect may be attached to in a model: texts owned by the list, NULL for everything. */
struct um_sensitivity_targets {
  char **name;
  size_t count;
};
enum um_status um_sensitivity_targets_create(struct um_context *context,
                                             const struct um_model *model,
                                             const struct um_effect *effect,
                                             struct um_sensitivity_targets *out);
void um_sensitivity_targets_release(struct um_context *context,
                                    struct um_sensitivity_targets *targets);

/* What a signature is taken of. */
struct um_sensitivity_point {
  struct um_sensitivity_forward *forward;
  const struct um_model_addition *addition; /* [naddition] */
  size_t naddition;
  const double *base; /* [nobservation] values with the additions */
  double noise; /* largest change of an observation, in its sigma, that a new integration of the
                   same heat makes */
};
/* Null values of temperatures that the target has; base: of the scenario, run when needed, released
 * by the caller. */
enum um_status um_sensitivity_scan(struct um_context *context,
                                   struct um_sensitivity_forward *forward,
                                   struct um_sensitivity_candidate *candidate,
                                   struct um_sensitivity_forward_run *base);
/* Columns of a candidate of which effect, target and null values are set: which parameters are
 * free, steps, signature, insensitive, why. */
enum um_status um_sensitivity_signature_create(struct um_context *context,
                                               const struct um_sensitivity_point *point,
                                               struct um_sensitivity_candidate *candidate);
/* The signature anew with the parameters that are free; steps may change. */
enum um_status um_sensitivity_signature_renew(struct um_context *context,
                                              const struct um_sensitivity_point *point,
                                              struct um_sensitivity_candidate *candidate);

#endif
