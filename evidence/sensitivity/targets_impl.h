/* Targets of an effect among what was measured. Private to evidence/sensitivity/. */
#ifndef UMBRA_SENSITIVITY_TARGETS_IMPL_H
#define UMBRA_SENSITIVITY_TARGETS_IMPL_H

#include "evidence/sensitivity/forward.h"
#include "evidence/sensitivity/targets.h"

/* The same, and each in one of several sets of measurements. */
enum um_status um_sensitivity_targets_create(struct um_context *context,
                                             const struct um_sensitivity_forward *forward,
                                             const struct um_effect *effect,
                                             struct um_sensitivity_targets *out);

#endif
