/* A box that a wing shades, seen from Graz, for tests of forecasts. */
#ifndef UMBRA_TESTS_FORECAST_BOX_TEST_H
#define UMBRA_TESTS_FORECAST_BOX_TEST_H

#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

#define OK(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s", um_core_message(context));                                 \
  } while (0)

/* Its scenario, from a time to another. */
#define BOX(start, stop)                                                                           \
  "schema: 1\n"                                                                                    \
  "name: box\n"                                                                                    \
  "time: {start_utc: " start ", stop_utc: " stop ", step_s: 20}\n"                                 \
  "orbit:\n"                                                                                       \
  "  tle: |\n"                                                                                     \
  "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"                    \
  "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n"                    \
  "attitude: [{lvlh: {}}]\n"                                                                       \
  "observer:\n"                                                                                    \
  "  station: {name: Graz, latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}\n"          \
  "parts:\n"                                                                                       \
  "  - {name: bus, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"                 \
  "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"                                              \
  "  - {name: wing, plate: {size_m: [2, 1]}, pose: {position_m: [0, 1.1, 0.3]}, lumped: true,\n"   \
  "     front: grey_panel, back: grey_white,\n"                                                    \
  "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"              \
  "optics: {samples: 4}\n"                                                                         \
  "thermal: {start: isothermal, orbits_before: 0.05, step_s: 30, view_factor_rays: 64}\n"          \
  "bands:\n"                                                                                       \
  "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"                                                 \
  "  lwir: {from_um: 8, to_um: 12, bins: 4}\n"

#endif
