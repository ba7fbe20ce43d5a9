/* Loads over a turn of the body. Attitudes at midpoints of n equal parts of the turn,
 *
 *   u_j = P (j + s_k) / n,   s_k = 1/2, or for a mean frac(k (sqrt(5) - 1) / 2 + 1/2),
 *
 * shifted by the golden section from row to row: the error of a row's mean at a kink, where a
 * surface turns into the Sun, is h^2/2 (s^2 - s + 1/6) of the jump in slope, whose mean over shifts
 * is 0. What is absorbed at an angle is not linear in the cosine, so sunlight is kept by cosine. */
#include <math.h>

#include "base/core/golden.h"
#include "thermal/loads/loads_impl.h"

void um_irradiation_spin_node(const struct um_irradiation_spin *spin, size_t k, size_t j, double *u,
                              double *weight)
{
  double n = (double)spin->n, shift = fmod(0.5 + UM_GOLDEN * (double)k, 1.0);
  double share = ((double)j + (spin->variation ? 0.5 : shift)) / n;
  *u = share * spin->period;
  *weight = spin->variation ? spin->period * (share - 0.5) / n : 1.0 / n;
}

/* What a direct load of a cosine adds to the four nodes around it: Lagrange's weights. */
static void spread(float *by_cosine, double cosine, double load)
{
  double x = sqrt(cosine) * (UM_IRRADIATION_COSINES - 1);
  size_t b = x > 1.0 ? (size_t)x - 1 : 0;
  if (b > UM_IRRADIATION_COSINES - 4) b = UM_IRRADIATION_COSINES - 4;
  double v = x - (double)b, w = v - 1.0, y = v - 2.0, z = v - 3.0;
  by_cosine[b] -= (float)(w * y * z / 6.0 * load);
  by_cosine[b + 1] += (float)(v * y * z / 2.0 * load);
  by_cosine[b + 2] -= (float)(v * w * z / 2.0 * load);
  by_cosine[b + 3] += (float)(v * w * y / 6.0 * load);
}

static void add(float *to, double weight, const float *from, size_t n)
{
  for (size_t s = 0; to != NULL && s < n; s++) to[s] += (float)(weight * (double)from[s]);
}

void um_irradiation_spin_add(const struct um_irradiation_loads *loads, size_t k, double weight,
                             const struct um_irradiation_row *one)
{
  struct um_irradiation_row to = um_irradiation_row_of(loads, k);
  size_t n = loads->nsurface;
  float *by_cosine = loads->by_cosine + k * n * UM_IRRADIATION_COSINES;
  add(to.sun, weight, one->sun, n);
  add(to.albedo, weight, one->albedo, n);
  add(to.planet, weight, one->planet, n);
  add(to.view_factor, weight, one->view_factor, n);
  add(to.gas, weight, one->gas, n);
  add(to.albedo_moments, weight, one->albedo_moments, n * UM_ANGULAR_MOMENTS);
  add(to.planet_moments, weight, one->planet_moments, n * UM_ANGULAR_MOMENTS);
  for (size_t s = 0; s < n; s++)
    if (one->sun[s] > 0.0f)
      spread(by_cosine + s * UM_IRRADIATION_COSINES, (double)one->incidence[s],
             weight * (double)one->sun[s]);
}
