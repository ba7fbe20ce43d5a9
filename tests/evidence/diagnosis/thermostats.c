/* Thermostats in a diagnosis, on a crate of six walls that holds a little box: its cycle begins
 * anywhere, and one that never switches is constant power. Temperatures of the box are measured
 * every 20 s for most of an hour, six cycles of the heater. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "evidence/diagnosis/diagnose.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/inversion/synth.h"
#include "tests/support/cmocka_all.h"

#define WALL(side) "      \"" side "\": {shell: {areal_heat_capacity_J_m2_K: 20000}"
static const char scenario[] =
    "schema: 1\n"
    "name: crate\n"
    "time: {start_utc: 2021-06-20T03:00:00Z, stop_utc: 2021-06-20T03:50:00Z, step_s: 20,\n"
    "  light_time: false}\n"
    "orbit: {circular: {altitude_km: 620, beta_deg: 10, epoch_utc: 2021-06-20T03:40:00Z}}\n"
    "attitude: [{lvlh: {roll_deg: 0, pitch_deg: 0, yaw_deg: 0}}]\n"
    "parts:\n"
    "  - name: crate\n"
    "    box: {size_m: [0.4, 0.3, 0.3]}\n"
    "    lumped: true\n"
    "    outside: white_paint\n"
    "    interior: {capacity_J_K: 700, power_W: 5}\n"
    "    groups:\n" WALL("+x") ", interior_conductance_W_K: 0.2}\n" WALL("-x") "}\n" WALL(
        "+y") "}\n" WALL("-y") "}\n" WALL("+z") "}\n" WALL("-z") "}\n"
                                                                 "thermal: {start: periodic, "
                                                                 "orbits_before: 1}\n"
                                                                 "bands:\n"
                                                                 "  lwir: {from_um: 8, to_um: 12, "
                                                                 "bins: 3}\n";

static struct um_context *context;
static char path[64];

#define OK(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(context));                      \
  } while (0)

static int set_up(void **state)
{
  (void)state;
  if (um_core_context_create(NULL, &context) != UM_OK) return -1;
  um_core_context_set_threads(context, 1);
  snprintf(path, sizeof path, "crate_%ld.yaml", (long)getpid());
  FILE *file = fopen(path, "w");
  if (file == NULL) return -1;
  fputs(scenario, file);
  return fclose(file);
}

static int tear_down(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  return remove(path);
}

struct case_of {
  struct um_compare_measurements *measured;
  struct um_sensitivity_forward *forward;
  struct um_sensitivity_candidates *candidates;
  struct um_diagnosis *d;
};

/* place: whose temperature is measured, with noise sigma [K]. */
static struct case_of diagnose(const char *with, const char *place, double sigma, const char *step)
{
  struct case_of c = {.measured = NULL};
  static const char *const only[] = {"internal_power:crate", "heater:crate.interior",
                                     "interior_capacity:crate"};
  const struct um_model_options changes = {
      .with = &with, .nwith = 1, .overrides = &step, .noverride = 1};
  const struct um_compare_synth noise = {.relative = 0.01,
                                         .floor = 0.001,
                                         .seed = 3,
                                         .place = &place,
                                         .nplace = 1,
                                         .temperature_sigma = sigma};
  const struct um_diagnosis_options options = {
      .candidates = {.only = only, .nonly = 3}, .no_next = true, .no_heat = true, .no_light = true};
  OK(um_compare_synth_run(context, path, &changes, &noise, "made", &c.measured));
  OK(um_sensitivity_forward_create(context, path, NULL, c.measured, UM_VARIANT_TIGHT, &c.forward));
  OK(um_sensitivity_candidates_create(context, c.forward, NULL, 0, &options.candidates,
                                      &c.candidates));
  OK(um_diagnosis_create(context, c.forward, c.candidates, &options, &c.d));
  print_message("  %s: %s\n  %zu evaluations\n", um_diagnosis_verdict_name(c.d->verdict),
                c.d->summary, c.forward->evaluations);
  return c;
}

static void end(struct case_of *c)
{
  um_diagnosis_destroy(context, &c->d);
  um_sensitivity_candidates_destroy(context, &c->candidates);
  um_sensitivity_forward_destroy(context, &c->forward);
  um_compare_measurements_destroy(context, &c->measured);
}

/* The truth is off and a quarter of the way down where the rows begin, which no orbit of cycles
 * before them leads to. The heater is named all the same, with its phase, and its values are right
 * within three of their sigmas. */
static void phase_is_free(void **state)
{
  (void)state;
  static const double truth[] = {12.0, 290.0, 2.0, 0.62};
  struct case_of c = diagnose("heater:crate.interior,power_W=12,on_K=290,band_K=2,phase=0.62",
                              "crate.interior", 0.4, "time.step_s=20");
  assert_int_equal(c.d->verdict, UM_VERDICT_FOUND);
  assert_int_equal(c.d->naddition, 1);
  assert_string_equal(c.d->addition[0].effect->name, "heater");
  assert_int_equal(c.d->step[0].confidence, UM_CONFIDENCE_CERTAIN);
  for (size_t p = 0; p < 4; p++) {
    double off = (c.d->addition[0].value[p] - truth[p]) / c.d->addition_sigma[0][p];
    print_message("  %g +- %g: %+.2f sigma\n", c.d->addition[0].value[p], c.d->addition_sigma[0][p],
                  off);
    assert_true(fabs(off) <= 3.0);
  }
  end(&c);
}

/* A thermostat that is on all the time is constant power, and explains whatever that does. Sigma is
 * 2 K, of which a heater of two more numbers makes 1 in chi-square: within the evidence by n alone.
 * Internal power is certain all the same, and the heater is it by another name. */
static void always_on_is_constant(void **state)
{
  (void)state;
  struct case_of c =
      diagnose("internal_power:crate,power_W=4", "crate.interior", 2.0, "time.step_s=20");
  assert_int_equal(c.d->verdict, UM_VERDICT_FOUND);
  assert_string_equal(c.d->addition[0].effect->name, "internal_power");
  assert_int_equal(c.d->step[0].confidence, UM_CONFIDENCE_CERTAIN);
  bool tried = false;
  for (size_t i = 1; i < c.d->step[0].nalternative; i++) {
    const struct um_diagnosis_alternative *r = &c.d->step[0].alternative[i];
    if (strcmp(c.candidates->candidate[r->candidate].name, "heater:crate.interior") != 0) continue;
    print_message("  behind by %g\n", r->bic - c.d->step[0].alternative[0].bic);
    tried = r->fitted;
    assert_true(r->contains_winner && r->same_effect && !r->indistinguishable);
  }
  assert_true(tried);
  end(&c);
}

/* The same with 500 rows of sigma 0.4 K. What a heater costs for its temperatures, 2 ln n, keeps it
 * from being fitted, and then it is no rival either. */
static void not_worth_a_fit(void **state)
{
  (void)state;
  struct case_of c =
      diagnose("internal_power:crate,power_W=4", "crate.interior", 0.4, "time.step_s=6");
  bool seen = false;
  for (size_t i = 1; i < c.d->step[0].nalternative; i++) {
    const struct um_diagnosis_alternative *r = &c.d->step[0].alternative[i];
    if (strcmp(c.candidates->candidate[r->candidate].name, "heater:crate.interior") != 0) continue;
    seen = true;
    print_message("  fitted %d, not tried %d\n", r->fitted, r->not_tried);
    assert_true(!r->fitted && !r->not_tried);
  }
  assert_true(seen);
  assert_int_equal(c.d->verdict, UM_VERDICT_FOUND);
  assert_int_equal(c.d->step[0].confidence, UM_CONFIDENCE_CERTAIN);
  end(&c);
}

/* The wall that leads the box's heat away does not follow its cycle. A heater is fitted with its
 * power alone, as one that is on all the time, so it fits as constant power does, and takes no
 * share of its probability. */
static void unseen_cycle(void **state)
{
  (void)state;
  struct case_of c = diagnose("internal_power:crate,power_W=12", "crate.+x", 4.0, "time.step_s=20");
  const struct um_diagnosis_alternative *best = &c.d->step[0].alternative[0], *r = best;
  while (strcmp(c.candidates->candidate[r->candidate].name, "heater:crate.interior") != 0) r++;
  print_message("  %g W, switches at %g K, behind by %g\n", r->value[0], r->value[1],
                r->bic - best->bic);
  assert_true(r->fitted && isfinite(r->sigma[0]) && r->value[1] > 500.0);
  assert_true(fabs(r->value[0] - best->value[0]) < 0.1 * best->sigma[0]);
  double two_more = 2.0 * log((double)c.forward->observations.count);
  assert_true(fabs(r->bic - best->bic - two_more) < 0.1 && r->contains_winner);
  assert_true(r->probability == 0.0);
  end(&c);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(phase_is_free), cmocka_unit_test(always_on_is_constant),
      cmocka_unit_test(not_worth_a_fit), cmocka_unit_test(unseen_cycle)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
