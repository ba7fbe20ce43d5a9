/* How the limb of the Earth stands before the Sun, for what the air makes of its light. */
#ifndef UMBRA_ENVIRONMENT_SHADOW_IMPL_H
#define UMBRA_ENVIRONMENT_SHADOW_IMPL_H

#include "environment/environment.h"

struct um_environment_limb_sight {
  double angle;    /* centre of the Sun above the limb, at right angles to the limb [rad] */
  double nadir;    /* the limb below it from the geocentre [rad] */
  double distance; /* from the geocentre [m] */
  double disc;     /* angular radius of the Sun [rad] */
};
struct um_environment_limb_sight um_environment_limb_sight(const struct um_environment *environment,
                                                           struct um_vec3 r, struct um_vec3 sun,
                                                           double distance, struct um_vec3 pole);

/* Share of the disc that no solid Earth hides, air left out [1]. */
double um_environment_airless_fraction(const struct um_environment *environment, struct um_vec3 r,
                                       struct um_vec3 sun, double distance, struct um_vec3 pole);

#endif
