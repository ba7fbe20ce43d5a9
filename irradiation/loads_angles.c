/* Angular moments of what a surface sees of the Earth past the satellite itself. An unobstructed
 * plate's are known (E_k, of an irradiance E_0); sums over directions of the cap say how what
 * stands in the way moves them,
 *
 *   E_k' = share E_k + E_0 (sum(w L cos P_k free) - share sum(w L cos P_k)) / sum(w L cos)
 *
 * so that those of a surface with nothing before it are the plate's, and with all hidden 0. */
#include <math.h>

#include "irradiation/loads_impl.h"

#define MOMENTS UM_ANGULAR_MOMENTS

void um_irradiation_half_by_angle(const struct um_thermal_cap *cap, struct um_vec3 normal,
                                  struct um_thermal_half *half)
{
  size_t k = 0;
  half->by_angle = true;
  for (int m = 0; m < MOMENTS; m++) half->moment_albedo[m] = half->moment_planet[m] = 0.0;
  for (size_t i = 0; i < cap->n; i++) {
    double cosine = um_vec3_dot(normal, cap->point[i].direction);
    if (!(cosine > 0.0)) continue;
    double *p = half->polynomial[k];
    double planet = half->weight[k] * (half->varies ? half->emitted[k] : 1.0);
    double albedo = half->weight[k] * half->radiance[k];
    um_environment_angular_polynomials(fmin(cosine, 1.0), p);
    for (int m = 0; m < MOMENTS; m++) {
      half->moment_albedo[m] += albedo * p[m];
      half->moment_planet[m] += planet * p[m];
    }
    k++;
  }
}

void um_irradiation_shares_by_angle(const struct um_thermal_half *half,
                                    const double albedo[UM_ANGULAR_MOMENTS],
                                    const double planet[UM_ANGULAR_MOMENTS],
                                    struct um_thermal_shares *shares)
{
  double emitted = half->varies ? half->longwave : half->planet;
  for (int m = 0; m < MOMENTS; m++) {
    double kept = shares->planet * half->moment_planet[m];
    shares->moved_planet[m] = emitted > 0.0 ? (planet[m] - kept) / emitted : 0.0;
    kept = shares->albedo * half->moment_albedo[m];
    shares->moved_albedo[m] = half->albedo > 0.0 ? (albedo[m] - kept) / half->albedo : 0.0;
  }
}

void um_irradiation_moments_set(const double whole[UM_ANGULAR_MOMENTS], double load, double share,
                                const double moved[UM_ANGULAR_MOMENTS], float *to)
{
  for (int m = 0; m < MOMENTS; m++) to[m] = (float)(share * whole[m] + load * moved[m]);
}
