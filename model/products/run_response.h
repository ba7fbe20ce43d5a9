/* How a run answers to small changes of heat and temperature. */
#ifndef UMBRA_MODEL_RUN_RESPONSE_H
#define UMBRA_MODEL_RUN_RESPONSE_H

#include "model/build/model.h"
#include "model/run/result.h"
#include "model/run/thermal_solution.h"
#include "thermal/tangent/sensitivity.h"

/* um_model_run_with with the light of every surface made at its temperature plus offset[nsurface]
 * [K], for derivatives. Nodes and their places stay as they are, means of materials move along. */
enum um_status um_model_run_warmer(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_model_thermal_solution *heat,
                                   const double *offset, struct um_model_result **out);
/* How node temperatures answer to small heat from the first instant of the geometry tables
 * on, along this history: um_thermal_sensitivity to pulses[npulse] at the geometry tables'
 * instants [nobs * nsub], steps held to `tolerance` [1]; 0: the default. UM_ERR_INPUT for points.
 */
enum um_status um_model_thermal_solution_response(struct um_context *context,
                                                  const struct um_model_thermal_solution *heat,
                                                  const struct um_thermal_pulse *pulse,
                                                  size_t npulse, double tolerance,
                                                  um_thermal_sensitivity_take *take, void *user);

#endif
