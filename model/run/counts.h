/* Exposures of a run's sensors. Nothing here fails. */
#ifndef UMBRA_MODEL_COUNTS_H
#define UMBRA_MODEL_COUNTS_H

#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"

/* Observation k through sensor s: electrons and signal-to-noise of one exposure. What is not known
 * (hidden, no pixels) is NaN. */
struct um_instrument_exposure um_model_expose(const struct um_model *model,
                                              const struct um_model_tables *tables,
                                              const struct um_model_result *result, size_t k,
                                              size_t s);
/* Electrons of a pixel of sensor s beside the source, in an exposure of observation k; NaN without
 * pixels. */
double um_model_pixel_background(const struct um_model *model, const struct um_model_tables *tables,
                                 const struct um_model_result *result, size_t k, size_t s);
/* Relative scintillation of that exposure [1]; NaN from space, at the horizon, and without an
 * exposure. */
double um_model_scintillation(const struct um_model *model, const struct um_model_tables *tables,
                              size_t k, size_t s);
/* Bins of a band of the result with what passes of each; efficiency NULL: the filter alone.
 * Borrowed. */
struct um_instrument_bins um_model_bins(const struct um_model_result *result, size_t band,
                                        const double *efficiency);

#endif
