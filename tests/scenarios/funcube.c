/* scenarios/funcube-1 before the telemetry of FUNcube-1: 14 hours, nine eclipses, the mean of its
 * four side panels. No parameter is fitted; the numbers of the scenario are middles of stated
 * ranges, or come from other telemetry, as its README.md derives.
 *
 * Accepted: 1.0 K rms over a swing of 39 K, what the project asks for; 0.99 K is measured. A model
 * of two nodes with everything fitted leaves 1.04 K. Each withheld effect must cost at least 3 K,
 * more than the model is off in all: 4.3 K (power) to 14.8 K (Earth infrared) are measured. What is
 * withheld and added again as an effect must give the complete model back to 1 mK, the integrator's
 * tolerance. */
#include "base/core/csv.h"
#include "tests/scenarios/compared_test.h"

#define KNOCKE   "environment.earth=knocke"
#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/funcube-1"
#define MEASURED SCENARIO "/measured.csv"

#define ACCEPTED_RMS 1.0  /* [K] */
#define COST         3.0  /* of an effect withheld [K] */
#define SAME         1e-3 /* [K] */

/* Of the table in README.md. */
#define STILL                                                                                      \
  "attitude=[{spin: {axis_gcrs: [0.5295, -0.4936, 0.69], axis_body: [0, 0, 1], period_s: -195}}]"
#define ONE_FINISH "solar_absorptance:frame,shift=0.202", "emittance:frame,factor=1.92558"
#define RESISTANCE "contacts.0.conductance_W_K=0.577"
#define EXTRACTION "parts.body.electrical_extraction=0.094"

#define LIST(...) ((const char *const[]){__VA_ARGS__, NULL})
#define NONE      ((const char *const[]){NULL})

static size_t length(const char *const *list)
{
  size_t n = 0;
  while (list[n] != NULL) n++;
  return n;
}

/* Residual of the panel mean, all rows. */
static struct um_compare_metrics compute(const char *const *overrides, const char *const *with,
                                         const char *const *without)
{
  const struct um_model_options options = {.overrides = overrides,
                                           .noverride = length(overrides),
                                           .with = with,
                                           .nwith = length(with),
                                           .without = without,
                                           .nwithout = length(without)};
  return compared(SCENARIO, MEASURED, &options);
}

static double complete_rms = NAN; /* [K], NaN until the complete model was computed */

static double panel(struct um_context *context, const struct um_core_csv *csv, size_t row,
                    const char *name)
{
  size_t column = 0;
  double value = NAN;
  need(context, um_core_csv_require(context, csv, name, &column));
  need(context, um_core_csv_number(context, csv, row, column, &value));
  return value;
}

/* What is compared is the telemetry: the mean of the four panels of every frame. */
static void measurements_are_the_telemetry(void **state)
{
  (void)state;
  struct um_context *context = NULL;
  struct um_core_csv *telemetry = NULL, *measured = NULL;
  need(NULL, um_core_context_create(NULL, &context));
  need(context, um_core_csv_read(context, SCENARIO "/telemetry.csv", &telemetry));
  need(context, um_core_csv_read(context, MEASURED, &measured));
  assert_int_equal(um_core_csv_rows(telemetry), 714);
  assert_int_equal(um_core_csv_rows(measured), 714);
  for (size_t i = 0; i < 714; i++) {
    double mean = 0.25 * (panel(context, telemetry, i, "panel_x_plus_C") +
                          panel(context, telemetry, i, "panel_x_minus_C") +
                          panel(context, telemetry, i, "panel_y_plus_C") +
                          panel(context, telemetry, i, "panel_y_minus_C"));
    assert_string_equal(um_core_csv_text(measured, i, 0), um_core_csv_text(telemetry, i, 0));
    support_close("mean of the panels [K]", panel(context, measured, i, "value"), mean + 273.15,
                  6e-4);
    support_close("sigma [K]", panel(context, measured, i, "sigma"), 1.0, 0.0);
  }
  um_core_csv_destroy(&measured);
  um_core_csv_destroy(&telemetry);
  um_core_context_destroy(&context);
}

static void catalogue_properties_meet_the_panels(void **state)
{
  (void)state;
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
  } effects[] = {{"albedo", NULL, "albedo", NULL},
                 {"Earth infrared", NULL, "earth_ir", NULL},
                 {"internal power", "parts.body.interiors.stack.power_W=-1.17", NULL,
                  "internal_power:body.stack,power_W=1.17"},
                 {"the boards' capacity", "parts.body.interiors.stack.capacity_J_K=1", NULL,
                  "interior_capacity:body.stack,capacity_J_K=229"}};
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

/* What each piece of physics brings, as README.md prints it, with the air at the shadow's edge and
 * without: to half of its last digit, and the integrator's tolerance of 1 mK. */
static void steps_are_as_stated(void **state)
{
  (void)state;
  static const struct {
    const char *set;
    const char *with[3];
    double bias, rms, airless_bias, airless_rms; /* [K] as printed */
    const char *lambert[2];                      /* effects that are withheld beside */
  } steps[] = {{NULL, {NULL}, 0.40, 0.99, 0.19, 0.95, {NULL}},
               {RESISTANCE, {NULL}, 0.42, 1.14, 0.21, 1.10, {NULL}},
               {NULL, {ONE_FINISH, NULL}, 2.06, 2.27, 1.85, 2.08, {NULL}},
               {STILL, {NULL}, -1.42, 1.76, -1.64, 1.95, {NULL}},
               {EXTRACTION, {NULL}, 6.74, 6.90, 6.55, 6.72, {NULL}},
               {KNOCKE, {NULL}, 0.70, 1.26, 0.49, 1.16, {"earth_anisotropy", "earth_spectrum"}},
               {KNOCKE, {NULL}, 0.86, 1.36, 0.64, 1.23, {"earth_anisotropy"}},
               {KNOCKE, {NULL}, 0.50, 1.16, 0.29, 1.08, {NULL}}};
  for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
    struct um_compare_metrics found =
        compute(LIST(steps[i].set), steps[i].with, LIST(steps[i].lambert[0], steps[i].lambert[1]));
    struct um_compare_metrics airless =
        compute(LIST(steps[i].set), steps[i].with,
                LIST("shadow_refraction", steps[i].lambert[0], steps[i].lambert[1]));
    print_message("%-60s bias %+.2f rms %.2f K, no air %+.2f %.2f K\n",
                  steps[i].set == NULL ? "as it stands" : steps[i].set, found.bias, found.rms,
                  airless.bias, airless.rms);
    support_close("bias [K]", found.bias, steps[i].bias, 0.006);
    support_close("rms [K]", found.rms, steps[i].rms, 0.006);
    support_close("bias without air [K]", airless.bias, steps[i].airless_bias, 0.006);
    support_close("rms without air [K]", airless.rms, steps[i].airless_rms, 0.006);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(measurements_are_the_telemetry),
                                     cmocka_unit_test(catalogue_properties_meet_the_panels),
                                     cmocka_unit_test(each_effect_is_missed_and_comes_back),
                                     cmocka_unit_test(steps_are_as_stated)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
