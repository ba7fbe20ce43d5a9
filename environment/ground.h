/* What every place of the Earth reflects and emits: one description for heat loads and optics.
 *
 * A place is a unit vector from the geocentre. Where the Earth is not uniform, the caller says with
 * a globe how it is turned: pole and prime meridian in the caller's own frame, and the date. */
#ifndef UMBRA_ENVIRONMENT_GROUND_H
#define UMBRA_ENVIRONMENT_GROUND_H

#include <stdbool.h>

#include "base/core/vec.h"

struct um_environment_map; /* environment/map.h */

enum um_environment_earth {
  UM_EARTH_UNIFORM, /* albedo, outgoing_longwave, brightness_temperature everywhere */
  UM_EARTH_KNOCKE,  /* zonal and seasonal: Knocke, Ries & Tapley 1988 */
  UM_EARTH_MAP      /* monthly grids of a file */
};

/* A part of the Earth, for a part of the time, whose level is another: what the Earth has there is
 * multiplied by the factor, then the offset is added. From 0 to 1 over the edge and over the ramp
 * it goes like a cosine, half way at the radius, at from_tai and at to_tai. */
struct um_environment_region {
  bool everywhere;                         /* latitude, longitude, radius and edge are not used */
  double latitude, longitude;              /* of its centre, geocentric [rad] */
  double radius, edge;                     /* seen from the geocentre [rad] */
  double from_tai, to_tai;                 /* [s], may be -INFINITY and INFINITY */
  double ramp;                             /* [s], 0: at once */
  double albedo_factor, albedo_offset;     /* [1] */
  double longwave_factor, longwave_offset; /* [1], [W/m^2] */
  double brightness_shift;                 /* of the brightness temperature [K] */
};

/* How the Earth is turned, in the frame in which a caller gives everything else. */
struct um_environment_globe {
  double t_tai;             /* [s] */
  struct um_vec3 pole;      /* unit [1] */
  struct um_vec3 greenwich; /* unit: where prime meridian and equator meet [1] */
};

/* What a place reflects and emits. */
struct um_environment_ground {
  double albedo;     /* flux that is reflected over flux that arrives, 0..1 [1] */
  double longwave;   /* exitance, all wavelengths [W/m^2] */
  double brightness; /* brightness temperature in the window, seen from above [K] */
  double surface;    /* temperature of the ground [K] */
  double cloud;      /* share that cloud covers, 0..1 [1] */
  double land;       /* share of the ground that is land, 0..1 [1] */
  double own_albedo; /* before levels and the region: it says how thick cloud is [1] */
};

#endif
