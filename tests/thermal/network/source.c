/* Heat made inside by a table: single nodes in closed form, sums and jumps of energy.
 *
 *   boundary T_b --- G --- node C, heated by P(t)          tau = C / G
 *
 *   C dT/dt = P(t) + G (T_b - T)
 */
#include "tests/thermal/network_help.h"

#define C     2000.0 /* [J/K] */
#define G     4.0    /* [W/K] */
#define T_B   250.0  /* [K] */
#define TAU   (C / G)
#define START 6.0e8 /* [s] as late as t_tai is: the table keeps its digits */

/* Integration to 1e-10 of T, and t_tai as a double is good to 1.2e-7 s: 1e-8 K of 1 K in 500 s. */
#define EXACT 2e-7

static struct um_thermal_network *node_on_boundary(uint32_t *node)
{
  struct um_thermal_network *network = help_network();
  uint32_t boundary = help_boundary(network, T_B);
  *node = help_node(network, C, T_B);
  OK(um_thermal_network_conductor_add(network, boundary, *node, G));
  return network;
}

static void source_add(struct um_thermal_network *network, uint32_t node, const double *t,
                       const double *power, size_t nrow, bool stepwise)
{
  double weight = 1.0;
  const struct um_thermal_source source = {&node, &weight, 1, t, power, nrow, stepwise};
  OK(um_thermal_network_source_add(network, &source));
}

static struct um_thermal_history *run(const struct um_thermal_network *network, const double *times,
                                      size_t ntime)
{
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, NULL, &options, NULL, START, times, ntime, &history));
  print_message("audit %.1e, %zu steps\n", history->audit_error, history->steps);
  if (!(history->audit_error <= 1e-6)) fail_msg("audit %g", history->audit_error);
  return history;
}

/* 40 W from 100 s to 400 s, 10 W to 900 s; the last row only ends it. */
static void test_steps(void **state)
{
  (void)state;
  uint32_t node;
  struct um_thermal_network *network = node_on_boundary(&node);
  const double t[] = {START + 100, START + 400, START + 900}, power[] = {40.0, 10.0, 77.0};
  source_add(network, node, t, power, 3, true);
  const double at[] = {START + 100, START + 250, START + 400, START + 900, START + 1500};
  struct um_thermal_history *history = run(network, at, 5);
  double rise[5] = {0.0, 40.0 / G * -expm1(-150.0 / TAU), 40.0 / G * -expm1(-300.0 / TAU)};
  rise[3] = 10.0 / G + (rise[2] - 10.0 / G) * exp(-500.0 / TAU);
  rise[4] = rise[3] * exp(-600.0 / TAU);
  for (size_t k = 0; k < 5; k++)
    NEAR("stepwise power", history->temperature[2 * k + node], T_B + rise[k], EXACT);
  NEAR("energy of the steps", history->audit.internal, 40.0 * 300 + 10.0 * 500, 1e-6 * 17000);
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
}

/* A ramp p = q t from 0: T - T_b = q/G (t - tau (1 - exp(-t/tau))). It ends at 300 s in a jump to
 * 5 W, held to 600 s. The same with the ramp cut into a hundred rows. */
static void test_ramp(void **state)
{
  (void)state;
  for (size_t cut = 1; cut <= 100; cut *= 100) {
    uint32_t node;
    struct um_thermal_network *network = node_on_boundary(&node);
    double t[103], power[103];
    const double slope = 0.1;
    for (size_t k = 0; k <= cut; k++) {
      t[k] = START + 300.0 * (double)k / (double)cut;
      power[k] = slope * (t[k] - START);
    }
    t[cut + 1] = START + 300;
    t[cut + 2] = START + 600;
    power[cut + 1] = power[cut + 2] = 5.0;
    source_add(network, node, t, power, cut + 3, false);
    const double at[] = {START + 123, START + 300, START + 600, START + 1000};
    struct um_thermal_history *history = run(network, at, 4);
    double rise[4];
    for (size_t k = 0; k < 2; k++)
      rise[k] = slope / G * (at[k] - START + TAU * expm1(-(at[k] - START) / TAU));
    rise[2] = 5.0 / G + (rise[1] - 5.0 / G) * exp(-300.0 / TAU);
    rise[3] = rise[2] * exp(-400.0 / TAU);
    for (size_t k = 0; k < 4; k++)
      NEAR("linear power", history->temperature[2 * k + node], T_B + rise[k], EXACT);
    NEAR("energy of ramp and plateau", history->audit.internal, 4500.0 + 1500.0, 6e-3);
    um_thermal_history_destroy(help_context, &history);
    um_thermal_network_destroy(&network);
  }
}

/* A flash of 1 s that a step of hundreds of seconds could pass over: 500 W, 0.25 K in all. */
static void test_flash(void **state)
{
  (void)state;
  uint32_t node;
  struct um_thermal_network *network = node_on_boundary(&node);
  const double t[] = {START, START + 3000, START + 3000.5, START + 3001, START + 9000};
  const double power[] = {0.0, 0.0, 1000.0, 0.0, 0.0};
  source_add(network, node, t, power, 5, false);
  const double at = START + 3001;
  struct um_thermal_history *history = run(network, &at, 1);
  /* a triangle of 1 s against tau of 500 s: E/C (1 - 0.5/tau) to second order, 4e-7 of 0.25 K */
  NEAR("flash", history->temperature[node], T_B + 500.0 / C * (1.0 - 0.5 / TAU), 1e-6);
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
}

/* Weights share it out; an arithmetic node hands all of it on; heat at an instant says it. */
static void test_spread(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t node[3] = {help_node(network, C, 300.0), help_node(network, C, 300.0),
                      help_arithmetic(network, 300.0)};
  OK(um_thermal_network_conductor_add(network, node[1], node[2], G));
  const double weight[3] = {0.5, 0.2, 0.3}, t[] = {START, START + 100}, power[] = {60.0, 60.0};
  const struct um_thermal_source source = {node, weight, 3, t, power, 2, true};
  OK(um_thermal_network_source_add(network, &source));
  const double at[] = {START + 50, START + 200};
  struct um_thermal_history *history = run(network, at, 2);
  const double *middle = history->temperature, *end = history->temperature + 3;
  NEAR("half of it", end[0], 300.0 + 3000.0 / C, 1e-7);
  NEAR("the other half, through the massless node", end[1], 300.0 + 3000.0 / C, 1e-7);
  NEAR("the massless node stands above by its power", middle[2], middle[1] + 18.0 / G, 1e-7);
  NEAR("and not after", end[2], end[1], 1e-7);
  struct um_thermal_heat heat[3];
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  OK(um_thermal_heat_of_nodes(help_context, network, NULL, &options, at[0], middle, heat));
  NEAR("internal heat now", heat[0].internal, 30.0, 1e-12);
  NEAR("stored now", heat[1].stored, 30.0, 1e-5);
  OK(um_thermal_heat_of_nodes(help_context, network, NULL, &options, at[1], end, heat));
  NEAR("internal heat after", heat[0].internal, 0.0, 0.0);
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
}

/* In the orbit that repeats the table acts as it stands: mean of the rise over the boundary. */
static void test_periodic(void **state)
{
  (void)state;
  uint32_t node;
  struct um_thermal_network *network = node_on_boundary(&node);
  const double t[] = {START + 1000, START + 1300}, power[] = {80.0, 80.0};
  source_add(network, node, t, power, 2, false);
  struct um_thermal_solve_options options = help_options(1e-9, 1e-8, 0.0);
  double temperature[2], distance;
  OK(um_thermal_solve_periodic(help_context, network, NULL, &options, NULL, START, 2000.0, 1e-5,
                               temperature, &distance));
  double pulse = 80.0 / G * -expm1(-300.0 / TAU) * exp(-700.0 / TAU); /* at the orbit's end */
  NEAR("orbit with a pulse", temperature[node], T_B + pulse / -expm1(-2000.0 / TAU), 1e-5);
  um_thermal_network_destroy(&network);
}

static void refused(struct um_thermal_network *network, uint32_t node, double weight,
                    const double *t, size_t nrow, const char *words)
{
  const double power[3] = {1.0, NAN, 1.0};
  const struct um_thermal_source source = {&node, &weight, 1, t, power, nrow, false};
  assert_int_equal(um_thermal_network_source_add(network, &source), UM_ERR_INPUT);
  if (strstr(um_core_message(help_context), words) == NULL)
    fail_msg("'%s' lacks '%s'", um_core_message(help_context), words);
  um_core_message_clear(help_context);
}

static void test_refused(void **state)
{
  (void)state;
  uint32_t node;
  struct um_thermal_network *network = node_on_boundary(&node);
  const double rising[] = {0.0, 1.0, 2.0};
  refused(network, 7, 1.0, rising, 3, "node 7; accepted: one of the 2 nodes");
  refused(network, node, 0.9, rising, 3, "weights add to 0.9");
  refused(network, node, -1.0, rising, 3, "weight -1");
  refused(network, node, 1.0, rising, 1, "accepted: 2 or more");
  refused(network, node, 1.0, rising, 3, "row 1 is nan W at 1 s");
  refused(network, node, 1.0, (const double[]){1.0, 0.0}, 2, "accepted: finite");
  const double weight = 1.0, power[2] = {1.0, 1.0}, falling[2] = {1.0, 0.0};
  const struct um_thermal_source source = {&node, &weight, 1, falling, power, 2, false};
  assert_int_equal(um_thermal_network_source_add(network, &source), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(help_context), "before the row above"));
  um_thermal_network_destroy(&network);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_steps),    cmocka_unit_test(test_ramp),
      cmocka_unit_test(test_flash),    cmocka_unit_test(test_spread),
      cmocka_unit_test(test_periodic), cmocka_unit_test(test_refused),
  };
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
