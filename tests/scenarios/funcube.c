/* scenarios/funcube-1 before the telemetry of FUNcube-1: 14 hours, nine eclipses, the mean of its
 * four side panels. No parameter is fitted; the numbers of the scenario are within the ranges of
 * catalogues, which its README.md derives.
 *
 * Accepted: 2 K rms over a swing of 39 K, what the project asks for. A model of two nodes with
 * everything fitted leaves 1.04 K, ours 1.17 K.
 * Each withheld effect must cost at least 3 K, more than the model is off in all: 4.5 K (power) to
 * 14.7 K (Earth infrared) are measured. What is withheld and added again as an effect must give the
 * complete model back to 1 mK, the integrator's tolerance. */
#include <stdlib.h>
#include <string.h>

#include "compare/compare.h"
#include "tests/scenarios/support.h"

#define SCENARIO  UMBRA_SOURCE_DIR "/scenarios/funcube-1"
#define TELEMETRY UMBRA_SHARED_DIR "/data/funcube1/wod_2016-02-04_00-14h.csv"
#define MEASURED  "funcube_measured.csv"

#define ACCEPTED_RMS 2.0  /* [K] */
#define COST         3.0  /* of an effect withheld [K] */
#define SAME         1e-3 /* [K] */

#define LIST(...) ((const char *const[]){__VA_ARGS__, NULL})
#define NONE      ((const char *const[]){NULL})

static size_t length(const char *const *list)
{
  size_t n = 0;
  while (list[n] != NULL) n++;
  return n;
}

static void need(struct um_context *context, enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(context));
}

/* Residual of the panel mean, all rows. */
static struct um_compare_metrics compute(const char *const *overrides, const char *const *with,
                                         const char *const *without)
{
  struct um_context *context = NULL;
  struct um_compare_measurements *measured = NULL;
  struct um_compare_plan *plan = NULL;
  struct um_compare_comparison *comparison = NULL;
  struct support_run run = {0};
  const struct um_model_options options = {.overrides = overrides,
                                           .noverride = length(overrides),
                                           .with = with,
                                           .nwith = length(with),
                                           .without = without,
                                           .nwithout = length(without)};
  need(NULL, um_core_context_create(NULL, &context));
  need(context, um_compare_measurements_read(context, MEASURED, &measured));
  need(context, um_model_create(context, SCENARIO, &options, &run.model));
  need(context, um_compare_plan_create(context, run.model, measured, &plan));
  need(context, um_compare_plan_trace(context, run.model, plan, &run.trace));
  need(context, um_model_run(context, run.model, run.trace, &run.result));
  const struct um_compare_run compared = {run.model, plan, run.trace, run.result};
  need(context, um_compare_create(context, &compared, 0.0, &comparison));
  assert_int_equal(comparison->nchannel, 1);
  struct um_compare_metrics metrics = comparison->channel[0].all;
  um_compare_destroy(context, &comparison);
  um_model_result_destroy(context, &run.result);
  um_model_trace_destroy(context, &run.trace);
  um_compare_plan_destroy(context, &plan);
  um_model_destroy(context, &run.model);
  um_compare_measurements_destroy(context, &measured);
  um_core_context_destroy(&context);
  return metrics;
}

static double complete_rms; /* [K], NaN until the complete model was computed */

static void need_telemetry(void)
{
  FILE *file = fopen(MEASURED, "r");
  if (file == NULL) {
    print_message("skipped: " TELEMETRY " or python3 is missing\n");
    skip();
  }
  fclose(file);
}

static void catalogue_properties_meet_the_panels(void **state)
{
  (void)state;
  need_telemetry();
  struct um_compare_metrics all = compute(NONE, NONE, NONE);
  complete_rms = all.rms;
  print_message("%zu frames: bias %+.2f, standard deviation %.2f, rms %.2f K\n", all.count,
                all.bias, all.sd, all.rms);
  assert_int_equal(all.count, 714);
  if (!(all.rms <= ACCEPTED_RMS)) fail_msg("rms %.3f K, accepted %.1f K", all.rms, ACCEPTED_RMS);
}

static void each_effect_is_missed_and_comes_back(void **state)
{
  (void)state;
  static const struct {
    const char *what, *override, *without, *with; /* with: what gives it back, NULL: the switch */
  } effects[] = {
      {"albedo", NULL, "albedo", NULL},
      {"Earth infrared", NULL, "earth_ir", NULL},
      {"internal power", "parts.body.interior.power_W=0", NULL, "internal_power:body,power_W=1.29"},
      {"interior's capacity", "parts.body.interior.capacity_J_K=1", NULL,
       "interior_capacity:body,capacity_J_K=306"}};
  need_telemetry();
  for (size_t i = 0; i < sizeof effects / sizeof effects[0]; i++) {
    const char *const *overrides = LIST(effects[i].override);
    struct um_compare_metrics less = compute(overrides, NONE, LIST(effects[i].without));
    print_message("without %-20s rms %6.2f K\n", effects[i].what, less.rms);
    if (!(less.rms >= complete_rms + COST))
      fail_msg("without %s: rms %.3f K, complete %.3f K", effects[i].what, less.rms, complete_rms);
    if (effects[i].with == NULL) continue;
    struct um_compare_metrics back = compute(overrides, LIST(effects[i].with), NONE);
    support_close(effects[i].with, back.rms, complete_rms, SAME);
  }
}

/* Without the shared data, or python3, there is no file and the tests say so. */
static int convert(void **state)
{
  (void)state;
  complete_rms = NAN;
  remove(MEASURED);
  FILE *file = fopen(TELEMETRY, "r");
  if (file == NULL || system("python3 --version") != 0) return file == NULL ? 0 : fclose(file);
  fclose(file);
  return system("python3 " SCENARIO "/convert.py " TELEMETRY " " MEASURED);
}

static int clean(void **state)
{
  (void)state;
  remove(MEASURED);
  return 0;
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(catalogue_properties_meet_the_panels),
                                     cmocka_unit_test(each_effect_is_missed_and_comes_back)};
  return cmocka_run_group_tests(tests, convert, clean);
}
