/* The signature of a candidate. Private to evidence/sensitivity/. */
#ifndef UMBRA_SENSITIVITY_SIGNATURE_IMPL_H
#define UMBRA_SENSITIVITY_SIGNATURE_IMPL_H

#include "evidence/sensitivity/difference_impl.h"

/* Steps that the signature of a candidate begins with, one a parameter, into out
 * [UM_EFFECT_PARAMETERS_MAX]; how many. Effect, target, range and null values are set. */
size_t um_sensitivity_signature_moves(const struct um_sensitivity_candidate *candidate,
                                      struct um_sensitivity_move *out);
/* Columns of a candidate of which effect, target, range and null values are set: which parameters
 * are free, steps, signature [one a parameter][nobservation], insensitive. UM_ERR_REFUSED,
 * UM_ERR_NUMERIC: the model refuses what its effect asks. */
enum um_status um_sensitivity_signature_make(struct um_context *context,
                                             const struct um_sensitivity_point *point,
                                             struct um_sensitivity_candidate *candidate);
/* The signature anew with the parameters that are free; steps may change. */
enum um_status um_sensitivity_signature_renew(struct um_context *context,
                                              const struct um_sensitivity_point *point,
                                              struct um_sensitivity_candidate *candidate);

#endif
