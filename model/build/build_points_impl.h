/* Building a scenario of points. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_POINTS_IMPL_H
#define UMBRA_MODEL_BUILD_POINTS_IMPL_H

#include "model/build/model.h"

/* stations of orbit.points, and what such a scenario cannot have. */
enum um_status um_model_build_points(struct um_context *context, struct um_model *model);

#endif
