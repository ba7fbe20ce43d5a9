/* What an effect may be attached to. */
#ifndef UMBRA_SENSITIVITY_TARGETS_H
#define UMBRA_SENSITIVITY_TARGETS_H

#include "model/build/model.h"

/* Texts owned by the list, NULL for everything. */
struct um_sensitivity_targets {
  char **name;
  size_t count;
};
/* In a model that is built, whatever is measured of it; places that lie in another one that is
 * listed, too ("bus", "bus.+x"). None where the effect has nothing to act on. UM_ERR_MEMORY.
 * Released by the caller. */
enum um_status um_sensitivity_targets_of(struct um_context *context, const struct um_model *model,
                                         const struct um_effect *effect,
                                         struct um_sensitivity_targets *out);
void um_sensitivity_targets_release(struct um_context *context,
                                    struct um_sensitivity_targets *targets);

#endif
