/* Heaters with hysteresis.
 *
 *   boundary T_b --- G --- node C, heater P between T_on and T_off        tau = C / G
 *
 * On the node runs toward T_b + P/G, off toward T_b, both as exponentials, so
 *
 *   t_on  = tau ln((T_b + P/G - T_on) / (T_b + P/G - T_off)),
 *   t_off = tau ln((T_off - T_b) / (T_on - T_b)).
 */
#include "tests/thermal/network_help.h"
#include "thermal/network/network_group.h"

#define C     1600.0 /* [J/K] */
#define G     1.25   /* [W/K] */
#define T_B   200.0  /* [K] */
#define P     60.0   /* [W] */
#define ON    229.0  /* [K] */
#define OFF   230.7
#define TAU   (C / G)
#define T_ON  (TAU * log((T_B + P / G - ON) / (T_B + P / G - OFF))) /* 104 s */
#define T_OFF (TAU * log((OFF - T_B) / (ON - T_B)))                 /* 73 s */

static struct um_thermal_network *heated(double start, double power, uint32_t *node)
{
  struct um_thermal_network *network = help_network();
  uint32_t boundary = help_boundary(network, T_B);
  *node = help_node(network, C, start);
  OK(um_thermal_network_conductor_add(network, boundary, *node, G));
  const double weight = 1.0;
  const struct um_thermal_thermostat thermostat = {
      .node = node, .weight = &weight, .nnode = 1, .power = power, .on = ON, .off = OFF};
  OK(um_thermal_network_thermostat_add(network, &thermostat));
  return network;
}

/* Forty cycles from a switching: where each should switch the node is at its threshold, halfway
 * through each state where its exponential says, and the heat released is P t_on a cycle. */
static void test_cycle(void **state)
{
  (void)state;
  enum { CYCLES = 40 };
  uint32_t node;
  struct um_thermal_network *network = heated(OFF, P, &node);
  double times[4 * CYCLES], expected[4 * CYCLES], period = T_ON + T_OFF;
  for (size_t k = 0; k < CYCLES; k++) {
    double begin = (double)k * period, *t = times + 4 * k, *e = expected + 4 * k;
    t[0] = begin + 0.5 * T_OFF;
    t[1] = begin + T_OFF;
    t[2] = begin + T_OFF + 0.5 * T_ON;
    t[3] = begin + period;
    e[0] = T_B + (OFF - T_B) * exp(-0.5 * T_OFF / TAU);
    e[1] = ON;
    e[2] = T_B + P / G + (ON - T_B - P / G) * exp(-0.5 * T_ON / TAU);
    e[3] = OFF;
  }
  struct um_thermal_solve_options options = help_options(1e-11, 1e-10, 0.0);
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, times, 4 * CYCLES,
                      &history));
  /* 1e-6 of the period after 40 cycles, where T moves by 0.023 K/s: 4e-6 K in the last one */
  double worst = 0.0;
  for (size_t k = 0; k < 4 * CYCLES; k++) {
    worst = fmax(worst, fabs(history->temperature[2 * k + node] - expected[k]));
    if (k % 2 == 0) assert_true(history->heating[k] == (k % 4 == 2));
  }
  double duty = history->audit.internal / (P * CYCLES * T_ON);
  print_message("t_on %.3f s, t_off %.3f s: worst %.1e K, heat %.9f of P t_on, audit %.1e, %zu "
                "steps\n",
                T_ON, T_OFF, worst, duty, history->audit_error, history->steps);
  NEAR("forty cycles", worst, 0.0, 1e-6 * period * (P - G * (ON - T_B)) / C);
  NEAR("duty", duty, 1.0, 1e-6);
  if (!(history->audit_error <= 1e-6)) fail_msg("audit %g", history->audit_error);
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
}

/* Where the first state is by the start: below the middle on, above off. */
static void test_start(void **state)
{
  (void)state;
  static const struct {
    double start;
    bool on;
  } rows[] = {{220.0, true}, {229.8, true}, {229.9, false}, {240.0, false}};
  for (size_t k = 0; k < 4; k++) {
    uint32_t node;
    struct um_thermal_network *network = heated(rows[k].start, P, &node);
    double limit = T_B + (rows[k].on ? P / G : 0.0);
    NEAR("first seconds", help_temperature_at(network, 0.0, node, 10.0),
         limit + (rows[k].start - limit) * exp(-10.0 / TAU), 1e-6);
    um_thermal_network_destroy(&network);
  }
}

/* 37.5 W hold 230 K: in the band, never switched off; 30 W hold 224 K. Both are simply on. */
/* A given phase: from 229.8 K, off until it reaches 229 K though the sensor is below the middle, or
 * on until 230.7 K from above it; outside of the band the sensor decides. A run that goes on where
 * another ended, with its temperatures and what was on, goes on as one. */
static void test_given_phase(void **state)
{
  (void)state;
  static const double start[4] = {229.7, 230.2, 228.0, 232.0};
  static const enum um_thermal_thermostat_start phase[4] = {UM_THERMOSTAT_OFF, UM_THERMOSTAT_ON,
                                                            UM_THERMOSTAT_OFF, UM_THERMOSTAT_ON};
  static const bool on[4] = {false, true, true, false};
  const double t = 5.0;
  for (int k = 0; k < 4; k++) {
    uint32_t node;
    struct um_thermal_solve_options options = help_options(1e-9, 1e-7, 0.0);
    struct um_thermal_history *history = NULL;
    struct um_thermal_network *network = heated(start[k], P, &node);
    network->thermostat[0].start = phase[k];
    OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, &t, 1, &history));
    double toward = T_B + (on[k] ? P / G : 0.0);
    assert_int_equal(history->heating[0], on[k]);
    NEAR("given phase", history->temperature[node], toward + (start[k] - toward) * exp(-t / TAU),
         1e-5);
    um_thermal_history_destroy(help_context, &history);
    um_thermal_network_destroy(&network);
  }
}

/* A stated phase puts the sensor there in the band, from wherever in it the run starts: 0.1 of a
 * cycle is a fifth of the way up, on; 0.8 three fifths of the way down, off; 0.5 and 1 are the
 * instants of switching, off and on. The two exponentials lead on from there through the first
 * switching; what the phase adds to the start is no heat of the run. A quarter of the band above it
 * three quarters of what the phase lacks of the upper end are left; a whole band above it, and
 * below it, the sensor decides. */
static void test_phase(void **state)
{
  (void)state;
  static const struct {
    double start, phase, begin;
    bool on;
  } rows[] = {{229.7, 0.1, ON + 0.2 * (OFF - ON), true},
              {230.5, 0.8, ON + 0.4 * (OFF - ON), false},
              {229.2, 0.5, OFF, false},
              {230.5, 1.0, ON, true},
              {OFF + 0.25 * (OFF - ON), 0.8, OFF - 0.2 * (OFF - ON), false},
              {OFF + 0.25 * (OFF - ON), 0.1, OFF - 0.35 * (OFF - ON), true},
              {228.0, 0.8, 228.0, true},
              {233.0, 0.2, 233.0, false}};
  for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
    uint32_t node;
    struct um_thermal_solve_options options = help_options(1e-10, 1e-8, 0.0);
    struct um_thermal_history *history = NULL;
    struct um_thermal_network *network = heated(rows[k].start, P, &node);
    network->thermostat[0].phase = rows[k].phase;
    double towards = T_B + (rows[k].on ? P / G : 0.0), turns = rows[k].on ? OFF : ON;
    double first = TAU * log((rows[k].begin - towards) / (turns - towards)); /* it switches */
    double after = T_B + (rows[k].on ? 0.0 : P / G);
    const double t[3] = {0.0, 0.5 * first, first + 20.0};
    OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, t, 3, &history));
    NEAR("begins", history->temperature[node], rows[k].begin, 1e-12);
    NEAR("before it switches", history->temperature[2 + node],
         towards + (rows[k].begin - towards) * exp(-0.5 * first / TAU), 1e-5);
    NEAR("after it switched", history->temperature[4 + node],
         after + (turns - after) * exp(-20.0 / TAU), 1e-5);
    assert_int_equal(history->heating[2], !rows[k].on);
    if (!(history->audit_error <= 1e-6)) fail_msg("audit %g", history->audit_error);
    um_thermal_history_destroy(help_context, &history);
    um_thermal_network_destroy(&network);
  }
}

static void test_goes_on(void **state)
{
  (void)state;
  uint32_t node;
  const double times[2] = {1017.0, 2034.0};
  struct um_thermal_solve_options options = help_options(1e-10, 1e-8, 0.0);
  struct um_thermal_history *whole = NULL, *rest = NULL;
  struct um_thermal_network *network = heated(ON, P, &node);
  OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, times, 2, &whole));
  network->thermostat[0].start = whole->heating[0] ? UM_THERMOSTAT_ON : UM_THERMOSTAT_OFF;
  OK(um_thermal_solve(help_context, network, NULL, &options, whole->temperature, times[0],
                      times + 1, 1, &rest));
  NEAR("goes on", rest->temperature[node], whole->temperature[2 + node], 1e-6);
  assert_int_equal(rest->heating[0], whole->heating[1]);
  um_thermal_history_destroy(help_context, &whole);
  um_thermal_history_destroy(help_context, &rest);
  um_thermal_network_destroy(&network);
}

static void test_weak(void **state)
{
  (void)state;
  const double power[] = {37.5, 30.0};
  for (size_t k = 0; k < 2; k++) {
    uint32_t node;
    struct um_thermal_network *network = heated(215.0, power[k], &node);
    double limit = T_B + power[k] / G;
    NEAR("weak heater", help_temperature_at(network, 0.0, node, 20.0 * TAU), limit, 1e-6);
    um_thermal_network_destroy(&network);
  }
}

/* Two alike switch at the same instants; each would miss the other's. */
static void test_twins(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t boundary = help_boundary(network, T_B), node[2];
  const double weight = 1.0;
  for (int k = 0; k < 2; k++) {
    node[k] = help_node(network, C, OFF);
    OK(um_thermal_network_conductor_add(network, boundary, node[k], G));
    const struct um_thermal_thermostat thermostat = {
        .node = &node[k], .weight = &weight, .nnode = 1, .power = P, .on = ON, .off = OFF};
    OK(um_thermal_network_thermostat_add(network, &thermostat));
  }
  double t = 10.0 * (T_ON + T_OFF) - 0.5 * T_ON;
  double expected = T_B + P / G + (ON - T_B - P / G) * exp(-0.5 * T_ON / TAU);
  for (int k = 0; k < 2; k++)
    NEAR("twin", help_temperature_at(network, 0.0, node[k], t), expected, 1e-6);
  um_thermal_network_destroy(&network);
}

/* Sensor elsewhere: 100 W into one node, sensed on another through a conductor. Its own runs are
 * the reference: between switchings the temperatures stay in [on, off] of the sensor but for what
 * the second node stores, and the audit closes. */
static void test_remote_sensor(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t heater = help_node(network, 400.0, 230.0), sensor = help_node(network, C, 230.0);
  OK(um_thermal_network_conductor_add(network, heater, sensor, 5.0));
  OK(um_thermal_network_conductor_add(network, sensor, help_boundary(network, T_B), G));
  const double weight = 1.0;
  const struct um_thermal_thermostat thermostat = {
      &heater, &weight, 1, &sensor, &weight, 1, 100.0, ON, OFF, UM_THERMOSTAT_BY_SENSOR, 0.0};
  OK(um_thermal_network_thermostat_add(network, &thermostat));
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  double times[2000];
  for (int k = 0; k < 2000; k++) times[k] = 5.0 * (k + 1);
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, times, 2000, &history));
  double low = INFINITY, high = 0.0;
  for (size_t k = 200; k < 2000; k++) {
    double t = history->temperature[3 * k + sensor];
    low = fmin(low, t);
    high = fmax(high, t);
  }
  print_message("sensor from %.2f to %.2f K, audit %.1e\n", low, high, history->audit_error);
  assert_true(low < ON + 0.1 && low > ON - 2.0 && high > OFF - 0.1 && high < OFF + 8.0);
  if (!(history->audit_error <= 1e-6)) fail_msg("audit %g", history->audit_error);
  struct um_thermal_heat heat[3];
  for (size_t k = 0; k < 2000; k += 100) {
    OK(um_thermal_heat_of_nodes(help_context, network, NULL, &options, times[k],
                                history->temperature + 3 * k, heat));
    double before = heat[heater].stored;
    um_thermal_heat_of_thermostats(network, &history->heating[k], heat);
    NEAR("heat of the thermostat", heat[heater].internal, history->heating[k] ? 100.0 : 0.0, 0.0);
    NEAR("is stored or passed on", heat[heater].stored - before, heat[heater].internal, 1e-9);
  }
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
}

/* Steady: by the mean power the middle of the band, to the width of the transition (0.17 K); a weak
 * heater by its own, an idle one without. */
static void test_steady(void **state)
{
  (void)state;
  static const struct {
    double power, boundary_offset, expected, tolerance;
  } rows[] = {{P, 0.0, 0.5 * (ON + OFF), 0.17},
              {30.0, 0.0, T_B + 24.0, 1e-6},
              {P, 50.0, T_B + 50.0, 1e-6},
              {5000.0, 0.0, 0.5 * (ON + OFF), 0.34}};
  for (size_t k = 0; k < 4; k++) {
    struct um_thermal_network *network = help_network();
    uint32_t boundary = help_boundary(network, T_B + rows[k].boundary_offset);
    uint32_t node = help_node(network, C, 280.0);
    OK(um_thermal_network_conductor_add(network, boundary, node, G));
    const double weight = 1.0;
    const struct um_thermal_thermostat thermostat = {
        .node = &node, .weight = &weight, .nnode = 1, .power = rows[k].power, .on = ON, .off = OFF};
    OK(um_thermal_network_thermostat_add(network, &thermostat));
    struct um_thermal_solve_options options = help_options(1e-6, 1e-4, 0.0);
    double temperature[2];
    OK(um_thermal_solve_steady(help_context, network, NULL, 0, &options, NULL, temperature));
    NEAR("steady", temperature[node], rows[k].expected, rows[k].tolerance);
    um_thermal_network_destroy(&network);
  }
}

/* Orbits: a wall that cools to 200 K and is warmed to 260 K by turns, with a heater, on a slow
 * interior (tau 1000 orbits without it); starts from cold and from hot agree, within the tolerance
 * asked for, and the true cycling that starts there keeps the interior where it is. */
static struct um_thermal_network *wall_and_interior(double start, double interior_power,
                                                    uint32_t node[2])
{
  struct um_thermal_network *network = help_network();
  node[0] = help_node(network, C, start);
  node[1] = help_node(network, 5e6, start);
  OK(um_thermal_network_conductor_add(network, node[0], help_boundary(network, T_B), G));
  OK(um_thermal_network_conductor_add(network, node[0], node[1], 0.6));
  const double weight = 1.0, t[] = {2000.0, 6000.0}, power[] = {75.0, 75.0};
  const struct um_thermal_source sun = {&node[0], &weight, 1, t, power, 2, true};
  OK(um_thermal_network_source_add(network, &sun));
  struct um_thermal_thermostat thermostat = {
      .node = &node[0], .weight = &weight, .nnode = 1, .power = P, .on = ON, .off = OFF};
  OK(um_thermal_network_thermostat_add(network, &thermostat));
  thermostat.node = &node[1];
  thermostat.power = interior_power;
  thermostat.on = 250.0;
  thermostat.off = 253.0;
  if (interior_power > 0.0) OK(um_thermal_network_thermostat_add(network, &thermostat));
  return network;
}
static void test_periodic(void **state)
{
  (void)state;
  const double interior_power[] = {0.0, 15.0, 400.0}, starts[] = {150.0, 240.0, 330.0};
  for (size_t p = 0; p < 3; p++) {
    double found[3][3], times[60];
    struct um_thermal_network *network = NULL;
    struct um_thermal_solve_options options;
    um_thermal_solve_defaults(&options);
    uint32_t node[2];
    for (size_t s = 0; s < 3; s++) {
      um_thermal_network_destroy(&network);
      network = wall_and_interior(starts[s], interior_power[p], node);
      struct um_thermal_periodic report;
      OK(um_thermal_solve_periodic_report(help_context, network, NULL, &options, NULL, 0.0, 6000.0,
                                          0.01, found[s], NULL, NULL, &report));
      print_message("%5.0f W from %.0f K: wall %.3f K, interior %.3f K after %zu orbits\n",
                    interior_power[p], starts[s], found[s][node[0]], found[s][node[1]],
                    report.orbits);
      NEAR("distance", report.distance, 0.0, 0.01);
      NEAR("wall from another start", found[s][node[0]], found[0][node[0]], 0.02);
      NEAR("interior from another start", found[s][node[1]], found[0][node[1]], 0.02);
    }
    /* at a duty of 1 % the mean power stands W/4 ln 99 above the middle, W = 0.3 K */
    if (p == 2) NEAR("held interior", found[0][node[1]], 251.5, 0.4);
    for (int k = 0; k < 60; k++) times[k] = 6000.0 / 60.0 * (k + 1);
    struct um_thermal_history *history = NULL;
    OK(um_thermal_solve(help_context, network, NULL, &options, found[0], 0.0, times, 20, &history));
    if (!(history->audit_error <= 1e-6)) fail_msg("audit %g", history->audit_error);
    /* 400 W over a part of the 2000 s: at most 0.16 K */
    NEAR("cycling interior", history->temperature[19 * 3 + node[1]], found[0][node[1]],
         p == 2 ? 0.2 : 0.02);
    um_thermal_history_destroy(help_context, &history);
    um_thermal_network_destroy(&network);
  }
}

/* The same where heat is made in ninety nodes and sensed in all of them, more entries of the
 * Jacobian than it holds: a part that one conductor leads through, wrapped well. Nine tenths of its
 * power are wanted: W/4 ln 9 = 0.17 K below the middle of the band. */
#define MANY 90
static void test_many_nodes(void **state)
{
  (void)state;
  const double lost = 0.05 * MANY * (251.5 - T_B);
  for (int s = 0; s < 3; s++) {
    struct um_thermal_network *network = help_network();
    uint32_t cold = help_boundary(network, T_B), node[MANY];
    double weight[MANY], found[MANY + 1], mean = 0.0;
    for (int k = 0; k < MANY; k++) {
      node[k] = help_node(network, 5e4, 220.0 + 30.0 * s);
      weight[k] = 1.0 / MANY;
      OK(um_thermal_network_conductor_add(network, node[k], cold, 0.05));
      if (k > 0) OK(um_thermal_network_conductor_add(network, node[k - 1], node[k], 20.0));
    }
    const struct um_thermal_thermostat thermostat = {.node = node,
                                                     .weight = weight,
                                                     .nnode = MANY,
                                                     .power = lost / 0.9,
                                                     .on = 250.0,
                                                     .off = 253.0};
    OK(um_thermal_network_thermostat_add(network, &thermostat));
    struct um_thermal_solve_options options;
    um_thermal_solve_defaults(&options);
    struct um_thermal_periodic report;
    OK(um_thermal_solve_periodic_report(help_context, network, NULL, &options, NULL, 0.0, 6000.0,
                                        0.01, found, NULL, NULL, &report));
    for (int k = 0; k < MANY; k++) mean += weight[k] * found[node[k]];
    print_message("%d nodes: %.3f K after %zu orbits\n", MANY, mean, report.orbits);
    NEAR("held by many", mean, 251.5 - 0.25 * 0.3 * log(9.0), 0.02);
    assert_true(report.orbits <= 15);
    um_thermal_network_destroy(&network);
  }
}

static void test_refused(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t massless = help_arithmetic(network, 300.0), node = help_node(network, C, 300.0);
  const double weight = 1.0;
  struct um_thermal_thermostat t = {
      .node = &massless, .weight = &weight, .nnode = 1, .power = P, .on = ON, .off = OFF};
  assert_int_equal(um_thermal_network_thermostat_add(network, &t), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(help_context), "node 0, which stores no heat"));
  um_core_message_clear(help_context);
  t.node = &node;
  t.off = ON;
  assert_int_equal(um_thermal_network_thermostat_add(network, &t), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(help_context), "on at 229 K, off at 229 K"));
  um_core_message_clear(help_context);
  t.off = OFF;
  t.phase = 1.5;
  assert_int_equal(um_thermal_network_thermostat_add(network, &t), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(help_context), "phase 1.5; accepted: 0 to 1"));
  um_core_message_clear(help_context);
  t.phase = 0.0;
  t.power = -1.0;
  assert_int_equal(um_thermal_network_thermostat_add(network, &t), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(help_context), "power -1 W"));
  assert_int_equal(um_thermal_network_thermostats(network), 0);
  um_thermal_network_destroy(&network);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_cycle),       cmocka_unit_test(test_start),
      cmocka_unit_test(test_given_phase), cmocka_unit_test(test_phase),
      cmocka_unit_test(test_goes_on),     cmocka_unit_test(test_weak),
      cmocka_unit_test(test_twins),       cmocka_unit_test(test_remote_sensor),
      cmocka_unit_test(test_steady),      cmocka_unit_test(test_periodic),
      cmocka_unit_test(test_many_nodes),  cmocka_unit_test(test_refused),
  };
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
