/* For tests: how much a place of the Earth is of a region that differs (environment/ground.h). */
#ifndef UMBRA_TESTS_IRRADIATION_REGION_HELP_H
#define UMBRA_TESTS_IRRADIATION_REGION_HELP_H

#include "base/core/constants.h"
#include "environment/environment.h"

/* 0 to 1 like a cosine over the edge, half way at the radius; place, pole, greenwich: unit. */
static inline double region_weight(const struct um_environment_region *at, struct um_vec3 pole,
                                   struct um_vec3 greenwich, struct um_vec3 place)
{
  struct um_vec3 east = um_vec3_cross(pole, greenwich);
  double c = cos(at->latitude), x = c * cos(at->longitude), y = c * sin(at->longitude);
  struct um_vec3 centre =
      um_vec3_axpy(um_vec3_axpy(um_vec3_scale(greenwich, x), y, east), sin(at->latitude), pole);
  double share = (at->radius - um_vec3_angle(centre, place)) / at->edge;
  return share <= -0.5 ? 0.0 : share >= 0.5 ? 1.0 : 0.5 * (1.0 + sin(UM_PI * share));
}

#endif
