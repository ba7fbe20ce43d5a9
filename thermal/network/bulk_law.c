/* Capacities and conduction of a wall or solid that go with temperature:
 *
 *   C(T) = C r_C(T) (1 + k (T - 300 K)),   K(T_m) = K r_k(T_m),
 *
 * r the ratios of its material, k a slope on top of them, T_m the mean of a link's ends, which is
 * exact to second order in their difference, as the elements are. */
#include <math.h>

#include "thermal/network/builder_impl.h"

#include "base/core/constants.h"

#define LEAST 0.05 /* what a slope leaves of a capacity [1] */

enum um_status um_thermal_bulk_laws(struct um_thermal_builder *b,
                                    const struct um_thermal_bulk_law *law,
                                    struct um_thermal_bulk_index *out)
{
  *out = (struct um_thermal_bulk_index){UM_THERMAL_NO_LAW, UM_THERMAL_NO_LAW};
  if (law->capacity != NULL || law->capacity_slope != 0.0) {
    struct um_thermal_ratio ratio;
    for (size_t k = 0; k < UM_THERMAL_LAW_TEMPERATURES; k++) {
      double t = (double)k * UM_THERMAL_LAW_STEP;
      ratio.at[k] = fmax(LEAST, 1.0 + law->capacity_slope * (t - UM_REFERENCE_TEMPERATURE));
      if (law->capacity != NULL) ratio.at[k] *= law->capacity->at[k];
    }
    UM_TRY(um_thermal_network_capacity_law_add(b->network, &ratio, &out->capacity));
  }
  if (law->conductivity == NULL) return UM_OK;
  const struct um_thermal_link_law link = {.power = 4.0, .table = law->conductivity};
  return um_thermal_network_link_law_add(b->network, &link, &out->conduction);
}

enum um_status um_thermal_bulk_conductor(struct um_thermal_builder *b,
                                         const struct um_thermal_bulk_index *law, uint32_t one,
                                         uint32_t other, double conductance)
{
  UM_TRY(um_thermal_network_conductor_add(b->network, one, other, conductance));
  if (law->conduction != UM_THERMAL_NO_LAW)
    um_thermal_network_conductor_follow(b->network, law->conduction);
  return UM_OK;
}

enum um_status um_thermal_bulk_capacity(struct um_thermal_builder *b,
                                        const struct um_thermal_bulk_index *law, uint32_t node,
                                        double capacity)
{
  if (law->capacity == UM_THERMAL_NO_LAW || !(capacity > 0.0)) return UM_OK;
  return um_thermal_network_capacity_follow(b->network, node, capacity, law->capacity);
}
