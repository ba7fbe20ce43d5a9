/* What the observer sees: emission time, direction, range, azimuth and elevation.
 *
 * Light received at t left the satellite at t - tau:  tau = |r_satellite(t - tau) - r_observer(t)|
 * / c, a fixed point with contraction v/c = 3e-5. Azimuth and elevation are those of the satellite
 * at emission in the Earth-fixed frame of reception:  az = atan2(E, N), el = asin(U / range).
 *
 * A direction u and a height H place a satellite at r_station + s u where h(r_station + s u) = H.
 * h is convex along a line, so that one s > 0 solves it for H above the station, and Newton's steps
 *   s' = s - (h - H) / (n . u),  n the ellipsoid's normal at the point,
 * come down to it from the sphere of radius a + H, outside which every height is above H. */
#include "orbit/observer.h"

#include "base/core/constants.h"
#include "orbit/geodesy.h"
#include "orbit/sun.h"

enum { LIGHT_TIME_ITERATIONS = 10 };
static const double LIGHT_TIME_TOLERANCE = 1e-10; /* [s], 3 cm */
enum { HEIGHT_ITERATIONS = 50 };
static const double HEIGHT_TOLERANCE = 1e-6; /* [m]; the next Newton step is far smaller */

/* Where the observer is at reception, and for a station the frame it stands in. */
struct place {
  struct um_vec3 r_gcrs;       /* [m] */
  struct um_mat3 gcrs_to_itrf; /* STATION */
};

static enum um_status place_at(struct um_context *context, const struct um_orbit_observer *observer,
                               double t, struct place *place)
{
  if (observer->kind == UM_OBSERVER_TRAJECTORY)
    return um_orbit_trajectory_state(context, observer->trajectory, t, &place->r_gcrs, NULL);
  UM_TRY(um_orbit_frames_gcrs_to_itrf(context, &observer->orientation, t, &place->gcrs_to_itrf));
  struct um_vec3 r_itrf =
      um_orbit_geodesy_forward(observer->latitude, observer->longitude, observer->height);
  place->r_gcrs = um_mat3_apply(um_mat3_transpose(place->gcrs_to_itrf), r_itrf);
  return UM_OK;
}

/* Satellite state at emission and the vector from the satellite to the observer. */
static enum um_status emission(struct um_context *context, const struct um_orbit_observer *observer,
                               const struct um_orbit_trajectory *satellite, double t,
                               const struct place *place, struct um_orbit_look *out,
                               struct um_vec3 *to_observer)
{
  double tau = 0.0;
  for (int k = 0; k < LIGHT_TIME_ITERATIONS; k++) {
    out->t_satellite = t - tau;
    UM_TRY(um_orbit_trajectory_state(context, satellite, out->t_satellite, &out->r_gcrs,
                                     &out->v_gcrs));
    *to_observer = um_vec3_sub(place->r_gcrs, out->r_gcrs);
    if (!observer->light_time) return UM_OK;
    double next = um_vec3_norm(*to_observer) / UM_LIGHT_SPEED;
    if (fabs(next - tau) <= LIGHT_TIME_TOLERANCE) return UM_OK;
    tau = next;
  }
  return um_core_fail(context, UM_ERR_NUMERIC, "light time did not converge (%g s)", tau);
}

static double elevation_of(struct um_vec3 enu) { return asin(enu.z / um_vec3_norm(enu)); }

static void station_angles(const struct um_orbit_observer *observer, const struct place *place,
                           double t, struct um_orbit_look *out)
{
  double lat = observer->latitude, lon = observer->longitude, h = observer->height;
  struct um_vec3 enu =
      um_orbit_geodesy_enu(lat, lon, h, um_mat3_apply(place->gcrs_to_itrf, out->r_gcrs));
  double azimuth = atan2(enu.x, enu.y);
  out->azimuth = azimuth < 0.0 ? azimuth + 2.0 * UM_PI : azimuth;
  out->elevation = elevation_of(enu);
  struct um_vec3 sun =
      um_mat3_apply(place->gcrs_to_itrf, um_orbit_sun_position(observer->orientation.ephemeris, t));
  out->sun_elevation = elevation_of(um_orbit_geodesy_enu(lat, lon, h, sun));
}

enum um_status um_orbit_observer_look(struct um_context *context,
                                      const struct um_orbit_observer *observer,
                                      const struct um_orbit_trajectory *satellite,
                                      double t_observer, struct um_orbit_look *out)
{
  struct place place;
  struct um_vec3 to_observer;
  *out = (struct um_orbit_look){.azimuth = NAN, .elevation = NAN, .sun_elevation = NAN};
  if (observer->kind == UM_OBSERVER_DIRECTION) {
    out->t_satellite = t_observer;
    out->to_observer = um_vec3_unit(observer->direction_gcrs);
    out->range = observer->range;
    return um_orbit_trajectory_state(context, satellite, t_observer, &out->r_gcrs, &out->v_gcrs);
  }
  UM_TRY(place_at(context, observer, t_observer, &place));
  UM_TRY(emission(context, observer, satellite, t_observer, &place, out, &to_observer));
  out->range = um_vec3_norm(to_observer);
  if (!(out->range > 0.0))
    return um_core_fail(context, UM_ERR_INPUT, "the observer and the satellite are at one point");
  out->to_observer = um_vec3_scale(to_observer, 1.0 / out->range);
  if (observer->kind == UM_OBSERVER_STATION) station_angles(observer, &place, t_observer, out);
  return UM_OK;
}

/* Distance [m] from the station along the unit vector enu to the height h. */
static enum um_status range_of_height(struct um_context *context, const struct um_orbit_observer *o,
                                      struct um_vec3 enu, double h, double *range)
{
  struct um_vec3 r0 = um_orbit_geodesy_forward(o->latitude, o->longitude, o->height);
  struct um_vec3 u = um_vec3_sub(
      um_orbit_geodesy_from_enu(o->latitude, o->longitude, o->height, enu), r0); /* to 1e-9 */
  double along = um_vec3_dot(r0, u), radius = um_vec3_norm(r0), outer = UM_EARTH_RADIUS + h;
  double s = sqrt(along * along + (outer - radius) * (outer + radius)) - along;
  for (int k = 0; k < HEIGHT_ITERATIONS; k++) {
    double latitude, longitude, height;
    struct um_vec3 r =
        um_orbit_geodesy_from_enu(o->latitude, o->longitude, o->height, um_vec3_scale(enu, s));
    um_orbit_geodesy_reverse(r, &latitude, &longitude, &height);
    struct um_vec3 normal =
        um_vec3(cos(latitude) * cos(longitude), cos(latitude) * sin(longitude), sin(latitude));
    double step = (height - h) / um_vec3_dot(normal, u);
    s -= step;
    if (fabs(step) <= HEIGHT_TOLERANCE) {
      *range = s;
      return UM_OK;
    }
  }
  return um_core_fail(context, UM_ERR_NUMERIC, "the range of height %g m was not found", h);
}

static enum um_status check_direction(struct um_context *context,
                                      const struct um_orbit_observer *observer, double azimuth,
                                      double elevation, double height)
{
  if (observer->kind != UM_OBSERVER_STATION)
    return um_core_fail(context, UM_ERR_INPUT,
                        "azimuth and elevation want a station; accepted: observer.station");
  if (!isfinite(azimuth) || !(fabs(elevation) <= 0.5 * UM_PI))
    return um_core_fail(context, UM_ERR_INPUT,
                        "azimuth %g deg, elevation %g deg; accepted: finite numbers, elevation "
                        "from -90 to 90 deg",
                        azimuth / UM_DEG, elevation / UM_DEG);
  if (!(height > observer->height && height < INFINITY))
    return um_core_fail(context, UM_ERR_INPUT,
                        "satellite height %g km; accepted: above the station at %g km",
                        height * 1e-3, observer->height * 1e-3);
  return UM_OK;
}

enum um_status um_orbit_observer_locate(struct um_context *context,
                                        const struct um_orbit_observer *observer, double t_observer,
                                        double azimuth, double elevation, double height,
                                        struct um_orbit_look *out)
{
  struct place place;
  double lat = observer->latitude, lon = observer->longitude, h = observer->height;
  *out = (struct um_orbit_look){.azimuth = NAN, .elevation = NAN, .sun_elevation = NAN};
  UM_TRY(check_direction(context, observer, azimuth, elevation, height));
  UM_TRY(place_at(context, observer, t_observer, &place));
  struct um_vec3 enu =
      um_vec3(cos(elevation) * sin(azimuth), cos(elevation) * cos(azimuth), sin(elevation));
  UM_TRY(range_of_height(context, observer, enu, height, &out->range));
  struct um_vec3 r_itrf = um_orbit_geodesy_from_enu(lat, lon, h, um_vec3_scale(enu, out->range));
  out->r_gcrs = um_mat3_apply(um_mat3_transpose(place.gcrs_to_itrf), r_itrf);
  out->to_observer = um_vec3_scale(um_vec3_sub(place.r_gcrs, out->r_gcrs), 1.0 / out->range);
  out->t_satellite = t_observer;
  if (observer->light_time) out->t_satellite -= out->range / UM_LIGHT_SPEED;
  station_angles(observer, &place, t_observer, out);
  return UM_OK;
}
