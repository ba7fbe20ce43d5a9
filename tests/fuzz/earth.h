/* What a map of the Earth says of places, whatever file it is from. */
#ifndef UMBRA_TESTS_FUZZ_EARTH_H
#define UMBRA_TESTS_FUZZ_EARTH_H

#include "base/core/constants.h"
#include "environment/map.h"
#include "tests/fuzz/fuzz.h"

#define EARTH_DATE (6107.5 * 86400.0) /* 2016-09-21 0 h [s] */

static inline void earth_between(double value, double low, double high, const char *what)
{
  if (!(value >= low - 1e-4 && value <= high + 1e-4)) um_fuzz_finding("%s of %.9g", what, value);
}

static inline void earth_try(struct um_context *context, const char *path)
{
  struct um_environment_map *map = NULL;
  if (!um_fuzz_good(context, um_environment_map_read(context, path, EARTH_DATE, &map))) {
    if (map != NULL) um_fuzz_finding("a map in spite of the failure");
    return;
  }
  if (!um_environment_map_equal(map, map)) um_fuzz_finding("a map that differs from itself");
  for (int k = 0; k < 60; k++) {
    struct um_environment_ground g = {0.5, 240.0, 280.0, 290.0, 0.6, 0.29, 0.5};
    double latitude = (k % 5 - 2) * 45.0 * UM_DEG, longitude = (k % 7 - 3) * 60.0 * UM_DEG;
    um_environment_map_at(map, latitude, longitude, 0.2 * k, &g);
    earth_between(g.albedo, 0.0, 1.0, "an albedo");
    earth_between(g.longwave, 0.0, 600.0, "a longwave radiation");
    /* 420.2 K: what the window has where the longwave radiation is 600 W/m^2 */
    earth_between(g.brightness, 0.0, 420.3, "a brightness temperature");
    earth_between(g.surface, 150.0, 400.0, "a temperature of the ground");
    earth_between(g.cloud, 0.0, 1.0, "a cover of cloud");
  }
  um_environment_map_destroy(context, &map);
}

#endif
