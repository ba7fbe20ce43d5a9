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

#endif
