/* Several sets of measurements in one diagnosis. One satellite: sets joined are one file to the
 * last bit. A value for one set moves the rows of that alone. Power inside and heat stored there
 * are the same to either of two passes alone, and told apart by both; what is off in one pass is
 * named as of that one. */
#include "tests/evidence/diagnosis/sets_test.h"

#include "effects/effects.h"
#include "evidence/diagnosis/diagnose.h"
#include "evidence/diagnosis/request.h"
#include "evidence/measurements/listed.h"
#include "evidence/measurements/write.h"

static size_t evaluate(const struct um_compare_measurements *m,
                       const struct um_model_addition *addition, double *value)
{
  struct um_sensitivity_forward *f;
  OK(um_sensitivity_forward_create(context, path, NULL, m, UM_VARIANT_TIGHT, &f));
  OK(um_sensitivity_forward_evaluate(context, f, addition, addition != NULL, value));
  size_t n = f->observations.count;
  um_sensitivity_forward_destroy(context, &f);
  return n;
}

static void sets_are_one_file(void **state)
{
  (void)state;
  double sets[4 * ROWS], file[4 * ROWS], off[4 * ROWS], shifted[4 * ROWS];
  struct um_compare_measurements *both;
  measure_both(NULL, NULL, &both);
  assert_int_equal(both->nfile, 2);
  assert_int_equal(evaluate(both, NULL, sets), 4 * ROWS);
  const struct um_model_addition factor = {
      .effect = um_effects_find("zero_point"), .target = "lwir@late", .value = {0.9}};
  evaluate(both, &factor, off);
  for (size_t i = 0; i < 4 * ROWS; i++) {
    bool there = i >= 2 * ROWS && i % 2 == 1;
    assert_true(off[i] == (there ? 0.9 * sets[i] : sets[i]));
  }
  const struct um_model_addition clock = {
      .effect = um_effects_find("time_tag"), .target = "all@late", .value = {20.0}};
  evaluate(both, &clock, shifted);
  double moved[2] = {0.0, 0.0}; /* rows of the loads move a little with the observed instants */
  for (size_t i = 0; i < 4 * ROWS; i++)
    moved[i / (2 * ROWS)] = fmax(moved[i / (2 * ROWS)], fabs(shifted[i] / sets[i] - 1.0));
  print_message("  the clock moved rows by %g and %g\n", moved[0], moved[1]);
  assert_true(moved[0] < 2e-5 && moved[1] > 1e-3);
  for (size_t i = 0; i < both->count; i++) both->row[i].set = 0; /* as of one file */
  evaluate(both, NULL, file);
  assert_memory_equal(sets, file, sizeof sets);
  um_compare_measurements_destroy(context, &both);
}

static void nuisances_are_of_sets(void **state)
{
  (void)state;
  static const char *const nuisance[] = {"zero_point:lwir,sigma=0.1", "time_tag,per=all",
                                         "internal_power:bus,sigma=1", "background:vis@late",
                                         "zero_point:lwir@late,sigma=0.2"};
  struct um_compare_measurements *both;
  struct um_model *model;
  struct um_diagnosis_request r;
  measure_both(NULL, NULL, &both);
  const struct um_diagnosis_request_texts texts = {
      .nuisance = nuisance, .nnuisance = 5, .measurements = both};
  OK(um_model_create(context, path, NULL, &model));
  OK(um_diagnosis_request_make(context, model, &texts, &r));
  assert_int_equal(r.nnuisance, 5);
  assert_string_equal(r.nuisance[0].target, "lwir@early");
  assert_true(r.nuisance[0].sigma == 0.1);
  assert_string_equal(r.nuisance[1].target, "lwir@late");
  assert_true(r.nuisance[1].sigma == 0.2); /* the last text's */
  assert_null(r.nuisance[2].target);
  assert_string_equal(r.nuisance[3].target, "bus");
  assert_string_equal(r.nuisance[4].target, "vis@late");
  um_diagnosis_request_release(context, &r);
  static const struct {
    const char *text, *says;
  } refused[] = {
      {"zero_point:lwir@lat",
       "no set is called 'lat'; did you mean 'late'?; accepted: early, late"},
      {"zero_point:swir@late", "nothing that 'zero_point' acts on is called 'swir'"},
      {"time_tag:lwir@late", "effect 'time_tag' acts on everything; accepted: no target, or "
                             "'all@late'"},
      {"zero_point:lwir@", "no set is named behind '@'"},
      {"internal_power:bus@late", "nothing that 'internal_power' acts on is called 'bus@late'"},
      {"internal_power:bus,per=set", "acts on the satellite, which is one in all sets"},
  };
  for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
    const struct um_diagnosis_request_texts one = {
        .nuisance = &refused[i].text, .nnuisance = 1, .measurements = both};
    um_core_message_clear(context);
    assert_int_equal(um_diagnosis_request_make(context, model, &one, &r), UM_ERR_INPUT);
    if (strstr(um_core_message(context), refused[i].says) == NULL)
      fail_msg("%s said: %s", refused[i].text, um_core_message(context));
    um_diagnosis_request_release(context, &r);
  }
  static const char *const clock = "time_tag,sigma=0.1";
  const struct um_diagnosis_request_texts late = {
      .nuisance = &clock, .nnuisance = 1, .measurements = both};
  OK(um_diagnosis_request_make(context, model, &late, &r));
  assert_int_equal(r.nnuisance, 2);
  um_diagnosis_request_release(context, &r);
  both->row[0].t_tai += APART; /* sets that overlap have one clock */
  um_core_message_clear(context);
  assert_int_equal(um_diagnosis_request_make(context, model, &late, &r), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "sets 'early' and 'late' overlap in time"));
  um_diagnosis_request_release(context, &r);
  um_model_destroy(context, &model);
  um_compare_measurements_destroy(context, &both);
}

static const char listed[] =
    "measurements:\n"
    "  sets:\n"
    "    - {name: dawn, file: sets_early.csv, nuisance: [{effect: zero_point, target: vis, sigma: "
    "0.3}]}\n"
    "    - {name: dusk, file: sets_late.csv, from_utc: 2026-03-02T00:01:00Z, to_utc: "
    "2026-03-02T00:05:00Z,\n"
    "       nuisance: [{effect: time_tag, free: true}]}\n"
    "  nuisance: [{effect: zero_point, target: vis, sigma: 0.1}]\n";

/* What um_compare_measurements_listed makes of a scenario with these lines behind it. */
static enum um_status list(const char *lines, struct um_model **model,
                           struct um_compare_measurements **out)
{
  char text[sizeof scenario + 1024];
  snprintf(text, sizeof text, "%s%s", scenario, lines);
  const struct um_model_options options = {.text = text};
  OK(um_model_create(context, path, &options, model));
  um_core_message_clear(context);
  return um_compare_measurements_listed(context, (*model)->scenario, out);
}

static void a_scenario_lists_its_sets(void **state)
{
  (void)state;
  struct um_compare_measurements *alone[2], *both, *m;
  struct um_model *model;
  struct um_diagnosis_request r;
  measure_both(NULL, alone, &both);
  OK(um_compare_measurements_write(context, alone[0], "sets_early.csv"));
  OK(um_compare_measurements_write(context, alone[1], "sets_late.csv"));
  if (list(listed, &model, &m) != UM_OK) fail_msg("%s", um_core_message(context));
  assert_int_equal(m->nfile, 2);
  assert_string_equal(m->channel[1].label, "lwir@dawn");
  assert_string_equal(m->channel[2].label, "vis@dusk");
  for (size_t i = 0; i < m->count; i++) { /* rows 30 s apart from the start, the bands of a time */
    size_t k = i % (2 * ROWS) / 2;
    assert_true(m->row[i].value == both->row[i].value);
    assert_int_equal(m->row[i].flag, i >= 2 * ROWS && (k < 2 || k > 10));
  }
  const struct um_diagnosis_request_texts texts = {.measurements = m};
  OK(um_diagnosis_request_make(context, model, &texts, &r));
  assert_int_equal(r.nnuisance, 3); /* a set's own goes before that of all */
  assert_string_equal(r.nuisance[0].target, "vis@dawn");
  assert_true(r.nuisance[0].sigma == 0.3);
  assert_string_equal(r.nuisance[1].target, "vis@dusk");
  assert_true(r.nuisance[1].sigma == 0.1);
  assert_string_equal(r.nuisance[2].target, "all@dusk");
  assert_true(isinf(r.nuisance[2].sigma));
  um_diagnosis_request_release(context, &r);
  um_compare_measurements_destroy(context, &m);
  um_model_destroy(context, &model);
  static const struct {
    const char *lines, *says;
  } refused[] = {
      {"", "no measurements; accepted: files of them behind the scenario, or measurements.sets"},
      {"measurements: {sets: [{name: a@b, file: sets_late.csv}]}\n", "'a@b' has an '@'"},
      {"measurements: {sets: [{name: a, file: sets_late.csv}, {name: a, file: sets_early.csv}]}\n",
       "'a' is already listed on line"},
      {"measurements: {sets: [{name: a, file: sets_late.csv, to_utc: 2026-03-01T00:00:00Z}]}\n",
       "no row of sets_late.csv is left"},
      {"measurements: {sets: [{name: a, file: sets_late.csv, from_utc: 2026-03-02T00:00:00Z, "
       "to_utc: 2026-03-01T00:00:00Z}]}\n",
       "before from_utc"},
  };
  for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
    assert_int_equal(list(refused[i].lines, &model, &m), UM_ERR_INPUT);
    if (strstr(um_core_message(context), refused[i].says) == NULL)
      fail_msg("case %zu said: %s", i, um_core_message(context));
    um_model_destroy(context, &model);
  }
  for (size_t p = 0; p < 2; p++) um_compare_measurements_destroy(context, &alone[p]);
  um_compare_measurements_destroy(context, &both);
  assert_int_equal(remove("sets_early.csv"), 0);
  assert_int_equal(remove("sets_late.csv"), 0);
}

/* A diagnosis with the effects that look most alike; calibration: with a zero point, too, which a
 * white box cannot be told from warmth by. */
struct diagnosed {
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
};

static struct diagnosed diagnose(const struct um_compare_measurements *m, bool calibration)
{
  static const char *const only[] = {"internal_power", "stored_heat", "time_tag", "zero_point"};
  const struct um_diagnosis_options options = {
      .candidates = {.only = only, .nonly = calibration ? 4 : 3}, .no_next = true, .no_heat = true};
  struct diagnosed c = {0};
  OK(um_sensitivity_forward_create(context, path, NULL, m, UM_VARIANT_TIGHT, &c.forward));
  OK(um_sensitivity_candidates_create(context, c.forward, NULL, 0, &options.candidates,
                                      &c.candidates));
  OK(um_diagnosis_create(context, c.forward, c.candidates, &options, &c.d));
  print_message("  %s: %s\n", um_diagnosis_verdict_name(c.d->verdict), c.d->summary);
  return c;
}

static void end(struct diagnosed *c)
{
  um_diagnosis_destroy(context, &c->d);
  um_sensitivity_candidates_destroy(context, &c->candidates);
  um_sensitivity_forward_destroy(context, &c->forward);
}

#define POWER 8.0 /* [W] */

static void two_passes_tell_power_from_stored_heat(void **state)
{
  (void)state;
  struct um_compare_measurements *alone[2], *both;
  char with[64];
  snprintf(with, sizeof with, "internal_power:bus,power_W=%g", POWER);
  measure_both(with, alone, &both);
  for (size_t p = 0; p < 2; p++) {
    struct diagnosed c = diagnose(alone[p], false);
    assert_int_equal(c.d->verdict, UM_VERDICT_NOT_IDENTIFIABLE);
    end(&c);
    um_compare_measurements_destroy(context, &alone[p]);
  }
  struct diagnosed c = diagnose(both, false);
  assert_int_equal(c.d->verdict, UM_VERDICT_FOUND);
  assert_int_equal(c.d->naddition, 1);
  assert_string_equal(c.d->addition[0].effect->name, "internal_power");
  assert_int_equal(c.d->step[0].confidence, UM_CONFIDENCE_CERTAIN);
  double off = (c.d->addition[0].value[0] - POWER) / c.d->addition_sigma[0][0];
  if (!(fabs(off) < 3.0)) fail_msg("%g W is %g sigma off", c.d->addition[0].value[0], off);
  end(&c);
  um_compare_measurements_destroy(context, &both);
}

static void a_set_that_is_off_is_named(void **state)
{
  (void)state;
  struct um_compare_measurements *both;
  measure_both(NULL, NULL, &both);
  for (size_t i = 0; i < both->count; i++)
    if (both->row[i].set == 1 && i % 2 == 1) both->row[i].value *= 0.9;
  struct diagnosed c = diagnose(both, true);
  assert_int_equal(c.d->verdict, UM_VERDICT_FOUND);
  assert_int_equal(c.d->naddition, 1);
  assert_string_equal(c.d->addition[0].effect->name, "zero_point");
  assert_string_equal(c.d->addition[0].target, "lwir@late");
  double off = (c.d->addition[0].value[0] - 0.9) / c.d->addition_sigma[0][0];
  if (!(fabs(off) < 3.0)) fail_msg("%g is %g sigma off", c.d->addition[0].value[0], off);
  end(&c);
  um_compare_measurements_destroy(context, &both);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(sets_are_one_file),
                                     cmocka_unit_test(nuisances_are_of_sets),
                                     cmocka_unit_test(a_scenario_lists_its_sets),
                                     cmocka_unit_test(two_passes_tell_power_from_stored_heat),
                                     cmocka_unit_test(a_set_that_is_off_is_named)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
