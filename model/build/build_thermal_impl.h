/* Building the heat network. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_THERMAL_IMPL_H
#define UMBRA_MODEL_BUILD_THERMAL_IMPL_H

#include "model/build/model.h"

/* heat network. */
enum um_status um_model_build_thermal(struct um_context *context, struct um_model *model);

#endif
