/* Keys of scenario.yaml: limits of temperatures, and the cases that are held against them. */
#include "model/scenario/scenario_schema_group.h"

#define OF struct um_scenario_limit
static const struct um_schema_field limit_fields[] = {
    F(of, UM_SCHEMA_TEXT, NAME, REQUIRED,
      HELP("place, as temperatures.csv calls it: a part, side, group or interior")),
    F(minimum_K, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 5000),
      HELP("no part of it may be colder")),
    F(maximum_K, UM_SCHEMA_NUMBER, NO_DEFAULT, BETWEEN(0, 5000),
      HELP("no part of it may be warmer")),
    F(uncertainty_K, UM_SCHEMA_NUMBER, DEFAULT(0.0), BETWEEN(0, 1000),
      HELP("of what is computed: taken from both margins")),
};
#undef OF
SHARED_OBJECT(um_model_limit_schema, struct um_scenario_limit, "limit",
              "Between which temperatures a place must stay.", FIELDS(limit_fields));
static const char *const analysis_choices[] = {"transient", "orbit_mean", "steady", NULL};
#define OF struct um_scenario_case
static const struct um_schema_field case_fields[] = {
    F(analysis, UM_SCHEMA_CHOICE, DEFAULT(0), .choices = analysis_choices,
      HELP("transient: extremes from the first observation to the last; orbit_mean: balance under "
           "heat averaged over an orbit; steady: balance under the heat of the first observation")),
    F(set, UM_SCHEMA_TEXTS, MOST(1000), HELP("changes, KEY=VALUE as --set takes them")),
    F(with, UM_SCHEMA_TEXTS, MOST(1000), HELP("effects, as --with takes them")),
    F(without, UM_SCHEMA_TEXTS, MOST(1000), HELP("effects, as --without takes them")),
};
#undef OF
SHARED_OBJECT(um_model_case_schema, struct um_scenario_case, "case",
              "A variant of the scenario whose temperatures are held against the limits.",
              FIELDS(case_fields));
