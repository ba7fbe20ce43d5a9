/* Half vectors that a measured BRDF is sampled by: one distribution of their angle theta_h from the
 * normal for all observers, by an inverse cumulative sum.
 *
 *   p(theta_h) = (1 - w) <f cos_i 4 (o.h)/E(o)>_{o, phi_h} + w cos_h/pi,   dw_i = 4 (o.h) dw_h,
 * the mean over observers of the density that would leave no spread for each of them, with a floor
 * so that a direction that few observers use is never rare. Constant within bins of theta_h =
 * pi/2 s^2: the density is exact whatever the table is. */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/interpolation.h"
#include "materials/measured_impl.h"

#define BINS      UM_MATERIALS_MEASURED_BINS
#define OBSERVERS 12
#define TURNS     16
#define FLOOR     0.1 /* of the half vectors */

static double edge(int bin)
{
  double s = (double)bin / BINS;
  return bin == BINS ? 0.0 : cos(0.5 * UM_PI * s * s);
}

/* Mean of f cos_i 4 (o.h) over the azimuth of h [1/sr]. */
static double around(const struct um_materials_measured *m, double cos_h, double cos_o)
{
  double sin_h = sqrt(1.0 - cos_h * cos_h), sin_o = sqrt(1.0 - cos_o * cos_o), sum = 0.0;
  for (int k = 0; k < TURNS; k++) {
    double cos_d = cos_o * cos_h + sin_o * sin_h * cos(UM_PI * (k + 0.5) / TURNS);
    double cos_i = 2.0 * cos_d * cos_h - cos_o;
    if (!(cos_d > 0.0 && cos_i > 0.0)) continue;
    sum += um_materials_measured_evaluate(m, cos_i, cos_o, cos_d) * cos_i * 4.0 * cos_d;
  }
  return sum / TURNS;
}

void um_materials_measured_shares(struct um_materials_measured *m)
{
  double share[BINS] = {0.0};
  for (int n = 0; n < OBSERVERS; n++) {
    double cos_o = sqrt((n + 0.5) / OBSERVERS), of[BINS], sum = 0.0;
    for (int b = 0; b < BINS; b++) {
      double s = (b + 0.5) / BINS;
      of[b] = around(m, cos(0.5 * UM_PI * s * s), cos_o) * (edge(b) - edge(b + 1));
      sum += of[b];
    }
    for (int b = 0; b < BINS; b++) share[b] += sum > 0.0 ? of[b] / sum / OBSERVERS : 0.0;
  }
  double all = 0.0;
  for (int b = 0; b < BINS; b++) {
    double low = edge(b), high = edge(b + 1);
    share[b] = (1.0 - FLOOR) * share[b] + FLOOR * (low - high) * (low + high);
    all += share[b];
  }
  m->below[0] = 0.0;
  for (int b = 0; b < BINS; b++) {
    m->below[b + 1] = b + 1 < BINS ? m->below[b] + share[b] / all : 1.0;
    m->density[b] = (m->below[b + 1] - m->below[b]) / (2.0 * UM_PI * (edge(b) - edge(b + 1)));
  }
}

double um_materials_measured_draw(const struct um_materials_measured *m, double u)
{
  int low = (int)um_core_interval_find(m->below, BINS + 1, u);
  double t = (u - m->below[low]) / (m->below[low + 1] - m->below[low]);
  return edge(low) + t * (edge(low + 1) - edge(low));
}

double um_materials_measured_half_density(const struct um_materials_measured *m, double cos_h)
{
  if (!(cos_h > 0.0)) return 0.0;
  int bin = (int)(sqrt(acos(fmin(1.0, cos_h)) / (0.5 * UM_PI)) * BINS);
  return m->density[bin < BINS ? bin : BINS - 1];
}
