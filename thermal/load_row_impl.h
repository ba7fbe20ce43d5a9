/* One row of the heat loads as heat of the nodes. Private to thermal/. */
#ifndef UMBRA_THERMAL_LOAD_ROW_IMPL_H
#define UMBRA_THERMAL_LOAD_ROW_IMPL_H

#include "irradiation/loads.h"
#include "thermal/network_impl.h"
#include "thermal/solve_options.h"

/* Sums over the surfaces of each node [nnode], set:
 *
 *   sun_i    = sum_s w_is A_s (alpha_s - x_s) sun_s          per unit of irradiance [m^2]
 *   albedo_i = sum_s w_is A_s alpha_s albedo_s               [W]
 *   planet_i = sum_s w_is A_s eps_s planet_s                 [W]
 *
 * with x the extraction and alpha, eps those of the row where surfaces age (aging NULL: they do
 * not). */
void um_thermal_load_row_sum(const struct um_thermal_network *network,
                             const struct um_irradiation_loads *loads,
                             const struct um_thermal_aging *aging, size_t row, double *sun,
                             double *albedo, double *planet);
/* Emission to space of the surfaces of each node at that row, added: sigma sum_s w_is A_s eps_s
 * (1 - blocked_s) [W/K^4]. */
void um_thermal_load_row_space_add(const struct um_thermal_network *network,
                                   const struct um_thermal_aging *aging, size_t row, double *space);

/* Rows `low` and `high` around a time and the weight u of the second. */
struct um_thermal_load_interval {
  size_t low, high;
  double u;
};
/* Constant outside of the table. */
struct um_thermal_load_interval
um_thermal_load_interval_find(const struct um_irradiation_loads *loads, double t);

#endif
