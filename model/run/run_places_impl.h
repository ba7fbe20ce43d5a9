/* Places of a run. Private to model/run/. */
#ifndef UMBRA_MODEL_RUN_PLACES_IMPL_H
#define UMBRA_MODEL_RUN_PLACES_IMPL_H

#include "model/run/result.h"
#include "model/run/thermal_solution_group.h"

/* Histories of places and materials. */
enum um_status um_model_run_histories(struct um_context *context, const struct um_model *model,
                                      const struct um_model_precomputed *precomputed,
                                      const struct um_model_thermal_solution *heat,
                                      struct um_model_result *result);
/* Heat of all nodes of a place by its shares of them, mean over the exposure. */
enum um_status um_model_run_heat(struct um_context *context, const struct um_model *model,
                                 const struct um_model_precomputed *precomputed,
                                 const struct um_model_thermal_solution *heat,
                                 struct um_model_result *result);

#endif
