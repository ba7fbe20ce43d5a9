/* Building parts. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_PARTS_IMPL_H
#define UMBRA_MODEL_BUILD_PARTS_IMPL_H

#include "model/build/model.h"

/* library, geometry, material records of it. */
enum um_status um_model_build_parts(struct um_context *context, struct um_model *model);

#endif
