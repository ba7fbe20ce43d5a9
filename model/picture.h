/* Pictures of the satellite. */
#ifndef UMBRA_MODEL_PICTURE_H
#define UMBRA_MODEL_PICTURE_H

#include "model/model.h"
#include "model/precomputed.h"
#include "model/result.h"

/* Picture of observation k in a band, up being away from the Earth; see um_optics_image_render.
 * UM_ERR_INPUT without an observer. */
enum um_status um_model_picture(struct um_context *context, const struct um_model *model,
                                const struct um_model_precomputed *precomputed,
                                const struct um_model_result *result, size_t k, size_t band,
                                int width, int samples_per_pixel, struct um_optics_image **out);

#endif
