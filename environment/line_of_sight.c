/* The Earth between a satellite and who looks at it.
 *
 * Points r + s u, 0 <= s <= range, against the WGS-84 ellipsoid x^2 + y^2 + (z a/b)^2 = a^2. With
 * the axis of the pole drawn out by a/b the ellipsoid is a sphere and a line stays a line, whose
 * point nearest to the centre, of r and u drawn out, is
 *
 *   s0 = -(r' . u') / |u'|^2
 *
 * The line is cut when that point lies between the two ends and inside the sphere, or when its far
 * end lies deeper inside than any ground: who stands on low ground is no obstacle to himself. */
#include "base/core/constants.h"
#include "environment/environment.h"

#define LOWEST_GROUND 1e3 /* below the ellipsoid; the Dead Sea's shore is at -0.4 km [m] */

static struct um_vec3 drawn_out(struct um_vec3 v, struct um_vec3 pole)
{
  double more = 1.0 / (1.0 - UM_EARTH_FLATTENING) - 1.0;
  return um_vec3_axpy(v, more * um_vec3_dot(v, pole), pole);
}

bool um_environment_earth_between(struct um_vec3 r, struct um_vec3 direction, double range,
                                  struct um_vec3 pole)
{
  struct um_vec3 from = drawn_out(r, pole), along = drawn_out(direction, pole);
  struct um_vec3 end = um_vec3_axpy(from, range, along);
  if (um_vec3_norm(end) < UM_EARTH_RADIUS - LOWEST_GROUND) return true;
  double nearest = -um_vec3_dot(from, along) / um_vec3_dot(along, along);
  if (!(nearest > 0.0 && nearest < range)) return false;
  return um_vec3_norm(um_vec3_axpy(from, nearest, along)) < UM_EARTH_RADIUS;
}
