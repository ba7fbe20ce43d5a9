/* How surfaces depend on angle and temperature. Private to model/build/. */
#ifndef UMBRA_MODEL_SURFACE_LAW_IMPL_H
#define UMBRA_MODEL_SURFACE_LAW_IMPL_H

#include "model/build/model.h"

/* Into model->surface_law. */
enum um_status um_model_build_surface_laws(struct um_context *context, struct um_model *model);

#endif
