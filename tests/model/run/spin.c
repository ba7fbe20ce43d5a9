/* A box that turns in 5 s, its loads resolved and as means over the turn (thermal.spin_loads), at a
 * fixed point in the Sun: temperatures differ by no more than accuracy_K and the bound that the
 * log states, the light of the Sun, which is that of each instant, not at all. */
#include <stdlib.h>

#include "tests/effects/heat_help.h"

#define BOX                                                                                        \
  "parts=[{name: box, box: {size_m: [1, 1, 1]}, outside: grey_white,"                              \
  " shell: {areal_heat_capacity_J_m2_K: 4860, conductance_W_K: 0.33}}]",                           \
      "contacts=[]"
#define SPIN(period)                                                                               \
  "attitude=[{spin: {axis_gcrs: [0.3, 0.2, 0.9], axis_body: [0, 0, 1], period_s: " period "}}]"
#define TIME                                                                                       \
  "time.stop_utc=2020-03-20T12:07:00Z", "time.step_s=13.7", "thermal.start=isothermal",            \
      "thermal.orbits_before=0"
#define AVERAGED "thermal.spin_loads=averaged"
#define RESOLVED "thermal.spin_loads=resolved"
#define ACCURACY 0.01 /* thermal.accuracy_K, default [K] */

static double apart(const struct heat_run *a, const struct heat_run *b)
{
  const struct um_model_result *r = a->result;
  double largest = 0.0;
  for (size_t i = 0; i < r->nobs * r->nsurface; i++)
    largest = fmax(largest, fabs(r->surface_temperature[i] - b->result->surface_temperature[i]));
  return largest;
}

static void averaged_is_resolved(void **state)
{
  (void)state;
  const char *const material[] = {"grey_white", "aluminium_anodised"};
  for (size_t m = 0; m < 2; m++) { /* without and with a law by angle */
    char outside[64];
    snprintf(outside, sizeof outside, "parts.box.outside=%s", material[m]);
    struct heat_run a = heat_compute(LIST(BOX, outside, SPIN("5"), TIME, AVERAGED), NONE, NONE);
    struct heat_run b = heat_compute(
        LIST(BOX, outside, SPIN("5"), TIME, RESOLVED, "thermal.step_s=0.01"), NONE, NONE);
    print_message("%s: %.5f K apart, rows %zu and %zu, steps %zu and %zu\n", material[m],
                  apart(&a, &b), a.tables->loads->ntime, b.tables->loads->ntime, a.result->steps,
                  b.result->steps);
    assert_true(apart(&a, &b) <= ACCURACY);
    assert_true(a.tables->loads->ntime < 60 && a.result->steps * 20 < b.result->steps);
    assert_true(heat_same_reflected(&a, &b, "vis"));
    heat_release(&a);
    heat_release(&b);
  }
}

/* By default means where they leave less than accuracy_K: not behind foil, nor where a turn takes
 * longer than rows are apart, nor where the grid is stated. */
static void automatic(void **state)
{
  (void)state;
  static const struct {
    const char *change, *spin;
    bool averaged;
  } c[] = {{"thermal.samples=4", SPIN("5"), true},
           {"thermal.samples=4", SPIN("-5"), true},
           {"thermal.accuracy_K=1e-5", SPIN("5"), false},
           {"thermal.step_s=1", SPIN("5"), false},
           {"thermal.samples=4", SPIN("11"), false},
           {"parts.box.shell.areal_heat_capacity_J_m2_K=80", SPIN("5"), false}};
  for (size_t i = 0; i < sizeof c / sizeof c[0]; i++) {
    struct heat_run run =
        heat_compute(LIST(BOX, c[i].spin, "thermal.start=isothermal", c[i].change), NONE, NONE);
    if ((run.tables->spin_period == 5.0) != c[i].averaged)
      fail_msg("%s, %s: turn of %g s", c[i].spin, c[i].change, run.tables->spin_period);
    heat_release(&run);
  }
}

static void refused(void **state)
{
  (void)state;
  char message[512];
  heat_refused(LIST(BOX, AVERAGED), NONE, message, sizeof message);
  if (strstr(message, "spin_loads") == NULL || strstr(message, "not one law that turns") == NULL)
    fail_msg("%s", message);
}

/* A tumble whose rate is along an axis of inertia is a spin: from the same scenario keys the same
 * attitudes, temperatures and light to rounding, with the periodic start too. */
static void tumble_is_spin(void **state)
{
  (void)state;
  static const char *const start[] = {"thermal.start=isothermal", "thermal.start=periodic"};
  for (size_t i = 0; i < 2; i++) {
    struct heat_run a =
        heat_compute(LIST(BOX, start[i], "thermal.step_s=10",
                          "attitude=[{spin: {q_gcrs: [0.6, 0.48, 0, 0.64], axis_body: [0, 0, 1], "
                          "period_s: 90, at_utc: 2020-03-20T12:01:00Z}}]"),
                     NONE, NONE);
    struct heat_run b = heat_compute(
        LIST(BOX, start[i], "thermal.step_s=10",
             "attitude=[{tumble: {q_gcrs: [0.6, 0.48, 0, 0.64], rates_deg_s: [0, 0, 4], "
             "inertia_kg_m2: [20, 35, 50], at_utc: 2020-03-20T12:01:00Z}}]"),
        NONE, NONE);
    assert_true(apart(&a, &b) <= 1e-6);
    heat_release(&a);
    heat_release(&b);
  }
}

/* From one fixed attitude to another, 90 deg about x in 60 s from 12:03 on: half way after half of
 * the time, an eighth after a quarter (half of it speeding up). */
static void slew_between(void **state)
{
  (void)state;
  struct heat_run run = heat_compute(
      LIST(BOX, "thermal.start=isothermal", "thermal.orbits_before=0",
           "time.start_utc=2020-03-20T12:02:30Z", "time.stop_utc=2020-03-20T12:05:00Z",
           "time.step_s=15", "time.light_time=false",
           "attitude=[{fixed: {q_gcrs: [1, 0, 0, 0]}}, {from_utc: 2020-03-20T12:03:00Z, "
           "fixed: {q_gcrs: [0.7071067811865476, 0.7071067811865476, 0, 0]}, "
           "slew: {duration_s: 60}}]"),
      NONE, NONE);
  static const double angle[] = {0, 0, 0, 11.25, 45, 78.75, 90, 90, 90, 90, 90}; /* [deg] */
  assert_int_equal(run.tables->nobs, 11);
  for (size_t k = 0; k < 11; k++) {
    struct um_quat q = run.tables->sample[k * run.tables->nsub].q;
    double got = 2.0 * atan2(q.x, q.w) * 180.0 / acos(-1.0);
    if (!(fabs(got - angle[k]) <= 1e-6))
      fail_msg("row %zu: %.9g deg, expected %g", k, got, angle[k]);
  }
  heat_release(&run);
}

static int begin(void **state)
{
  (void)state;
  return heat_setup("model_spin.yaml");
}
static int end(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(averaged_is_resolved), cmocka_unit_test(automatic),
      cmocka_unit_test(refused), cmocka_unit_test(tumble_is_spin), cmocka_unit_test(slew_between)};
  return cmocka_run_group_tests_name("model_spin", tests, begin, end);
}
