/* What the sunlit Earth reflects, by angle: sea with its glint, land, snow, and cloud, under air.
 *
 * A scene's reflectance pi L/(mu_0 E) goes by the cosines mu_0 of the Sun's and mu of the view's
 * angle from the zenith and by the azimuth between them. All at 0.55 um. The derivation is at the
 * head of daylight.c. */
#ifndef UMBRA_ENVIRONMENT_DAYLIGHT_H
#define UMBRA_ENVIRONMENT_DAYLIGHT_H

#include "base/core/context.h"
#include "environment/ground.h"

#define UM_DAYLIGHT_COSINES  16 /* of Sun and view */
#define UM_DAYLIGHT_AZIMUTHS 25 /* every 7.5 deg from 0, the view toward the mirrored Sun */
#define UM_DAYLIGHT_CLOUDS   8  /* of optical depths about 0.5, 1, .. 64 */

enum um_daylight_scene {
  UM_DAYLIGHT_SEA,
  UM_DAYLIGHT_LAND,
  UM_DAYLIGHT_SNOW,
  UM_DAYLIGHT_CLOUD, /* of depth about 0.5, and so on */
  UM_DAYLIGHT_SCENES = UM_DAYLIGHT_CLOUD + UM_DAYLIGHT_CLOUDS
};

/* Made once, never written afterwards. */
struct um_environment_daylight {
  float reflectance[UM_DAYLIGHT_SCENES][UM_DAYLIGHT_COSINES][UM_DAYLIGHT_COSINES]
                   [UM_DAYLIGHT_AZIMUTHS];              /* [sun][view][azimuth] [1] */
  double flux[UM_DAYLIGHT_SCENES][UM_DAYLIGHT_COSINES]; /* reflected share of a Sun [1] */
  double albedo[UM_DAYLIGHT_SCENES];                    /* of light from everywhere [1] */
};
/* About 30 ms. UM_ERR_MEMORY; the caller frees *out with um_core_free. Tests:
 * environment/daylight. */
enum um_status um_environment_daylight_make(struct um_context *context,
                                            struct um_environment_daylight **out);

/* A pair of directions: cosines from the zenith, 0..1, and that of the azimuth between the view and
 * the Sun, -1 toward the mirrored Sun. */
struct um_environment_daylight_pair {
  double sun, view, azimuth;
};
/* Reflectance of one scene, linear between the table's nodes, and the share that it reflects of a
 * Sun there, the integral of the former over the views [1]. */
double um_environment_daylight_reflectance(const struct um_environment_daylight *daylight,
                                           enum um_daylight_scene scene,
                                           struct um_environment_daylight_pair pair);
double um_environment_daylight_flux(const struct um_environment_daylight *daylight,
                                    enum um_daylight_scene scene, double sun);

/* Shares of the scenes at a place: sea, land and snow where there is no cloud, and cloud so thick
 * that all together have the place's albedo, or as near to it as they can. share sums to 1. */
struct um_environment_daylight_place {
  double share[5]; /* of sea, land, snow, cloud, and cloud of twice its depth [1] */
  int cloud;       /* the former's, 0..UM_DAYLIGHT_CLOUDS - 2 */
};
struct um_environment_daylight_place
um_environment_daylight_place(const struct um_environment_daylight *daylight,
                              const struct um_environment_ground *ground);
/* Radiance over that of a Lambert surface that reflects as much of that Sun; its mean over the
 * views, weighed by their cosines, is 1 for every Sun and place [1]. */
double um_environment_daylight_factor(const struct um_environment_daylight *daylight,
                                      const struct um_environment_daylight_place *place,
                                      struct um_environment_daylight_pair pair);

#endif
