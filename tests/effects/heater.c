/* The thermostat heater on the small satellite of heat_help.h: what it holds, what it does where it
 * is too weak, that at power 0 it is not there, and that what cannot carry one says so. */
#include "effects/effects.h"
#include "heat_help.h"
#include "model/run/result.h"

/* In the Earth's shadow from 280 K on for an hour, a row every 20 s. */
#define DARK                                                                                       \
  "orbit={fixed: {position_gcrs_km: [-7000, 0, 0]}}", "thermal.start=isothermal",                  \
      "thermal.orbits_before=0", "time.step_s=20", "time.stop_utc=2020-03-20T13:00:00Z"

static void null_changes_no_bit(void **state)
{
  (void)state;
  static const char *const targets[] = {"bus", "bus.+x", "bus.interior", "panel.front"};
  struct heat_run without = heat_compute(LIST(DARK), NONE, NONE);
  for (size_t i = 0; i < 4; i++) {
    char text[96];
    snprintf(text, sizeof text, "heater:%s,power_W=0,on_K=279,band_K=0.5", targets[i]);
    struct heat_run with = heat_compute(LIST(DARK), LIST(text), NONE);
    assert_true(heat_same_temperatures(&without, &with));
    assert_true(heat_same_band(&without, &with, "lwir"));
    heat_release(&with);
  }
  heat_release(&without);
}

/* Too weak to reach its threshold it is an internal power; on a wall, all of it is radiated. */
static void weak_is_simply_on(void **state)
{
  (void)state;
  struct heat_run a = heat_compute(NONE, LIST("internal_power:bus,power_W=5"), NONE);
  struct heat_run b = heat_compute(NONE, LIST("heater:bus.interior,power_W=5,on_K=500"), NONE);
  for (size_t k = 0; k < 2; k++)
    heat_close("interior", heat_temperature(&b, "bus.interior", k),
               heat_temperature(&a, "bus.interior", k), 1e-9);
  heat_release(&a);
  heat_release(&b);
  struct heat_run none = heat_compute(NONE, NONE, NONE);
  double before = heat_budget(&none, NULL, false).emitted;
  heat_release(&none);
  static const char *const targets[] = {"bus", "bus.-y", "panel", "panel.back", "panel.plate"};
  for (size_t i = 0; i < 5; i++) {
    char text[96];
    snprintf(text, sizeof text, "heater:%s,power_W=20,on_K=500", targets[i]);
    struct heat_run run = heat_compute(NONE, LIST(text), NONE);
    /* float loads and 1e-9 of temperatures of 300 K, of some 3 kW */
    heat_close(text, heat_budget(&run, NULL, false).emitted, before + 20.0, 1e-6);
    heat_release(&run);
  }
}

static const struct um_thermal_heat *heat_of(const struct heat_run *run, const char *place,
                                             size_t k)
{
  const struct um_model_result *r = run->result;
  for (size_t p = 0; p < r->nplace; p++)
    if (strcmp(r->place[p].name, place) == 0) return &r->heat[k * r->nplace + p];
  fail_msg("no place is called '%s'", place);
  return NULL;
}

/* The back of the panel cools through 240 K and is held between 240 and 242 K from there on, its
 * heat in the table all or nothing. */
static void holds_in_the_dark(void **state)
{
  (void)state;
  struct heat_run run =
      heat_compute(LIST(DARK), LIST("heater:panel.back,power_W=800,on_K=240,band_K=2"), NONE);
  size_t n = run.result->nobs, cycles = 0, first = 0;
  while (first < n && !(heat_of(&run, "panel", first)->internal > 0.0)) first++;
  assert_true(first > 5 && first < n / 2);
  for (size_t k = 0; k < n; k++) {
    double t = heat_temperature(&run, "panel.back", k), p = heat_of(&run, "panel", k)->internal;
    if (k < first) assert_true(t > 240.0);
    /* the integrator's 1e-9 of a temperature */
    if (k >= first && !(t > 240.0 - 1e-5 && t < 242.0 + 1e-5)) fail_msg("row %zu: %g K", k, t);
    assert_true(p == 0.0 || fabs(p - 800.0) < 1e-9);
    cycles += k > 0 && p > 0.0 && heat_of(&run, "panel", k - 1)->internal == 0.0;
  }
  print_message("  held from row %zu of %zu, switched on %zu times, audit %.1e\n", first, n, cycles,
                run.result->audit_error);
  assert_true(cycles > 3);
  assert_true(run.result->audit_error <= 1e-6);
  heat_release(&run);
}

/* Where the sun holds the interior lower than wished, the start is at the middle of the band, to
 * the width in which the mean power falls off, a tenth of it. */
static void steady_start_is_held(void **state)
{
  (void)state;
  struct heat_run run =
      heat_compute(NONE, LIST("heater:bus.interior,power_W=300,on_K=330,band_K=3"), NONE);
  for (size_t k = 0; k < 2; k++) {
    double t = heat_temperature(&run, "bus.interior", k);
    print_message("  interior %.3f K\n", t);
    assert_true(t > 330.0 && t < 333.0);
  }
  heat_release(&run);
}

/* A phase says where the cycle is when the repeating orbit is over, which is when the observations
 * begin; what was before is the mean power. 0.15 of a cycle: 0.3 of the band up, on; 0.9: a fifth
 * of it above on_K, off. Not stated, an orbit of cycles comes before and decides. */
static void phase_begins_the_observations(void **state)
{
  (void)state;
#define ORBIT                                                                                      \
  "orbit={circular: {altitude_km: 600}}", "thermal.start=periodic", "thermal.orbits_before=1",     \
      "time.step_s=10", "time.stop_utc=2020-03-20T12:20:00Z"
  static const struct {
    double phase, share;
    bool on;
  } rows[] = {{0.15, 0.3, true}, {0.9, 0.2, false}};
  for (size_t i = 0; i < 2; i++) {
    char text[120];
    snprintf(text, sizeof text, "heater:panel.back,power_W=400,on_K=350,band_K=4,phase=%g",
             rows[i].phase);
    struct heat_run run = heat_compute(LIST(ORBIT), LIST(text), NONE);
    double t = heat_temperature(&run, "panel.back", 0), p = heat_of(&run, "panel", 0)->internal;
    print_message("  phase %g: %.6f K, %.0f W, then %.4f K\n", rows[i].phase, t, p,
                  heat_temperature(&run, "panel.back", 1));
    heat_close("begins", t, 350.0 + 4.0 * rows[i].share, 1e-9);
    assert_true(p == (rows[i].on ? 400.0 : 0.0));
    assert_true((heat_temperature(&run, "panel.back", 1) > t) == rows[i].on);
    assert_true(run.result->audit_error <= 1e-6);
    heat_release(&run);
  }
}

/* Where the place passes on_K the temperature rises in proportion to a small power: while it cools
 * below, the heater is on all the time. */
static void slope_at_null(void **state)
{
  (void)state;
  double t[3];
  for (int i = 0; i < 3; i++) {
    char text[96];
    snprintf(text, sizeof text, "heater:panel.back,power_W=%d,on_K=260", i);
    struct heat_run run = heat_compute(LIST(DARK), LIST(text), NONE);
    t[i] = heat_temperature(&run, "panel.back", run.result->nobs - 1);
    heat_release(&run);
  }
  print_message("  %.5f K per W, then %.5f K\n", t[1] - t[0], t[2] - t[1]);
  assert_true(t[1] - t[0] > 0.01);
  heat_close("second watt", t[2] - t[1], t[1] - t[0], 0.05);
}

static void refusals(void **state)
{
  (void)state;
  char message[512];
  heat_refused(NONE, LIST("heater:panel.interior"), message, sizeof message);
  if (strstr(message, "part panel: a heater on 'interior', which it has not") == NULL)
    fail_msg("'%s'", message);
  heat_refused(LIST("parts.bus.mli.wraps=interior"), LIST("heater:bus.-x"), message,
               sizeof message);
  if (strstr(message, "part bus, group -x: no wall that could take the heat of its heater") == NULL)
    fail_msg("'%s'", message);
  heat_refused(LIST("parts.panel.shell.areal_heat_capacity_J_m2_K=0"), LIST("heater:panel"),
               message, sizeof message);
  if (strstr(message, "accepted") == NULL) fail_msg("'%s'", message);
  heat_refused(NONE, LIST("heater"), message, sizeof message);
  assert_non_null(strstr(message, "needs a target"));
  heat_refused(NONE, LIST("heater:bus.+x,power_W=-3"), message, sizeof message);
  assert_non_null(strstr(message, "accepted: 0 to"));
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("effects_heater.yaml");
}
static int teardown(void **state)
{
  (void)state;
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(null_changes_no_bit),
      cmocka_unit_test(weak_is_simply_on),
      cmocka_unit_test(holds_in_the_dark),
      cmocka_unit_test(steady_start_is_held),
      cmocka_unit_test(slope_at_null),
      cmocka_unit_test(phase_begins_the_observations),
      cmocka_unit_test(refusals),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
