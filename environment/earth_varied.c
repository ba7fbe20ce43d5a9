/* Plates above an Earth that differs from place to place.
 *
 * The cap is cut into rings by azimuths; with a mean albedo a0 and a mean exitance M0 of the cap,
 *
 *   E(n) = E_uniform(n; a0, M0) + sum over cells of (L - L_uniform) max(n.d, 0) dOmega,
 *
 * the first term being exact (earth.c). Only the difference is left to cells, and an Earth that is
 * the same everywhere comes out as the uniform one does. Rings stand at the Gauss-Legendre nodes of
 * w = cos(e), the cosine at the ground between zenith and satellite, in which all is analytic from
 * the nadir to the limb; the terminator is averaged over each cell's azimuths. Cells stand side by
 * side in wide registers; those behind a plate count with a cosine of 0. */
#include "environment/earth_varied_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "base/core/wide.h"
#include "environment/earth_infrared.h"
#include "environment/quadrature_impl.h"

/* Temperature of a black body of this spectral radiance at UM_EARTH_WINDOW. */
static double temperature_of(double radiance)
{
  return um_core_planck_temperature(UM_EARTH_WINDOW, radiance);
}

/* Sums of the cap before a plate that faces nadir. */
struct sums {
  double light, albedo, factor, longwave, window;
};

/* Cells of one ring, from `first` on, toward horizontals [AROUND]; of_albedo and of_planet hold the
 * values themselves until means are known. */
static void ring_make(const struct um_environment_earth_view *view,
                      const struct um_environment_ground_view *ground,
                      const struct um_vec3 *horizontal, struct um_environment_gauss w, int first,
                      struct um_environment_varied *out, double *lit, struct sums *sums)
{
  struct um_environment_earth_ring ring = um_environment_earth_ring(view, w.x);
  double width = 2.0 * UM_PI / UM_EARTH_VARIED_AROUND;
  double solid_angle = w.w * ring.solid_angle * width;
  double limb = ground->spectral ? um_environment_earth_limb(w.x) : 1.0;
  double anisotropy = ground->spectral ? um_environment_earth_anisotropy(w.x) : 1.0;
  for (int j = 0; j < UM_EARTH_VARIED_AROUND; j++) {
    int k = first + j;
    double phi = width * (j + 0.5), folded = fmin(phi, 2.0 * UM_PI - phi);
    struct um_vec3 across = horizontal[j];
    struct um_vec3 place = um_environment_earth_ground(view, &ring, w.x, across);
    struct um_environment_ground at = um_environment_ground_at(ground, place);
    lit[k] = um_environment_earth_lit_mean(&ring, folded - 0.5 * width, folded + 0.5 * width);
    struct um_vec3 to = um_vec3_axpy(um_vec3_scale(view->nadir, ring.z), ring.x, across);
    at.albedo *=
        um_environment_ground_toward(ground, &at, place, view->sun, um_vec3_scale(to, -1.0));
    out->x[k] = to.x;
    out->y[k] = to.y;
    out->z[k] = to.z;
    out->solid_angle[k] = solid_angle;
    out->of_albedo[k] = at.albedo;
    out->of_planet[k] = anisotropy * at.longwave;
    out->window[k] = limb * um_core_planck_radiance(UM_EARTH_WINDOW, at.brightness) * solid_angle;
    double factor = ring.z * solid_angle;
    sums->light += lit[k] * factor;
    sums->albedo += at.albedo * lit[k] * factor;
    sums->factor += factor;
    sums->longwave += out->of_planet[k] * factor;
    sums->window += out->window[k] * ring.z;
  }
}

void um_environment_varied_make(const struct um_environment_earth_view *view,
                                const struct um_environment_ground_view *ground,
                                struct um_environment_varied *out)
{
  double lit[UM_EARTH_VARIED_CELLS];
  struct um_vec3 horizontal[UM_EARTH_VARIED_AROUND];
  struct sums sums = {0};
  for (int j = 0; j < UM_EARTH_VARIED_AROUND; j++)
    horizontal[j] =
        um_environment_earth_across(view, 2.0 * UM_PI * (j + 0.5) / UM_EARTH_VARIED_AROUND);
  for (int i = 0; i < UM_EARTH_VARIED_RINGS; i++)
    ring_make(view, ground, horizontal, um_environment_gauss_16[i], i * UM_EARTH_VARIED_AROUND, out,
              lit, &sums);
  out->albedo = sums.light > 0.0 ? sums.albedo / sums.light : 0.0;
  out->longwave = sums.factor > 0.0 ? sums.longwave / sums.factor : 0.0;
  out->brightness = temperature_of(sums.factor > 0.0 ? sums.window / sums.factor : 0.0);
  for (int k = 0; k < UM_EARTH_VARIED_CELLS; k++) {
    out->of_albedo[k] = (out->of_albedo[k] - out->albedo) * lit[k] * out->solid_angle[k];
    out->of_planet[k] = (out->of_planet[k] - out->longwave) / UM_PI * out->solid_angle[k];
  }
}

#define LANES 64 /* cells side by side */

/* Cosines to LANES cells from `first` on; 0 of those behind the plate. */
static inline void cosines(const struct um_environment_varied *v, struct um_vec3 n, int first,
                           double out[LANES])
{
  for (int s = 0; s < LANES; s++) {
    int k = first + s;
    double cosine = n.x * v->x[k] + n.y * v->y[k] + n.z * v->z[k];
    cosine = cosine > 0.0 ? cosine : 0.0;
    out[s] = cosine < 1.0 ? cosine : 1.0;
  }
}

static inline void add_products(const double cosine[LANES], const double *of, double sum[LANES])
{
  for (int s = 0; s < LANES; s++) sum[s] += cosine[s] * of[s];
}

static inline double sum_of(double lane[LANES])
{
  for (int half = LANES / 2; half > 0; half /= 2)
    for (int s = 0; s < half; s++) lane[s] += lane[s + half];
  return lane[0];
}

/* out: of_albedo, of_planet, window, solid_angle by cosines. */
UM_WIDE_VECTORS static void plate_sums(const struct um_environment_varied *v, struct um_vec3 n,
                                       double out[4])
{
  double sum[4][LANES] = {{0.0}}, cosine[LANES];
  for (int first = 0; first < UM_EARTH_VARIED_CELLS; first += LANES) {
    cosines(v, n, first, cosine);
    add_products(cosine, v->of_albedo + first, sum[0]);
    add_products(cosine, v->of_planet + first, sum[1]);
    add_products(cosine, v->window + first, sum[2]);
    add_products(cosine, v->solid_angle + first, sum[3]);
  }
  for (int i = 0; i < 4; i++) out[i] = sum_of(sum[i]);
}

void um_environment_varied_plate(const struct um_environment_varied *varied, struct um_vec3 normal,
                                 double *albedo, double *planet, double *brightness)
{
  double sum[4];
  plate_sums(varied, normal, sum);
  *albedo = sum[0];
  *planet = sum[1];
  *brightness = sum[3] > 0.0 ? temperature_of(sum[2] / sum[3]) : varied->brightness;
}

/* out: of_albedo by cosine and P_1 to P_5, then of_planet. */
UM_WIDE_VECTORS static void moment_sums(const struct um_environment_varied *v, struct um_vec3 n,
                                        double out[2 * UM_ANGULAR_MOMENTS])
{
  double sum[2 * UM_ANGULAR_MOMENTS][LANES] = {{0.0}}, cosine[LANES], p[UM_ANGULAR_MOMENTS][LANES];
  for (int first = 0; first < UM_EARTH_VARIED_CELLS; first += LANES) {
    cosines(v, n, first, cosine);
    for (int s = 0; s < LANES; s++) {
      double at[UM_ANGULAR_MOMENTS];
      um_environment_angular_polynomials(cosine[s], at);
      for (int m = 0; m < UM_ANGULAR_MOMENTS; m++) p[m][s] = cosine[s] * at[m];
    }
    for (int m = 0; m < UM_ANGULAR_MOMENTS; m++) {
      add_products(p[m], v->of_albedo + first, sum[m]);
      add_products(p[m], v->of_planet + first, sum[UM_ANGULAR_MOMENTS + m]);
    }
  }
  for (int i = 0; i < 2 * UM_ANGULAR_MOMENTS; i++) out[i] = sum_of(sum[i]);
}

void um_environment_varied_moments(const struct um_environment_varied *varied,
                                   struct um_vec3 normal,
                                   struct um_environment_earth_moments *moments)
{
  double sum[2 * UM_ANGULAR_MOMENTS];
  moment_sums(varied, normal, sum);
  for (int m = 0; m < UM_ANGULAR_MOMENTS; m++) {
    moments->albedo[m] += sum[m];
    moments->planet[m] += sum[UM_ANGULAR_MOMENTS + m];
  }
}
