/* By which angles light arrives at a surface, in six numbers: with u = sqrt(cos theta), radiance L
 * and Jacobi's polynomials of the weight u^3, orthogonal over what a Lambert sky sends,
 *
 *   E_k = int P_k(u) L cos theta dOmega,   P_k(u) = P_k^(0,3)(2 u - 1),   P_0 = 1, P_k(1) = 1
 *
 * E_0 is the irradiance; light that is the same from all sides has no other. Of an absorptance
 *
 *   alpha(theta) = sum_k a_k P_k(u),   a_k = 2 (k + 2) int alpha P_k u^3 du  (0..1)
 *
 * is absorbed sum_k a_k E_k, with a_0 that of light from all sides. Degree 5 keeps what materials
 * of Fresnel's law absorb of the Earth to 1e-4 of what falls on a plate that faces it, below 2000
 * km (test: thermal/loads/angles). */
#ifndef UMBRA_ENVIRONMENT_ANGULAR_MOMENTS_H
#define UMBRA_ENVIRONMENT_ANGULAR_MOMENTS_H

#include <math.h>
#include <stddef.h>

#define UM_ANGULAR_MOMENTS 5 /* E_1 to E_5 */

/* P_1 to P_5 at a cosine of 0 to 1 (Abramowitz & Stegun 1964, 22.3.2). */
static inline void um_environment_angular_polynomials(double cosine, double p[UM_ANGULAR_MOMENTS])
{
  double u = sqrt(cosine);
  p[0] = 5.0 * u - 4.0;
  p[1] = (21.0 * u - 30.0) * u + 10.0;
  p[2] = ((84.0 * u - 168.0) * u + 105.0) * u - 20.0;
  p[3] = (((330.0 * u - 840.0) * u + 756.0) * u - 280.0) * u + 35.0;
  p[4] = ((((1287.0 * u - 3960.0) * u + 4620.0) * u - 2520.0) * u + 630.0) * u - 56.0;
}

/* a_1 to a_5 of values at n nodes of u, evenly from 0 to 1, by Boole's rule (Abramowitz & Stegun
 * 1964, 25.4.14); n - 1 a multiple of 4, above 0. */
void um_environment_angular_project(const double *value, size_t n, double a[UM_ANGULAR_MOMENTS]);

#endif
