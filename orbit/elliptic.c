/* Means a' = (a + b)/2, b' = sqrt(a b), c' = (a - b)/2 from a = 1, b = sqrt m1, c = sqrt m; then
 *   K = pi/(2 a),  phi_N = 2^N a u,  sin(2 phi_(n-1) - phi_n) = (c_n/a_n) sin phi_n,  am u = phi_0,
 *   F(phi) = sin phi R_F(cos^2 phi, 1 - m sin^2 phi, 1)  for |phi| <= pi/2, 2 K more each half
 * turn. R_F by duplication (Carlson 1995, Numer. Algorithms 10:13). */
#include "orbit/elliptic_impl.h"

#include <math.h>

#include "base/core/constants.h"

#define MEANS 12 /* they double their digits each time: enough from m1 = 1e-300 on */
#define EQUAL 1e-16

double um_orbit_elliptic_k(double m1)
{
  double a = 1.0, b = sqrt(m1);
  for (int i = 0; i < MEANS && fabs(a - b) > EQUAL * a; i++) {
    double mean = 0.5 * (a + b);
    b = sqrt(a * b);
    a = mean;
  }
  return 0.5 * UM_PI / a;
}

static double carlson_rf(double x, double y, double z)
{
  double mean = (x + y + z) / 3.0, dx = mean - x, dy = mean - y, apart = 1.0;
  while (fmax(fabs(dx), fmax(fabs(dy), fabs(dx + dy))) * apart > 1e-3 * mean) {
    double l = sqrt(x) * sqrt(y) + sqrt(y) * sqrt(z) + sqrt(z) * sqrt(x);
    x = 0.25 * (x + l);
    y = 0.25 * (y + l);
    z = 0.25 * (z + l);
    mean = 0.25 * (mean + l);
    apart *= 0.25;
  }
  dx *= apart / mean;
  dy *= apart / mean;
  double dz = -dx - dy, e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
  return (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0 -
          5.0 * e2 * e2 * e2 / 208.0 + 3.0 * e3 * e3 / 104.0) /
         sqrt(mean);
}

double um_orbit_elliptic_f(double amplitude, double m1)
{
  double halves = round(amplitude / UM_PI), phi = amplitude - halves * UM_PI;
  double s = sin(phi), c = cos(phi);
  return 2.0 * halves * um_orbit_elliptic_k(m1) + s * carlson_rf(c * c, c * c + m1 * s * s, 1.0);
}

void um_orbit_elliptic_jacobi(double u, double m1, double *sn, double *cn, double *dn)
{
  double a[MEANS + 1] = {1.0}, c[MEANS + 1] = {sqrt(fmax(1.0 - m1, 0.0))}, b = sqrt(m1);
  int n = 0;
  while (n < MEANS && c[n] > EQUAL * a[n]) {
    a[n + 1] = 0.5 * (a[n] + b);
    c[n + 1] = 0.5 * (a[n] - b);
    b = sqrt(a[n] * b);
    n++;
  }
  double phi = ldexp(a[n] * u, n);
  for (; n > 0; n--) phi = 0.5 * (phi + asin(c[n] / a[n] * sin(phi)));
  *sn = sin(phi);
  *cn = cos(phi);
  *dn = sqrt(m1 + (1.0 - m1) * *cn * *cn);
}
