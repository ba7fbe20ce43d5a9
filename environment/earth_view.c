/* The visible cap as rings about the nadir:
 *
 *   sin(theta) = sin(e)/h,  psi = e - theta,  dOmega = w / (h^2 cos(theta)) dw dphi,  w = cos(e)
 *
 * theta is the angle from the nadir at the satellite, e that between zenith and satellite at the
 * ground, psi that between both places at the geocentre. */
#include "environment/earth_view_impl.h"

struct um_environment_earth_view um_environment_earth_view(const struct um_environment *environment,
                                                           struct um_vec3 r, struct um_vec3 sun)
{
  struct um_environment_earth_view view;
  double distance = um_vec3_norm(r);
  view.h = fmax(distance / environment->earth_radius, 1.0);
  view.nadir = um_vec3_scale(r, -1.0 / distance);
  view.sun = sun;
  view.cos_zenith = -um_vec3_dot(sun, view.nadir);
  struct um_vec3 across = um_vec3_axpy(sun, view.cos_zenith, view.nadir);
  view.sin_zenith = um_vec3_norm(across);
  if (view.sin_zenith > 1e-8) {
    view.sunward = um_vec3_scale(across, 1.0 / view.sin_zenith);
    view.side = um_vec3_cross(view.nadir, view.sunward);
  } else {
    um_core_vec3_frame(view.nadir, &view.sunward, &view.side);
  }
  return view;
}

struct um_environment_earth_ring
um_environment_earth_ring(const struct um_environment_earth_view *view, double w)
{
  struct um_environment_earth_ring ring;
  double se = sqrt((1.0 - w) * (1.0 + w));
  ring.x = se / view->h;
  ring.z = sqrt((1.0 - ring.x) * (1.0 + ring.x));
  ring.solid_angle = ring.z > 0.0 ? w / (view->h * view->h * ring.z) : 0.0;
  /* psi = e - theta; cos SZA = cos(psi) cos(sigma) + sin(psi) sin(sigma) cos(phi) */
  ring.a = (w * ring.z + se * ring.x) * view->cos_zenith;
  ring.b = fmax(se * ring.z - w * ring.x, 0.0) * view->sin_zenith;
  um_environment_earth_arc(ring.a, ring.b, &ring.gamma, &ring.cos_gamma, &ring.sin_gamma);
  return ring;
}

double um_environment_earth_lit_mean(const struct um_environment_earth_ring *ring, double first,
                                     double last)
{
  double end = fmin(last, ring->gamma);
  if (!(end > first)) return 0.0;
  double sum = ring->a * (end - first) + ring->b * (sin(end) - sin(first));
  return fmax(sum, 0.0) / (last - first);
}

/* psi = e - theta is the angle between nadir point and ground, seen from the geocentre. */
struct um_vec3 um_environment_earth_ground(const struct um_environment_earth_view *view,
                                           const struct um_environment_earth_ring *ring, double w,
                                           struct um_vec3 across)
{
  double se = sqrt((1.0 - w) * (1.0 + w));
  double c = w * ring->z + se * ring->x, s = se * ring->z - w * ring->x;
  return um_vec3_axpy(um_vec3_scale(view->nadir, -c), s, across);
}
