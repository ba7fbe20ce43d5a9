/* Bands and sensors by name, and the bins of a band. */
#ifndef UMBRA_MODEL_BANDS_H
#define UMBRA_MODEL_BANDS_H

#include "model/build/model.h"
#include "optics/instrument/photometry.h"

/* Index of a band by name, (size_t)-1 when there is none. */
size_t um_model_band_find(const struct um_model *model, const char *name);
/* The same; UM_ERR_INPUT with the nearest one and what is accepted when there is none. */
enum um_status um_model_band_require(struct um_context *context, const struct um_model *model,
                                     const char *name, size_t *out);
/* Index of a sensor by name; UM_ERR_INPUT with the nearest one and what is accepted when there is
 * none. */
enum um_status um_model_sensor_require(struct um_context *context, const struct um_model *model,
                                       const char *name, size_t *out);

/* Does the band lie where objects shine by their own heat, UM_INSTRUMENT_THERMAL_FROM to _TO? */
bool um_model_band_is_thermal(const struct um_optics_band *band);
size_t um_model_thermal_bands(const struct um_model *model); /* their number */

/* Are magnitudes of the band by custom relative to Vega? Its scenario states vega_magnitude, or a
 * filter of a system that is (Johnson, Cousins, Gaia, WISE), and Vega is known there. */
bool um_model_band_is_vega(const struct um_model *model, size_t band);

/* Bins of a band as photometry wants them, with what its filter lets through, which stays the
 * band's. UM_ERR_MEMORY; _clear frees. */
enum um_status um_model_band_bins(struct um_context *context, const struct um_optics_band *band,
                                  struct um_instrument_bins *out);
void um_model_band_bins_clear(struct um_context *context, struct um_instrument_bins *bins);

#endif
