/* The Earth in cells of a cube: the radiance of the nearest direction of its cap where a point of
 * the cell lies on its disc, mean over points of the cell. No cell is brighter than the brightest
 * point of the Earth, so that no mirror makes it warmer. */
#include "thermal/loads/mirrored_impl.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/wide.h"
#include "geometry/cube.h"
#include "geometry/mirror_paths.h"

#define POINTS 3 /* along each side of a cell */

/* Four directions of the cap side by side. */
typedef double four __attribute__((vector_size(4 * sizeof(double))));
typedef int64_t four_places __attribute__((vector_size(4 * sizeof(int64_t))));
struct directions {
  size_t n;
  four x[UM_EARTH_CAP_POINTS / 4], y[UM_EARTH_CAP_POINTS / 4], z[UM_EARTH_CAP_POINTS / 4];
};

static void directions_of(const struct um_environment_cap_point *cap, size_t n,
                          struct directions *out)
{
  out->n = (n + 3) / 4;
  for (size_t i = 0; i < 4 * out->n; i++) { /* the last is repeated */
    struct um_vec3 d = cap[i < n ? i : n - 1].direction;
    out->x[i / 4][i % 4] = d.x;
    out->y[i / 4][i % 4] = d.y;
    out->z[i / 4][i % 4] = d.z;
  }
}

/* The first of those that are nearest. */
UM_WIDE_VECTORS static size_t nearest(const struct directions *of, struct um_vec3 d)
{
  four most = {-2.0, -2.0, -2.0, -2.0};
  four_places best = {0}, at = {0, 1, 2, 3};
  for (size_t k = 0; k < of->n; k++, at += 4) {
    four cosine = of->x[k] * d.x + of->y[k] * d.y + of->z[k] * d.z;
    four_places nearer = cosine > most;
    best = (at & nearer) | (best & ~nearer);
    most = (four)(((four_places)cosine & nearer) | ((four_places)most & ~nearer));
  }
  size_t first = 0;
  for (size_t l = 1; l < 4; l++)
    if (most[l] > most[first] || (most[l] == most[first] && best[l] < best[first])) first = l;
  return (size_t)best[first];
}

void um_irradiation_mirrored_earth(const struct um_environment *environment,
                                   const struct um_environment_sample *sample, double weight,
                                   const struct um_vec3 *middle, float *albedo, float *planet)
{
  struct um_environment_cap_point cap[UM_EARTH_CAP_POINTS];
  struct directions directions;
  struct um_vec3 r = um_quat_apply(sample->q, sample->r);
  struct um_vec3 sun = um_quat_apply(sample->q, sample->sun);
  struct um_environment_globe globe = {.t_tai = sample->t_tai,
                                       .pole = um_quat_apply(sample->q, sample->pole),
                                       .greenwich = um_quat_apply(sample->q, sample->greenwich)};
  size_t n = um_environment_earth_cap(environment, &globe, r, sun, sample->sun_distance, cap);
  double ratio = environment->earth_radius / um_vec3_norm(r);
  if (n == 0 || !(ratio < 1.0)) return;
  directions_of(cap, n, &directions);
  double edge = sqrt(1.0 - ratio * ratio); /* cosine of the disc's angular radius */
  /* a cell whose middle is farther from the disc than half its diagonal has nothing of it */
  double wide = 1.5 / UM_GEOMETRY_SKY_SIDE, clear = cos(fmin(acos(edge) + wide, UM_PI));
  double full = acos(edge) > wide ? cos(acos(edge) - wide) : 2.0;
  struct um_vec3 down = um_vec3_scale(um_vec3_unit(r), -1.0);
  for (size_t cell = 0; cell < UM_GEOMETRY_SKY_CELLS; cell++) {
    double cosine = um_vec3_dot(middle[cell], down);
    if (cosine < clear) continue;
    int inside = cosine > full ? POINTS * POINTS : 0;
    for (int i = 0; inside < POINTS * POINTS && i < POINTS * POINTS; i++) {
      int row = i / POINTS;
      struct um_vec3 d = um_geometry_cube_direction(
          UM_GEOMETRY_SKY_SIDE, cell, (i % POINTS + 0.5) / POINTS, (row + 0.5) / POINTS);
      inside += um_vec3_dot(d, down) > edge;
    }
    if (inside == 0) continue;
    const struct um_environment_cap_point *at = &cap[nearest(&directions, middle[cell])];
    double share = weight * inside / (POINTS * POINTS);
    albedo[cell] += (float)(share * at->albedo_radiance);
    planet[cell] += (float)(share * at->planet_radiance);
  }
}
