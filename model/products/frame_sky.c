/* Where a frame lies on the sky. */
#include "model/products/frame_sky.h"

#include <math.h>

#include "base/core/constants.h"

struct um_model_frame_sky um_model_frame_sky(const struct um_model_tables *tables, size_t k,
                                             double pixel)
{
  size_t at = k * tables->nsub + tables->nsub / 2;
  struct um_vec3 toward = tables->look[at].to_observer, seen = um_vec3_scale(toward, -1.0);
  struct um_vec3 up = um_vec3_unit(tables->sample[at].r);
  up = um_vec3_unit(um_vec3_axpy(up, -um_vec3_dot(up, toward), toward));
  struct um_vec3 right = um_vec3_cross(up, toward);
  double ra = atan2(seen.y, seen.x), dec = asin(fmax(-1.0, fmin(1.0, seen.z)));
  struct um_vec3 east = um_vec3(-sin(ra), cos(ra), 0.0);
  struct um_vec3 north = um_vec3_cross(seen, east);
  double step = pixel / 3600.0;
  return (struct um_model_frame_sky){
      .ra = (ra < 0.0 ? ra + 2.0 * UM_PI : ra) / UM_DEG,
      .dec = dec / UM_DEG,
      .cd = {{step * um_vec3_dot(right, east), step * um_vec3_dot(up, east)},
             {step * um_vec3_dot(right, north), step * um_vec3_dot(up, north)}}};
}
