/* Angular moments of what a uniform Earth sends to a plate; private to the environment. */
#ifndef UMBRA_ENVIRONMENT_EARTH_MOMENTS_IMPL_H
#define UMBRA_ENVIRONMENT_EARTH_MOMENTS_IMPL_H

#include "environment/earth_view_impl.h"

/* Azimuths at which rings are looked at, on one side of each. */
#define UM_EARTH_AZIMUTHS 16
struct um_environment_earth_azimuths {
  int n;        /* on a side */
  bool crossed; /* by the terminator, somewhere */
  double part[UM_EARTH_AZIMUTHS],
      weight[UM_EARTH_AZIMUTHS]; /* of half the arc of a ring that ends */
  double cosine[UM_EARTH_AZIMUTHS], sine[UM_EARTH_AZIMUTHS]; /* on one that is whole */
};
struct um_environment_earth_azimuths
um_environment_earth_azimuths(const struct um_environment_earth_view *view);

/* Moments over E_0 [1] of what the Earth emits and of what it reflects, seen at azimuths of the
 * same view; 0 where nothing comes. lit: what it reflects is wanted. */
void um_environment_earth_moments(const struct um_environment_earth_view *view,
                                  const struct um_environment_earth_azimuths *azimuths,
                                  struct um_vec3 normal, bool lit,
                                  struct um_environment_earth_moments *out);

#endif
