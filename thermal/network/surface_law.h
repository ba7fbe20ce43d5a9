/* How a surface's optics go with angle and temperature, as ratios to its numbers in network.h: one
 * for all surfaces of a material. */
#ifndef UMBRA_THERMAL_SURFACE_LAW_H
#define UMBRA_THERMAL_SURFACE_LAW_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "environment/angular_moments.h"

#define UM_THERMAL_LAW_ANGLES       65     /* nodes in the square root of the cosine, 0 to 1 */
#define UM_THERMAL_LAW_TEMPERATURES 641    /* nodes, 0 K to the hottest */
#define UM_THERMAL_LAW_HOTTEST      1280.0 /* [K]; constant beyond */

struct um_thermal_surface_law {
  /* absorptance of sunlight at an angle, and of the albedo, over `absorptance` */
  double absorptance[UM_THERMAL_LAW_ANGLES], albedo;
  double planet; /* absorptance of the Earth's own radiation over `emittance` */
  /* what both add by the angles at which they arrive, where loads say (angular_moments.h): a_1 to
     a_5 of the albedo's over `absorptance`, of the Earth's own radiation over `emittance` */
  bool by_angle;
  double albedo_angle[UM_ANGULAR_MOMENTS], planet_angle[UM_ANGULAR_MOMENTS];
  double emittance[UM_THERMAL_LAW_TEMPERATURES]; /* at a temperature over `emittance` */
};

/* Linear between nodes; law NULL: 1. */
static inline double um_thermal_surface_law_absorptance(const struct um_thermal_surface_law *law,
                                                        double cosine)
{
  if (law == NULL) return 1.0;
  double x = sqrt(fmax(0.0, fmin(1.0, cosine))) * (UM_THERMAL_LAW_ANGLES - 1);
  size_t i = x < UM_THERMAL_LAW_ANGLES - 2 ? (size_t)x : UM_THERMAL_LAW_ANGLES - 2;
  double u = x - (double)i;
  return (1.0 - u) * law->absorptance[i] + u * law->absorptance[i + 1];
}

/* slope: derivative over the temperature [1/K]. */
static inline double um_thermal_surface_law_emittance(const struct um_thermal_surface_law *law,
                                                      double temperature, double *slope)
{
  const double step = UM_THERMAL_LAW_HOTTEST / (UM_THERMAL_LAW_TEMPERATURES - 1);
  *slope = 0.0;
  if (law == NULL) return 1.0;
  double x = temperature / step;
  if (!(x > 0.0)) return law->emittance[0];
  if (x >= UM_THERMAL_LAW_TEMPERATURES - 1) return law->emittance[UM_THERMAL_LAW_TEMPERATURES - 1];
  size_t i = (size_t)x;
  double u = x - (double)i;
  *slope = (law->emittance[i + 1] - law->emittance[i]) / step;
  return (1.0 - u) * law->emittance[i] + u * law->emittance[i + 1];
}

#endif
