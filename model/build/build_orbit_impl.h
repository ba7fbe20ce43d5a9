/* Building orbit and attitude. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_ORBIT_IMPL_H
#define UMBRA_MODEL_BUILD_ORBIT_IMPL_H

#include "model/build/model.h"

/* orientation, trajectory, attitude, observer. */
enum um_status um_model_build_orbit(struct um_context *context, struct um_model *model);

#endif
