/* Columns of straight rays upward, N(z, mu) = int n ds / int n dz, are tabulated; a ray that first
 * falls, and passes at the height h of its lowest point, has the column of the whole ray through
 * the limb less that of the rest of it,
 *
 *   N = N_limb(h) - N(z, -mu),   R + h = (R + z) sin chi',
 *
 * chi' the apparent zenith angle of the Sun. Refraction lifts it, chi = chi' + alpha', where of the
 * bending alpha(h) of the whole ray (limb_air.h) a point at the height z beyond its lowest has
 *
 *   alpha' = alpha(h) (1 + erf(sqrt((z - h)/H)))/2,   H = 7.5 km,
 *
 * and one before it the rest: exact for an exponential atmosphere, z - h << R. What arrives is
 * diluted by d chi'/d chi (Link 1969, Eclipse Phenomena in Astronomy, ch. 1). */
#include "environment/slant_air.h"

#include <math.h>
#include <stddef.h>

#include "base/core/constants.h"

#define STEP       (UM_SLANT_TOP / (UM_SLANT_DENSITIES - 1))
#define STEP_UP    1e3    /* [m] between tabulated heights */
#define POINTS     120    /* of an integral upward */
#define SCALE      7500.0 /* [m] */
#define LEAST      1e-300 /* in place of 0 before a logarithm [1] */
#define MOST_BENT  0.04   /* [rad] more than any ray is */
#define HALVINGS   16
#define DIFFERENCE 1e-5 /* [rad] */

double um_environment_slant_density(const struct um_environment_slant *slant,
                                    enum um_environment_limb_constituent which, double height)
{
  double place = fmax(height, 0.0) / STEP;
  if (!(place < UM_SLANT_DENSITIES - 1)) return 0.0;
  size_t k = (size_t)place;
  double x = place - (double)k;
  return (1.0 - x) * slant->density[which][k] + x * slant->density[which][k + 1];
}

/* Way along a ray from height z and cosine u up to another height. */
static double way(double radius, double z, double u, double to)
{
  double r = radius + z, end = radius + to;
  return sqrt(fmax(end * end - r * r * (1.0 - u) * (1.0 + u), 0.0)) - r * u;
}

static void integrate_up(const struct um_environment_slant *slant, double z, double u,
                         double sum[UM_LIMB_CONSTITUENTS])
{
  double before = 0.0;
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) sum[c] = 0.0;
  for (int i = 0; i < POINTS; i++) {
    double x = (i + 1.0) / POINTS, middle = (i + 0.5) / POINTS;
    double after = way(slant->radius, z, u, z + (UM_SLANT_TOP - z) * x * x);
    double at = z + (UM_SLANT_TOP - z) * middle * middle;
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++)
      sum[c] += (after - before) *
                um_environment_slant_density(slant, (enum um_environment_limb_constituent)c, at);
    before = after;
  }
}

void um_environment_slant_make(const struct um_environment_limb_air *air, double radius,
                               struct um_environment_slant *out)
{
  struct um_environment_limb_profile p = um_environment_limb_standard(UM_LIMB_MIDDLE);
  out->air = air;
  out->radius = radius;
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) {
    double whole = 0.0, *n = out->density[c];
    for (int k = 0; k < UM_SLANT_DENSITIES; k++) {
      n[k] = p.density(p.self, (enum um_environment_limb_constituent)c, k * STEP);
      if (k > 0) whole += 0.5 * STEP * (n[k - 1] + n[k]);
    }
    for (int k = 0; k < UM_SLANT_DENSITIES; k++) n[k] /= whole;
  }
  for (int i = 0; i < UM_SLANT_HEIGHTS; i++)
    for (int k = 0; k < UM_SLANT_ANGLES; k++) {
      double u = (double)k / (UM_SLANT_ANGLES - 1), sum[UM_LIMB_CONSTITUENTS];
      integrate_up(out, i * STEP_UP, u * u, sum);
      for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) out->up[c][i][k] = log(fmax(sum[c], LEAST));
    }
}

void um_environment_slant_up(const struct um_environment_slant *slant, double height, double cosine,
                             double column[UM_LIMB_CONSTITUENTS])
{
  double row = fmin(fmax(height / STEP_UP, 0.0), UM_SLANT_HEIGHTS - 1.001);
  double col = sqrt(fmin(fmax(cosine, 0.0), 1.0)) * (UM_SLANT_ANGLES - 1);
  size_t i = (size_t)row, k = (size_t)fmin(col, UM_SLANT_ANGLES - 2);
  double x = row - (double)i, y = col - (double)k;
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) {
    const double *low = slant->up[c][i] + k, *high = slant->up[c][i + 1] + k;
    column[c] = exp((1.0 - x) * ((1.0 - y) * low[0] + y * low[1]) +
                    x * ((1.0 - y) * high[0] + y * high[1]));
  }
}

/* Values over the height of a ray's lowest point: exponential between, and below the ground. */
static double by_height(const double *value, double h)
{
  double place = fmin(fmax(h / UM_LIMB_STEP, 0.0), UM_LIMB_NODES - 1.001);
  size_t k = (size_t)place;
  double x = place - (double)k;
  double v = value[k] > 0.0 && value[k + 1] > 0.0
                 ? exp((1.0 - x) * log(value[k]) + x * log(value[k + 1]))
                 : 0.0;
  return h < 0.0 ? v * exp(fmin(-h / SCALE, 100.0)) : v;
}

/* Bending up to a point at which the ray arrives at an apparent zenith angle. */
static double bent(const struct um_environment_slant *slant, double z, double apparent)
{
  double h = (slant->radius + z) * sin(apparent) - slant->radius;
  double depth = fmax(z - h, 0.0) / SCALE;
  if (apparent <= 0.5 * UM_PI && depth > 60.0) return 0.0;
  double share = apparent > 0.5 * UM_PI ? 1.0 + erf(sqrt(depth)) : erfc(sqrt(depth));
  return 0.5 * share * by_height(slant->air->bending, h);
}

/* chi' of chi = chi' + alpha'(chi'), which ascends. */
static double apparent_of(const struct um_environment_slant *slant, double z, double zenith_angle)
{
  double low = zenith_angle - MOST_BENT, high = zenith_angle;
  if (zenith_angle < 1.2) return zenith_angle; /* 70 deg: less than 3 arc minutes */
  for (int i = 0; i < HALVINGS; i++) {
    double middle = 0.5 * (low + high);
    if (middle + bent(slant, z, middle) > zenith_angle)
      high = middle;
    else
      low = middle;
  }
  return 0.5 * (low + high);
}

bool um_environment_slant_sun(const struct um_environment_slant *slant, double height,
                              double zenith_angle, double column[UM_LIMB_CONSTITUENTS],
                              double *dilution)
{
  double horizon = UM_PI - asin(slant->radius / (slant->radius + fmax(height, 0.0)));
  if (zenith_angle > horizon + MOST_BENT) return false;
  double apparent = apparent_of(slant, height, zenith_angle);
  if (apparent > horizon) return false;
  double slope =
      (bent(slant, height, apparent + DIFFERENCE) - bent(slant, height, apparent)) / DIFFERENCE;
  *dilution = 1.0 / (1.0 + fmax(slope, 0.0));
  um_environment_slant_up(slant, height, fabs(cos(apparent)), column);
  if (apparent <= 0.5 * UM_PI) return true;
  double h = (slant->radius + height) * sin(apparent) - slant->radius;
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++)
    column[c] = fmax(by_height(slant->air->column[c], h) - column[c], 0.0);
  return true;
}
