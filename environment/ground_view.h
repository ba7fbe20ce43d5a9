/* What the ground is at an instant, place by place. */
#ifndef UMBRA_ENVIRONMENT_GROUND_VIEW_H
#define UMBRA_ENVIRONMENT_GROUND_VIEW_H

#include "environment/daylight.h"
#include "environment/environment.h"

/* The region does nothing: its factors are 1, its offsets 0. */
bool um_environment_region_is_neutral(const struct um_environment_region *region);
/* Everything that is one for all places of an instant. */
struct um_environment_ground_view {
  const struct um_environment *environment;
  struct um_vec3 pole, greenwich, east; /* right-handed [1] */
  double season;                        /* cosine of the annual phase of Knocke's model [1] */
  double irradiance;                    /* solar, nominal, at the Earth's distance [W/m^2] */
  double month;  /* 0 in the middle of January, 11 in that of December; -0.5..11.5 [months] */
  double weight; /* of the region at this time, 0..1 [1] */
  bool spectral; /* um_environment_earth_is_spectral */
  const struct um_environment_daylight
      *daylight;         /* NULL: not um_environment_earth_is_anisotropic */
  struct um_vec3 centre; /* of the region [1] */
};
/* globe: NULL for a uniform Earth. sun_distance [m]. */
struct um_environment_ground_view
um_environment_ground_view(const struct um_environment *environment,
                           const struct um_environment_globe *globe, double sun_distance);
/* At a place, a unit vector from the geocentre. Latitudes are geocentric: against geodetic ones, as
 * grids have them, they are off by 0.19 deg at most. The albedo is kept within 0..1 and the other
 * two above zero. Tests: environment/ground_view. */
struct um_environment_ground um_environment_ground_at(const struct um_environment_ground_view *view,
                                                      struct um_vec3 place);
/* Sunlight that a place reflects toward a view over what a Lambert surface of its albedo sends, 1
 * where the view has no daylight. place: a unit vector from the geocentre; sun, toward: unit, to
 * the Sun and to the viewer. Test: environment/daylight. */
double um_environment_ground_toward(const struct um_environment_ground_view *view,
                                    const struct um_environment_ground *ground,
                                    struct um_vec3 place, struct um_vec3 sun,
                                    struct um_vec3 toward);

#endif
