/* Kept rows of the loads, taken for another network. Private to thermal/solver/. */
#ifndef UMBRA_THERMAL_LOAD_SUMS_IMPL_H
#define UMBRA_THERMAL_LOAD_SUMS_IMPL_H

#include "thermal/solver/load_row_impl.h"
#include "thermal/solver/load_sums.h"

/* What a network has beside them. *out NULL where they do not serve: none, other loads, surfaces on
 * other nodes, or that age. The caller destroys. */
struct um_thermal_load_near;
enum um_status um_thermal_load_near_make(struct um_context *context,
                                         const struct um_thermal_load_sums *sums,
                                         const struct um_thermal_network *network,
                                         const struct um_irradiation_loads *loads,
                                         const struct um_thermal_aging *aging,
                                         const struct um_thermal_exchange *exchange,
                                         struct um_thermal_load_near **out);
/* Accepts NULL, sets NULL. */
void um_thermal_load_near_destroy(struct um_context *context, struct um_thermal_load_near **near);
/* um_thermal_load_row_sum of that network, to rounding. */
void um_thermal_load_near_row(const struct um_thermal_load_near *near,
                              const struct um_thermal_network *network,
                              const struct um_thermal_exchange *exchange, size_t row, double *sun,
                              double *albedo, double *planet);

#endif
