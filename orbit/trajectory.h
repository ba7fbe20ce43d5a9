/* Where the satellite (or a moving observer) is: one object behind every kind of orbit. */
#ifndef UMBRA_ORBIT_TRAJECTORY_H
#define UMBRA_ORBIT_TRAJECTORY_H

#include "base/core/context.h"
#include "base/core/vec.h"
#include "orbit/elements.h"
#include "orbit/frames.h"

struct um_orbit_trajectory;

/* orientation is copied (its finals table stays borrowed). */
enum um_status um_orbit_trajectory_create_tle(struct um_context *context,
                                              const struct um_orbit_tle *tle,
                                              const struct um_orbit_earth_orientation *orientation,
                                              struct um_orbit_trajectory **out);
/* Of several sets of one object, rising in epoch: at every time by the set whose epoch is nearest;
 * half way between epochs the place steps by what they disagree. Period and epoch are those of the
 * set nearest to t_near. */
enum um_status um_orbit_trajectory_create_elements(
    struct um_context *context, const struct um_orbit_elements *elements, double t_near,
    const struct um_orbit_earth_orientation *orientation, struct um_orbit_trajectory **out);
/* Two-body motion, mu = UM_EARTH_GM, elements in GCRS at epoch_tai [s]; a [m], e [1], angles [rad].
 */
struct um_orbit_kepler {
  double epoch_tai, a, e, i, raan, argp, mean_anomaly;
};
enum um_status um_orbit_trajectory_create_kepler(struct um_context *context,
                                                 const struct um_orbit_kepler *kepler,
                                                 struct um_orbit_trajectory **out);
/* Circular orbit of given altitude above `earth_radius` [m] whose plane makes the angle beta [rad]
 * with the geocentric Sun of the epoch; at the epoch the satellite is nearest the sub-solar point
 * (beta 0: at it); motion is prograde about the normal nearest the pole. `period` [s]: 0 for
 * Kepler's, otherwise the angular rate is 2 pi / period at the same radius. */
enum um_status um_orbit_trajectory_create_circular(struct um_context *context, double epoch_tai,
                                                   double altitude, double earth_radius,
                                                   double beta, double period,
                                                   struct um_orbit_trajectory **out);
/* CSV `time_utc,x_km,y_km,z_km[,vx_km_s,vy_km_s,vz_km_s]` in GCRS, times ascending, or an ephemeris
 * of others (OEM of CCSDS as key = value or XML, of CIC, or STK) in a frame of orbit/frames.h, to
 * which the orientation belongs (NULL: UT1 is UTC, the pole at zero); which, is found out. Cubic
 * Hermite (velocities by a spline when absent). Outside the table is UM_ERR_INPUT, and so are, with
 * file, line and column, positions below 6000 km or beyond 1e9 km from the geocentre and speeds not
 * below that of light. */
enum um_status
um_orbit_trajectory_create_table(struct um_context *context, const char *path,
                                 const struct um_orbit_earth_orientation *orientation,
                                 struct um_orbit_trajectory **out);
/* A point fixed in GCRS [m] (velocity zero). */
enum um_status um_orbit_trajectory_create_fixed(struct um_context *context, struct um_vec3 r_gcrs,
                                                struct um_orbit_trajectory **out);
/* No track at all: observations that stand alone (um_orbit_observer_locate). Its state is
 * UM_ERR_INPUT, its period NaN. */
enum um_status um_orbit_trajectory_create_none(struct um_context *context,
                                               struct um_orbit_trajectory **out);
void um_orbit_trajectory_destroy(struct um_orbit_trajectory **trajectory);

/* r_gcrs [m], v_gcrs [m/s] (either may be NULL). Errors of the source. */
enum um_status um_orbit_trajectory_state(struct um_context *context,
                                         const struct um_orbit_trajectory *trajectory, double t_tai,
                                         struct um_vec3 *r_gcrs, struct um_vec3 *v_gcrs);
/* From now on the state at t is that of t + seconds: an error along the track. 0 undoes it. */
void um_orbit_trajectory_shift(struct um_orbit_trajectory *trajectory, double seconds);
/* Period of one revolution [s]: nodal from the mean motion for TLE, 2 pi sqrt(a^3/mu) otherwise;
 * NaN for a fixed point and without a track. */
double um_orbit_trajectory_period(const struct um_orbit_trajectory *trajectory);
/* First and last time covered (-inf, +inf where unlimited); epoch of a TLE, NaN otherwise. */
void um_orbit_trajectory_span(const struct um_orbit_trajectory *trajectory, double *first,
                              double *last);
double um_orbit_trajectory_epoch(const struct um_orbit_trajectory *trajectory);

#endif
