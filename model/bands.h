/* Bands and sensors by name, and the bins of a band. */
#ifndef UMBRA_MODEL_BANDS_H
#define UMBRA_MODEL_BANDS_H

#include "instrument/photometry.h"
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

/* Bins of a band as photometry wants them, with what its filter lets through, which stays the
 * band's. UM_ERR_MEMORY; _clear frees. */
enum um_status um_model_band_bins(struct um_context *context, const struct um_optics_band *band,
                                  struct um_instrument_bins *out);
void um_model_band_bins_clear(struct um_context *context, struct um_instrument_bins *bins);

#endif
