/* Nodes of the visible cap. A plate that faces nadir has of a ring the share cos(theta) dOmega =
 * w/h^2 dw dphi, weighed by hats between the nodes. */
#include "environment/earth_seen.h"

#include <math.h>

#include "base/core/constants.h"
#include "environment/earth_view_impl.h"
#include "environment/ground_view.h"

static void shares_fill(double share[UM_EARTH_SEEN_RINGS])
{
  enum { STEPS = 32 }; /* of a gap between two rings */
  double sum = 0.0;
  for (int i = 0; i < UM_EARTH_SEEN_RINGS; i++) share[i] = 0.0;
  for (int i = 0; i + 1 < UM_EARTH_SEEN_RINGS; i++)
    for (int k = 0; k < STEPS; k++) {
      double from = um_environment_earth_seen_cosine(i + (double)k / STEPS);
      double to = um_environment_earth_seen_cosine(i + (k + 1.0) / STEPS);
      double part = to * to - from * from, v = (k + 0.5) / STEPS;
      share[i] += (1.0 - v) * part;
      share[i + 1] += v * part;
      sum += part;
    }
  for (int i = 0; i < UM_EARTH_SEEN_RINGS; i++) share[i] /= sum;
}

double um_environment_earth_seen_cosine(double ring)
{
  double y = ring / (UM_EARTH_SEEN_RINGS - 1.0);
  return sin(0.5 * UM_PI * y * y);
}

void um_environment_earth_seen(const struct um_environment *environment,
                               const struct um_environment_globe *globe, struct um_vec3 r,
                               struct um_vec3 sun, double distance,
                               struct um_environment_earth_seen *out)
{
  struct um_environment_ground_view ground =
      um_environment_ground_view(environment, globe, distance);
  struct um_environment_earth_view view = um_environment_earth_view(environment, r, sun);
  double ratio[UM_EARTH_TEMPERATURES];
  if (ground.spectral) um_environment_earth_window_fill(ratio);
  out->axes = (struct um_environment_earth_axes){view.nadir, view.sunward, view.side, view.h};
  out->spectral = ground.spectral;
  shares_fill(out->share);
  struct um_vec3 across[UM_EARTH_SEEN_AROUND];
  for (int j = 0; j < UM_EARTH_SEEN_AROUND; j++)
    across[j] = um_environment_earth_across(&view, 2.0 * UM_PI * j / UM_EARTH_SEEN_AROUND);
  for (int i = 0; i < UM_EARTH_SEEN_RINGS; i++) {
    double w = um_environment_earth_seen_cosine(i);
    struct um_environment_earth_ring ring = um_environment_earth_ring(&view, w);
    for (int j = 0; j < UM_EARTH_SEEN_AROUND; j++) {
      int k = i * UM_EARTH_SEEN_AROUND + j;
      struct um_vec3 place = um_environment_earth_ground(&view, &ring, w, across[j]);
      struct um_vec3 toward =
          um_vec3_unit(um_vec3_axpy(um_vec3_scale(place, -1.0), -view.h, view.nadir));
      out->ground[k] = um_environment_ground_at(&ground, place);
      out->ground[k].albedo *=
          um_environment_ground_toward(&ground, &out->ground[k], place, view.sun, toward);
      out->parts[k] = um_environment_ground_split(&out->ground[k], ground.spectral ? ratio : NULL);
    }
  }
}

void um_environment_earth_seen_at(const struct um_environment_earth_axes *axes,
                                  struct um_vec3 direction, unsigned short node[4],
                                  double weight[4])
{
  double x = um_vec3_dot(direction, axes->sunward), y = um_vec3_dot(direction, axes->side);
  double sine = axes->h * sqrt(x * x + y * y); /* of the angle at the ground */
  double place = sqrt(acos(fmin(sine, 1.0)) / (0.5 * UM_PI)) * (UM_EARTH_SEEN_RINGS - 1);
  double around = atan2(y, x) * UM_EARTH_SEEN_AROUND / (2.0 * UM_PI);
  if (around < 0.0) around += UM_EARTH_SEEN_AROUND;
  int ring = (int)fmin(place, UM_EARTH_SEEN_RINGS - 2.0);
  int j = (int)around % UM_EARTH_SEEN_AROUND, next = (j + 1) % UM_EARTH_SEEN_AROUND;
  double v = place - ring, p = around - floor(around);
  for (int k = 0; k < 4; k++) {
    node[k] = (unsigned short)((ring + (k >> 1)) * UM_EARTH_SEEN_AROUND + (k & 1 ? next : j));
    weight[k] = (k & 1 ? p : 1.0 - p) * (k >> 1 ? v : 1.0 - v);
  }
}
