/* A lumped plate that is cheap to compute, on the pass of ENVISAT over Graz that begins in the
 * umbra: scenario, context and file for tests of a diagnosis. PLATE_STEP: seconds between instants,
 * as text, defined before this is included. */
#ifndef UMBRA_TESTS_DIAGNOSIS_PLATE_TEST_H
#define UMBRA_TESTS_DIAGNOSIS_PLATE_TEST_H

#include <stdio.h>
#include <unistd.h>

#include "base/core/context.h"
#include "tests/support/cmocka_all.h"

static const char scenario[] =
    "schema: 1\n"
    "name: plate\n"
    "time: {start_utc: 2016-09-06T18:08:00Z, stop_utc: 2016-09-06T18:20:00Z, step_s: " PLATE_STEP
    "}\n"
    "orbit:\n"
    "  tle: |\n"
    "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n"
    "attitude:\n"
    "  - spin: {axis_lvlh: [0, 1, 0], axis_body: [0, 1, 0], period_s: 240}\n"
    "observer:\n"
    "  station: {name: Graz, latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}\n"
    "parts:\n"
    "  - {name: wing, plate: {size_m: [2, 1]}, front: grey_panel, back: white_paint, lumped: "
    "true,\n"
    "     shell: {areal_heat_capacity_J_m2_K: 3000, through_conductance_W_m2_K: 50}}\n"
    "thermal: {start: isothermal, start_temperature_K: 280, orbits_before: 0.2}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 3}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 3}\n";

static struct um_context *context;
static char path[64]; /* of the scenario */

#define OK(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(context));                      \
  } while (0)

static inline int set_up(void **state)
{
  (void)state;
  if (um_core_context_create(NULL, &context) != UM_OK) return -1;
  um_core_context_set_threads(context, 1); /* too small to share */
  snprintf(path, sizeof path, "plate_%ld.yaml", (long)getpid());
  FILE *file = fopen(path, "w");
  if (file == NULL) return -1;
  fputs(scenario, file);
  return fclose(file);
}

static inline int tear_down(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  return remove(path);
}

#endif
