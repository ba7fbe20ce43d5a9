/* How what is stored and what is conducted go with temperature: ratios to the numbers that a
 * network states at UM_REFERENCE_TEMPERATURE, one for all nodes or links of a material or blanket.
 */
#ifndef UMBRA_THERMAL_TEMPERATURE_LAW_H
#define UMBRA_THERMAL_TEMPERATURE_LAW_H

#include <stddef.h>
#include <stdint.h>

#include "thermal/network/surface_law.h"

#define UM_THERMAL_LAW_STEP                                                                        \
  (UM_THERMAL_LAW_HOTTEST / (UM_THERMAL_LAW_TEMPERATURES - 1)) /* [K] between nodes of a table */
#define UM_THERMAL_LAW_TERMS 2
#define UM_THERMAL_NO_LAW    UINT32_MAX

/* A ratio [1] at temperatures from 0 K, as in a surface law: linear between, constant beyond. */
struct um_thermal_ratio {
  double at[UM_THERMAL_LAW_TEMPERATURES];
};

/* A link by temperature. With T_m the mean of its ends, the heat from b to a is
 *
 *   value r(T_m) (phi(T_b) - phi(T_a)),
 *   r = sum_k factor_k (T_m / 300 K)^exponent_k, or a table at T_m,
 *   phi = T of a conductor; T^power (300 K)^(4 - power) times sigma of a radiator. */
struct um_thermal_link_law {
  double power; /* of a radiator, 4 for black bodies [1] */
  double factor[UM_THERMAL_LAW_TERMS], exponent[UM_THERMAL_LAW_TERMS]; /* [1] */
  const struct um_thermal_ratio *table; /* in place of the terms; NULL: they hold */
};

/* slope: derivative over the temperature [1/K]. */
static inline double um_thermal_ratio_at(const struct um_thermal_ratio *ratio, double temperature,
                                         double *slope)
{
  double x = temperature / UM_THERMAL_LAW_STEP;
  *slope = 0.0;
  if (!(x > 0.0)) return ratio->at[0];
  if (x >= UM_THERMAL_LAW_TEMPERATURES - 1) return ratio->at[UM_THERMAL_LAW_TEMPERATURES - 1];
  size_t i = (size_t)x;
  double u = x - (double)i;
  *slope = (ratio->at[i + 1] - ratio->at[i]) / UM_THERMAL_LAW_STEP;
  return (1.0 - u) * ratio->at[i] + u * ratio->at[i + 1];
}

#endif
