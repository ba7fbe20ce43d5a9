/* Warnings of a geometry that counts something twice. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_COINCIDENT_IMPL_H
#define UMBRA_MODEL_BUILD_COINCIDENT_IMPL_H

#include "model/build/model.h"

/* Say in the log which parts have surfaces in one place (geometry/coincident.h), and which have an
 * interior that bodies share which do not touch (geometry/bodies.h). After the parts are built.
 * UM_ERR_MEMORY, UM_ERR_CANCELLED. */
enum um_status um_model_warn_coincident(struct um_context *context, const struct um_model *model);

#endif
