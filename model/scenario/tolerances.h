/* Tolerances of the integration in time. */
#ifndef UMBRA_MODEL_TOLERANCES_H
#define UMBRA_MODEL_TOLERANCES_H

#include "model/scenario/scenario.h"

/* As thermal states them, else by its accuracy_K: [1], [K]. */
void um_model_tolerances(const struct um_scenario_thermal *thermal, double *relative,
                         double *absolute);

#endif
