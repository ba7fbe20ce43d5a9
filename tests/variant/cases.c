/* Cases of heat: balances against closed forms, limits and margins, and what is refused. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/near.h"
#include "tests/support/with_context.h"
#include "variant/cases.h"

#define FILE_NAME "model_cases.yaml"

/* A black two-sided plate that faces the Sun, 500 km above an Earth that sends nothing, with the
 * Sun in the plane of the orbit; it begins in sunlight. */
static const char scenario[] =
    "schema: 1\nname: plate\n"
    "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T13:40:00Z, step_s: 30, "
    "light_time: false}\n"
    "orbit: {circular: {altitude_km: 500, beta_deg: 0, period_s: 5677}}\n"
    "attitude:\n  - sun: {axis_body: [0, 0, 1], clock_body: [1, 0, 0]}\n"
    "environment: {sun: frozen, sun_distance_au: 1, solar_irradiance_W_m2: 1361, albedo: 0, "
    "olr_W_m2: 0, shadow: cylinder, shadow_radius_km: 6371, earth_radius_km: 6371, disc: point}\n"
    "parts:\n"
    "  - {name: plate, plate: {size_m: [1, 1]}, front: black, back: black, lumped: true, shell: "
    "{areal_heat_capacity_J_m2_K: 5000}}\n"
    "thermal: {orbits_before: 1, space_temperature_K: 0}\n";

static int teardown(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  (void)remove(FILE_NAME);
  return 0;
}

static void write_scenario(const char *more)
{
  FILE *file = fopen(FILE_NAME, "w");
  assert_non_null(file);
  fprintf(file, "%s%s", scenario, more);
  assert_int_equal(fclose(file), 0);
}

static struct um_variant_cases *compute(const char *more)
{
  struct um_model_options options = {0};
  struct um_variant_cases *cases = NULL;
  write_scenario(more);
  if (um_variant_cases_create(context, FILE_NAME, &options, &cases) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return cases;
}

static const struct um_variant_case_place *place_of(const struct um_variant_case *c,
                                                    const char *name)
{
  for (size_t p = 0; p < c->nplace; p++)
    if (strcmp(c->place[p].name, name) == 0) return &c->place[p];
  fail_msg("no place is called '%s'", name);
  return NULL;
}

/* 2 sigma T^4 = S, and S times the sunlit share of the orbit, 1 - (asin(R/r) + R/au)/pi behind a
 * cylinder: the Sun at 1 au stands R/au off its direction from the geocentre at the edge of the
 * shadow, which is 1.6 mK. Edges found to 1e-3 s are 2e-5 K of the mean. */
static void balances_are_closed_forms(void **state)
{
  (void)state;
  struct um_variant_cases *cases =
      compute("cases:\n  now: {analysis: steady}\n  mean: {analysis: orbit_mean}\n  orbit: {}\n");
  assert_int_equal(cases->count, 3);
  double sunlit = 1.0 - (asin(6371.0 / 6871.0) + 6371e3 / UM_AU) / UM_PI;
  double now = pow(1361.0 / (2.0 * UM_STEFAN_BOLTZMANN), 0.25);
  const struct um_variant_case_place *steady = place_of(&cases->item[0], "plate");
  const struct um_variant_case_place *mean = place_of(&cases->item[1], "plate");
  const struct um_variant_case_place *orbit = place_of(&cases->item[2], "plate");
  check_near("steady", steady->mean, now, 1e-6);
  check_near("orbit mean", mean->mean, now * pow(sunlit, 0.25), 2e-4);
  /* the periodic orbit stays below the balance in sunlight and crosses that of the mean */
  assert_true(orbit->highest < steady->mean && orbit->highest > mean->mean);
  assert_true(orbit->lowest < mean->mean && orbit->mean < mean->mean);
  um_variant_cases_destroy(context, &cases);
}

/* A case is what the command line makes of the same changes, and margins are what they say. */
static void changes_and_margins(void **state)
{
  (void)state;
  struct um_variant_cases *cases =
      compute("limits:\n  - {of: plate, minimum_K: 200, maximum_K: 300, uncertainty_K: 4}\n"
              "  - {of: plate.front, maximum_K: 350}\n"
              "cases:\n  hot: {analysis: steady, set: [environment.solar_irradiance_W_m2=1414]}\n"
              "  edge_on: {analysis: steady, set: [\"attitude.0.sun={axis_body: [1, 0, 0], "
              "clock_body: [0, 0, "
              "1]}\", \"parts.plate.groups={plate: {power_W: 100}}\"]}\n"
              "  level: {analysis: steady, with: [\"solar_irradiance,irradiance_factor=0.9\"]}\n");
  /* the name that the parameter had before, which is said */
  assert_non_null(strstr(um_core_log_text(context), "irradiance_factor is now called factor"));
  double hot = pow(1414.0 / (2.0 * UM_STEFAN_BOLTZMANN), 0.25);
  const struct um_variant_case_place *p = place_of(&cases->item[0], "plate");
  check_near("hot", p->highest, hot, 1e-6);
  check_near("margin of the minimum", p->margin_low, hot - 4.0 - 200.0, 1e-6);
  check_near("margin of the maximum", p->margin_high, 300.0 - 4.0 - hot, 1e-6);
  check_near("least margin", um_variant_case_margin(p), 300.0 - 4.0 - hot, 1e-6);
  p = place_of(&cases->item[0], "plate.front");
  assert_true(isnan(p->margin_low));
  check_near("one bound", um_variant_case_margin(p), 350.0 - hot, 1e-6);
  assert_true(isnan(um_variant_case_margin(place_of(&cases->item[0], "plate.back"))));
  p = place_of(&cases->item[1], "plate");
  check_near("edge on", p->mean, pow(100.0 / (2.0 * UM_STEFAN_BOLTZMANN), 0.25), 1e-6);
  p = place_of(&cases->item[2], "plate");
  check_near("less of the Sun", p->mean, pow(0.9 * 1361.0 / (2.0 * UM_STEFAN_BOLTZMANN), 0.25),
             1e-6);
  um_variant_cases_destroy(context, &cases);
}

/* Without cases the scenario itself is one. */
static void nominal(void **state)
{
  (void)state;
  struct um_variant_cases *cases = compute("");
  assert_int_equal(cases->count, 1);
  assert_string_equal(cases->item[0].name, "nominal");
  assert_true(cases->item[0].analysis == UM_ANALYSIS_TRANSIENT);
  um_variant_cases_destroy(context, &cases);
}

static void refused(const char *more, const char *words)
{
  struct um_model_options options = {0};
  struct um_variant_cases *cases = NULL;
  write_scenario(more);
  um_core_message_clear(context);
  assert_int_equal(um_variant_cases_create(context, FILE_NAME, &options, &cases), UM_ERR_INPUT);
  assert_null(cases);
  if (strstr(um_core_message(context), words) == NULL)
    fail_msg("'%s' lacks '%s'", um_core_message(context), words);
}

static void bad_input(void **state)
{
  (void)state;
  refused("limits: [{of: plat, maximum_K: 300}]\n", "no place 'plat'; did you mean 'plate'?");
  refused("limits: [{of: plate}]\n", "no bound is given");
  refused("limits: [{of: plate, minimum_K: 300, maximum_K: 200}]\n", "300 is not below");
  refused("limits: [{of: plate, minimum_K: 3}, {of: plate, maximum_K: 400}]\n", "has a limit");
  refused("cases: {hot: {set: [environment.albedo=2]}}\n", "cases.hot: ");
  refused("cases: {hot: {analysis: mean}}\n", "orbit_mean");
  refused("cases: {m: {analysis: orbit_mean, set: [thermal.start=isothermal, "
          "thermal.orbits_before=0, \"time.stop_utc=2020-03-20T12:10:00Z\"]}}\n",
          "no whole orbit");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(balances_are_closed_forms),
      cmocka_unit_test(changes_and_margins),
      cmocka_unit_test(nominal),
      cmocka_unit_test(bad_input),
  };
  return cmocka_run_group_tests(tests, context_set_up, teardown);
}
