/* A candidate differenced. Private to sensitivity/. */
#ifndef UMBRA_SENSITIVITY_SIGNATURE_IMPL_H
#define UMBRA_SENSITIVITY_SIGNATURE_IMPL_H

#include "sensitivity/candidate.h"
#include "sensitivity/forward.h"

/* What a signature is taken of. */
struct um_sensitivity_point {
  struct um_sensitivity_forward *forward;
  const struct um_model_addition *addition; /* [naddition] */
  size_t naddition;
  const double *base; /* [nobservation] values with the additions */
  double noise; /* largest change of an observation, in its sigma, that a new integration of the
                   same heat makes */
};
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
