/* Honeycomb panels as walls. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_HONEYCOMB_IMPL_H
#define UMBRA_MODEL_BUILD_HONEYCOMB_IMPL_H

#include "model/build/model.h"

/* Fills what of *to is not stated (NaN); shell->honeycomb is there. */
enum um_status um_model_build_honeycomb(struct um_context *context, struct um_model *model,
                                        const struct um_scenario_shell *shell,
                                        struct um_thermal_shell *to);

#endif
