/* A satellite in the shadow sees the limb's air at twilight. A line of sight whose lowest point is
 * at height h, seen from the distance r at nadir angle eta, r sin(eta) = R + h, brings
 *
 *   L = E_0 sum_c P_c(Theta) int k_c w_c D exp(-tau_sun - tau) ds,
 *
 * k_c the extinction by constituent c, w_c the share of it that scatters, P_c its phase function, D
 * and tau_sun what refraction and extinction leave of the Sun's ray to that point (slant_air.h),
 * tau from there to the satellite. Theta, between the Sun and the line of sight, is the same all
 * along it. A surface that faces the Sun gets
 *
 *   E/E_0 = int L/E_0 cos(Theta) dOmega = 2 int_0^pi cos(Theta) cot(psi)/r l(phi) dphi,
 *
 * psi = pi/2 - eta, phi the azimuth from the Sun, l = int L/E_0 dh. Of any other surface that sees
 * the whole bright arc it is the same times the cosine to the mean direction of the light, for
 * which that of the Sun is taken. With the Sun delta below the limb
 *
 *   cos(chi) = -cos(psi) sin(psi + delta) + sin(psi) cos(psi + delta) cos(phi),
 *   cos(Theta) = sin(psi) sin(psi + delta) + cos(psi) cos(psi + delta) cos(phi),
 *
 * chi the zenith angle of the Sun at the lowest point. l without P_c is tabulated by chi and by
 * cos(A), A the azimuth there, sin(chi) cos(A) = cos(Theta).
 *
 * Clouds: of the Sun's ray the clear share of its lowest point arrives (shadow_light.c), of a line
 * of sight that of its own lowest point from beyond it, and that of the point itself before. What
 * clouds and ground send themselves is left out: the Sun is down there.
 *
 * Light that is scattered more than once is left out: by sky_orders.c it adds 3 to 8 % in blue and
 * 1 to 5 % in red light. */
#include "environment/umbra_scatter.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/quadrature_impl.h"
#include "environment/shadow_impl.h"
#include "environment/shadow_light.h"
#include "environment/sky_light_impl.h"
#include "environment/slant_air.h"

#define WAVES   UM_UMBRA_SCATTER_WAVES
#define SUNS    UM_UMBRA_SCATTER_SUNS
#define TURNS   UM_UMBRA_SCATTER_TURNS
#define KINDS   UM_UMBRA_SCATTER_KINDS
#define TOP     100e3          /* of the air [m] */
#define HEIGHTS 28             /* of lines of sight */
#define STEPS   48             /* on each */
#define ROWS    41             /* of heights that the Sun lights */
#define COLUMNS 181            /* of its zenith angles */
#define LOWEST  (82 * UM_DEG)  /* of these [rad] */
#define HIGHEST (118 * UM_DEG) /* [rad] */
#define FIRST   (90 * UM_DEG)  /* of chi [rad] */
#define LAST    (106 * UM_DEG) /* [rad] */
#define DARK    -200.0         /* ln of nothing */

static const double waves[WAVES] = {0.30e-6,  0.33e-6, 0.37e-6, 0.42e-6, 0.48e-6, 0.53e-6, 0.575e-6,
                                    0.605e-6, 0.65e-6, 0.72e-6, 0.88e-6, 1.20e-6, 2.00e-6};

/* --- what the air holds --------------------------------------------------------------------- */

static void amounts_of(const struct um_environment *e, double amount[UM_LIMB_CONSTITUENTS],
                       double *cloud_top)
{
  double dobson = e->ozone_dobson, cloud = e->cloud_top;
  if (isnan(dobson)) dobson = um_environment_limb_zone_ozone(UM_LIMB_MIDDLE);
  if (isnan(cloud)) cloud = um_environment_limb_zone_cloud(UM_LIMB_MIDDLE);
  amount[UM_LIMB_AIR] = e->air_factor;
  amount[UM_LIMB_OZONE] = e->ozone_factor * dobson;
  amount[UM_LIMB_HAZE] = e->haze;
  amount[UM_LIMB_AEROSOL] = e->aerosol;
  *cloud_top = cloud + e->cloud_shift;
}

bool um_environment_umbra_scatter_is_of(const struct um_environment_umbra_scatter *scatter,
                                        const struct um_environment *environment)
{
  double amount[UM_LIMB_CONSTITUENTS], cloud_top;
  amounts_of(environment, amount, &cloud_top);
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++)
    if (!(amount[c] == scatter->amount[c])) return false;
  return cloud_top == scatter->cloud_top && environment->shadow_radius == scatter->radius;
}

/* --- lines of sight ------------------------------------------------------------------------- */

struct point {
  double height, along; /* of a point on a line of sight, and from its lowest point, sunward [m] */
  double seen[KINDS][WAVES]; /* k w exp(-tau) ds dh of it [m] */
};

struct work {
  struct um_environment_slant slant;
  double depth[WAVES][UM_LIMB_CONSTITUENTS]; /* vertical optical depths */
  double sun[WAVES][ROWS][COLUMNS];          /* ln of tau_sun */
  double arrives[ROWS][COLUMNS];             /* D times clear sight */
  struct point point[HEIGHTS][STEPS];
  double lowest[HEIGHTS]; /* of the lines of sight [m] */
};

/* Height of the lowest point of the Sun's ray, of which the air's column is known: heights descend
 * by as much as columns grow. */
static double lowest_of(const struct um_environment_limb_air *air, double column, double least)
{
  const double *n = air->column[UM_LIMB_AIR];
  int k = 0;
  while (k + 2 < UM_LIMB_NODES && n[k + 1] > column) k++;
  double x = log(n[k] / fmax(column, 1e-12)) / log(n[k] / n[k + 1]);
  return fmin(air->height[k] + x * (air->height[k + 1] - air->height[k]), least);
}

/* What arrives of the Sun; where the Earth is in the way, the depths are the last that were lit. */
static void light_points(const struct um_environment_umbra_scatter *of, struct work *w)
{
  for (int i = 0; i < ROWS; i++)
    for (int k = 0; k < COLUMNS; k++) {
      double x = (double)i / (ROWS - 1), z = TOP * x * x, dilution = 0.0;
      double chi = LOWEST + k * (HIGHEST - LOWEST) / (COLUMNS - 1);
      double column[UM_LIMB_CONSTITUENTS] = {0.0}, rest[UM_LIMB_CONSTITUENTS];
      bool lit = um_environment_slant_sun(&w->slant, z, chi, column, &dilution);
      double low = z;
      if (lit && chi > 0.5 * UM_PI) {
        /* the whole ray through the limb, of which the rest is beyond the point */
        um_environment_slant_up(&w->slant, z, -cos(chi), rest);
        low = lowest_of(w->slant.air, column[UM_LIMB_AIR] + rest[UM_LIMB_AIR], z);
      }
      double clear = lit ? um_environment_limb_clear(of->cloud_top, low) : 0.0;
      w->arrives[i][k] = clear * dilution;
      for (int l = 0; l < WAVES; l++) {
        double tau = 0.0;
        for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) tau += w->depth[l][c] * column[c];
        w->sun[l][i][k] = lit ? log(fmax(tau, 1e-30)) : w->sun[l][i][k - 1];
      }
    }
}

/* A point's share of its line of sight at all wavelengths. */
static void see_point(const struct um_environment_umbra_scatter *of, struct work *w, double lowest,
                      double size, const double whole[UM_LIMB_CONSTITUENTS], struct point *p)
{
  const double r = w->slant.radius + p->height;
  double up[UM_LIMB_CONSTITUENTS], clear = 0.0;
  um_environment_slant_up(&w->slant, p->height, fabs(p->along) / r, up);
  if (p->along > 0.0) /* beyond the lowest point */
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) up[c] = fmax(whole[c] - up[c], 0.0);
  clear = um_environment_limb_clear(of->cloud_top, p->along > 0.0 ? lowest : p->height);
  for (int l = 0; l < WAVES; l++) {
    double tau = 0.0, scatter[UM_LIMB_CONSTITUENTS];
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) {
      tau += w->depth[l][c] * up[c];
      scatter[c] = w->depth[l][c] *
                   um_environment_slant_density(&w->slant, (enum um_environment_limb_constituent)c,
                                                p->height);
    }
    double seen = clear * exp(-tau) * size;
    p->seen[0][l] = seen * scatter[UM_LIMB_AIR];
    p->seen[1][l] =
        seen * UM_SKY_AEROSOL_ALBEDO * (scatter[UM_LIMB_HAZE] + scatter[UM_LIMB_AEROSOL]);
  }
}

static void lay_lines(const struct um_environment_umbra_scatter *of, struct work *w)
{
  for (int i = 0; i < HEIGHTS; i++) {
    double x = (i + 0.5) / HEIGHTS, h = TOP * x * sqrt(x), dh = 1.5 * TOP * sqrt(x) / HEIGHTS;
    double r0 = w->slant.radius + h, end = w->slant.radius + TOP;
    double half = sqrt((end - r0) * (end + r0)), whole[UM_LIMB_CONSTITUENTS];
    um_environment_slant_up(&w->slant, h, 0.0, whole);
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) whole[c] *= 2.0;
    w->lowest[i] = h;
    for (int k = 0; k < STEPS; k++) {
      struct point *p = &w->point[i][k];
      double u = 2.0 * (k + 0.5) / STEPS - 1.0;
      p->along = half * u * fabs(u);
      p->height = hypot(r0, p->along) - w->slant.radius;
      see_point(of, w, h, dh * half * 4.0 * fabs(u) / STEPS, whole, p);
    }
  }
}

/* Between four nodes of a table. */
struct place {
  int row, column;
  double x, y;
};
static double table_at(const double table[ROWS][COLUMNS], const struct place *at)
{
  const double *low = &table[at->row][at->column], *high = &table[at->row + 1][at->column];
  return (1.0 - at->x) * ((1.0 - at->y) * low[0] + at->y * low[1]) +
         at->x * ((1.0 - at->y) * high[0] + at->y * high[1]);
}

static struct place place_of(double height, double chi)
{
  double row = fmin((ROWS - 1) * sqrt(fmax(height, 0.0) / TOP), ROWS - 1.001);
  double column = (chi - LOWEST) / (HIGHEST - LOWEST) * (COLUMNS - 1);
  column = fmin(fmax(column, 0.0), COLUMNS - 1.001);
  return (struct place){(int)row, (int)column, row - (int)row, column - (int)column};
}

/* Sums of all lines of sight, for a Sun at the zenith angle chi and the cosine of the azimuth from
 * it. */
static void sum_lines(const struct work *w, double chi, double turn, double sum[KINDS][WAVES])
{
  for (int i = 0; i < HEIGHTS; i++)
    for (int k = 0; k < STEPS; k++) {
      const struct point *p = &w->point[i][k];
      double r = w->slant.radius + p->height;
      double cosine =
          ((w->slant.radius + w->lowest[i]) * cos(chi) + p->along * sin(chi) * turn) / r;
      struct place at = place_of(p->height, acos(fmin(fmax(cosine, -1.0), 1.0)));
      double arrives = table_at(w->arrives, &at);
      if (!(arrives > 0.0)) continue;
      for (int l = 0; l < WAVES; l++) {
        double light = arrives * exp(-exp(table_at(w->sun[l], &at)));
        for (int q = 0; q < KINDS; q++) sum[q][l] += light * p->seen[q][l];
      }
    }
}

enum um_status um_environment_umbra_scatter_make(struct um_context *context,
                                                 const struct um_environment *environment,
                                                 struct um_environment_umbra_scatter **out)
{
  enum um_status status;
  struct work *w = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof **out, out));
  UM_CHECK(um_core_allocate(context, 1, sizeof *w, &w));
  struct um_environment_umbra_scatter *to = *out;
  amounts_of(environment, to->amount, &to->cloud_top);
  to->radius = environment->shadow_radius;
  um_environment_slant_make(&environment->limb->bent[UM_LIMB_MIDDLE], environment->shadow_radius,
                            &w->slant);
  for (int l = 0; l < WAVES; l++) {
    um_environment_limb_depth(waves[l], w->depth[l]);
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) w->depth[l][c] *= to->amount[c];
  }
  light_points(to, w);
  lay_lines(to, w);
  for (int i = 0; i < SUNS; i++)
    for (int t = 0; t < TURNS; t++) {
      double sum[KINDS][WAVES] = {{0.0}};
      sum_lines(w, FIRST + i * (LAST - FIRST) / (SUNS - 1), (double)t / (TURNS - 1), sum);
      for (int q = 0; q < KINDS; q++)
        for (int l = 0; l < WAVES; l++)
          to->once[q][l][i][t] = sum[q][l] > 0.0 ? fmax(log(sum[q][l]), DARK) : DARK;
    }
done:
  um_core_free(context, w);
  return status;
}

/* --- at a place ----------------------------------------------------------------------------- */

/* Light of the limb at an azimuth from the Sun: what it adds to a surface that faces it [1]. */
static void add_azimuth(const struct um_environment_umbra_scatter *scatter, double cos_chi,
                        double cos_theta, double weight, double sum[WAVES])
{
  double chi = acos(fmin(fmax(cos_chi, -1.0), 1.0));
  if (!(cos_theta > 0.0) || chi >= LAST) return;
  double row = fmax((chi - FIRST) / (LAST - FIRST), 0.0) * (SUNS - 1);
  double turn = fmin(cos_theta / sin(chi), 1.0) * (TURNS - 1);
  int i = (int)fmin(row, SUNS - 2), t = (int)fmin(turn, TURNS - 2);
  double x = row - i, y = turn - t;
  const double phase[KINDS] = {um_environment_sky_rayleigh(cos_theta),
                               um_environment_sky_aerosol(cos_theta)};
  for (int l = 0; l < WAVES; l++) {
    for (int q = 0; q < KINDS; q++) {
      const double *low = scatter->once[q][l][i] + t, *high = scatter->once[q][l][i + 1] + t;
      double once = exp((1.0 - x) * ((1.0 - y) * low[0] + y * low[1]) +
                        x * ((1.0 - y) * high[0] + y * high[1]));
      sum[l] += weight * cos_theta * phase[q] * once;
    }
  }
}

void um_environment_umbra_scattered(const struct um_environment *environment, struct um_vec3 r,
                                    struct um_vec3 sun, double distance, struct um_vec3 pole,
                                    double lit, struct um_environment_scattered *out)
{
  double sum[WAVES] = {0.0};
  out->any = false;
  if (!environment->shadow_refraction_on || !environment->umbra_scatter_on ||
      environment->umbra_scatter == NULL || !(lit < 1.0))
    return;
  struct um_environment_limb_sight sight =
      um_environment_limb_sight(environment, r, sun, distance, pole);
  double delta = -sight.angle, psi = 0.5 * UM_PI - sight.nadir;
  if (!(psi > 0.0) || delta > LAST - FIRST) return;
  double below = psi + delta, near = cos(psi) / (sin(psi) * sight.distance);
  for (int i = 0; i < 16; i++) {
    struct um_environment_gauss g = um_environment_gauss_16[i];
    double across = cos(UM_PI * g.x * g.x), weight = 4.0 * UM_PI * g.x * g.w;
    add_azimuth(environment->umbra_scatter, -cos(psi) * sin(below) + sin(psi) * cos(below) * across,
                sin(psi) * sin(below) + cos(psi) * cos(below) * across, weight * near * (1.0 - lit),
                sum);
  }
  for (int l = 0; l < WAVES; l++) out->share[l] = sum[l] > 0.0 ? fmax(log(sum[l]), DARK) : DARK;
  out->any = true;
  out->any = um_environment_scattered_at(out, UM_UMBRA_SCATTER_ASKED) >= UM_UMBRA_SCATTER_LEAST;
}

double um_environment_scattered_at(const struct um_environment_scattered *scattered,
                                   double wavelength)
{
  if (!scattered->any || !(wavelength >= waves[0] && wavelength <= waves[WAVES - 1])) return 0.0;
  int k = 0;
  while (k + 2 < WAVES && waves[k + 1] < wavelength) k++;
  double x = log(wavelength / waves[k]) / log(waves[k + 1] / waves[k]);
  return exp((1.0 - x) * scattered->share[k] + x * scattered->share[k + 1]);
}
