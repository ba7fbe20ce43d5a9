/* Measurements made by the library beside the command's, and their columns. */
#include <stdlib.h>

#include "tests/library/session_test.h"

#define CHANGES "--set", "time.step_s=6", "--set", "time.start_utc=2016-09-06T18:08:00Z"

static struct umbra_scenario *scenario;

static int enter(void **state)
{
  if (session_enter(state) != 0) return -1;
  command_copy_data("box.yaml");
  ok(umbra_scenario_read(umbra, "box.yaml", NULL, &scenario));
  ok(umbra_scenario_set(umbra, scenario, "time.step_s", "6"));
  ok(umbra_scenario_set(umbra, scenario, "time.start_utc", "2016-09-06T18:08:00Z"));
  return 0;
}

static int leave(void **state)
{
  umbra_scenario_close(&scenario);
  return session_leave(state);
}

static struct umbra_measurements *make(unsigned long long seed)
{
  static const char *const place[] = {"bus"};
  struct umbra_synth_settings settings = UMBRA_SYNTH_SETTINGS;
  struct umbra_measurements *made;
  settings.noise = 0.02;
  settings.floor = 0.005;
  settings.seed = seed;
  settings.place = place;
  settings.nplace = 1;
  settings.temperature_sigma = 0.2;
  ok(umbra_synth(umbra, scenario, &settings, &made));
  return made;
}

static void expect_same_file(const char *a, const char *b)
{
  size_t n, m;
  char *left = command_read_bytes(a, &n), *right = command_read_bytes(b, &m);
  assert_true(n > 1000);
  assert_int_equal(n, m);
  assert_memory_equal(left, right, n);
  free(left);
  free(right);
}

/* The file that the command writes, byte by byte; it is not overwritten unasked. */
static void test_command(void **state)
{
  (void)state;
  struct umbra_measurements *made = make(5);
  ok(umbra_measurements_write(umbra, made, "ours.csv", 0));
  command_expect(0, "synth", "box.yaml", CHANGES, "--noise", "0.02,0.005", "--temperatures", "bus",
                 "--temperature-sigma", "0.2", "--seed", "5", "-o", "theirs.csv", NULL);
  expect_same_file("ours.csv", "theirs.csv");
  refused(umbra_measurements_write(umbra, made, "ours.csv", 0), UMBRA_ERR_IO, "exists");
  ok(umbra_measurements_write(umbra, made, "ours.csv", 1));
  umbra_measurements_close(&made);
}

/* Columns make the same measurements again, and hold what was asked for. */
static void test_columns(void **state)
{
  (void)state;
  struct umbra_measurements *made = make(5), *again;
  const struct umbra_columns *c;
  size_t bus = 0;
  ok(umbra_measurements_columns(umbra, made, &c));
  assert_true(c->count > 50);
  assert_null(c->station);
  assert_null(c->track);
  assert_null(c->elevation_deg);
  for (size_t i = 0; i < c->count; i++) {
    if (strcmp(c->of[i], "bus") != 0) continue;
    assert_string_equal(c->quantity[i], "temperature");
    assert_close(c->sigma[i], 0.2, 1e-12);
    bus++;
  }
  assert_int_equal(3 * bus, c->count);                 /* two bands beside it */
  assert_close(c->time_unix_s[0], 1473185280.0, 1e-6); /* 2016-09-06T18:08:00Z */
  ok(umbra_measurements_make(umbra, c, &again));
  ok(umbra_measurements_write(umbra, made, "made.csv", 0));
  ok(umbra_measurements_write(umbra, again, "again.csv", 0));
  expect_same_file("made.csv", "again.csv");
  umbra_measurements_close(&again);
  umbra_measurements_close(&made);
}

static void test_refusals(void **state)
{
  (void)state;
  struct umbra_synth_settings settings = UMBRA_SYNTH_SETTINGS;
  struct umbra_measurements *made;
  refused(umbra_synth(umbra, scenario, &settings, &made), UMBRA_ERR_INPUT, "noise");
  assert_null(made);
  static const char *const place[] = {"wing"};
  settings.noise = 0.01;
  settings.place = place;
  settings.nplace = 1;
  refused(umbra_synth(umbra, scenario, &settings, &made), UMBRA_ERR_INPUT, "wing");
  settings.size = 3;
  refused(umbra_synth(umbra, scenario, &settings, &made), UMBRA_ERR_INPUT, "size");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_command, enter, leave),
      cmocka_unit_test_setup_teardown(test_columns, enter, leave),
      cmocka_unit_test_setup_teardown(test_refusals, enter, leave),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
