/* Plates above an Earth that differs from place to place.
 *
 * The cap is cut into rings by azimuths; with a mean albedo a0 and a mean exitance M0 of the cap,
 *
 *   E(n) = E_uniform(n; a0, M0) + sum over cells of (L - L_uniform) max(n.d, 0) dOmega,
 *
 * the first term being exact (earth.c). Only the difference is left to cells, and an Earth that is
 * the same everywhere comes out as the uniform one does. Rings stand at the Gauss-Legendre nodes of
 * w = cos(e), the cosine at the ground between zenith and satellite, in which all is analytic from
 * the nadir to the limb; the terminator is averaged over each cell's azimuths. */
#include "environment/earth_varied_impl.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "environment/quadrature_impl.h"

/* Temperature of a black body of this spectral radiance at UM_EARTH_WINDOW. */
static double temperature_of(double radiance)
{
  double wavelength5 = pow(UM_EARTH_WINDOW, 5.0);
  if (!(radiance > 0.0)) return 0.0;
  return UM_RADIATION_C2 / UM_EARTH_WINDOW / log1p(UM_RADIATION_C1L / (wavelength5 * radiance));
}

/* Sums of the cap before a plate that faces nadir. */
struct sums {
  double light, albedo, factor, longwave, window;
};

/* Cells of one ring; albedo and planet of a cell hold the values themselves until means are known.
 */
static void ring_make(const struct um_environment_earth_view *view,
                      const struct um_environment_ground_view *ground,
                      struct um_environment_gauss w, struct um_environment_varied_cell *cell,
                      double *lit, struct sums *sums)
{
  struct um_environment_earth_ring ring = um_environment_earth_ring(view, w.x);
  double width = 2.0 * UM_PI / UM_EARTH_VARIED_AROUND;
  double solid_angle = w.w * ring.solid_angle * width;
  for (int j = 0; j < UM_EARTH_VARIED_AROUND; j++) {
    double phi = width * (j + 0.5), folded = fmin(phi, 2.0 * UM_PI - phi);
    struct um_vec3 across =
        um_vec3_axpy(um_vec3_scale(view->sunward, cos(phi)), sin(phi), view->side);
    struct um_environment_ground at =
        um_environment_ground_at(ground, um_environment_earth_ground(view, &ring, w.x, phi));
    lit[j] = um_environment_earth_lit_mean(&ring, folded - 0.5 * width, folded + 0.5 * width);
    cell[j].direction = um_vec3_axpy(um_vec3_scale(view->nadir, ring.z), ring.x, across);
    cell[j].solid_angle = solid_angle;
    cell[j].albedo = at.albedo;
    cell[j].planet = at.longwave;
    cell[j].window = um_core_planck_radiance(UM_EARTH_WINDOW, at.brightness) * solid_angle;
    double factor = ring.z * solid_angle;
    sums->light += lit[j] * factor;
    sums->albedo += at.albedo * lit[j] * factor;
    sums->factor += factor;
    sums->longwave += at.longwave * factor;
    sums->window += cell[j].window * ring.z;
  }
}

void um_environment_varied_make(const struct um_environment_earth_view *view,
                                const struct um_environment_ground_view *ground,
                                struct um_environment_varied *out)
{
  double lit[UM_EARTH_VARIED_CELLS];
  struct sums sums = {0};
  for (int i = 0; i < UM_EARTH_VARIED_RINGS; i++)
    ring_make(view, ground, um_environment_gauss_16[i], out->cell + i * UM_EARTH_VARIED_AROUND,
              lit + i * UM_EARTH_VARIED_AROUND, &sums);
  out->albedo = sums.light > 0.0 ? sums.albedo / sums.light : 0.0;
  out->longwave = sums.factor > 0.0 ? sums.longwave / sums.factor : 0.0;
  out->brightness = temperature_of(sums.factor > 0.0 ? sums.window / sums.factor : 0.0);
  for (int k = 0; k < UM_EARTH_VARIED_CELLS; k++) {
    struct um_environment_varied_cell *cell = &out->cell[k];
    cell->albedo = (cell->albedo - out->albedo) * lit[k] * cell->solid_angle;
    cell->planet = (cell->planet - out->longwave) / UM_PI * cell->solid_angle;
  }
}

void um_environment_varied_plate(const struct um_environment_varied *varied, struct um_vec3 normal,
                                 double *albedo, double *planet, double *brightness)
{
  double factor = 0.0, window = 0.0;
  *albedo = *planet = 0.0;
  for (int k = 0; k < UM_EARTH_VARIED_CELLS; k++) {
    const struct um_environment_varied_cell *cell = &varied->cell[k];
    double cosine = um_vec3_dot(normal, cell->direction);
    if (!(cosine > 0.0)) continue;
    *albedo += cosine * cell->albedo;
    *planet += cosine * cell->planet;
    window += cosine * cell->window;
    factor += cosine * cell->solid_angle;
  }
  *brightness = factor > 0.0 ? temperature_of(window / factor) : varied->brightness;
}

void um_environment_varied_moments(const struct um_environment_varied *varied,
                                   struct um_vec3 normal,
                                   struct um_environment_earth_moments *moments)
{
  for (int k = 0; k < UM_EARTH_VARIED_CELLS; k++) {
    const struct um_environment_varied_cell *cell = &varied->cell[k];
    double cosine = fmin(um_vec3_dot(normal, cell->direction), 1.0), p[UM_ANGULAR_MOMENTS];
    if (!(cosine > 0.0)) continue;
    um_environment_angular_polynomials(cosine, p);
    for (int m = 0; m < UM_ANGULAR_MOMENTS; m++) {
      moments->albedo[m] += cosine * cell->albedo * p[m];
      moments->planet[m] += cosine * cell->planet * p[m];
    }
  }
}
