/* Orbit and attitude as tables: a scenario that takes them in flies as the one that wrote them. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "model/build/build.h"
#include "model/build/timeline.h"
#include "model/geometry/precompute.h"
#include "output/trajectory.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/in_folder.h"

#define TABLES  "orbit: {table: t/orbit.csv}\nattitude: [{table: t/attitude.csv}]\n"
#define MESSAGE "orbit: {table: t/orbit.oem}\nattitude: [{table: t/attitude.aem}]\n"
#define CNES    "orbit: {table: t/orbit.cic}\nattitude: [{table: t/attitude.cic}]\n"
#define ENVISAT                                                                                    \
  "orbit:\n"                                                                                       \
  "  tle: |\n"                                                                                     \
  "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"                    \
  "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n"

#define KEPLER                                                                                     \
  "orbit: {kepler: {epoch_utc: 2016-09-06T18:00:00Z, a_km: 7143, e: 0.001, i_deg: 98.3, "          \
  "raan_deg: 300, argp_deg: 80, mean_anomaly_deg: 10}}\n"

static struct um_model *model_of(const char *flight)
{
  struct um_model *model;
  FILE *file = fopen("s.yaml", "w");
  assert_non_null(file);
  fprintf(file,
          "schema: 1\nname: s\n"
          "time: {start_utc: 2016-09-06T18:08:00.25Z, stop_utc: 2016-09-06T18:12:00Z, step_s: 60}\n"
          "%sobserver:\n  station: {latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}\n"
          "parts:\n  - {name: box, box: {size_m: [1, 1, 1]}, outside: grey_white, lumped: true,\n"
          "     shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
          "thermal: {start: periodic, orbits_before: 1}\n",
          flight);
  assert_int_equal(fclose(file), 0);
  if (um_model_create(context, "s.yaml", NULL, &model) != UM_OK)
    fail_msg("%s", um_core_message(context));
  remove("s.yaml");
  return model;
}

static void write_tables(const struct um_model *model, struct um_output_instants *instants)
{
  struct um_core_folder *folder;
  if (um_output_instants_choose(context, model, instants) != UM_OK ||
      um_core_folder_begin(context, "t", false, &folder) != UM_OK ||
      um_output_write_trajectory(context, model, instants, folder) != UM_OK ||
      um_core_folder_commit(context, &folder) != UM_OK)
    fail_msg("%s", um_core_message(context));
}

static double turn_between(struct um_quat a, struct um_quat b)
{
  struct um_quat d = um_quat_then(um_quat_conjugate(a), b);
  return 2.0 * sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

/* The largest differences at `n` times [m], [m/s], [rad]. */
static void compare(const struct um_model *a, const struct um_model *b, double from, double step,
                    size_t n, double worst[3])
{
  worst[0] = worst[1] = worst[2] = 0.0;
  for (size_t i = 0; i < n; i++) {
    struct um_environment_sample x, y;
    assert_int_equal(um_model_sample_at(context, a, from + step * (double)i, &x), UM_OK);
    assert_int_equal(um_model_sample_at(context, b, from + step * (double)i, &y), UM_OK);
    worst[0] = fmax(worst[0], um_vec3_norm(um_vec3_sub(x.r, y.r)));
    worst[1] = fmax(worst[1], um_vec3_norm(um_vec3_sub(x.v, y.v)));
    worst[2] = fmax(worst[2], turn_between(x.q, y.q));
  }
}

/* Every kind of turn on an orbit of Kepler and on one of SGP4: in the rows 1 mm and 1e-9 (a double
 * of t_tai resolves 0.1 us, 0.7 mm of the way). Between them the same 1 mm on Kepler's; SGP4's
 * velocities are not the slopes of its places, by 0.03 m/s, which leaves 1 cm. Turns are good to
 * 1e-7. The heat of the second begins inside the tables: precomputing, tried
 * of the first law, would refuse it otherwise. */
static void test_flies_alike(void **state)
{
  (void)state;
  static const char *const attitudes[] = {
      "attitude: [{lvlh: {}}]\n",
      "attitude: [{spin: {axis_gcrs: [0.3, 0.1, 1], axis_body: [0, 0, 1], period_s: 60}}]\n",
      "attitude: [{spin: {axis_lvlh: [0, 1, 0], axis_body: [0, 1, 0], period_s: 240}}]\n",
      "attitude: [{sun: {axis_body: [1, 0, 0], clock_body: [0, 1, 0]}}]\n"};
  for (size_t i = 0; i < 2 * sizeof attitudes / sizeof *attitudes; i++) {
    bool kepler = i % 2 == 0;
    const char *attitude = attitudes[i / 2];
    char flight[600];
    struct um_output_instants instants;
    struct um_model_tables *tables = NULL;
    double worst[3];
    snprintf(flight, sizeof flight, "%s%s", kepler ? KEPLER : ENVISAT, attitude);
    struct um_model *a = model_of(flight);
    write_tables(a, &instants);
    struct um_model *b = model_of(i < 3 ? TABLES : i < 6 ? MESSAGE : CNES);
    compare(a, b, instants.from, 7.0 * instants.step, (instants.count - 1) / 7, worst);
    if (!(worst[0] < 1e-3 && worst[1] < 1e-5 && worst[2] < 1e-9))
      fail_msg("%s in the rows: %g m, %g m/s, %g rad", attitude, worst[0], worst[1], worst[2]);
    compare(a, b, instants.from + 0.37 * instants.step, 16.18 * instants.step,
            (size_t)(0.06 * (double)instants.count), worst);
    if (!(worst[0] < (kepler ? 1e-3 : 2e-2) && worst[1] < (kepler ? 1e-3 : 6e-2) &&
          worst[2] < 1e-7))
      fail_msg("%s between rows: %g m, %g m/s, %g rad", attitude, worst[0], worst[1], worst[2]);
    if (i < 2 && um_model_precompute(context, b, &tables) != UM_OK)
      fail_msg("%s", um_core_message(context));
    um_model_tables_destroy(context, &tables);
    um_model_destroy(context, &b);
    /* tables of tables: they end sooner, and what is there is taken */
    b = model_of(TABLES);
    um_model_destroy(context, &a);
    assert_int_equal(um_output_instants_choose(context, b, &instants), UM_OK);
    um_model_destroy(context, &b);
    remove("t/orbit.csv");
    remove("t/orbit.oem");
    remove("t/orbit.cic");
    remove("t/attitude.cic");
    remove("t/attitude.aem");
    remove("t/attitude.csv");
    remove("t/.umbra");
    rmdir("t");
  }
}

static void test_refusal(void **state)
{
  (void)state;
  struct um_output_instants instants;
  struct um_model *a = model_of(
      ENVISAT "attitude: [{spin: {axis_gcrs: [0, 0, 1], axis_body: [0, 0, 1], period_s: 0.01}}]\n");
  assert_int_equal(um_output_instants_choose(context, a, &instants), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "accepted: at most 2e+06"));
  um_model_destroy(context, &a);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_flies_alike),
                                     cmocka_unit_test(test_refusal)};
  return cmocka_run_group_tests(tests, folder_enter, folder_leave);
}
