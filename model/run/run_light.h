/* Light of a run before air and instrument. */
#ifndef UMBRA_MODEL_RUN_LIGHT_H
#define UMBRA_MODEL_RUN_LIGHT_H

#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/thermal_solution.h"

/* Light toward the observer before air and instrument; *out NULL without an observer. Errors of
 * um_model_run_observed. The caller destroys by um_optics_lightcurve_destroy. */
enum um_status um_model_run_light(struct um_context *context, const struct um_model *model,
                                  const struct um_model_tables *tables,
                                  const struct um_model_thermal_solution *heat,
                                  struct um_optics_lightcurve **out);

#endif
