/* What every place of the Earth reflects and emits: one description for heat loads and optics.
 *
 * A place is a unit vector from the geocentre. Where the Earth is not uniform, the caller says with
 * a globe how it is turned: pole and prime meridian in the caller's own frame, and the date. */
#ifndef UMBRA_ENVIRONMENT_GROUND_H
#define UMBRA_ENVIRONMENT_GROUND_H

#include <stdbool.h>

#include "core/vec.h"

struct um_environment;
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
  struct um_vec3 pole;      /* unit */
  struct um_vec3 greenwich; /* unit: where prime meridian and equator meet */
};

/* What a place reflects and emits, as Lambert surface. */
struct um_environment_ground {
  double albedo;     /* 0..1 [1] */
  double longwave;   /* emitted, all wavelengths [W/m^2] */
  double brightness; /* brightness temperature in 8-12 um [K] */
};

/* The region does nothing: its factors are 1, its offsets 0. */
bool um_environment_region_is_neutral(const struct um_environment_region *region);
/* Does the Earth differ from place to place, or in time? Then a globe is wanted. */
bool um_environment_earth_varies(const struct um_environment *environment);

/* Everything that is one for all places of an instant. */
struct um_environment_ground_view {
  const struct um_environment *environment;
  struct um_vec3 pole, greenwich, east; /* right-handed */
  double season;                        /* cosine of the annual phase of Knocke's model [1] */
  double irradiance;                    /* solar, nominal, at the Earth's distance [W/m^2] */
  double month;          /* 0 in the middle of January, 11 in that of December; -0.5..11.5 */
  double weight;         /* of the region at this time, 0..1 [1] */
  struct um_vec3 centre; /* of the region */
};
/* globe: NULL for a uniform Earth. sun_distance [m]. */
struct um_environment_ground_view
um_environment_ground_view(const struct um_environment *environment,
                           const struct um_environment_globe *globe, double sun_distance);
/* At a place, a unit vector from the geocentre. Latitudes are geocentric: against geodetic ones, as
 * grids have them, they are off by 0.19 deg at most. The albedo is kept within 0..1 and the other
 * two above zero. Tests: environment/ground. */
struct um_environment_ground um_environment_ground_at(const struct um_environment_ground_view *view,
                                                      struct um_vec3 place);

/* Knocke, Ries & Tapley 1988 (AIAA 88-4292): with P1 = s and P2 = (3 s^2 - 1)/2 of the sine s of
 * the latitude, and the cosine c of 2 pi (days since 1981-12-22)/365.25, albedo = 0.34 + 0.10 c P1
 * + 0.29 P2,  emissivity = 0.68 - 0.07 c P1 - 0.18 P2, the emitted flux being emissivity * S/4 for
 * the solar irradiance S at the Earth's distance. */
void um_environment_knocke(double sine_latitude, double season, double *albedo, double *emissivity);
/* c of a date. */
double um_environment_knocke_season(double t_tai);
/* Brightness temperature in the window [K] of ground that emits this flux [W/m^2]: the flux
 * temperature T_F = (flux/sigma)^(1/4) is T (1.228 - 1.106e-3/K T) (Ohring, Gruber & Ellingson
 * 1984, J. Climate Appl. Meteor. 23:416, figures as in Yang & Slingo 2001, Mon. Wea. Rev. 129:784).
 * Meant for 100 to 320 W/m^2; does not fail. */
double um_environment_window_temperature(double longwave);
/* Month of a date, as in the view; and days since 2000-01-01 of a civil date, for readers. */
double um_environment_month_of(double t_tai);

#endif
