/* One row of the heat loads as heat of the nodes. Private to thermal/solver/. */
#ifndef UMBRA_THERMAL_LOAD_ROW_IMPL_H
#define UMBRA_THERMAL_LOAD_ROW_IMPL_H

#include "thermal/exchange/exchange_group.h"
#include "thermal/loads/loads.h"
#include "thermal/network/network_group.h"
#include "thermal/network/solve_options.h"

/* Sums over the surfaces of each node [nnode], set:
 *
 *   sun_i    = sum_s w_is A_s (alpha_s - x_s) k_s(theta) sun_s   per unit of irradiance [m^2]
 *   albedo_i = sum_s w_is A_s alpha_s k_s,albedo albedo_s        [W], and by angle
 *   planet_i = sum_s w_is A_s eps_s k_s,planet planet_s          [W], alike (load_angle_group.h)
 *   gas_i    = sum_s w_is A_s gas_s   (NULL where loads have none) [W]
 *
 * with x the extraction, k the surface's law (surface_law.h), theta the angle of incidence, and
 * alpha, eps those of the row where surfaces age (aging NULL: they do not). What other surfaces
 * reflect (exchange NULL: nothing) adds to each load; reflected sunlight comes from all sides, like
 * the albedo, and nothing of it is extracted. */
void um_thermal_load_row_sum(const struct um_thermal_network *network,
                             const struct um_irradiation_loads *loads,
                             const struct um_thermal_aging *aging,
                             const struct um_thermal_exchange *exchange, size_t row, double *sun,
                             double *albedo, double *planet, double *gas);
/* What a surface that is attached takes of each load, per area, nothing reflected; and its shares
 * of light and infrared from all sides. */
struct um_thermal_load_taken {
  double sun, albedo, planet;    /* as above */
  double absorptance, emittance; /* [1] */
};
void um_thermal_load_row_take(const struct um_thermal_network *network,
                              const struct um_irradiation_loads *loads,
                              const struct um_thermal_aging *aging, size_t row, size_t s,
                              struct um_thermal_load_taken *out);
/* Emission to space of share k of a surface at that row without its law [W/K^4]: sigma w A eps
 * (1 - blocked). */
double um_thermal_load_row_emission(const struct um_thermal_network *network,
                                    const struct um_thermal_aging *aging, size_t row,
                                    size_t surface, int k);

/* Rows `low` and `high` around a time and the weight u of the second. */
struct um_thermal_load_interval {
  size_t low, high;
  double u;
};
/* Constant outside of the table. */
struct um_thermal_load_interval
um_thermal_load_interval_find(const struct um_irradiation_loads *loads, double t);

#endif
