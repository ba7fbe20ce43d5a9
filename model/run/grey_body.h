/* What an infrared observer concludes from a run. */
#ifndef UMBRA_MODEL_GREY_BODY_H
#define UMBRA_MODEL_GREY_BODY_H

#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"

/* Grey bodies of every observation, result->grey_body, from measured_intensity in the thermal bands
 * (um_model_band_is_thermal); nothing with fewer than three. A band is weighed by the error that
 * the scenario states for its rows without sigma (measurements.noise of radiant_intensity or
 * band_irradiance), else 1 % of its light, in quadrature with the run's standard error. One grey
 * body from three bands on, two from five. UM_ERR_MEMORY, UM_ERR_CANCELLED. */
enum um_status um_model_run_grey_bodies(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables,
                                        struct um_model_result *result);

/* Errors of temperature [K] and area [m^2] of the one grey body of observation k where the bands
 * have the errors of their intensities `error` [nband of the result] [W/sr], to first order; NaN
 * where there is none. UM_ERR_MEMORY. */
enum um_status um_model_grey_body_error(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables,
                                        const struct um_model_result *result, size_t k,
                                        const double *error, double *temperature, double *area);

#endif
