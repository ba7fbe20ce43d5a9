/* Power histories. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_POWER_IMPL_H
#define UMBRA_MODEL_BUILD_POWER_IMPL_H

#include "model/build/model.h"

/* A power history from the file of a key `power_file`; *out is owned by the
 * document, NULL without a file. at: the mapping that holds the key. */
struct um_thermal_power_history;
enum um_status um_model_power_history(struct um_context *context, struct um_model *model,
                                      const struct um_mark *at, const char *file,
                                      const struct um_thermal_power_history **out);

#endif
