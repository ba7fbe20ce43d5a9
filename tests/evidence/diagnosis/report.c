/* The files of a diagnosis, from one that is filled by hand: its numbers stand where they belong,
 * the improved scenario is the model that was diagnosed, and a folder that cannot be written is
 * not there. */
#include "base/core/csv.h"
#include "tests/app/json.h"
#include "tests/evidence/diagnosis/report_test.h"

static void test_json(const char *path)
{
  static const char *const want[] = {
      "\"scenario\": \"pass\"",
      "\"verdict\": \"not_identifiable\"",
      "\"sentence\": \"Missing: \\\"power\\\"\\u000aand more.\"",
      "\"baseline\": {",
      "\"chi2_red\": ",
      "\"metrics\": [",
      "\"quantity\": \"temperature\", \"of\": \"bus.interior\", \"unit\": \"K\"",
      "\"unit\": \"mag\", \"residual_unit\": \"flux of magnitude 0\", \"all\": {\"count\": 1",
      "{\"effect\": \"internal_power\", \"target\": \"bus\", \"parameters\": [{",
      ("\"name\": \"power_W\", \"value\": 41.5, \"sigma\": 0.7, \"unit\": \"W\", \"whole\": {"
       "\"what\": \"power inside\", \"value\": 66.5, \"sigma\": 0.7, \"instead_of\": 25, "
       "\"unit\": \"W\"}}]"),
      /* 0.1 is what the scenario's effects state, beside nothing of the part */
      ("\"what\": \"electrical extraction\", \"value\": 0.1875, \"sigma\": 0.01, "
       "\"instead_of\": 0.1"),
      "\"standing\": \"one_of_group\"",
      "\"not_quite_noise\": true",
      "\"superseded\": [\n    {\"effect\": \"earth_ir_level\", \"target\": null",
      "\"what\": \"outgoing longwave radiation\", \"value\": 118.5",
      "\"bic_behind\": 10}",
      "\"residual\": {\"channel\": \"bus.+y\", \"chi2_red\": 7.5, \"mean_in_sigma\": -2",
      "\"excluded_by\": \"prior\"",
      "{\"effect\": \"internal_power:bus\", \"alternative\": \"emittance:grey_white\", \"what\"",
      "\"alternative\": \"time_tag\", \"what\": null, \"told_apart_by\": \"stars in frames\", "
      "\"passes\": []}",
      "\"p_value\": 1e-09, \"delta_bic\": -4990, \"held_out\": {\"before\": 5000, \"after\": 130}",
      "\"indistinguishable_from\": [\"emittance:grey_white\"]",
      "\"next_measurement\": {\"what\": \"temperature of bus.+y in the umbra\"",
      "\"segment\": \"umbra\"",
      "\"unexplained\": {\"coordinate\": \"time_s\"",
      "\"part\": \"bus.interior\", \"shape\": \"pulse\", \"start_utc\": "
      "\"2016-09-06T18:10:00.000Z\"",
      "\"last_s\": 80",
      "\"period_s\": null",
      "\"bic_behind\": {\"step\": 0",
      "\"energy_J\": 4400",
      "\"history\": [",
      "\"ranking\": [",
      "\"effect\": \"time_tag\", \"target\": null",
      "\"cost\": {\"candidates\": 3",
  };
  const char *where;
  char *text = read_text(path);
  if (!json_is_valid(text, &where)) fail_msg("not JSON from here on: %.80s", where);
  expect_in(text, want, sizeof want / sizeof want[0]);
  um_core_free(context, text);
}

/* Every row of the measurements, in their own unit; the residuals of both models square-sum to
 * their chi-squares. */
static void test_tables(const struct world *w)
{
  struct um_core_csv *csv;
  double sum[2] = {0.0, 0.0}, value;
  assert_ok(um_core_csv_read(context, "out/fit.csv", &csv));
  assert_int_equal(um_core_csv_rows(csv), w->forward->observations.count);
  for (size_t i = 0; i < um_core_csv_rows(csv); i++)
    for (size_t k = 0; k < 2; k++) {
      assert_ok(um_core_csv_number(context, csv, i, 7 + k, &value));
      sum[k] += value * value;
    }
  assert_close(sum[0], w->d.chi2, 1e-7 * w->d.chi2); /* nine digits are written */
  assert_close(sum[1], w->d.chi2_after, 1e-7 * w->d.chi2_after);
  size_t last = um_core_csv_rows(csv) - 1; /* the magnitude came last */
  assert_string_equal(um_core_csv_text(csv, last, 1), "magnitude_ab");
  assert_ok(um_core_csv_number(context, csv, last, 3, &value));
  assert_close(value, 5.5, 0.0);
  assert_ok(um_core_csv_number(context, csv, last, 4, &value));
  assert_close(value, 0.02, 0.0);
  assert_ok(um_core_csv_number(context, csv, last, 6, &value));
  assert_true(value > 0.0 && value < 15.0);
  um_core_csv_destroy(&csv);
  assert_ok(um_core_csv_read(context, "out/ranking.csv", &csv));
  assert_int_equal(um_core_csv_rows(csv), 3);
  assert_string_equal(um_core_csv_text(csv, 1, 1), "emittance");
  assert_string_equal(um_core_csv_text(csv, 1, 2), "grey_white");
  assert_string_equal(um_core_csv_text(csv, 2, 12), "tested");
  um_core_csv_destroy(&csv);
  assert_ok(um_core_csv_read(context, "out/heat.csv", &csv));
  assert_int_equal(um_core_csv_rows(csv), 40);
  assert_string_equal(um_core_csv_text(csv, 0, 0), "2016-09-06T18:08:00.000Z");
  assert_string_equal(um_core_csv_text(csv, 39, 1), "2016-09-06T18:14:00.000Z");
  um_core_csv_destroy(&csv);
}

static void test_files(void **state)
{
  (void)state;
  struct world w;
  world_make(&w);
  write_out(&w);
  test_json("out/diagnosis.json");
  test_tables(&w);
  remove_out();
  world_end(&w);
}

/* The text keeps what the user wrote; the changes of the command line and the effects stand in it;
 * the model that it makes says the same of every observation. */
static void test_improved(void **state)
{
  (void)state;
  static const char *const want[] = {
      "# Written by umbra 9.9: umbra diagnose scene m.csv\n",
      "# Verdict: not_identifiable. Missing: \"power\" and more.\n",
      " before, ",
      "# a box and a panel\n",
      "tle_file: ../../scene/orbit.tle # of the day",
      "mesh: ../../scene/panel.obj",
      "power_W: 25, conductance_W_K: 2",
      "  - {effect: panel_extraction, target: panel, efficiency: 0.1875} # guessed\n"
      "  - {effect: albedo, off: true}\n"
      "  - {effect: solar_absorptance, target: grey_white, shift: 0.05",
      "  - {effect: internal_power, target: bus, power_W: 41.5}\n"
      "  - {effect: zero_point, target: lwir, factor: 1.0078125}\n"
      "measurements:\n",
  };
  struct world w;
  world_make(&w);
  write_out(&w);
  char *text = read_text("out/improved/scenario.yaml");
  expect_in(text, want, sizeof want / sizeof want[0]);
  um_core_free(context, text);
  struct um_sensitivity_forward *again;
  assert_ok(um_sensitivity_forward_create(context, "out/improved", NULL, w.measurements,
                                          UM_VARIANT_TIGHT, &again));
  double *value;
  assert_ok(um_core_allocate(context, again->observations.count, sizeof *value, &value));
  assert_ok(um_sensitivity_forward_evaluate(context, again, NULL, 0, value));
  for (size_t i = 0; i < again->observations.count;
       i++) /* effects come in another order: rounding */
    assert_close(value[i], w.d.value_after[i], 1e-9 * fabs(w.d.value_after[i]));
  um_core_free(context, value);
  um_sensitivity_forward_destroy(context, &again);
  remove_out();
  world_end(&w);
}

/* A mesh that has gone since: said in one line, nothing left. */
static void test_failure(void **state)
{
  (void)state;
  struct world w;
  struct um_core_folder *folder;
  world_make(&w);
  assert_int_equal(rename("scene", "gone"), 0);
  assert_ok(um_core_folder_begin(context, "out", false, &folder));
  um_core_message_clear(context);
  assert_int_equal(um_diagnosis_report_write(context, &w.d, "c", "v", false, folder), UM_ERR_IO);
  assert_string_equal(um_core_message(context), "orbit.tle: No such file or directory");
  um_core_folder_abort(&folder);
  assert_int_equal(access("out", F_OK), -1);
  assert_int_equal(rename("gone", "scene"), 0);
  world_end(&w);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_files), cmocka_unit_test(test_improved),
                                     cmocka_unit_test(test_failure)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
