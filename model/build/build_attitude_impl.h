/* Attitude laws of a scenario. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_ATTITUDE_IMPL_H
#define UMBRA_MODEL_BUILD_ATTITUDE_IMPL_H

#include "model/build/model.h"

/* The laws, as effects change them. */
enum um_status um_model_build_attitude(struct um_context *context, struct um_model *model);
/* What lies between two laws is known where the second begins: wants orbit, Sun and observer. */
enum um_status um_model_build_slews(struct um_context *context, struct um_model *model);

#endif
