/* How a satellite is lit and seen at an observation, and coordinates of it that a correction of
 * light may go with: of the search for missing light (evidence/missing_light/) and of effects of a
 * user's own alike. */
#ifndef UMBRA_EFFECTS_VIEW_H
#define UMBRA_EFFECTS_VIEW_H

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/vec.h"

/* At mid-exposure, with one band. */
struct um_effect_view {
  struct um_vec3 sun, observer, nadir; /* from the satellite, unit, in body axes [1] */
  double azimuth, elevation, airmass;  /* at the station [rad], [rad], [1]; NaN without one */
  double sunlit;                       /* of the Sun's disc [1] */
  double range;                        /* [m] */
  /* light of the band before effects on observations, by the material that it comes from */
  size_t nmaterial, nmechanism;
  const char *const *material; /* [nmaterial] */
  const double *intensity;     /* [nmaterial][nmechanism] [W/sr] */
};

/* Share of the light that comes from a material [1]; NULL: 1, all of it. 0 where nothing arrives.
 */
static inline double um_effect_share(const struct um_effect_view *view, const char *material)
{
  double all = 0.0, of = 0.0;
  if (material == NULL) return 1.0;
  for (size_t m = 0; m < view->nmaterial; m++) {
    double sum = 0.0;
    for (size_t i = 0; i < view->nmechanism; i++) sum += view->intensity[m * view->nmechanism + i];
    all += sum;
    if (strcmp(view->material[m], material) == 0) of += sum;
  }
  return all > 0.0 ? of / all : 0.0;
}

enum um_effect_coordinate {
  UM_COORDINATE_TIME,  /* t_tai [s] */
  UM_COORDINATE_PHASE, /* Sun - satellite - observer [deg] */
  UM_COORDINATE_SUN_X, /* of the Sun from the body's x axis [deg]: incidence on what faces it */
  UM_COORDINATE_SUN_Y, /* y */
  UM_COORDINATE_SUN_Z, /* z */
  UM_COORDINATE_OBSERVER_X, /* of the observer from it [deg]: emission */
  UM_COORDINATE_OBSERVER_Y,
  UM_COORDINATE_OBSERVER_Z,
  UM_COORDINATE_BISECTOR_X, /* of the middle between Sun and observer from it [deg]: 0 is a glint */
  UM_COORDINATE_BISECTOR_Y,
  UM_COORDINATE_BISECTOR_Z,
  UM_COORDINATE_TURN_X, /* of the observer about the axis [turns], circular: the spin */
  UM_COORDINATE_TURN_Y,
  UM_COORDINATE_TURN_Z,
  UM_COORDINATE_NADIR_SUN, /* Sun - satellite - geocentre [deg] */
  UM_COORDINATE_SUNLIT,    /* of the Sun's disc [1] */
  UM_COORDINATE_AIRMASS,   /* [1] */
  UM_COORDINATE_ELEVATION, /* at the station [deg] */
  UM_COORDINATE_AZIMUTH,   /* at the station [turns], circular */
  UM_COORDINATES
};

static inline double um_effect_component(struct um_vec3 v, int axis)
{
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
static inline double um_effect_from_axis(struct um_vec3 v, int axis)
{
  return acos(fmax(-1.0, fmin(1.0, um_effect_component(v, axis)))) / UM_DEG;
}
static inline double um_effect_turn_about(struct um_vec3 v, int axis)
{
  double a = um_effect_component(v, (axis + 1) % 3), b = um_effect_component(v, (axis + 2) % 3);
  double turns = atan2(b, a) / (2.0 * UM_PI);
  return turns < 0.0 ? turns + 1.0 : turns;
}

static inline int um_effect_is_circular(enum um_effect_coordinate coordinate)
{
  return coordinate == UM_COORDINATE_AZIMUTH ||
         (coordinate >= UM_COORDINATE_TURN_X && coordinate <= UM_COORDINATE_TURN_Z);
}

/* In the unit above; NaN where it is not known. */
static inline double um_effect_coordinate_at(enum um_effect_coordinate coordinate, double t_tai,
                                             const struct um_effect_view *view)
{
  int from = (int)coordinate;
  if (coordinate == UM_COORDINATE_TIME) return t_tai;
  if (coordinate == UM_COORDINATE_PHASE) return um_vec3_angle(view->sun, view->observer) / UM_DEG;
  if (from <= UM_COORDINATE_SUN_Z)
    return um_effect_from_axis(view->sun, from - UM_COORDINATE_SUN_X);
  if (from <= UM_COORDINATE_OBSERVER_Z)
    return um_effect_from_axis(view->observer, from - UM_COORDINATE_OBSERVER_X);
  if (from <= UM_COORDINATE_BISECTOR_Z)
    return um_effect_from_axis(um_vec3_unit(um_vec3_add(view->sun, view->observer)),
                               from - UM_COORDINATE_BISECTOR_X);
  if (from <= UM_COORDINATE_TURN_Z)
    return um_effect_turn_about(view->observer, from - UM_COORDINATE_TURN_X);
  if (coordinate == UM_COORDINATE_NADIR_SUN) return um_vec3_angle(view->sun, view->nadir) / UM_DEG;
  if (coordinate == UM_COORDINATE_SUNLIT) return view->sunlit;
  if (coordinate == UM_COORDINATE_AIRMASS) return view->airmass;
  if (coordinate == UM_COORDINATE_ELEVATION) return view->elevation / UM_DEG;
  return view->azimuth / (2.0 * UM_PI);
}

#endif
