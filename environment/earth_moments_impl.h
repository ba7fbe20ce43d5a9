/* Angular moments of what a uniform Earth sends to a plate; private to the environment. */
#ifndef UMBRA_ENVIRONMENT_EARTH_MOMENTS_IMPL_H
#define UMBRA_ENVIRONMENT_EARTH_MOMENTS_IMPL_H

#include "environment/earth_view_impl.h"

/* Moments over E_0 [1] of what the Earth emits and of what it reflects; 0 where nothing comes.
 * lit: what it reflects is wanted. */
void um_environment_earth_moments(const struct um_environment_earth_view *view,
                                  struct um_vec3 normal, bool lit,
                                  struct um_environment_earth_moments *out);

#endif
