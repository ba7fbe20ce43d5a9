/* The schema table of a scenario. */
#ifndef UMBRA_MODEL_SCENARIO_SCHEMA_H
#define UMBRA_MODEL_SCENARIO_SCHEMA_H

#include "base/document/schema.h"

extern const struct um_schema_object um_model_scenario_schema;

#endif
