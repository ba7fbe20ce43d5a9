/* scenarios/starlink-v15: 800 magnitudes of Starlink v1.5 satellites against two plates whose
 * reflection is fitted to laboratory BRDFs, nothing fitted to the sky.
 *
 * Fankhauser, Tyson & Askari 2023 (AJ 166, 59) publish a Pearson correlation of magnitudes of 0.69
 * for their two plates with laboratory BRDFs and no earthshine: with the same data and surfaces
 * ours must not be worse. Earthshine is light that they say is there: with it the rms of the
 * residual in flux must be lower. The measurements are not part of the repository; they are
 * converted by the scenario's own script. */
#include <stdlib.h>
#include <unistd.h>

#include "compare/compare.h"
#include "tests/scenarios/support.h"
#include "tests/support/temporary.h"

#define SCENARIO     UMBRA_SOURCE_DIR "/scenarios/starlink-v15"
#define OBSERVATIONS UMBRA_SHARED_DIR "/data/starlink_v15/pomenis_observations_part1.csv"

static struct um_context *context;
static char folder[UM_TEST_PATH], measured[UM_TEST_PATH + 32];

static void need(enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

/* Convert into a folder of the test's own; skips without data or Python. */
static void convert(void)
{
  char command[4 * UM_TEST_PATH];
  if (access(OBSERVATIONS, R_OK) != 0) {
    print_message(OBSERVATIONS " is not there: skipped\n");
    skip();
  }
  if (system("python3 --version > /dev/null 2>&1") != 0) {
    print_message("python3 is not there to convert the observations: skipped\n");
    skip();
  }
  snprintf(command, sizeof command, "python3 '" SCENARIO "/convert.py' '" OBSERVATIONS "' '%s'",
           measured);
  assert_int_equal(system(command), 0);
}

/* Metrics of the only channel. */
static struct um_compare_metrics metrics_of(const struct um_model_options *options)
{
  struct um_compare_measurements *measurements;
  struct um_model *model;
  struct um_compare_plan *plan;
  struct um_model_trace *trace;
  struct um_model_result *result;
  struct um_compare_comparison *comparison;
  need(um_compare_measurements_read(context, measured, &measurements));
  need(um_model_create(context, SCENARIO, options, &model));
  need(um_compare_plan_create(context, model, measurements, &plan));
  need(um_compare_plan_trace(context, model, plan, &trace));
  need(um_model_run(context, model, trace, &result));
  struct um_compare_run run = {model, plan, trace, result};
  need(um_compare_create(context, &run, 0.0, &comparison));
  assert_int_equal(comparison->nchannel, 1);
  struct um_compare_metrics all = comparison->channel[0].all;
  um_compare_destroy(context, &comparison);
  um_model_result_destroy(context, &result);
  um_model_trace_destroy(context, &trace);
  um_compare_plan_destroy(context, &plan);
  um_model_destroy(context, &model);
  um_compare_measurements_destroy(context, &measurements);
  return all;
}

static void magnitudes(void **state)
{
  (void)state;
  convert();
  static const char *const earthshine[] = {"earthshine"};
  struct um_model_options without = {.without = earthshine, .nwithout = 1};
  struct um_compare_metrics with = metrics_of(NULL), dark = metrics_of(&without);
  print_message("with earthshine: correlation %.4f, rms %.8g, median measured/model %.3f\n",
                with.correlation, with.rms, with.median_ratio);
  print_message("without:         correlation %.4f, rms %.8g\n", dark.correlation, dark.rms);
  assert_int_equal(with.count, 800);
  assert_true(with.correlation >= 0.69);
  assert_true(with.rms < dark.rms);
  assert_true(with.chi2 < dark.chi2);
}

static int set_up(void **state)
{
  (void)state;
  if (um_test_folder_create(folder) != 0) return -1;
  snprintf(measured, sizeof measured, "%s/measured.csv", folder);
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

static int tear_down(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  remove(measured);
  return um_test_folder_remove(folder);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(magnitudes)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
