/* Free-molecular heating: what the atmosphere brings before each surface,
 *
 *   q = f rho v^3 / 2 max(n . w, 0) times the free share toward w,
 *
 * w the unit vector of the motion over the atmosphere, f the environment's factor. A mean free path
 * is longer than any satellite above 130 km, so molecules come straight, as light does, and the
 * satellite shades itself. */
#include <math.h>

#include "environment/atmosphere.h"
#include "thermal/loads/loads_impl.h"

void um_irradiation_gas_trace(const struct um_environment *environment,
                              const struct um_environment_sample *sample,
                              const struct um_geometry_mesh *mesh,
                              const struct um_thermal_scene *scene, int nsample, double *fraction,
                              float *gas)
{
  struct um_vec3 from;
  double flow = environment->gas_density_factor * um_environment_atmosphere_flow(sample, &from);
  if (!(flow > 0.0)) return;
  struct um_vec3 body = um_quat_apply(sample->q, from);
  um_geometry_visibility_toward(scene->visibility, body, nsample, fraction);
  for (size_t s = 0; s < mesh->nsurface; s++) {
    struct um_vec3 n = um_geometry_surface_normal(mesh, scene->pose, s);
    gas[s] = (float)(flow * fraction[s] * fmax(um_vec3_dot(n, body), 0.0));
  }
}
