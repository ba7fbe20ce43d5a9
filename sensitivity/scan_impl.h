/* Where a signature is taken. Private to sensitivity/. */
#ifndef UMBRA_SENSITIVITY_SCAN_IMPL_H
#define UMBRA_SENSITIVITY_SCAN_IMPL_H

#include "sensitivity/candidate.h"
#include "sensitivity/forward.h"

/* Null values of temperatures that the target has; base: of the scenario, run when needed, released
 * by the caller. */
enum um_status um_sensitivity_scan(struct um_context *context,
                                   struct um_sensitivity_forward *forward,
                                   struct um_sensitivity_candidate *candidate,
                                   struct um_sensitivity_forward_run *base);

#endif
