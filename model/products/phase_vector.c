/* Phase vector to latitude, longitude, phase angle and plane, and back
 * (docs/physics/reflectivity-map.md; Kucharski et al. and the Flying Laptop paper draw the first
 * two). */
#include "model/products/phase_vector.h"

#include "base/core/constants.h"

#define OPPOSITE 1e-9 /* |s + o| below which there is no bisector */

/* North and east of the map at a place; at the poles those of the meridian. */
static void axes(double latitude, double longitude, struct um_vec3 *north, struct um_vec3 *east)
{
  double s = sin(latitude), c = cos(longitude), d = sin(longitude);
  *north = um_vec3(-s * c, -s * d, cos(latitude));
  *east = um_vec3(-d, c, 0.0);
}

struct um_model_phase_vector um_model_phase_vector(struct um_vec3 sun, struct um_vec3 observer)
{
  struct um_vec3 both = um_vec3_add(sun, observer), across = um_vec3_sub(sun, observer);
  struct um_vec3 north, east;
  double length = um_vec3_norm(both);
  struct um_model_phase_vector out = {NAN, NAN, um_vec3_angle(sun, observer), NAN};
  if (!(length > OPPOSITE)) return out;
  struct um_vec3 p = um_vec3_scale(both, 1.0 / length);
  out.latitude = atan2(p.z, hypot(p.x, p.y));
  out.longitude = atan2(p.y, p.x);
  axes(out.latitude, out.longitude, &north, &east);
  out.plane = 0.0;
  if (um_vec3_norm(across) > OPPOSITE)
    out.plane = atan2(um_vec3_dot(across, east), um_vec3_dot(across, north));
  if (out.plane < 0.0) out.plane += 2.0 * UM_PI;
  return out;
}

void um_model_phase_directions(const struct um_model_phase_vector *at, struct um_vec3 *sun,
                               struct um_vec3 *observer)
{
  struct um_vec3 north, east;
  double c = cos(at->latitude), half = 0.5 * at->phase_angle;
  struct um_vec3 p = um_vec3(c * cos(at->longitude), c * sin(at->longitude), sin(at->latitude));
  axes(at->latitude, at->longitude, &north, &east);
  struct um_vec3 t = um_vec3_axpy(um_vec3_scale(north, cos(at->plane)), sin(at->plane), east);
  *sun = um_vec3_unit(um_vec3_axpy(um_vec3_scale(p, cos(half)), sin(half), t));
  *observer = um_vec3_unit(um_vec3_axpy(um_vec3_scale(p, cos(half)), -sin(half), t));
}
