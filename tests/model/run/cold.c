/* Light of instants that stand alone against a run with its history of heat: a box with a plate
 * beside it, spinning above the lit Earth, exposures of 20 s. Heat does not show at 0.38-0.78 um,
 * so sunlight, the Earth's light and that between surfaces are the same, and what air and
 * instrument make of them: lines of sight are traced alike, loads of the Earth asked of the same
 * sky. Then the same instants with the attitudes of others. */
#include <math.h>

#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/geometry/posed.h"
#include "model/run/run.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

#define SCENARIO "cold_scenario.yaml"
#define SHELL    "shell: {areal_heat_capacity_J_m2_K: 3000}, lumped: true"

static const char *const text =
    "schema: 1\n"
    "name: cold\n"
    "time: {start_utc: 2016-09-06T08:31:00Z, stop_utc: 2016-09-06T08:40:00Z, step_s: 60, "
    "exposure_s: 20}\n"
    "orbit:\n"
    "  tle: |\n"
    "    1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "    2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n"
    "attitude:\n"
    "  - spin: {axis_gcrs: [0.36, 0.48, 0.8], axis_body: [0, 0, 1], period_s: 200}\n"
    "observer:\n"
    "  station: {name: Graz, latitude_deg: 47.067, longitude_deg: 15.493, height_m: 495}\n"
    "  air: {profile: us_standard}\n"
    "thermal: {start: isothermal, orbits_before: 0}\n"
    "bands: {vis: {from_um: 0.38, to_um: 0.78, bins: 4}}\n"
    "optics: {interreflection_samples: 64}\n"
    "parts:\n"
    "  - {name: bus, box: {size_m: [1, 2, 1.5]}, outside: grey_white, " SHELL "}\n"
    "  - {name: plate, plate: {size_m: [3, 1]}, front: grey_white, back: grey_metal, pose: "
    "{position_m: [0, 2, 0], rotation_deg: [30, 50, 0]}, " SHELL "}\n";

static struct um_model *model_made(void)
{
  struct um_model *model = NULL;
  FILE *f = fopen(SCENARIO, "w");
  assert_non_null(f);
  fputs(text, f);
  assert_int_equal(fclose(f), 0);
  if (um_model_create(context, SCENARIO, NULL, &model) != UM_OK)
    fail_msg("%s", um_core_message(context));
  remove(SCENARIO);
  return model;
}

static const int mechanisms[] = {UM_MECHANISM_SUN, UM_MECHANISM_EARTH, UM_MECHANISM_INTERREFLECTED};

/* Largest difference of `a` at observation i from `b` at k, of the light there [1]. */
static double apart(const struct um_model_result *a, size_t i, const struct um_model_result *b,
                    size_t k)
{
  double largest = fabs(a->irradiance[i] / b->irradiance[k] - 1.0);
  for (int m = 0; m < 3; m++) {
    double own = um_model_result_intensity(a, i, 0, mechanisms[m]);
    double other = um_model_result_intensity(b, k, 0, mechanisms[m]);
    largest = fmax(largest, fabs(own - other) / um_model_result_intensity(b, k, 0, -1));
  }
  return largest;
}

static void as_a_run_with_heat(void **state)
{
  (void)state;
  struct um_model *model = model_made();
  struct um_model_tables *whole = NULL, *posed = NULL;
  struct um_model_result *run = NULL, *cold = NULL;
  double least[3] = {0.0, 0.0, 0.0};
  assert_int_equal(um_model_precompute(context, model, &whole), UM_OK);
  assert_int_equal(um_model_run(context, model, whole, &run), UM_OK);
  const struct um_model_instants instants = {.time = whole->t_obs, .count = whole->nobs};
  assert_int_equal(um_model_precompute_unposed(context, model, &instants, &posed), UM_OK);
  struct um_model_sampling same = {0, 0};
  assert_int_equal(um_model_precompute_posed(context, model, same, true, posed), UM_OK);
  assert_int_equal(um_model_run_cold(context, model, posed, &cold), UM_OK);
  assert_int_equal(cold->nobs, run->nobs);
  assert_int_equal(posed->nsub, whole->nsub);
  assert_true(posed->nsub > 1);
  for (size_t k = 0; k < run->nobs; k++) {
    assert_close(apart(cold, k, run, k), 0.0, 1e-9);
    for (int m = 0; m < 3; m++) least[m] += um_model_result_intensity(run, k, 0, mechanisms[m]);
  }
  print_message("light of all instants: Sun %.3g, Earth %.3g, between %.3g W/sr\n", least[0],
                least[1], least[2]);
  assert_true(least[1] > 0.1 * least[0] && least[2] > 1e-3 * least[0]);
  um_model_result_destroy(context, &cold);

  /* posed again: the body turned by 50 deg about its x, as um_model_run_turned has it */
  struct um_model_result *turned = NULL;
  for (size_t i = 0; i < posed->nobs * posed->nsub; i++)
    posed->sample[i].q =
        um_quat_then(posed->sample[i].q, um_quat_from_axis(um_vec3(1.0, 0.0, 0.0), 50.0 * UM_DEG));
  assert_int_equal(um_model_precompute_posed(context, model, same, true, posed), UM_OK);
  assert_int_equal(um_model_run_cold(context, model, posed, &turned), UM_OK);
  double moved = 0.0;
  for (size_t k = 0; k < run->nobs; k++) moved = fmax(moved, apart(turned, k, run, k));
  assert_true(moved > 0.5);
  um_model_result_destroy(context, &turned);
  um_model_result_destroy(context, &run);
  um_model_tables_destroy(context, &posed);
  um_model_tables_destroy(context, &whole);
  um_model_destroy(context, &model);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(as_a_run_with_heat, context_set_up, context_tear_down)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
