/* The Earth that varies, as a place above it sees it direction by direction. */
#ifndef UMBRA_ENVIRONMENT_EARTH_SEEN_H
#define UMBRA_ENVIRONMENT_EARTH_SEEN_H

#include "environment/earth_infrared.h"
#include "environment/environment.h"

/* Nodes on rings about the nadir, whose ground sees the satellite at a cosine w from its zenith:
 * w = sin(pi y^2/2), y in equal steps from the limb, 0, to the nadir, 1. So both the radiance near
 * the limb and the places near the nadir go nearly linearly. Azimuths count from the Sun's. */
#define UM_EARTH_SEEN_RINGS  9
#define UM_EARTH_SEEN_AROUND 24
#define UM_EARTH_SEEN_NODES  (UM_EARTH_SEEN_RINGS * UM_EARTH_SEEN_AROUND)

/* Directions toward the nadir and toward the Sun's azimuth, in any frame. */
struct um_environment_earth_axes {
  struct um_vec3 nadir, sunward, side; /* unit, right-handed (sunward, side, nadir) */
  double h;                            /* distance of the geocentre over the Earth's radius [1] */
};
struct um_environment_earth_seen {
  struct um_environment_earth_axes axes;
  bool spectral; /* um_environment_earth_is_spectral */
  /* albedo: that of a Lambert surface as bright in sunlight, seen from here */
  struct um_environment_ground ground[UM_EARTH_SEEN_NODES];
  struct um_environment_ground_parts parts[UM_EARTH_SEEN_NODES];
  /* of the mean that a plate sees which faces nadir; their sum is 1 [1] */
  double share[UM_EARTH_SEEN_RINGS];
};
/* Arguments of um_environment_earth_flux; axes are in the caller's frame and may be turned into
 * another afterwards. */
void um_environment_earth_seen(const struct um_environment *environment,
                               const struct um_environment_globe *globe, struct um_vec3 r,
                               struct um_vec3 sun, double distance,
                               struct um_environment_earth_seen *out);
/* w of a ring, or between rings. */
double um_environment_earth_seen_cosine(double ring);
/* The four nodes about a unit direction and their weights, which sum to 1. A direction beside the
 * Earth has those of the limb. Linear in azimuth and in y. */
void um_environment_earth_seen_at(const struct um_environment_earth_axes *axes,
                                  struct um_vec3 direction, unsigned short node[4],
                                  double weight[4]);

#endif
