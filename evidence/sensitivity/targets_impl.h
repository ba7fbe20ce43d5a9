/* Targets of an effect. Private to evidence/sensitivity/. */
#ifndef UMBRA_SENSITIVITY_TARGETS_IMPL_H
#define UMBRA_SENSITIVITY_TARGETS_IMPL_H

#include "evidence/sensitivity/forward.h"

/* What an effect may be attached to in a model, and in one of several sets of measurements: texts
 * owned by the list, NULL for everything. */
struct um_sensitivity_targets {
  char **name;
  size_t count;
};
enum um_status um_sensitivity_targets_create(struct um_context *context,
                                             const struct um_sensitivity_forward *forward,
                                             const struct um_effect *effect,
                                             struct um_sensitivity_targets *out);
void um_sensitivity_targets_release(struct um_context *context,
                                    struct um_sensitivity_targets *targets);

#endif
