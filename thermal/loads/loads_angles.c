/* Angular moments of what a surface sees of the Earth past the satellite itself. An unobstructed
 * plate's are known (E_k, of an irradiance E_0); sums over directions of the cap say how what
 * stands in the way moves them,
 *
 *   E_k' = share E_k + E_0 (sum(w L cos P_k free) - share sum(w L cos P_k)) / sum(w L cos)
 *
 * so that those of a surface with nothing before it are the plate's, and with all hidden 0. */

#include "base/core/wide.h"
#include "thermal/loads/loads_impl.h"

#define MOMENTS UM_ANGULAR_MOMENTS

UM_WIDE_VECTORS static void polynomials(struct um_thermal_half *half)
{
  for (size_t k = 0; k < (half->n + 3) / 4 * 4; k++) {
    double p[MOMENTS], cosine = half->cosine[k];
    um_environment_angular_polynomials(cosine < 1.0 ? cosine : 1.0, p);
    for (int m = 0; m < MOMENTS; m++) half->polynomial[m][k] = p[m];
  }
}

/* Four directions side by side. */
typedef double four __attribute__((vector_size(4 * sizeof(double)), aligned(sizeof(double))));

UM_WIDE_VECTORS static void moments(const struct um_thermal_half *half, const double *value,
                                    double out[MOMENTS])
{
  four sum[MOMENTS] = {{0.0}};
  for (size_t k = 0; k < half->n; k += 4)
    for (int m = 0; m < MOMENTS; m++)
      sum[m] += *(const four *)&value[k] * *(const four *)&half->polynomial[m][k];
  for (int m = 0; m < MOMENTS; m++) out[m] = sum[m][0] + sum[m][1] + sum[m][2] + sum[m][3];
}

void um_irradiation_half_by_angle(struct um_thermal_half *half)
{
  half->by_angle = true;
  polynomials(half);
  moments(half, half->reflected, half->moment_albedo);
  moments(half, half->varies ? half->emitted : half->open, half->moment_planet);
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
