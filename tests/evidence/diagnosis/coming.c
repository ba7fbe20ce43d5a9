/* Passes to come, as what could be measured next. A box was measured by its telemetry alone, which
 * cannot say whether its inside makes heat or still holds some. What a pass tells is held against
 * two models of their own, run over it, and heat that was stored is gone days later. */
#include "tests/evidence/diagnosis/sets_test.h"

#include "base/core/constants.h"
#include "evidence/diagnosis/diagnose.h"

#define STATION "observer={station: {name: Here, latitude_deg: 48, longitude_deg: 11}}"
#define PASSES  9
#define STEPS   40   /* of a pass */
#define USUAL   0.02 /* sigma of a band that was not measured [1] */
#define FAINT   0.01 /* and of its largest value [1] */
#define CADENCE 20.0 /* time.step_s [s] */

static const char *const overrides[] = {STATION, "time.step_s=20"};
static const struct um_model_options with_station = {.overrides = overrides, .noverride = 2};

static struct um_compare_measurements *telemetry(void)
{
  static const char *const place[] = {"bus.+z", "bus.-x"};
  struct um_compare_row row[2 * ROWS];
  struct um_compare_measurements *m;
  struct um_model *model;
  OK(um_model_create(context, path, NULL, &model));
  for (size_t i = 0; i < 2 * ROWS; i++)
    row[i] = (struct um_compare_row){.t_tai = model->scenario->time->start + STEP * (double)(i / 2),
                                     .quantity = "temperature",
                                     .of = place[i % 2],
                                     .value = 280.0,
                                     .sigma = 0.2,
                                     .exposure = NAN,
                                     .satellite_height = NAN,
                                     .azimuth = NAN,
                                     .elevation = NAN};
  um_model_destroy(context, &model);
  OK(um_compare_measurements_make(context, "telemetry", row, 2 * ROWS, &m));
  measure("internal_power:bus,power_W=8", m);
  for (size_t i = 0; i < m->count; i++) { /* 0.2 K in place of 1 % */
    m->row[i].value += (0.2 - m->row[i].sigma) * noise_of(i);
    m->row[i].sigma = 0.2;
  }
  return m;
}

/* Irradiance of both bands at times and its error, [n][2], by a model of its own with an effect. */
static void light_of(const struct um_model_addition *a, const double *time, size_t n, double *value,
                     double *error)
{
  char with[128];
  const char *one = with;
  const struct um_model_options options = {
      .overrides = overrides, .noverride = 2, .with = &one, .nwith = 1};
  struct um_model *model;
  struct um_model_tables *tables;
  struct um_model_result *result;
  snprintf(with, sizeof with, "%s:%s,%s=%.17g", a->effect->name, a->target,
           a->effect->parameters[0].name, a->value[0]);
  OK(um_model_create(context, path, &options, &model));
  OK(um_model_precompute_at(context, model, time, NULL, n, (struct um_model_sampling){0, 0},
                            &tables));
  OK(um_model_run(context, model, tables, &result));
  assert_int_equal(result->nband, 2);
  memcpy(value, result->irradiance, n * 2 * sizeof *value);
  memcpy(error, result->irradiance_error, n * 2 * sizeof *error);
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
}

/* Chi-square of each step of a pass in a band; peak: largest value of that over all passes. */
static void apart(const double *a, const double *b, const double *error, size_t band, double peak,
                  double each, double *chi2)
{
  for (size_t k = 0; k < STEPS; k++) {
    double difference = a[2 * k + band] - b[2 * k + band];
    double sigma = hypot(USUAL * a[2 * k + band], FAINT * peak);
    chi2[k] = difference * difference / (sigma * sigma + pow(error[2 * k + band], 2)) * each;
    if (isnan(chi2[k])) chi2[k] = 0.0;
  }
}

static void what_a_pass_tells(void **state)
{
  (void)state;
  static const char *const only[] = {"internal_power", "stored_heat"};
  const struct um_diagnosis_options options = {
      .candidates = {.only = only, .nonly = 2}, .passes = PASSES, .no_heat = true};
  struct um_compare_measurements *m = telemetry();
  struct um_sensitivity_forward *f;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
  OK(um_sensitivity_forward_create(context, path, &with_station, m, UM_VARIANT_TIGHT, &f));
  OK(um_sensitivity_candidates_create(context, f, NULL, 0, &options.candidates, &candidates));
  OK(um_diagnosis_create(context, f, candidates, &options, &d));
  print_message("%s\n", d->summary);
  assert_int_equal(d->verdict, UM_VERDICT_NOT_IDENTIFIABLE);
  assert_true(d->nnext >= 1);
  const struct um_diagnosis_next *next = &d->next_of[0];
  assert_int_equal(next->npass, PASSES);
  /* which passes they are */
  struct um_orbit_pass *pass;
  size_t n;
  double last = f->plan->time[f->plan->ntime - 1];
  OK(um_orbit_passes_find(context, &f->model->station[0], f->model->trajectory, last,
                          next->pass[PASSES - 1].set + 10.0, 0.0, &pass, &n));
  assert_int_equal(n, PASSES);
  struct um_model_addition one = d->addition[0], other = {0};
  other.effect = candidates->candidate[next->candidate].effect;
  other.target = candidates->candidate[next->candidate].target;
  for (size_t i = 1; i < d->step[0].nalternative; i++)
    if (d->step[0].alternative[i].candidate == next->candidate)
      other.value[0] = d->step[0].alternative[i].value[0];
  enum { ALL = 1 + PASSES * STEPS };
  static double time[ALL], a[2 * ALL], b[2 * ALL], error[2 * ALL], unused[2 * ALL];
  time[0] = f->plan->time[0];
  for (size_t p = 0; p < PASSES; p++) {
    assert_true(fabs(next->pass[p].rise - pass[p].rise) < 0.01);
    assert_true(fabs(next->pass[p].set - pass[p].set) < 0.01);
    assert_string_equal(next->pass[p].station, "Here");
    for (size_t k = 0; k < STEPS; k++)
      time[1 + p * STEPS + k] =
          pass[p].rise + ((double)k + 0.5) / STEPS * (pass[p].set - pass[p].rise);
  }
  light_of(&one, time, ALL, a, error);
  light_of(&other, time, ALL, b, unused);
  double peak[2] = {0.0, 0.0}, later = 0.0;
  for (size_t i = 0; i < 2 * ALL; i++)
    if (a[i] > peak[i % 2]) peak[i % 2] = a[i];
  for (size_t p = 0; p < PASSES; p++) {
    const struct um_diagnosis_pass *said = &next->pass[p];
    size_t at = 2 * (1 + p * STEPS), band = strcmp(said->of, "lwir") == 0;
    double step = (pass[p].set - pass[p].rise) / STEPS, chi2[STEPS], sum = 0.0, within = 0.0;
    apart(a + at, b + at, error + at, band, peak[band], step / CADENCE, chi2);
    for (size_t k = 0; k < STEPS; k++) sum += chi2[k];
    print_message("  pass %zu: %.3f sigma in %s, by models of their own %.3f; 5 in %.0f s\n", p,
                  said->sigmas, said->of, sqrt(sum), said->seconds);
    if (!(fabs(said->sigmas - sqrt(sum)) <= 0.02 * sqrt(sum) + 0.02))
      fail_msg("pass %zu: %g sigma, %g by models of their own", p, said->sigmas, sqrt(sum));
    if (p > 0) later = fmax(later, said->sigmas);
    assert_true(isnan(said->seconds) == (said->sigmas < 5.0));
    if (isnan(said->seconds)) continue;
    for (size_t k = 0; k < STEPS; k++) { /* what lies in the stretch is worth 5 sigma */
      double from = pass[p].rise + (double)k * step, to = from + step;
      double part = (fmin(to, said->from + said->seconds) - fmax(from, said->from)) / step;
      if (part > 0.0) within += part * chi2[k];
    }
    if (!(fabs(within - 25.0) <= 0.1)) fail_msg("pass %zu: 5 sigma are %g", p, sqrt(within));
  }
  assert_true(later > 2.0 * next->pass[0].sigmas);
  um_core_free(context, pass);
  um_diagnosis_destroy(context, &d);
  um_sensitivity_candidates_destroy(context, &candidates);
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

/* The scenario with another text in place of a part of it, into its file. */
static void write_with(const char *what, const char *by, const char *also, const char *by_too)
{
  char text[sizeof scenario + 512], *at;
  snprintf(text, sizeof text, "%s", scenario);
  for (int k = 0; k < 2; k++) {
    const char *old = k == 0 ? what : also, *next = k == 0 ? by : by_too;
    at = strstr(text, old);
    assert_non_null(at);
    memmove(at + strlen(next), at + strlen(old), strlen(at + strlen(old)) + 1);
    memcpy(at, next, strlen(next));
  }
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  fputs(text, file);
  assert_int_equal(fclose(file), 0);
}

/* An attitude that is not known so far ahead costs the passes, with a warning, and not the verdict.
 */
static void attitude_ends(void **state)
{
  (void)state;
  static const char *const only[] = {"internal_power", "stored_heat"};
  static const char *const at_station[] = {STATION};
  const struct um_model_options here = {.overrides = at_station, .noverride = 1};
  const struct um_diagnosis_options options = {
      .candidates = {.only = only, .nonly = 2}, .passes = 1, .no_heat = true};
  struct um_sensitivity_forward *f;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
  FILE *table = fopen("coming_attitude.csv", "w");
  assert_non_null(table);
  fputs("time_utc,q0,q1,q2,q3\n2026-02-28T18:00:00Z,1,0,0,0\n2026-03-01T00:15:00Z,1,0,0,0\n",
        table);
  assert_int_equal(fclose(table), 0);
  write_with("attitude: [{lvlh: {}}]", "attitude: [{table: coming_attitude.csv}]",
             "2026-03-02T00:10:00Z", "2026-03-01T00:10:00Z");
  struct um_compare_measurements *m = telemetry();
  OK(um_sensitivity_forward_create(context, path, &here, m, UM_VARIANT_TIGHT, &f));
  OK(um_sensitivity_candidates_create(context, f, NULL, 0, &options.candidates, &candidates));
  OK(um_diagnosis_create(context, f, candidates, &options, &d));
  assert_int_equal(d->verdict, UM_VERDICT_NOT_IDENTIFIABLE);
  assert_true(d->nnext >= 1);
  assert_true(isfinite(d->next_of[0].from)); /* the scenario's own window was looked at */
  assert_int_equal(d->next_of[0].npass, 0);
  assert_string_equal(um_core_message(context), "");
  um_diagnosis_destroy(context, &d);
  um_sensitivity_candidates_destroy(context, &candidates);
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
  remove("coming_attitude.csv");
  write_with("name: box", "name: box", "name: box", "name: box");
}

static void without_a_station(void **state)
{
  (void)state;
  const struct um_diagnosis_options options = {.passes = 1};
  struct um_compare_measurements *m = telemetry();
  struct um_sensitivity_forward *f;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
  char message[256];
  OK(um_sensitivity_forward_create(context, path, NULL, m, UM_VARIANT_TIGHT, &f));
  OK(um_sensitivity_candidates_create(context, f, NULL, 0, &options.candidates, &candidates));
  assert_int_equal(um_diagnosis_create(context, f, candidates, &options, &d), UM_ERR_INPUT);
  snprintf(message, sizeof message,
           "--passes: %s has no station; accepted: a scenario with observer.station", path);
  assert_string_equal(um_core_message(context), message);
  assert_null(d);
  um_sensitivity_candidates_destroy(context, &candidates);
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(what_a_pass_tells),
                                     cmocka_unit_test(attitude_ends),
                                     cmocka_unit_test(without_a_station)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
