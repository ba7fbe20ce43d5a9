/* Fresnel reflectance of an interface and of an absorbing sheet on an opaque substrate.
 *
 *   eta = n + i k,  q = sqrt(eta^2 - sin^2 theta)
 *   r_s = (cos theta - q)/(cos theta + q),  r_p = (eta^2 cos theta - q)/(eta^2 cos theta + q)
 *   R = (|r_s|^2 + |r_p|^2)/2
 * (Born & Wolf 1999, 1.5 and 14.2). A sheet of thickness d that is many coherence lengths thick is
 * an incoherent sum over its internal passes, for s and p apart (Siegel & Howell 2002, ch. 18):
 *   R = R_01 + (1 - R_01)^2 R_12 t^2 / (1 - R_01 R_12 t^2),  t = exp(-4 pi Im(q) d / lambda)
 * with R_01 the front of the sheet, R_12 the interface below it, t the transmittance of one pass.
 * The loss inside an absorbing interface is neglected in 1 - R_01 (exact for k << n).
 * A film thinner than light is coherent adds amplitudes instead (Airy; Born & Wolf 1999, 1.6.4),
 *   r = (r_01 + r_12 exp(2 i beta)) / (1 + r_01 r_12 exp(2 i beta)),  beta = 2 pi q d / lambda
 * for s and p apart, exact for absorbing films and substrates. */
#include <assert.h>
#include <math.h>

#include "base/core/constants.h"
#include "materials/bsdf.h"

static double complex square(double complex z) { return z * z; }

/* |z|^2 */
static double norm(double complex z) { return creal(z) * creal(z) + cimag(z) * cimag(z); }

/* q = sqrt(eta^2 - sin^2 theta), the branch with Im q >= 0 (decaying into the medium). */
static double complex normal_component(double complex eta, double cos_theta)
{
  double sin2 = (1.0 - cos_theta) * (1.0 + cos_theta);
  double complex q = csqrt(square(eta) - sin2);
  return cimag(q) < 0.0 ? -q : q;
}

static double clamp_cosine(double c) { return c < 0.0 ? 0.0 : (c > 1.0 ? 1.0 : c); }

double um_materials_fresnel(double n, double k, double cos_theta)
{
  double c = clamp_cosine(cos_theta);
  double complex eta = n + k * I, eta2 = square(eta);
  double complex q = normal_component(eta, c);
  double s = norm(c - q) / norm(c + q);
  double p = norm(eta2 * c - q) / norm(eta2 * c + q);
  return 0.5 * (s + p);
}

/* Sum of the passes for one polarisation. */
static double sheet_sum(double front, double below, double pass)
{
  double back = below * pass * pass;
  return front + (1.0 - front) * (1.0 - front) * back / (1.0 - front * back);
}

double um_materials_fresnel_sheet(double n, double k, double thickness, double ns, double ks,
                                  double wavelength, double cos_theta)
{
  assert(thickness >= 0.0 && wavelength > 0.0);
  double c = clamp_cosine(cos_theta);
  if (c == 0.0) return 1.0;
  double complex eta1 = n + k * I, eta2 = ns + ks * I;
  double complex e1 = square(eta1), e2 = square(eta2);
  double complex q1 = normal_component(eta1, c), q2 = normal_component(eta2, c);
  double front_s = norm(c - q1) / norm(c + q1);
  double front_p = norm(e1 * c - q1) / norm(e1 * c + q1);
  double below_s = norm(q1 - q2) / norm(q1 + q2);
  double below_p = norm(e2 * q1 - e1 * q2) / norm(e2 * q1 + e1 * q2);
  double pass = exp(-4.0 * UM_PI * cimag(q1) * thickness / wavelength);
  return 0.5 * (sheet_sum(front_s, below_s, pass) + sheet_sum(front_p, below_p, pass));
}

double um_materials_fresnel_film(double n, double k, double thickness, double ns, double ks,
                                 double wavelength, double cos_theta)
{
  assert(thickness >= 0.0 && wavelength > 0.0);
  double c = clamp_cosine(cos_theta);
  if (c == 0.0) return 1.0;
  double complex e1 = square(n + k * I), e2 = square(ns + ks * I);
  double complex q1 = normal_component(n + k * I, c), q2 = normal_component(ns + ks * I, c);
  double complex pass = cexp(4.0 * UM_PI * I * q1 * thickness / wavelength);
  double complex front_s = (c - q1) / (c + q1), below_s = (q1 - q2) / (q1 + q2) * pass;
  double complex front_p = (e1 * c - q1) / (e1 * c + q1);
  double complex below_p = (e2 * q1 - e1 * q2) / (e2 * q1 + e1 * q2) * pass;
  double s = norm((front_s + below_s) / (1.0 + front_s * below_s));
  double p = norm((front_p + below_p) / (1.0 + front_p * below_p));
  return 0.5 * (s + p);
}
