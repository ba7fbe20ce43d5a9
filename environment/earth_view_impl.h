/* The visible cap of the Earth as rings about the nadir, private to the environment. */
#ifndef UMBRA_ENVIRONMENT_EARTH_VIEW_IMPL_H
#define UMBRA_ENVIRONMENT_EARTH_VIEW_IMPL_H

#include <math.h>

#include "base/core/vec.h"
#include "environment/environment.h"

/* Nadir, the sunward horizontal, what completes them; and what the rings need to know. */
struct um_environment_earth_view {
  struct um_vec3 nadir, sunward, side; /* unit, right-handed (sunward, side, nadir) */
  struct um_vec3 sun;                  /* unit, toward it */
  double h;                            /* r/R >= 1 [1] */
  double cos_zenith, sin_zenith;       /* of the Sun at the sub-satellite point [1] */
};
struct um_environment_earth_view um_environment_earth_view(const struct um_environment *environment,
                                                           struct um_vec3 r, struct um_vec3 sun);

/* Directions at one angle theta from the nadir. The ground there sees the Sun with
 * cos SZA = a + b cos(phi), phi from `sunward`; it is lit where |phi| < gamma. */
struct um_environment_earth_ring {
  double z, x;                        /* cos(theta), sin(theta) [1] */
  double a, b;                        /* [1], b >= 0 */
  double gamma, cos_gamma, sin_gamma; /* 0..pi [rad] */
  double solid_angle;                 /* dOmega / (dw dphi) [sr/rad] */
};
/* The ring whose ground sees the satellite at the angle e from its zenith, sin(theta) = sin(e)/h.
 */
struct um_environment_earth_ring
um_environment_earth_ring(const struct um_environment_earth_view *view, double w);
/* cos(angle) at which p + q cos(angle) = 0, q >= 0, and the arc |angle| < *arc on which it is
 * positive. */
static inline void um_environment_earth_arc(double p, double q, double *arc, double *cosine,
                                            double *sine)
{
  double c = p >= q ? -1.0 : p <= -q ? 1.0 : -p / q;
  *cosine = c;
  *sine = sqrt((1.0 - c) * (1.0 + c));
  *arc = acos(c);
}
/* Mean of max(cos SZA, 0) over azimuths first to last, 0 <= first < last <= pi. */
double um_environment_earth_lit_mean(const struct um_environment_earth_ring *ring, double first,
                                     double last);
/* The horizontal at an azimuth from `sunward` [rad]: unit vector. */
static inline struct um_vec3
um_environment_earth_across(const struct um_environment_earth_view *view, double phi)
{
  return um_vec3_axpy(um_vec3_scale(view->sunward, cos(phi)), sin(phi), view->side);
}
/* The ground that is seen on the ring of w toward a horizontal: unit vector from the geocentre. */
struct um_vec3 um_environment_earth_ground(const struct um_environment_earth_view *view,
                                           const struct um_environment_earth_ring *ring, double w,
                                           struct um_vec3 across);

#endif
