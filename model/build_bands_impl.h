/* Bands and the sensors that count them. Private to model/. */
#ifndef UMBRA_MODEL_BUILD_BANDS_IMPL_H
#define UMBRA_MODEL_BUILD_BANDS_IMPL_H

#include "model/model.h"

/* Edges, bins and filters of the bands, Vega in them, and the scenario's sensors; a variant has
 * those of its origin. UM_ERR_INPUT with file, line and key, and what filters and their files are
 * refused for; UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_model_build_bands(struct um_context *context, struct um_model *model);

#endif
