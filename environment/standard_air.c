/* Layers of constant lapse rate L in geopotential height H = r0 z/(r0 + z),
 *
 *   T = T_b + L (H - H_b),   p = p_b (T_b/T)^(g0 M/(R L)),  or  p_b exp(-g0 M (H - H_b)/(R T_b)),
 *   rho = p M/(R T). */
#include "environment/standard_air.h"

#include <math.h>
#include <stddef.h>

#define GEOPOTENTIAL_RADIUS 6356766.0                       /* r0 [m] */
#define HYDROSTATIC         (9.80665 * 0.0289644 / 8.31432) /* g0 M/R [K/m] */
#define GAS                 (0.0289644 / 8.31432)           /* M/R [kg K/J] */
#define HIGHEST             86e3                            /* [m] */
#define SCALE_ABOVE         5.4e3                           /* [m] */

struct layer {
  double base, temperature, lapse, pressure; /* [m], [K], [K/m], [Pa] */
};

static const struct layer layers[] = {
    {0.0, 288.15, -6.5e-3, 101325.0}, {11e3, 216.65, 0.0, 22632.06},
    {20e3, 216.65, 1e-3, 5474.889},   {32e3, 228.65, 2.8e-3, 868.0187},
    {47e3, 270.65, 0.0, 110.9063},    {51e3, 270.65, -2.8e-3, 66.93887},
    {71e3, 214.65, -2e-3, 3.956420},
};

static double below(double height)
{
  double h = GEOPOTENTIAL_RADIUS * height / (GEOPOTENTIAL_RADIUS + height);
  size_t k = sizeof layers / sizeof layers[0] - 1;
  while (k > 0 && h < layers[k].base) k--;
  const struct layer *l = &layers[k];
  double t = l->temperature + l->lapse * (h - l->base);
  double p = l->lapse == 0.0 ? exp(-HYDROSTATIC * (h - l->base) / l->temperature)
                             : pow(l->temperature / t, HYDROSTATIC / l->lapse);
  return l->pressure * p * GAS / t;
}

double um_environment_standard_air_density(double height)
{
  if (height <= HIGHEST) return below(height);
  return below(HIGHEST) * exp(-(height - HIGHEST) / SCALE_ABOVE);
}

double um_environment_refractivity(double wavelength)
{
  double um = fmax(wavelength * 1e6, 0.23), s2 = 1.0 / (um * um);
  return 1e-8 * (5792105.0 / (238.0185 - s2) + 167917.0 / (57.362 - s2));
}
