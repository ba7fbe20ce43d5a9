/* Capacities and links that go with temperature, against closed forms and printed formulas; the
 * balances that hold whatever the laws are. Ratios here are straight lines, which tables with
 * linear interpolation hold exactly, but for the cube of Debye's law. */
#include <stdlib.h>

#include "base/core/constants.h"
#include "tests/thermal/law_help.h"
#include "thermal/network/mli_law.h"
#include "thermal/tangent/sensitivity.h"

#define CAPACITY 1500.0 /* [J/K] at 300 K */
#define RADIATOR 0.8    /* [m^2] */

/* C (T/300)^n of a body that radiates to 0 K. */
static struct um_thermal_network *lump(double exponent)
{
  struct um_thermal_network *network = help_network();
  struct um_thermal_ratio ratio;
  uint32_t node = help_node(network, CAPACITY, 320.0), law;
  for (size_t k = 0; k < UM_THERMAL_LAW_TEMPERATURES; k++)
    ratio.at[k] =
        pow(fmax(1e-3, (double)k * UM_THERMAL_LAW_STEP) / UM_REFERENCE_TEMPERATURE, exponent);
  OK(um_thermal_network_capacity_law_add(network, &ratio, &law));
  OK(um_thermal_network_capacity_follow(network, node, CAPACITY, law));
  OK(um_thermal_network_radiator_add(network, node, UM_THERMAL_SPACE, RADIATOR));
  return network;
}

/* C T/300 dT/dt = -k T^4: T^-2 = T_0^-2 + 2 (300 k/C) t;  C (T/300)^3 dT/dt = -k T^4: T = T_0
 * exp(-300^3 k t / C). Steps held to 1e-10. The table of the cube lies between its chords, above it
 * by at most (2 K)^2/8 6 T, 3 K^2/T^2 of it: in cooling from 320 to 170 K, which takes ln(320/170)
 * of a time, T is later by 1/2 (3/2) (1/T^2 - 1/T_0^2) of itself at most. */
static void bodies_cool(void **state)
{
  (void)state;
  const double k = UM_STEFAN_BOLTZMANN * RADIATOR;
  struct um_thermal_network *line = lump(1.0), *cube = lump(3.0);
  for (double t = 200.0; t < 3000.0; t += 700.0) {
    double exact = pow(pow(320.0, -2.0) + 2.0 * 300.0 * k / CAPACITY * t, -0.5);
    NEAR("C ~ T", help_temperature_at(line, 0.0, 0, t), exact, 2e-6);
    exact = 320.0 * exp(-2.7e7 * k * t / CAPACITY);
    if (exact < 100.0) continue;
    double late = 0.75 * (1.0 / (exact * exact) - 1.0 / (320.0 * 320.0)) * 2.0;
    NEAR("C ~ T^3", help_temperature_at(cube, 0.0, 0, t), exact, late * exact + 2e-6);
  }
  um_thermal_network_destroy(&line);
  um_thermal_network_destroy(&cube);
}

/* Kirchhoff: with k = k_0 (1 + b (T - 300)) the integral of k dT falls linearly along a slab. The
 * conductance at the mean temperature of a link is exact for a line, so are the nodes. */
static void slab_conducts(void **state)
{
  (void)state;
  enum { NODES = 9 };
  const double slope = 4e-3, hot = 450.0, cold = 200.0;
  const struct um_thermal_ratio ratio = law_line(slope);
  const struct um_thermal_link_law law = {.power = 4.0, .table = &ratio};
  struct um_thermal_network *network = help_network();
  uint32_t index, before = help_boundary(network, hot);
  OK(um_thermal_network_link_law_add(network, &law, &index));
  for (int k = 1; k <= NODES + 1; k++) {
    uint32_t node = k <= NODES ? help_node(network, 10.0, 300.0) : help_boundary(network, cold);
    OK(um_thermal_network_conductor_add(network, before, node, 3.0));
    um_thermal_network_conductor_follow(network, index);
    before = node;
  }
  double temperature[NODES + 2];
  struct um_thermal_solve_options options = help_options(1e-9, 1e-8, 0.0);
  OK(um_thermal_solve_steady(help_context, network, NULL, 0, &options, NULL, temperature));
  double a = hot - 300.0, b = cold - 300.0;
  for (int k = 0; k < NODES + 2; k++) {
    double u = (double)k / (NODES + 1);
    double theta = (1.0 - u) * (a + 0.5 * slope * a * a) + u * (b + 0.5 * slope * b * b);
    double exact = 300.0 + (sqrt(1.0 + 2.0 * slope * theta) - 1.0) / slope;
    NEAR("T", temperature[k], exact, 1e-7);
  }
  struct um_thermal_heat heat[NODES + 2];
  OK(um_thermal_heat_of_nodes(help_context, network, NULL, &options, 0.0, temperature, heat));
  double through = 3.0 / (NODES + 1) * (a - b + 0.5 * slope * (a * a - b * b));
  NEAR("heat", heat[0].conducted / -through, 1.0, 1e-8);
  um_thermal_network_destroy(&network);
}

/* A blanket of 2 m^2 between boundaries: what it lets through [W/m^2]. */
static double leak(enum um_thermal_mli_law which, struct um_thermal_mli_slope slope, double hot,
                   double cold)
{
  const double area = 2.0, black = 4.0 * UM_STEFAN_BOLTZMANN * 2.7e7;
  double radiator = slope.effective_emittance * area, c = slope.conducted;
  struct um_thermal_link_law law = {.power = 4.0, .factor = {c, 1.0 - c}, .exponent = {-2, 0.667}};
  struct um_thermal_network *network = help_network();
  uint32_t a = help_boundary(network, hot), b = help_boundary(network, cold), index;
  if (which == UM_MLI_LOCKHEED) {
    law = (struct um_thermal_link_law){.power = 4.67, .factor = {1.0}};
    radiator *= (1.0 - c) * 4.0 / 4.67;
    const struct um_thermal_link_law spacers = {.power = 4.0, .factor = {1.0}, .exponent = {1.0}};
    OK(um_thermal_network_link_law_add(network, &spacers, &index));
    OK(um_thermal_network_conductor_add(network, a, b,
                                        c * slope.effective_emittance * area * black));
    um_thermal_network_conductor_follow(network, index);
  }
  OK(um_thermal_network_link_law_add(network, &law, &index));
  OK(um_thermal_network_radiator_add(network, a, b, radiator));
  um_thermal_network_radiator_follow(network, index);
  help_node(network, 1.0, 300.0); /* something must store */
  const double temperature[3] = {hot, cold, 300.0};
  struct um_thermal_heat heat[3];
  struct um_thermal_solve_options options = help_options(1e-9, 1e-8, 0.0);
  OK(um_thermal_heat_of_nodes(help_context, network, NULL, &options, 0.0, temperature, heat));
  um_thermal_network_destroy(&network);
  return (heat[1].conducted + heat[1].exchanged) / area;
}

/* The formulas as their papers print them. e* of Doenecke: 0.0124 at 290 K, 0.0144 at 250 K, 0.0191
 * at 200 K to three digits (docs/physics/mli.md). Lockheed's q of 40 layers at 20/cm between 300
 * and 77 K: 0.351 W/m^2, computed with the coefficients by hand. */
static void blankets_leak(void **state)
{
  (void)state;
  static const double printed[3][2] = {{290.0, 0.0124}, {250.0, 0.0144}, {200.0, 0.0191}};
  for (int k = 0; k < 3; k++) {
    double t = printed[k][0], d = 1e-3;
    double q = leak(UM_MLI_DOENECKE, um_thermal_mli_doenecke(1.0), t + d, t - d);
    NEAR("e*", q / (UM_STEFAN_BOLTZMANN * (pow(t + d, 4) - pow(t - d, 4))), printed[k][1], 5e-5);
  }
  for (double cold = 77.0; cold < 300.0; cold += 40.0) {
    const double hot = 300.0, mean = 0.5 * (hot + cold);
    double e = 0.000136 / (4.0 * UM_STEFAN_BOLTZMANN * mean * mean) + 0.000121 * pow(mean, 0.667);
    double q = 1.7 * e * UM_STEFAN_BOLTZMANN * (pow(hot, 4) - pow(cold, 4));
    NEAR("Doenecke", leak(UM_MLI_DOENECKE, um_thermal_mli_doenecke(1.7), hot, cold) / q, 1.0,
         1e-12);
    q = 8.95e-8 * pow(20.0, 2.56) * mean / 41.0 * (hot - cold) +
        5.39e-10 * 0.031 / 40.0 * (pow(hot, 4.67) - pow(cold, 4.67));
    NEAR("Lockheed",
         leak(UM_MLI_LOCKHEED, um_thermal_mli_lockheed(40.0, 2000.0, 0.031), hot, cold) / q, 1.0,
         1e-12);
    if (cold == 77.0) NEAR("Lockheed at 77 K", q, 0.351, 1e-3);
  }
}

/* Heat in less heat out is what is stored, to 1e-6 over ten orbits with default tolerances, with
 * skins that store heat and with massless ones. */
static void energy_closes(void **state)
{
  (void)state;
  enum { ORBITS = 10, ROWS = 241 };
  for (int c = 0; c < 2; c++) {
    uint32_t interior;
    struct um_thermal_network *network = box_network(2, c == 0 ? 77.39 : 0.0, &interior);
    law_give(network);
    struct um_irradiation_loads *loads =
        box_loads(2, ROWS * ORBITS, 6000.0 * ORBITS, 28.0 * ORBITS);
    struct um_thermal_solve_options options;
    um_thermal_solve_defaults(&options);
    struct um_thermal_history *history = NULL;
    double end = 6000.0 * ORBITS;
    OK(um_thermal_solve(help_context, network, loads, &options, NULL, 0.0, &end, 1, &history));
    print_message("audit %.1e in %zu steps, %zu evaluations, %zu Jacobians\n", history->audit_error,
                  history->steps, history->rhs_evaluations, history->jacobians);
    if (!(history->audit_error <= 1e-6)) fail_msg("audit %g", history->audit_error);
    um_thermal_history_destroy(help_context, &history);
    um_irradiation_loads_destroy(help_context, &loads);
    um_thermal_network_destroy(&network);
  }
}

/* The periodic state repeats: integrated for one more period from it, no node ends further away
 * than the tolerance and twice the 5 mK that an orbit's integration leaves. */
static void orbits_repeat(void **state)
{
  (void)state;
  uint32_t interior;
  struct um_thermal_network *network = box_network(2, 77.39, &interior);
  law_give(network);
  struct um_irradiation_loads *loads = box_loads(2, 241, 6000.0, 3.0);
  struct um_thermal_solve_options options = help_options(1e-9, 1e-7, 3.0);
  struct um_thermal_periodic report;
  struct um_thermal_history *history = NULL;
  double *t = calloc(network->nnode, sizeof *t), end = 6000.0;
  assert_non_null(t);
  OK(um_thermal_solve_periodic_report(help_context, network, loads, &options, NULL, 0.0, end, 1e-3,
                                      t, NULL, NULL, &report));
  print_message("periodic after %zu orbits\n", report.orbits);
  assert_true(report.orbits <= 12); /* each correction leaves a tenth */
  OK(um_thermal_solve(help_context, network, loads, &options, t, 0.0, &end, 1, &history));
  for (size_t i = 0; i < network->nnode; i++)
    NEAR("one orbit later", history->temperature[i], t[i], 2e-3);
  um_thermal_history_destroy(help_context, &history);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
  free(t);
}

struct answers {
  double *response; /* [nnode] of the last time */
  size_t nnode;
};
static enum um_status take(void *user, size_t k, const double *temperature, const double *response)
{
  struct answers *answers = user;
  (void)k, (void)temperature;
  memcpy(answers->response, response, answers->nnode * sizeof *response);
  return UM_OK;
}

/* The response to a watt on one wall, on for 1000 s, against the difference of tight runs with +-1
 * W: third order in the watt, 1e-5. */
static void responses_follow(void **state)
{
  (void)state;
  const double one = 1.0, times[2] = {0.0, 1500.0};
  for (int c = 0; c < 2; c++) {
    uint32_t interior, wall = 3;
    struct um_thermal_network *network = box_network(2, c == 0 ? 77.39 : 0.0, &interior);
    law_give(network);
    struct um_irradiation_loads *loads = box_loads(2, 241, 6000.0, 3.0);
    struct um_thermal_solve_options options = help_options(1e-10, 1e-8, 3.0);
    struct answers answers = {calloc(network->nnode, sizeof(double)), network->nnode};
    assert_non_null(answers.response);
    const struct um_thermal_pulse pulse = {&wall, &one, 1, 0.0, 1000.0};
    const struct um_thermal_forcings forcings = {.pulse = &pulse, .npulse = 1};
    OK(um_thermal_sensitivity(help_context, network, loads, &options, NULL, 0.0, times, 2,
                              &forcings, NULL, take, &answers));
    struct um_thermal_history *history[2] = {NULL, NULL};
    for (int side = 0; side < 2; side++) {
      struct um_thermal_network *moved = box_network(2, c == 0 ? 77.39 : 0.0, &interior);
      law_give(moved);
      const double t[2] = {0.0, 1000.0},
                   power[2] = {side == 0 ? 1.0 : -1.0, side == 0 ? 1.0 : -1.0};
      const struct um_thermal_source heat = {&wall, &one, 1, t, power, 2, false};
      OK(um_thermal_network_source_add(moved, &heat));
      OK(um_thermal_solve(help_context, moved, loads, &options, NULL, 0.0, times, 2,
                          &history[side]));
      um_thermal_network_destroy(&moved);
    }
    double largest = 0.0, worst = 0.0;
    for (size_t i = 0; i < network->nnode; i++) {
      size_t at = network->nnode + i;
      double exact = 0.5 * (history[0]->temperature[at] - history[1]->temperature[at]);
      largest = fmax(largest, fabs(exact));
      worst = fmax(worst, fabs(answers.response[i] - exact));
    }
    print_message("response at most %.3f K/W, off by %.1e of it\n", largest, worst / largest);
    NEAR("response", worst / largest, 0.0, 2e-3);
    for (int side = 0; side < 2; side++) um_thermal_history_destroy(help_context, &history[side]);
    free(answers.response);
    um_irradiation_loads_destroy(help_context, &loads);
    um_thermal_network_destroy(&network);
  }
}

/* Laws count where networks are compared. */
static void laws_are_compared(void **state)
{
  (void)state;
  uint32_t interior;
  struct um_thermal_network *n[4];
  for (int k = 0; k < 4; k++) {
    n[k] = box_network(1, 77.39, &interior);
    if (k < 3) law_give(n[k]);
  }
  assert_true(um_thermal_network_equal(n[0], n[1]));
  assert_false(um_thermal_network_equal(n[0], n[3]));
  n[1]->capacity_law[0]->at[100] *= 1.001;
  n[2]->radiator[0].law = UM_THERMAL_NO_LAW;
  assert_false(um_thermal_network_equal(n[0], n[1]));
  assert_false(um_thermal_network_equal(n[0], n[2]));
  for (int k = 0; k < 4; k++) um_thermal_network_destroy(&n[k]);
}

static void refused(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  struct um_thermal_ratio ratio = law_line(1e-3);
  struct um_thermal_link_law law = {.power = 0.5, .factor = {1.0}};
  uint32_t index, fixed = help_boundary(network, 300.0);
  assert_int_equal(um_thermal_network_link_law_add(network, &law, &index), UM_ERR_INPUT);
  law = (struct um_thermal_link_law){.power = 4.0, .factor = {NAN}};
  assert_int_equal(um_thermal_network_link_law_add(network, &law, &index), UM_ERR_INPUT);
  OK(um_thermal_network_capacity_law_add(network, &ratio, &index));
  assert_int_equal(um_thermal_network_capacity_follow(network, fixed, 1.0, index), UM_ERR_INPUT);
  um_core_message_clear(help_context); /* the first message is the one that stays */
  ratio.at[7] = 0.0;
  assert_int_equal(um_thermal_network_capacity_law_add(network, &ratio, &index), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(help_context), "ratio 0 at 14 K"));
  um_core_message_clear(help_context);
  um_thermal_network_destroy(&network);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(bodies_cool),       cmocka_unit_test(slab_conducts),
      cmocka_unit_test(blankets_leak),     cmocka_unit_test(energy_closes),
      cmocka_unit_test(orbits_repeat),     cmocka_unit_test(responses_follow),
      cmocka_unit_test(laws_are_compared), cmocka_unit_test(refused),
  };
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
