/* Bands and the sensors that count them. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_BANDS_IMPL_H
#define UMBRA_MODEL_BUILD_BANDS_IMPL_H

#include "model/build/model.h"
#include "optics/instrument/filter.h"

/* Edges, bins and filters of the bands, Vega in them, and the scenario's sensors; a variant has
 * those of its origin. UM_ERR_INPUT with file, line and key, and what filters and their files are
 * refused for; UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_model_build_bands(struct um_context *context, struct um_model *model);

/* The sensors alone, once the bands stand. */
enum um_status um_model_build_sensors(struct um_context *context, struct um_model *model);

/* A curve of the scenario's folder, as um_instrument_filter_read; the caller destroys. */
enum um_status um_model_curve_read(struct um_context *context, struct um_model *model,
                                   const struct um_mark *at, const char *key, const char *relative,
                                   struct um_instrument_filter **out);
/* [n] ones, of the model. */
enum um_status um_model_bins_ones(struct um_context *context, struct um_model *model, int n,
                                  double **out);
/* The mean of a curve over each bin of a band, multiplied into to [bins]. Does not fail. */
void um_model_bins_pass(const struct um_instrument_filter *curve, const struct um_optics_band *band,
                        double *to);

#endif
