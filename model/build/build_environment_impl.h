/* Building the environment. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_ENVIRONMENT_IMPL_H
#define UMBRA_MODEL_BUILD_ENVIRONMENT_IMPL_H

#include "model/build/model.h"

/* environment: from the scenario's mapping, then its effects. */
enum um_status um_model_build_environment(struct um_context *context, struct um_model *model);

#endif
