/* Heat through a link that goes with temperature, and its derivatives (equation in
 * temperature_law.h). */
#include <math.h>

#include "thermal/network/link_law_group.h"

#include "base/core/constants.h"

#define COLDEST 1.0 /* [K] of a mean temperature: powers below 0 have no value at 0 K */

/* (t / 300 K)^exponent */
static double power_of(double t, double exponent)
{
  double x = t / UM_REFERENCE_TEMPERATURE;
  if (exponent == 0.0) return 1.0;
  if (exponent == 1.0) return x;
  if (exponent == -2.0) return 1.0 / (x * x);
  return pow(x, exponent);
}

double um_thermal_link_law_ratio(const struct um_thermal_link_law *law, double mean, double *slope)
{
  if (law->table != NULL) return um_thermal_ratio_at(law->table, mean, slope);
  double t = fmax(mean, COLDEST), ratio = 0.0;
  *slope = 0.0;
  for (int k = 0; k < UM_THERMAL_LAW_TERMS; k++) {
    if (law->factor[k] == 0.0) continue;
    double term = law->factor[k] * power_of(t, law->exponent[k]);
    ratio += term;
    if (mean > COLDEST) *slope += law->exponent[k] * term / t;
  }
  return ratio;
}

/* |T|^(power - 1) T (300 K)^(4 - power), odd as T^4 is in system_group.h, and its derivative. */
static double potential(double power, double t, double *slope)
{
  double a = fabs(t);
  if (power == 4.0) {
    *slope = 4.0 * a * a * a;
    return a * a * a * t;
  }
  double root = pow(a, power - 1.0) * pow(UM_REFERENCE_TEMPERATURE, 4.0 - power);
  *slope = power * root;
  return root * t;
}

double um_thermal_link_law_heat(const struct um_thermal_link_law *law, double linear, double fourth,
                                double own, double other, double *out, double *in)
{
  double slope, by_own = linear, by_other = linear;
  double difference = linear * (other - own);
  double ratio = um_thermal_link_law_ratio(law, 0.5 * (own + other), &slope);
  if (fourth != 0.0) {
    double phi = potential(law->power, other, &by_other) - potential(law->power, own, &by_own);
    difference = fourth * phi;
    by_own *= fourth;
    by_other *= fourth;
  }
  *out = ratio * by_own - 0.5 * slope * difference;
  *in = ratio * by_other + 0.5 * slope * difference;
  return ratio * difference;
}
