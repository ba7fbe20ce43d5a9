/* The visible cap of the Earth as rings about the nadir, private to the environment. */
#ifndef UMBRA_ENVIRONMENT_EARTH_IMPL_H
#define UMBRA_ENVIRONMENT_EARTH_IMPL_H

#include "core/vec.h"
#include "environment/environment.h"

/* Nadir, the sunward horizontal, what completes them; and what the rings need to know. */
struct um_environment_earth_view {
  struct um_vec3 nadir, sunward, side; /* unit, right-handed (sunward, side, nadir) */
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

#endif
