/* The environment as the scenario writes it. Private to model/build/. */
#ifndef UMBRA_MODEL_SCENARIO_ENVIRONMENT_IMPL_H
#define UMBRA_MODEL_SCENARIO_ENVIRONMENT_IMPL_H

#include "environment/environment.h"
#include "model/scenario/scenario.h"

/* The scenario's keys as they stand, without effects. */
void um_model_scenario_environment(const struct um_scenario *scenario, struct um_environment *to);

#endif
