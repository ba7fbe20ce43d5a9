/* Temperatures of a body that turns faster than its walls follow, over loads that are means over
 * the turn (um_irradiation_spin): bounds of their variation within one, and that variation. */
#ifndef UMBRA_THERMAL_SPIN_VARIATION_H
#define UMBRA_THERMAL_SPIN_VARIATION_H

#include "thermal/loads/loads.h"
#include "thermal/network/network.h"
#include "thermal/network/solve_options.h"

struct um_thermal_spin_variation {
  double amplitude; /* half the largest variation of a node within a turn [K] */
  double error;  /* what of it um_thermal_spin_variation_add leaves wrong in the worst node [K] */
  uint32_t node; /* that node */
};

/* Bounds for a turn of `period` [s] in sunlight of `sun` [W/m^2] over an Earth that reflects
 * `albedo` of it and emits `longwave` [W/m^2]. A node of capacity C that takes q from its surfaces
 * varies by
 *
 *   a = 0.55 q P / (2 pi C),   0.55 q: a surface that turns through the Sun, half a wave of cosine;
 *
 * what it gives away meanwhile, G = K + 4 sigma R T^3 at 300 K over all its links and to space,
 * changes that by a share of G P / (2 pi C), in the variation at the start and in that of an
 * instant, and the mean by 3/4 a^2 / T, since T^4 is not linear: error is the sum. Infinite for
 * what absorbs and has no capacity. UM_ERR_MEMORY. Test: thermal/solver/spin_variation. */
enum um_status um_thermal_spin_variation_bound(struct um_context *context,
                                               const struct um_thermal_network *network,
                                               double period, double sun, double albedo,
                                               double longwave,
                                               struct um_thermal_spin_variation *out);
/* Add to temperatures [nnode] factor times the variation of the nodes at a row of such a table:
 * variation_i / C_i, variation_i the sum over its surfaces as of any load. Nothing where a node has
 * no capacity. Light that other surfaces reflect is left out. UM_ERR_MEMORY. */
enum um_status um_thermal_spin_variation_add(struct um_context *context,
                                             const struct um_thermal_network *network,
                                             const struct um_irradiation_loads *variation,
                                             const struct um_thermal_solve_options *options,
                                             size_t row, double factor, double *temperature);

#endif
