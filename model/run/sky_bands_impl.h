/* Light of the sky for effects on observations. Private to model/run/. */
#ifndef UMBRA_MODEL_SKY_BANDS_IMPL_H
#define UMBRA_MODEL_SKY_BANDS_IMPL_H

#include "model/build/model.h"
#include "model/geometry/precomputed.h"
#include "model/run/result.h"

/* Radiance of the scattered light behind the satellite through the filter [W/m^2/sr], of every
 * observation and band, out[nobs][nband], for effects that act on observations; NULL
 * where the model uses none of these or nothing is scattered. The caller frees. UM_ERR_MEMORY. */
enum um_status um_model_sky_bands(struct um_context *context, const struct um_model *model,
                                  const struct um_model_precomputed *precomputed,
                                  const struct um_model_result *result, double **out);

#endif
