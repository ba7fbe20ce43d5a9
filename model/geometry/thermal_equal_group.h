/* What temperatures hang on, compared number for number. Private to the rooms of model/. */
#ifndef UMBRA_MODEL_THERMAL_EQUAL_GROUP_H
#define UMBRA_MODEL_THERMAL_EQUAL_GROUP_H

#include "model/geometry/tables.h"
#include "thermal/network/solve_options.h"

/* NULL: none, here and below. */
bool um_model_loads_equal(const struct um_irradiation_loads *a,
                          const struct um_irradiation_loads *b);
bool um_model_mirror_classes_equal(const struct um_geometry_mirrors *a,
                                   const struct um_geometry_mirrors *b);
bool um_model_view_factors_equal(const struct um_geometry_view_factor_table *a,
                                 const struct um_geometry_view_factor_table *b);
/* Instants of the observations and where the heat begins. */
bool um_model_times_equal(const struct um_model_tables *a, const struct um_model_tables *b);
/* Tolerances and switches. */
bool um_model_heat_options_equal(const struct um_thermal_solve_options *a,
                                 const struct um_thermal_solve_options *b);

#endif
