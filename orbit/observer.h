/* Who looks: a station on the ground, a moving observer, or a fixed direction; and passes. */
#ifndef UMBRA_ORBIT_OBSERVER_H
#define UMBRA_ORBIT_OBSERVER_H

#include "base/core/context.h"
#include "orbit/frames.h"
#include "orbit/trajectory.h"

enum um_orbit_observer_kind { UM_OBSERVER_STATION, UM_OBSERVER_TRAJECTORY, UM_OBSERVER_DIRECTION };

struct um_orbit_observer {
  enum um_orbit_observer_kind kind;
  double latitude, longitude, height;            /* STATION, geodetic WGS-84 [rad], [rad], [m] */
  struct um_orbit_earth_orientation orientation; /* STATION */
  const struct um_orbit_trajectory *trajectory;  /* TRAJECTORY; borrowed */
  struct um_vec3 direction_gcrs;                 /* DIRECTION: unit, satellite to observer [1] */
  double range;                                  /* DIRECTION [m] */
  int light_time;                                /* nonzero: iterate light time (not DIRECTION) */
};

/* What the observer sees at t_observer (light received). Station quantities are NaN otherwise. */
struct um_orbit_look {
  double t_satellite;            /* emission time, t_tai [s] */
  struct um_vec3 r_gcrs, v_gcrs; /* satellite then [m], [m/s] */
  struct um_vec3 to_observer;    /* unit, GCRS, from the satellite [1] */
  double range;                  /* [m] */
  double azimuth, elevation;     /* [rad], airless, azimuth north over east, 0..2 pi */
  double sun_elevation;          /* [rad] at the station, airless, geometric */
};
enum um_status um_orbit_observer_look(struct um_context *context,
                                      const struct um_orbit_observer *observer,
                                      const struct um_orbit_trajectory *satellite,
                                      double t_observer, struct um_orbit_look *out);

/* A satellite that is seen at a direction, at a height: azimuth and elevation [rad], airless, in
 * the station's Earth-fixed frame of t_observer; height [m] above the WGS-84 ellipsoid, more than
 * the station's. Its range is the only one at which the line of sight reaches that height. The same
 * look as um_orbit_observer_look of an orbit that passes there, the place being that of emission;
 * v_gcrs, which is not known, is 0. UM_ERR_INPUT: no station, height too low, elevation beyond 90
 * deg, not finite. The place agrees with the orbit's to 1 mm (tests/orbit/observer.c). */
enum um_status um_orbit_observer_locate(struct um_context *context,
                                        const struct um_orbit_observer *observer, double t_observer,
                                        double azimuth, double elevation, double height,
                                        struct um_orbit_look *out);

struct um_orbit_pass {
  double rise, culmination, set; /* t_tai [s], to 1 ms; rise/set clipped to the window */
  double rise_azimuth, culmination_azimuth, set_azimuth; /* [rad] */
  double culmination_elevation;                          /* [rad] */
  double culmination_range;                              /* [m] */
};
/* All passes above min_elevation [rad] between two times; the caller frees *out with um_core_free.
 */
enum um_status um_orbit_passes_find(struct um_context *context,
                                    const struct um_orbit_observer *observer,
                                    const struct um_orbit_trajectory *satellite, double from,
                                    double to, double min_elevation, struct um_orbit_pass **out,
                                    size_t *count);

#endif
