/* Measurements, comparison, fit and diagnosis by the library beside the command's. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/app/table.h"
#include "tests/library/session_test.h"

#define BOX "box.yaml", "--set", "time.step_s=6", "--set", "time.start_utc=2016-09-06T18:08:00Z"

static struct umbra_scenario *scenario;
static struct umbra_measurements *measured;

/* A box whose emittance is 0.8 of what its scenario says. */
static int enter(void **state)
{
  if (session_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  command_expect(0, "synth", BOX, "--noise", "0.01,0.001", "--temperatures", "bus", "--seed", "5",
                 "-o", "m.csv", "--with", "emittance:grey_white,factor=0.8", NULL);
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_scenario_set(umbra, scenario, "time.step_s", "6"));
  ok(umbra_scenario_set(umbra, scenario, "time.start_utc", "2016-09-06T18:08:00Z"));
  ok(umbra_measurements_read(umbra, "m.csv", &measured));
  return 0;
}

static int leave(void **state)
{
  umbra_measurements_close(&measured);
  umbra_scenario_close(&scenario);
  return session_leave(state);
}

static void write_as(const struct umbra_result *result, const char *command)
{
  struct umbra_write write = UMBRA_WRITE;
  write.command = command;
  ok(umbra_result_write(umbra, result, "ours", &write));
}

static void test_compare(void **state)
{
  (void)state;
  static const char command[] = "umbra compare box.yaml --set time.step_s=6 --set "
                                "time.start_utc=2016-09-06T18:08:00Z m.csv --no-plots --out theirs";
  static const char *const files[] = {"compare.json", "residuals.csv", NULL};
  struct umbra_result *result;
  ok(umbra_compare(umbra, scenario, measured, &result));
  umbra_measurements_close(&measured); /* the result keeps it */
  write_as(result, command);
  command_expect(0, "compare", BOX, "m.csv", "--no-plots", "--out", "theirs", NULL);
  command_expect_same("ours", "theirs", files);
  const struct umbra_comparison *c = umbra_result_comparison(result);
  assert_int_equal(c->nchannel, 3);
  assert_close(c->chi2, c->chi2_reduced * c->dof, 1e-9 * c->chi2);
  assert_true(c->chi2_reduced > 10.0); /* the scenario is wrong */
  double chi2 = 0.0;
  size_t n = 0;
  for (size_t i = 0; i < c->nchannel; i++) {
    chi2 += c->channel[i].chi2;
    n += c->channel[i].count;
    assert_true(c->channel[i].quantity[0] != '\0' && c->channel[i].of[0] != '\0');
  }
  assert_close(chi2, c->chi2, 1e-9 * chi2);
  const struct umbra_array *residual = umbra_result_array(result, "residual");
  const struct umbra_array *sigma = umbra_result_array(result, "sigma");
  const struct umbra_array *model = umbra_result_array(result, "model_sigma");
  assert_int_equal(residual->shape[0], n);
  chi2 = 0.0;
  for (size_t i = 0; i < n; i++)
    chi2 += residual->data[i] * residual->data[i] /
            (sigma->data[i] * sigma->data[i] + model->data[i] * model->data[i]);
  assert_close(chi2, c->chi2, 1e-9 * chi2);
  assert_null(umbra_result_verdict(result));
  umbra_result_close(&result);
}

/* The rows of a table as a caller has them. */
struct columns {
  size_t count;
  double time[256], value[256], sigma[256], exposure[256];
  const char *quantity[256], *of[256];
  struct table table;
};

static struct umbra_columns columns_of(struct columns *c)
{
  struct umbra_columns columns = UMBRA_COLUMNS;
  c->table = table_read("m.csv");
  c->count = c->table.nrow;
  for (size_t i = 0; i < c->count; i++) {
    int minute;
    double second;
    const char *time = table_text(&c->table, i, "time_utc");
    assert_int_equal(sscanf(time, "2016-09-06T18:%d:%lf", &minute, &second), 2);
    c->time[i] = 1473184800.0 + 60.0 * minute + second; /* 2016-09-06T18:00:00Z */
    c->value[i] = strtod(table_text(&c->table, i, "value"), NULL);
    c->sigma[i] = strtod(table_text(&c->table, i, "sigma"), NULL);
    c->exposure[i] = 0.0;
    c->quantity[i] = table_text(&c->table, i, "quantity");
    c->of[i] = table_text(&c->table, i, "of");
  }
  columns.count = c->count;
  columns.time_unix_s = c->time;
  columns.quantity = c->quantity;
  columns.of = c->of;
  columns.value = c->value;
  columns.sigma = c->sigma;
  columns.exposure_s = c->exposure;
  return columns;
}

/* Arrays are the file: the same chi-square. */
static void test_arrays(void **state)
{
  (void)state;
  static struct columns c;
  const struct umbra_columns columns = columns_of(&c);
  struct umbra_measurements *made;
  struct umbra_result *file, *arrays;
  ok(umbra_measurements_make(umbra, &columns, &made));
  ok(umbra_compare(umbra, scenario, measured, &file));
  ok(umbra_compare(umbra, scenario, made, &arrays));
  double expected = umbra_result_comparison(file)->chi2;
  assert_close(umbra_result_comparison(arrays)->chi2, expected, 1e-5 * expected);
  umbra_result_close(&arrays);
  umbra_result_close(&file);
  umbra_measurements_close(&made);
  table_release(&c.table);
}

static void test_wrong_arrays(void **state)
{
  (void)state;
  static struct columns c;
  struct umbra_columns columns = columns_of(&c), wrong = columns;
  struct umbra_measurements *made;
  wrong.size = 3;
  refused(umbra_measurements_make(umbra, &wrong, &made), UMBRA_ERR_INPUT, "size");
  assert_null(made);
  wrong = columns;
  wrong.value = NULL;
  refused(umbra_measurements_make(umbra, &wrong, &made), UMBRA_ERR_INPUT, "column");
  wrong = columns;
  wrong.count = 0;
  refused(umbra_measurements_make(umbra, &wrong, &made), UMBRA_ERR_INPUT, "no measurements");
  double sigma = c.sigma[2], time = c.time[5];
  c.sigma[2] = -1.0;
  refused(umbra_measurements_make(umbra, &columns, &made), UMBRA_ERR_INPUT,
          "measurements:3: sigma");
  c.sigma[2] = sigma;
  c.time[5] = 1e12;
  refused(umbra_measurements_make(umbra, &columns, &made), UMBRA_ERR_INPUT, "1960 to 2100");
  c.time[5] = time - 60.0;
  refused(umbra_measurements_make(umbra, &columns, &made), UMBRA_ERR_INPUT, "time order");
  c.time[5] = time;
  const char *quantity = c.quantity[1];
  c.quantity[1] = "temprature";
  refused(umbra_measurements_make(umbra, &columns, &made), UMBRA_ERR_INPUT, "'temperature'");
  c.quantity[1] = quantity;
  c.exposure[1] = -2.0;
  refused(umbra_measurements_make(umbra, &columns, &made), UMBRA_ERR_INPUT, "exposure -2;");
  c.exposure[1] = 0.0;
  c.value[1] = (double)NAN;
  refused(umbra_measurements_make(umbra, &columns, &made), UMBRA_ERR_INPUT,
          "measurements:2: value");
  table_release(&c.table);
  refused(umbra_measurements_read(umbra, "none.csv", &made), UMBRA_ERR_IO, "none.csv");
}

/* Geometry of rows: kilometres and degrees, all of it or none. */
static void test_geometry_of_arrays(void **state)
{
  (void)state;
  static struct columns c;
  static double height[256], azimuth[256], elevation[256];
  struct umbra_columns columns = columns_of(&c);
  struct umbra_measurements *made;
  for (size_t i = 0; i < c.count; i++) {
    height[i] = 700.0;
    azimuth[i] = 350.0;
    elevation[i] = 89.0;
  }
  columns.satellite_height_km = height;
  columns.azimuth_deg = azimuth;
  refused(umbra_measurements_make(umbra, &columns, &made), UMBRA_ERR_INPUT, "elevation [deg] nan");
  columns.elevation_deg = elevation;
  ok(umbra_measurements_make(umbra, &columns, &made));
  umbra_measurements_close(&made);
  elevation[3] = 91.0;
  refused(umbra_measurements_make(umbra, &columns, &made), UMBRA_ERR_INPUT, "elevation [deg] 91;");
  elevation[3] = 89.0;
  azimuth[3] = 361.0;
  refused(umbra_measurements_make(umbra, &columns, &made), UMBRA_ERR_INPUT, "azimuth [deg] 361;");
  azimuth[3] = 0.0;
  height[3] = 2e6;
  refused(umbra_measurements_make(umbra, &columns, &made), UMBRA_ERR_INPUT, "height [km] 2000000;");
  height[3] = 700.0;
  height[0] = azimuth[0] = elevation[0] = (double)NAN;
  refused(umbra_measurements_make(umbra, &columns, &made), UMBRA_ERR_INPUT,
          "measurements:2: satellite height [km] 700; accepted: none, as in the first row");
  table_release(&c.table);
}

/* A fit from a start, and the same of the command: the same numbers. */
static void test_fit(void **state)
{
  (void)state;
  struct umbra_effect_change change[2] = {UMBRA_EFFECT_CHANGE, UMBRA_EFFECT_CHANGE};
  struct umbra_result *result;
  static const char *const files[] = {"fit.csv", NULL};
  change[0].effect = change[1].effect = "emittance";
  change[0].target = change[1].target = "grey_white";
  refused(umbra_fit(umbra, scenario, measured, change, 2, &result), UMBRA_ERR_INPUT, "twice");
  change[0].off = 1;
  refused(umbra_fit(umbra, scenario, measured, change, 1, &result), UMBRA_ERR_INPUT,
          "emittance is off");
  assert_null(result);
  change[0].off = 0;
  ok(umbra_fit(umbra, scenario, measured, change, 1, &result));
  const struct umbra_verdict *v = umbra_result_verdict(result);
  assert_int_equal(v->nfinding, 1);
  const struct umbra_finding *f = v->finding;
  assert_string_equal(f->effect, "emittance");
  assert_string_equal(f->target, "grey_white");
  assert_int_equal(f->confidence, UMBRA_CHOSEN);
  assert_true(fabs(f->estimate[0].value - 0.8) < 3.0 * f->estimate[0].sigma);
  assert_true(v->chi2_after < 0.2 * v->chi2_before);
  write_as(result, "umbra fit");
  command_expect(0, "fit", BOX, "m.csv", "--add", "emittance:grey_white", "--no-plots", "--out",
                 "theirs", NULL);
  command_expect_same("ours", "theirs", files);
  umbra_result_close(&result);
}

/* What the command finds in tests/app/diagnose.c, as structure. */
static void test_diagnose(void **state)
{
  (void)state;
  static const char *const only[] = {"emittance", "area:bus", "zero_point", "albedo_level"};
  static const char *const files[] = {"fit.csv", NULL};
  static const char *const none[] = {"emitance"};
  struct umbra_diagnose_settings settings = UMBRA_DIAGNOSE_SETTINGS;
  struct umbra_result *result;
  const struct umbra_citation *citation;
  settings.only = none;
  settings.nonly = 1;
  refused(umbra_diagnose(umbra, scenario, measured, &settings, &result), UMBRA_ERR_INPUT,
          "emittance");
  assert_null(result);
  settings.level = 1.0;
  refused(umbra_diagnose(umbra, scenario, measured, &settings, &result), UMBRA_ERR_INPUT,
          "level 1; accepted");
  settings.level = 0.0;
  settings.steps = 21;
  refused(umbra_diagnose(umbra, scenario, measured, &settings, &result), UMBRA_ERR_INPUT,
          "steps 21; accepted");
  settings.steps = 0;
  settings.only = only;
  settings.nonly = 4;
  ok(umbra_diagnose(umbra, scenario, measured, &settings, &result));
  umbra_measurements_close(&measured);
  const struct umbra_verdict *v = umbra_result_verdict(result);
  assert_int_equal(v->kind, UMBRA_FOUND);
  assert_int_equal(v->nfinding, 1);
  assert_true(v->sentence[0] != '\0' && v->chi2_before > 10.0 * v->chi2_after);
  assert_close(v->chi2_after / v->dof_after, 1.0, 3.0 * sqrt(2.0 / 93.0));
  const struct umbra_finding *f = v->finding;
  assert_string_equal(f->effect, "emittance");
  assert_int_equal(f->confidence, UMBRA_CERTAIN);
  assert_true(f->p_value < 1e-6 && f->delta_bic < -100.0);
  assert_string_equal(f->estimate[0].name, "factor");
  assert_true(fabs(f->estimate[0].value - 0.8) < 3.0 * f->estimate[0].sigma);
  assert_true(f->nalternative > 0);
  for (size_t i = 0; i < f->nalternative; i++) {
    assert_true(strcmp(f->alternative[i].effect, "emittance") != 0 && !f->alternative[i].tied);
    if (f->alternative[i].fitted) assert_true(f->alternative[i].delta_bic > 10.0);
  }
  assert_int_equal(umbra_result_array(result, "before")->shape[0], 93);
  ok(umbra_cite(umbra, result, &citation));
  assert_non_null(strstr(citation->sentence, "SGP4"));
  write_as(result, "umbra diagnose");
  command_expect(0, "diagnose", BOX, "m.csv", "--only", "emittance", "--only", "area:bus", "--only",
                 "zero_point", "--only", "albedo_level", "--no-plots", "--out", "theirs", NULL);
  command_expect_same("ours", "theirs", files);
  assert_null(umbra_result_comparison(result));
  umbra_result_close(&result);
}

/* Two sets: a calibration is one of each. */
static void test_sets(void **state)
{
  (void)state;
  static const char *const only[] = {"emittance", "zero_point"};
  static const char *const names[] = {"one", "one", "two"};
  struct umbra_diagnose_settings settings = UMBRA_DIAGNOSE_SETTINGS;
  const struct umbra_measurements *part[] = {measured, measured};
  struct umbra_measurements *both;
  struct umbra_result *result;
  double sum = 0.0;
  refused(umbra_measurements_join(umbra, part, names, 0, &both), UMBRA_ERR_INPUT, "one and more");
  refused(umbra_measurements_join(umbra, part, names, 2, &both), UMBRA_ERR_INPUT, "'one'");
  assert_null(both);
  ok(umbra_measurements_join(umbra, part, names + 1, 2, &both));
  part[1] = both;
  struct umbra_measurements *more;
  refused(umbra_measurements_join(umbra, part, NULL, 2, &more), UMBRA_ERR_INPUT,
          "measurements 2 are several");
  settings.only = only;
  settings.nonly = 2;
  ok(umbra_diagnose(umbra, scenario, both, &settings, &result));
  const struct umbra_verdict *v = umbra_result_verdict(result);
  assert_string_equal(v->finding[0].effect, "emittance");
  assert_int_equal(umbra_result_array(result, "before")->shape[0], 2 * 93);
  assert_true(v->probability_one > 0.9 && v->nhalf == 6);
  assert_string_equal(v->half[1].name, "surface");
  assert_true(v->half[1].probability > 0.9);
  for (size_t h = 0; h < v->nhalf; h++) sum += v->half[h].probability;
  assert_close(sum, 1.0, 1e-9);
  sum = v->probability_nothing + v->probability_one + v->probability_several + v->probability_none;
  assert_close(sum, 1.0, 1e-9);
  umbra_result_close(&result);
  umbra_measurements_close(&both);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_compare, enter, leave),
      cmocka_unit_test_setup_teardown(test_arrays, enter, leave),
      cmocka_unit_test_setup_teardown(test_wrong_arrays, enter, leave),
      cmocka_unit_test_setup_teardown(test_geometry_of_arrays, enter, leave),
      cmocka_unit_test_setup_teardown(test_fit, enter, leave),
      cmocka_unit_test_setup_teardown(test_diagnose, enter, leave),
      cmocka_unit_test_setup_teardown(test_sets, enter, leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
