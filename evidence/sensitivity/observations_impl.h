/* Observations from measurements and a first run. Private to evidence/sensitivity/. */
#ifndef UMBRA_SENSITIVITY_OBSERVATIONS_IMPL_H
#define UMBRA_SENSITIVITY_OBSERVATIONS_IMPL_H

#include "evidence/comparison/predict.h"
#include "evidence/sensitivity/observations.h"

/* Observations in use of the plan's measurements. predicted: [rows of the set] what the scenario as
 * it stands says of them, in their unit; result: the run that it is of. UM_ERR_INPUT naming file
 * and line: an observation without sigma that the scenario's noise model does not fill. The caller
 * releases, after an error too. */
enum um_status um_sensitivity_observations_create(struct um_context *context,
                                                  const struct um_compare_plan *plan,
                                                  const struct um_scenario *scenario,
                                                  const struct um_model_result *result,
                                                  const double *predicted,
                                                  struct um_sensitivity_observations *out);
void um_sensitivity_observations_release(struct um_context *context,
                                         struct um_sensitivity_observations *observations);

#endif
