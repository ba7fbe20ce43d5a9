/* Bands and sensors by name. */
#ifndef UMBRA_MODEL_BANDS_H
#define UMBRA_MODEL_BANDS_H

#include "model/model.h"

/* Index of a band by name, (size_t)-1 when there is none. */
size_t um_model_band_find(const struct um_model *model, const char *name);
/* The same; UM_ERR_INPUT with the nearest one and what is accepted when there is none. */
enum um_status um_model_band_require(struct um_context *context, const struct um_model *model,
                                     const char *name, size_t *out);
/* Index of a sensor by name; UM_ERR_INPUT with the nearest one and what is accepted when there is
 * none. */
enum um_status um_model_sensor_require(struct um_context *context, const struct um_model *model,
                                       const char *name, size_t *out);

#endif
