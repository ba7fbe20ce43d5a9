/* Spins found again in light that was made with one. The body has no symmetry: a box of three grey
 * levels with a slanted plate; then one that has: what cannot be told apart is then known.
 *
 * A box of equal sides opposite each other, turned by half a turn about y, is the same box. A spin
 * about z is then the spin about -z the other way round: axis and rate reversed together is one and
 * the same motion of the axis, of a body turned about y. Both give the same light. */
#include "evidence/inversion/spin.h"

#include "orbit/time.h"
#include "tests/evidence/model_test.h"

#define AXIS "[0.36, 0.48, 0.8]"

/* A pass at dusk, which begins where the satellite leaves the shadow, and one by day, above the lit
 * Earth. */
static const char *const dusk =
    "time: {start_utc: 2016-09-06T18:10:40Z, stop_utc: 2016-09-06T18:19:00Z, step_s: 10}\n";
static const char *const day =
    "time: {start_utc: 2016-09-06T08:31:00Z, stop_utc: 2016-09-06T08:40:00Z, step_s: 10}\n";

static const char *const frame_text =
    "schema: 1\n"
    "name: spin\n"
    "%s"
    "orbit:\n"
    "  tle: |\n"
    "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n"
    "attitude:\n"
    "  - spin: {axis_gcrs: " AXIS ", axis_body: [0, 0, 1], period_s: 200, phase_deg: 70, at_utc: "
    "2016-09-06T18:12:00Z}\n"
    "observer:\n"
    "  station: {name: Graz, latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}\n"
    "thermal: {start: isothermal, orbits_before: 0}\n"
    "bands: {vis: {from_um: 0.38, to_um: 0.78, bins: 1}}\n"
    "effects: [%s]\n"
    "parts:\n%s";

#define SHELL "shell: {areal_heat_capacity_J_m2_K: 3000}, lumped: true"
#define BOX                                                                                        \
  "  - {name: bus, box: {size_m: [1, 2, 1.5]}, materials: {+x: grey_white, -x: grey_white, +y: "   \
  "grey_metal, -y: grey_metal, +z: grey_panel, -z: grey_panel}, " SHELL "}\n"
#define LOPSIDED                                                                                   \
  "  - {name: bus, box: {size_m: [1, 2, 1.5]}, materials: {+x: grey_white, -x: grey_metal, +y: "   \
  "grey_metal, -y: grey_white, +z: grey_white, -z: grey_panel}, " SHELL "}\n"                      \
  "  - {name: plate, plate: {size_m: [3, 1]}, front: grey_white, back: grey_metal, pose: "         \
  "{position_m: [0, 4, 0], rotation_deg: [30, 50, 0]}, " SHELL "}\n"

#define NO_EARTH "{effect: earthshine, off: true}"

static struct um_model *body_of(const char *time, const char *effects, const char *parts)
{
  struct um_model *model = NULL;
  char text[8192];
  snprintf(text, sizeof text, frame_text, time, effects, parts);
  put(SCENARIO, text);
  assert_ok(um_model_create(context, SCENARIO, NULL, &model));
  return model;
}

/* Light of the scenario's own times by a run of the whole model, heat and all; sigma 1 % of the
 * mean and no noise. */
static struct um_compare_measurements *measure(const struct um_model *model)
{
  struct um_compare_measurements *m = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  double mean = 0.0;
  char text[16384];
  assert_ok(um_model_precompute(context, model, &tables));
  assert_ok(um_model_run(context, model, tables, &result));
  for (size_t i = 0; i < result->nobs; i++)
    mean += um_model_result_intensity(result, i, 0, -1) / (double)result->nobs;
  size_t n = (size_t)snprintf(text, sizeof text, HEAD);
  for (size_t i = 0; i < result->nobs; i++) {
    char at[32];
    um_orbit_time_format(tables->t_obs[i], at);
    n += (size_t)snprintf(text + n, sizeof text - n, "%s,radiant_intensity,vis,%.9g,%.9g\n", at,
                          um_model_result_intensity(result, i, 0, -1), 0.01 * mean);
  }
  put("m.csv", text);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  return m;
}

static struct um_compare_spins *find(const struct um_model *model,
                                     const struct um_compare_measurements *m, size_t keep)
{
  static const double degrees[] = {30.0, 60.0, 90.0, 120.0};
  struct um_compare_on_map *on_map = NULL;
  struct um_compare_spins *spins = NULL;
  struct um_model_map *map = NULL;
  double phase[4];
  for (size_t i = 0; i < 4; i++) phase[i] = degrees[i] * UM_DEG;
  struct um_model_map_grid grid = {9.0 * UM_DEG, phase, 4, 4, 0.0};
  struct um_compare_spin_search search = {12.0 * UM_DEG, 6.0 * UM_DEG, 190.0, 210.0, keep};
  assert_ok(um_compare_on_map_create(context, model, m, &on_map));
  assert_ok(um_model_map_create(context, model, &grid, &map));
  assert_ok(um_compare_spins_find(context, model, on_map, map, &search, &spins));
  um_model_map_destroy(context, &map);
  um_compare_on_map_destroy(context, &on_map);
  for (size_t i = 0; i < spins->count; i++)
    print_message("%zu: axis %.4f %.4f %.4f period %.3f phase %.2f chi2 %.4g apart %.3g\n", i,
                  spins->spin[i].axis.x, spins->spin[i].axis.y, spins->spin[i].axis.z,
                  spins->spin[i].period, spins->spin[i].phase / UM_DEG, spins->spin[i].chi2,
                  spins->spin[i].apart);
  return spins;
}

/* Turn at the reference time that the scenario's own law has [rad]. */
static double hidden_phase(const struct um_compare_spins *spins)
{
  double at;
  assert_ok(um_orbit_time_parse(context, "2016-09-06T18:12:00Z", &at));
  return 70.0 * UM_DEG + 2.0 * UM_PI * (spins->at_tai - at) / 200.0;
}

/* A twentieth of a degree and of a second: the fit ends where the next step gains less than a tenth
 * of a sigma, and a sigma is some hundredths of a degree. */
static void found_in(const char *time, const char *effects)
{
  struct um_model *model = body_of(time, effects, LOPSIDED);
  struct um_compare_measurements *m = measure(model);
  struct um_compare_spins *spins = find(model, m, 8);
  const struct um_compare_spin *best = &spins->spin[0];
  assert_close(um_vec3_angle(best->axis, um_vec3(0.36, 0.48, 0.8)) / UM_DEG, 0.0, 0.05);
  assert_close(best->period, 200.0, 0.05);
  assert_close(remainder(best->phase - hidden_phase(spins), 2.0 * UM_PI) / UM_DEG, 0.0, 0.05);
  assert_true(best->chi2 < 0.05 && best->apart == 0.0);
  for (size_t i = 1; i < spins->count; i++) assert_true(spins->spin[i].apart > 3.0);
  um_compare_spins_destroy(context, &spins);
  um_compare_measurements_destroy(context, &m);
  um_model_destroy(context, &model);
}

static void hidden_spin_is_found(void **state)
{
  (void)state;
  found_in(dusk, NO_EARTH);
}

/* By day the Earth gives 8 to 99 % of the light of an instant, the surfaces up to 6 W/sr to
 * each other: both are in the search. */
static void hidden_spin_is_found_above_the_lit_earth(void **state)
{
  (void)state;
  found_in(day, "");
}

/* The box agrees with its half turns about z (phase + 180 deg), and about x and y (axis and sense
 * reversed): four solutions of the same light, and the hidden one among them. */
static void symmetric_body_is_ambiguous(void **state)
{
  (void)state;
  struct um_model *model = body_of(dusk, NO_EARTH, BOX);
  struct um_compare_measurements *m = measure(model);
  struct um_compare_spins *spins = find(model, m, 12);
  size_t same = 0, reversed = 0;
  for (size_t i = 0; i < spins->count && spins->spin[i].apart < 1.0; i++) {
    const struct um_compare_spin *s = &spins->spin[i];
    double away = um_vec3_angle(s->axis, um_vec3(0.36, 0.48, 0.8)) / UM_DEG;
    double turn = remainder(s->phase - hidden_phase(spins), UM_PI) / UM_DEG;
    if (away < 0.1 && fabs(s->period - 200.0) < 0.1 && fabs(turn) < 0.1) same++;
    if (away > 179.9 && fabs(s->period + 200.0) < 0.1) reversed++;
  }
  assert_int_equal(same, 2);
  assert_int_equal(reversed, 2);
  um_compare_spins_destroy(context, &spins);
  um_compare_measurements_destroy(context, &m);
  um_model_destroy(context, &model);
}

static void refused(void **state)
{
  (void)state;
  struct um_model *model = body_of(dusk, NO_EARTH, BOX);
  struct um_compare_measurements *m = NULL;
  struct um_compare_on_map *on_map = NULL;
  struct um_compare_spin_search s = {0.2, 0.1, 190.0, 210.0, 4};
  put("m.csv", HEAD DAY "12:00.000Z,radiant_intensity,vis,1,0.1\n" DAY
                        "12:10.000Z,radiant_intensity,vis,1,\n");
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_ok(um_compare_on_map_create(context, model, m, &on_map));
  assert_refused(
      um_compare_spins_check(context, model, on_map, &s), UM_ERR_INPUT,
      "m.csv: 2 rows of light in sunlight, in bands that end by 2.5 um; accepted: 5 or more");
  um_compare_on_map_destroy(context, &on_map);
  um_compare_measurements_destroy(context, &m);
  put("m.csv", HEAD DAY
      "12:00.000Z,radiant_intensity,vis,1,0.1\n" DAY "12:10.000Z,radiant_intensity,vis,1,0.1\n" DAY
      "12:20.000Z,radiant_intensity,vis,1,0.1\n" DAY "12:30.000Z,radiant_intensity,vis,1,\n" DAY
      "12:40.000Z,radiant_intensity,vis,1,0.1\n");
  assert_ok(um_compare_measurements_read(context, "m.csv", &m));
  assert_ok(um_compare_on_map_create(context, model, m, &on_map));
  assert_refused(um_compare_spins_check(context, model, on_map, &s), UM_ERR_INPUT,
                 "m.csv:5: column 'sigma' is empty; accepted: a sigma in every row");
  um_compare_on_map_destroy(context, &on_map);
  um_compare_measurements_destroy(context, &m);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(hidden_spin_is_found, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(hidden_spin_is_found_above_the_lit_earth, model_set_up,
                                      model_tear_down),
      cmocka_unit_test_setup_teardown(symmetric_body_is_ambiguous, model_set_up, model_tear_down),
      cmocka_unit_test_setup_teardown(refused, model_set_up, model_tear_down)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
