/* Blankets of published laws (mli_law.h), stated at 300 K. */
#include "thermal/network/mli_law.h"

#include <math.h>

#include "base/core/constants.h"

struct um_thermal_mli_slope um_thermal_mli_doenecke(double factor)
{
  double t = UM_REFERENCE_TEMPERATURE;
  double spacers = 0.000136 / (4.0 * UM_STEFAN_BOLTZMANN * t * t);
  double shields = 0.000121 * pow(t, 0.667);
  return (struct um_thermal_mli_slope){factor * (spacers + shields), spacers / (spacers + shields)};
}

struct um_thermal_mli_slope um_thermal_mli_lockheed(double layers, double density, double emittance)
{
  double t = UM_REFERENCE_TEMPERATURE, black = 4.0 * UM_STEFAN_BOLTZMANN * t * t * t;
  double spacers = 8.95e-8 * pow(density * 1e-2, 2.56) * t / (layers + 1.0); /* [W/m^2/K] */
  double shields = 5.39e-10 * emittance / layers * 4.67 * pow(t, 3.67);
  return (struct um_thermal_mli_slope){(spacers + shields) / black, spacers / (spacers + shields)};
}
