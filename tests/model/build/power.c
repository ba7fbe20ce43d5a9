/* Dissipation of a scenario: power_W and power_file of groups and interiors, on the small satellite
 * of tests/effects/heat_help.h in the dark, where what is released is what the table says. */
#include "tests/effects/heat_help.h"

#define CSV "model_power.csv"
#define DARK                                                                                       \
  "orbit={fixed: {position_gcrs_km: [-7000, 0, 0]}}", "thermal.start=isothermal",                  \
      "thermal.orbits_before=0", "time.step_s=30", "time.stop_utc=2020-03-20T12:20:00Z"

static void write_csv(const char *text)
{
  FILE *f = fopen(CSV, "w");
  assert_non_null(f);
  fputs(text, f);
  assert_int_equal(fclose(f), 0);
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

/* A table that says the same all the time is a constant power: to the integrator's 1e-9. */
static void constant_table_is_power(void **state)
{
  (void)state;
  write_csv("time_utc,power_W\n2020-03-20T11:00:00Z,15\n2020-03-20T13:00:00Z,15\n");
  struct heat_run a = heat_compute(
      LIST(DARK, "parts.bus.interior.power_W=35", "parts.bus.groups={-x: {power_W: 15}}"), NONE,
      NONE);
  struct heat_run b = heat_compute(LIST(DARK, "parts.bus.interior.power_file=" CSV,
                                        "parts.bus.groups={-x: {power_file: " CSV "}}"),
                                   NONE, NONE);
  size_t last = a.result->nobs - 1;
  heat_close("interior", heat_temperature(&b, "bus.interior", last),
             heat_temperature(&a, "bus.interior", last), 1e-8);
  heat_close("wall", heat_temperature(&b, "bus.-x.wall", last),
             heat_temperature(&a, "bus.-x.wall", last), 1e-8);
  heat_close("internal heat of the interior", heat_of(&b, "bus.interior", last)->internal, 35.0,
             1e-12);
  struct heat_run none = heat_compute(LIST(DARK), NONE, NONE);
  assert_true(heat_temperature(&a, "bus.-x.wall", last) >
              heat_temperature(&none, "bus.-x.wall", last) + 0.5);
  heat_release(&none);
  heat_release(&a);
  heat_release(&b);
}

/* A pulse of 200 W from 12:05 to 12:10 that begins and ends in jumps, a ramp to 12:15 from nothing:
 * the table of heat flows says it, the energy is in the audit. */
static void pulse_and_ramp(void **state)
{
  (void)state;
  write_csv("# telemetry\ntime_utc,power_W,note\n2020-03-20T12:05:00Z,200,on\n"
            "2020-03-20T12:10:00Z,200,\n2020-03-20T12:10:00Z,0,off\n2020-03-20T12:15:00Z,30,\n");
  struct heat_run run = heat_compute(LIST(DARK, "parts.bus.interior.power_W=0",
                                          "parts.panel.groups={plate: {power_file: " CSV "}}"),
                                     NONE, NONE);
  const double expected[] = {0, 0, 0, 0, 0, 200, 200, 200, 200, 200, 0, 6, 12, 18, 24};
  for (size_t k = 0; k < 15; k++)
    if (!(fabs(heat_of(&run, "panel", 2 * k)->internal - expected[k]) <= 0.01))
      fail_msg("minute %zu: %g W", k, heat_of(&run, "panel", 2 * k)->internal);
  /* times of a table in UTC are good to 1e-7 s */
  heat_close("energy", run.result->audit.internal, 200.0 * 300.0 + 15.0 * 300.0, 1e-6);
  assert_true(run.result->audit_error <= 1e-6);
  heat_release(&run);
}

static void refused(const char *csv, const char *words)
{
  char message[512];
  write_csv(csv);
  heat_refused(LIST("parts.bus.interior.power_file=" CSV), NONE, message, sizeof message);
  if (strstr(message, words) == NULL || strstr(message, "power_file") == NULL)
    fail_msg("'%s' lacks '%s'", message, words);
}

/* What an effect takes away is held against the least of the table: 12 W beside 3 W. */
static void effect_goes_down_to_the_least(void **state)
{
  (void)state;
  char message[512];
  const char *const *table =
      LIST(DARK, "parts.bus.interior.power_W=3", "parts.bus.interior.power_file=" CSV);
  write_csv("time_utc,power_W\n2020-03-20T11:00:00Z,15\n2020-03-20T12:05:00Z,12\n"
            "2020-03-20T13:00:00Z,40\n");
  struct heat_run run = heat_compute(table, LIST("internal_power:bus,power_W=-15"), NONE);
  heat_release(&run);
  heat_refused(table, LIST("internal_power:bus,power_W=-15.5"), message, sizeof message);
  if (strstr(message, "makes the power inside 'bus' -0.5 W; accepted: 0 or more in all") == NULL)
    fail_msg("'%s'", message);
}

static void tables_are_checked(void **state)
{
  (void)state;
  char message[512];
  refused("time_utc,watts\n2020-03-20T12:00:00Z,1\n2020-03-20T12:01:00Z,1\n", "power_W");
  refused("time_utc,power_W\n2020-03-20T12:00:00Z,1\n", CSV ": 1 row; accepted: 2 or more");
  refused("time_utc,power_W\n2020-03-20T12:00:00Z,1\nyesterday,1\n", CSV ":3");
  refused("time_utc,power_W\n2020-03-20T12:00:00Z,1\n2020-03-20T11:00:00Z,1\n",
          CSV ":3: column 'time_utc': 2020-03-20T11:00:00Z is before the row above");
  refused("time_utc,power_W\n2020-03-20T12:00:00Z,1\n2020-03-20T12:00:00Z,2\n"
          "2020-03-20T12:00:00Z,3\n",
          CSV ":4: column 'time_utc': 2020-03-20T12:00:00Z stands there three times");
  refused("time_utc,power_W\n2020-03-20T12:00:00Z,1\n2020-03-20T12:01:00Z,nan\n",
          CSV ":3: column 'power_W'");
  heat_refused(LIST("parts.bus.mli.wraps=interior", "parts.bus.groups={+x: {power_W: 5}}"), NONE,
               message, sizeof message);
  if (strstr(message, "part bus, group +x: no wall") == NULL) fail_msg("'%s'", message);
}

static int setup(void **state)
{
  (void)state;
  return heat_setup("model_power.yaml");
}
static int teardown(void **state)
{
  (void)state;
  remove(CSV);
  return heat_teardown();
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(constant_table_is_power),
      cmocka_unit_test(pulse_and_ramp),
      cmocka_unit_test(effect_goes_down_to_the_least),
      cmocka_unit_test(tables_are_checked),
  };
  return cmocka_run_group_tests(tests, setup, teardown);
}
