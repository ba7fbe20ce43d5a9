/* Parts of a run. Private to model/run/. */
#ifndef UMBRA_MODEL_RUN_PARTS_IMPL_H
#define UMBRA_MODEL_RUN_PARTS_IMPL_H

#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"
#include "model/run/thermal_solution_group.h"

/* Every material whose record states a range and that leaves it at an observation: a warning, or
 * with thermal.outside_range: error UM_ERR_NUMERIC, with part, time and range. */
enum um_status um_model_check_record_ranges(struct um_context *context,
                                            const struct um_model *model,
                                            const struct um_model_tables *tables,
                                            const struct um_model_result *result);

/* Histories of places and materials. */
enum um_status um_model_run_histories(struct um_context *context, const struct um_model *model,
                                      const struct um_model_tables *tables,
                                      const struct um_model_thermal_solution *heat,
                                      struct um_model_result *result);
/* Heat of all nodes of a place by its shares of them, mean over the exposure. */
enum um_status um_model_run_heat(struct um_context *context, const struct um_model *model,
                                 const struct um_model_tables *tables,
                                 const struct um_model_thermal_solution *heat,
                                 struct um_model_result *result);

/* Radiance of the scattered light behind the satellite through the filter [W/m^2/sr], of every
 * observation and band, out[nobs][nband], for effects that act on observations; NULL
 * where the model uses none of these or nothing is scattered. The caller frees. UM_ERR_MEMORY. */
enum um_status um_model_sky_bands(struct um_context *context, const struct um_model *model,
                                  const struct um_model_tables *tables,
                                  const struct um_model_result *result, double **out);

#endif
