/* Black-body radiation.
 *
 *   B_lambda = c1L / lambda^5 / (exp(C2 / (lambda T)) - 1)
 *   F(0 -> lambda T) = 15/pi^4 sum_m exp(-m z) (z^3/m + 3 z^2/m^2 + 6 z/m^3 + 6/m^4), z =
 * C2/(lambda T) (Chang & Rhee 1984) for small z the complement by the power series of x^3/(e^x - 1)
 * (Bernoulli numbers). */
#include "base/core/planck.h"

#include <math.h>

#include "base/core/constants.h"

double um_core_planck_radiance(double wavelength, double temperature)
{
  if (!(temperature > 0.0)) return 0.0;
  double z = UM_RADIATION_C2 / (wavelength * temperature);
  double l2 = wavelength * wavelength;
  return UM_RADIATION_C1L / (l2 * l2 * wavelength) / expm1(z);
}

double um_core_planck_temperature(double wavelength, double radiance)
{
  double l2 = wavelength * wavelength;
  if (!(radiance > 0.0)) return 0.0;
  return UM_RADIATION_C2 / wavelength / log1p(UM_RADIATION_C1L / (l2 * l2 * wavelength * radiance));
}

/* int_z^inf x^n/(e^x - 1) dx, n = 2 or 3, for z >= 1; the m-th term falls like exp(-m z). */
static double debye_tail(double z, int n)
{
  double sum = 0.0;
  for (int m = 1; m < 64; m++) {
    double i = 1.0 / m;
    double square = z * z + i * (2.0 * z + 2.0 * i); /* of x^2 */
    double term = exp(-m * z) * i * (n == 2 ? square : z * z * z + 3.0 * i * square);
    sum += term;
    if (term < 1e-17 * sum) break;
  }
  return sum;
}

/* int_0^z x^n/(e^x - 1) dx for z < 2: z^n (1/n - z/(2 (n + 1)) + sum_k B_2k z^2k / ((2k + n)
 * (2k)!)), which converges for z < 2 pi. */
static double debye_head(double z, int n)
{
  static const double bernoulli[] = {1.0 / 6.0,         -1.0 / 30.0,      1.0 / 42.0,
                                     -1.0 / 30.0,       5.0 / 66.0,       -691.0 / 2730.0,
                                     7.0 / 6.0,         -3617.0 / 510.0,  43867.0 / 798.0,
                                     -174611.0 / 330.0, 854513.0 / 138.0, -236364091.0 / 2730.0};
  double sum = 1.0 / n - z / (2.0 * (n + 1.0));
  double power = 1.0, factorial = 1.0;
  for (int k = 1; k <= 12; k++) {
    power *= z * z;
    factorial *= (2.0 * k - 1.0) * (2.0 * k);
    sum += bernoulli[k - 1] * power / ((2.0 * k + n) * factorial);
  }
  return (n == 2 ? z * z : z * z * z) * sum;
}

#define DEBYE_SPLIT 1.5 /* z where head and tail meet */

/* int_0^inf x^n/(e^x - 1) dx: 2 zeta(3) and pi^4/15 */
static double debye_total(int n)
{
  return n == 2 ? 2.4041138063191885 : UM_PI * UM_PI * UM_PI * UM_PI / 15.0;
}

double um_core_planck_fraction(double lambda_t)
{
  if (!(lambda_t > 0.0)) return 0.0;
  double z = UM_RADIATION_C2 / lambda_t;
  return z < DEBYE_SPLIT ? 1.0 - debye_head(z, 3) / debye_total(3)
                         : debye_tail(z, 3) / debye_total(3);
}

/* int_z1^z2 x^n/(e^x - 1) dx, z1 < z2, without the cancellation of fractions near 1. */
static double debye_between(double z1, double z2, int n)
{
  if (z2 < DEBYE_SPLIT) return debye_head(z2, n) - debye_head(z1, n);
  if (z1 >= DEBYE_SPLIT) return debye_tail(z1, n) - debye_tail(z2, n);
  return debye_total(n) - debye_head(z1, n) - debye_tail(z2, n);
}

double um_core_planck_band(double from, double to, double temperature)
{
  if (!(temperature > 0.0)) return 0.0;
  double t4 = temperature * temperature * temperature * temperature;
  double z1 = UM_RADIATION_C2 / (to * temperature), z2 = UM_RADIATION_C2 / (from * temperature);
  /* L = c1L (T/C2)^4 int x^3/(e^x - 1) dx */
  double c2 = UM_RADIATION_C2;
  return UM_RADIATION_C1L * t4 / (c2 * c2 * c2 * c2) * debye_between(z1, z2, 3);
}

double um_core_planck_band_slope(double from, double to, double temperature)
{
  if (!(temperature > 0.0)) return 0.0;
  /* L = c T^4 D(z1, z2), z = C2/(lambda T), dz/dT = -z/T, d/dz of the tail is -x^3/(e^x - 1):
   * dL/dT = 4 L/T + c T^3 (g(z1) - g(z2)), g(z) = z^4/(e^z - 1) */
  double z1 = UM_RADIATION_C2 / (to * temperature), z2 = UM_RADIATION_C2 / (from * temperature);
  double g1 = z1 * z1 * z1 * z1 / expm1(z1), g2 = z2 * z2 * z2 * z2 / expm1(z2);
  double c2 = UM_RADIATION_C2, t3 = temperature * temperature * temperature;
  return 4.0 * um_core_planck_band(from, to, temperature) / temperature +
         UM_RADIATION_C1L * t3 / (c2 * c2 * c2 * c2) * (g1 - g2);
}

double um_core_planck_band_photons(double from, double to, double temperature)
{
  if (!(temperature > 0.0)) return 0.0;
  double z1 = UM_RADIATION_C2 / (to * temperature), z2 = UM_RADIATION_C2 / (from * temperature);
  double s = temperature / UM_RADIATION_C2;
  /* 2 c (T/C2)^3 int x^2/(e^x - 1) dx */
  return 2.0 * UM_LIGHT_SPEED * s * s * s * debye_between(z1, z2, 2);
}
