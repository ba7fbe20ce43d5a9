/* The visible cap of the Earth as directions with solid angles and radiances.
 *
 * Cells: CELLS_ACROSS rings by CELLS_AROUND azimuths from the Sun's. Rings lie at the
 * Gauss-Legendre nodes of cos(theta) between the limb and the nadir, so that the solid angles sum
 * to that of the cap, 2 pi (1 - sqrt(1 - R^2/r^2)). The reflected radiance of a cell is the mean of
 * (a S / pi) max(cos SZA, 0) over its azimuths, which keeps what the terminator leaves; where the
 * Earth is not uniform, albedo and exitance are those of the ground in its middle. */
#include "environment/environment.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/earth_infrared.h"
#include "environment/earth_varied_impl.h"
#include "environment/quadrature_impl.h"

enum { CELLS_ACROSS = 8, CELLS_AROUND = UM_EARTH_CAP_POINTS / CELLS_ACROSS };

size_t um_environment_earth_cap(const struct um_environment *environment,
                                const struct um_environment_globe *globe, struct um_vec3 r,
                                struct um_vec3 sun, double distance,
                                struct um_environment_cap_point *out)
{
  bool varies = globe != NULL && um_environment_earth_varies(environment);
  struct um_environment_ground_view ground =
      um_environment_ground_view(environment, varies ? globe : NULL, distance);
  struct um_environment_earth_view view = um_environment_earth_view(environment, r, sun);
  double sine = 1.0 / view.h, cap = sine * sine / (1.0 + sqrt((1.0 - sine) * (1.0 + sine)));
  double irradiance = um_environment_solar_irradiance(environment, distance);
  double width = 2.0 * UM_PI / CELLS_AROUND;
  size_t count = 0;
  for (int i = 0; i < CELLS_ACROSS; i++) {
    /* 1 - cos(theta) = cap x; sin(e) = h sin(theta), w = cos(e) */
    double drop = cap * um_environment_gauss_8[i].x;
    double x = sqrt(drop * (2.0 - drop));
    double se = fmin(view.h * x, 1.0);
    double w = sqrt((1.0 - se) * (1.0 + se));
    struct um_environment_earth_ring ring = um_environment_earth_ring(&view, w);
    double solid_angle = cap * um_environment_gauss_8[i].w * width;
    double anisotropy = ground.spectral ? um_environment_earth_anisotropy(w) : 1.0;
    for (int j = 0; j < CELLS_AROUND; j++) {
      double phi = width * (j + 0.5), folded = fmin(phi, 2.0 * UM_PI - phi);
      struct um_vec3 across = um_environment_earth_across(&view, phi);
      struct um_environment_ground at = {.albedo = environment->albedo,
                                         .longwave = environment->outgoing_longwave};
      struct um_vec3 direction = um_vec3_axpy(um_vec3_scale(view.nadir, 1.0 - drop), x, across);
      if (varies) {
        struct um_vec3 place = um_environment_earth_ground(&view, &ring, w, across);
        at = um_environment_ground_at(&ground, place);
        at.albedo *=
            um_environment_ground_toward(&ground, &at, place, sun, um_vec3_scale(direction, -1.0));
      }
      double lit = um_environment_earth_lit_mean(&ring, folded - 0.5 * width, folded + 0.5 * width);
      out[count++] = (struct um_environment_cap_point){
          .direction = direction,
          .solid_angle = solid_angle,
          .albedo_radiance = at.albedo * irradiance / UM_PI * lit,
          .planet_radiance = anisotropy * at.longwave / UM_PI,
      };
    }
  }
  return count;
}
