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

/* Temperature of all surfaces where heat is not followed and must not show [K]. */
#define UM_MODEL_COLD 3.0

/* Light of instants that stand alone (model/geometry/posed.h), of a body that is cold throughout:
 * sunlight, the Earth's light, light between surfaces where the model has it, moonlight; what
 * bodies emit and what the Earth heats is for bands below 2.5 um no part of what is seen. Errors as
 * above. The caller destroys. */
enum um_status um_model_run_cold_light(struct um_context *context, const struct um_model *model,
                                       const struct um_model_tables *tables,
                                       struct um_optics_lightcurve **out);

#endif
