/* The scenario of a box and a panel on a pass of ENVISAT over Graz: folder, context and file for
 * tests of requests and reports. */
#ifndef UMBRA_TESTS_DIAGNOSIS_PASS_TEST_H
#define UMBRA_TESTS_DIAGNOSIS_PASS_TEST_H

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/context.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

/* A box and a panel from a file, on the pass of ENVISAT over Graz that begins in the umbra.
 * Isothermal at the start, so that a model and its copy do the same arithmetic. */
static const char scenario_text[] =
    "# a box and a panel\n"
    "schema: 1\n"
    "name: pass\n"
    "time: {start_utc: 2016-09-06T18:08:00Z, stop_utc: 2016-09-06T18:14:00Z, step_s: 12}\n"
    "orbit:\n"
    "  tle_file: orbit.tle # of the day\n"
    "attitude:\n"
    "  - spin: {axis_lvlh: [0, 1, 0], axis_body: [0, 1, 0], period_s: 240}\n"
    "observer:\n"
    "  station: {name: Graz, latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}\n"
    "parts:\n"
    "  - name: bus\n"
    "    box: {size_m: [1, 1, 1]}\n"
    "    outside: grey_white\n"
    "    shell: {areal_heat_capacity_J_m2_K: 3000}\n"
    "    interior: {capacity_J_K: 4000, power_W: 20, conductance_W_K: 2}\n"
    "    lumped: true\n"
    "  - name: panel\n"
    "    mesh: panel.obj\n"
    "    pose: {position_m: [0, 3, 0]}\n"
    "    front: grey_panel\n"
    "    back: grey_metal\n"
    "    shell: {areal_heat_capacity_J_m2_K: 2000, through_conductance_W_m2_K: 50}\n"
    "    lumped: true\n"
    "thermal: {start: isothermal, orbits_before: 0.05}\n"
    "bands:\n"
    "  vis: {from_um: 0.38, to_um: 0.78, bins: 4}\n"
    "  lwir: {from_um: 8, to_um: 12, bins: 4}\n"
    "effects:\n"
    "  - {effect: panel_extraction, target: panel, efficiency: 0.1} # guessed\n"
    "measurements:\n"
    "  nuisance: [{effect: zero_point, target: lwir, sigma: 0.02}]\n"
    "  exclude: [time_tag]\n";
static const char tle_text[] =
    "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n";
static const char panel_text[] =
    "v -1 -0.5 0\nv 1 -0.5 0\nv 1 0.5 0\nv -1 0.5 0\ng plate\nf 1 2 3 4\n";

static struct um_context *context;
static char base[UM_TEST_PATH];

static inline void put(const char *path, const char *text)
{
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(text, 1, strlen(text), file), strlen(text));
  assert_int_equal(fclose(file), 0);
}

#define assert_ok(call)                                                                            \
  do {                                                                                             \
    um_core_message_clear(context);                                                                \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(context));                      \
  } while (0)

static inline int set_up(void **state)
{
  (void)state;
  if (um_test_folder_create(base) != 0 || chdir(base) != 0 || mkdir("scene", 0777) != 0) return -1;
  put("scene/scenario.yaml", scenario_text);
  put("scene/orbit.tle", tle_text);
  put("scene/panel.obj", panel_text);
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

static inline int tear_down(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  remove("scene/scenario.yaml");
  remove("scene/orbit.tle");
  remove("scene/panel.obj");
  return rmdir("scene") == 0 && chdir("/") == 0 && um_test_folder_remove(base) == 0 ? 0 : -1;
}

#endif
