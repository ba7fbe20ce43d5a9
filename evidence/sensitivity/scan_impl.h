/* Where a signature is taken. Private to evidence/sensitivity/. */
#ifndef UMBRA_SENSITIVITY_SCAN_IMPL_H
#define UMBRA_SENSITIVITY_SCAN_IMPL_H

#include "evidence/sensitivity/candidate.h"
#include "evidence/sensitivity/forward.h"

/* Set null values of temperatures to one that the target has. base: temperatures of the scenario,
 * made when needed; the caller destroys. */
enum um_status um_sensitivity_scan(struct um_context *context,
                                   struct um_sensitivity_forward *forward,
                                   struct um_sensitivity_candidate *candidate,
                                   struct um_model_result **base);

/* Set null values of rates (um_effect_parameter.is_rate) to those for which the observations speak
 * most, and how many were looked at, of candidates [count] that have one that matters only beside
 * other parameters. Errors of the model. */
enum um_status um_sensitivity_scan_rates(struct um_context *context,
                                         struct um_sensitivity_forward *forward,
                                         struct um_sensitivity_candidate *candidate, size_t count);

#endif
