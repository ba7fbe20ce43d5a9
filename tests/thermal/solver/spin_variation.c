/* A wall that a fast turn heats, integrated over every turn, against means and variation.
 *
 *   q(t) = max(cos(2 pi t / P), 0) --> o C --K-- 250 K       a surface of 1 m2, absorptance 1
 *
 * Linear: T_slow of the mean q / pi plus the variation is off by a share K P / (2 pi C) of it.
 */
#include "thermal/solver/spin_variation.h"
#include "tests/thermal/network_help.h"

#define PERIOD 5.0
#define SUN    1361.0
#define TURNS  40
#define ROWS   (TURNS * 180 + 1)
/* [s] by which edges of the half wave stand off the rows: (1 - 1/sqrt(3)) / 2 of an interval, where
 * what is linear between rows has the right mean over a kink */
#define OFF (0.21132486540518713 * PERIOD / 180.0)

static const double capacity = 4860.0, held = 20.0; /* [J/K], [W/K]: 243 s */

static struct um_thermal_network *wall(void)
{
  struct um_thermal_network *network = help_network();
  uint32_t node = help_node(network, capacity, 260.0);
  OK(um_thermal_network_conductor_add(network, node, help_boundary(network, 250.0), held));
  help_surface(network, 0, node, 1.0, 1.0, 0.0);
  return network;
}

static struct um_irradiation_loads *table(size_t n)
{
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_create(help_context, n, 1, 0, &loads));
  for (size_t k = 0; k < n; k++) {
    loads->t[k] = n > 1 ? PERIOD * TURNS * (double)k / (double)(n - 1) : 0.0;
    loads->irradiance[k] = SUN;
    loads->sunlit[k] = 1.0;
  }
  return loads;
}

/* P / (2 pi) (S(x) - x / pi), see tests/thermal/loads/spin_averaged.c. */
static double variation_at(double t)
{
  double x = 2.0 * UM_PI * (t / PERIOD - floor(t / PERIOD + 0.5));
  double sine = fabs(x) < 0.5 * UM_PI ? sin(x) : x > 0.0 ? 1.0 : -1.0;
  return PERIOD / (2.0 * UM_PI) * (sine - x / UM_PI);
}

static void test_wall(void **state)
{
  (void)state;
  struct um_thermal_network *network = wall();
  struct um_thermal_solve_options options = help_options(1e-9, 1e-7, 0.0);
  struct um_irradiation_loads *resolved = table(ROWS), *mean = table(2), *variation = table(1);
  for (size_t k = 0; k < ROWS; k++)
    resolved->sun[k] = (float)fmax(cos(2.0 * UM_PI * (resolved->t[k] + OFF) / PERIOD), 0.0);
  mean->sun[0] = mean->sun[1] = (float)(1.0 / UM_PI);
  struct um_thermal_history *exact = NULL, *slow = NULL;
  OK(um_thermal_solve(help_context, network, resolved, &options, NULL, 0.0, resolved->t, ROWS,
                      &exact));
  double start[2] = {260.0 - SUN / capacity * variation_at(OFF), 250.0};
  OK(um_thermal_solve(help_context, network, mean, &options, start, 0.0, resolved->t, ROWS, &slow));
  struct um_thermal_spin_variation bound;
  OK(um_thermal_spin_variation_bound(help_context, network, PERIOD, SUN, 0.0, 0.0, &bound));
  /* a = 0.55 q P / (2 pi C) = 0.12257 K; K P / (2 pi C) = 0.003275 of it, 3/4 a^2 / 300 K beside */
  NEAR("amplitude", bound.amplitude, 0.122567, 1e-6);
  NEAR("error", bound.error, 0.122567 * 2.0 * 0.00327481 + 0.75 * 0.122567 * 0.122567 / 300.0,
       1e-8);
  double worst = 0.0, alone = 0.0;
  for (size_t k = 0; k < ROWS; k++) {
    double temperature[2] = {slow->temperature[2 * k], 250.0};
    variation->sun[0] = (float)variation_at(resolved->t[k] + OFF);
    alone = fmax(alone, fabs(temperature[0] - exact->temperature[2 * k]));
    OK(um_thermal_spin_variation_add(help_context, network, variation, &options, 0, 1.0,
                                     temperature));
    worst = fmax(worst, fabs(temperature[0] - exact->temperature[2 * k]));
    NEAR("what is held stays", temperature[1], 250.0, 0.0);
  }
  print_message("means off by %.4f K, with the variation by %.6f K, bound %.6f K\n", alone, worst,
                bound.error);
  NEAR("variation", alone, bound.amplitude, 0.01 * bound.amplitude);
  assert_true(worst <= bound.error);
  um_thermal_history_destroy(help_context, &exact);
  um_thermal_history_destroy(help_context, &slow);
  um_irradiation_loads_destroy(help_context, &resolved);
  um_irradiation_loads_destroy(help_context, &mean);
  um_irradiation_loads_destroy(help_context, &variation);
  um_thermal_network_destroy(&network);
}

/* What has no capacity follows at once; what has no surface does not matter. */
static void test_without_capacity(void **state)
{
  (void)state;
  struct um_thermal_spin_variation bound;
  struct um_thermal_network *network = wall();
  uint32_t foil = help_arithmetic(network, 250.0);
  OK(um_thermal_network_conductor_add(network, foil, 0, 1.0));
  OK(um_thermal_spin_variation_bound(help_context, network, PERIOD, SUN, 0.0, 0.0, &bound));
  assert_true(bound.error < 1.0);
  help_surface(network, 1, foil, 1.0, 0.5, 0.5);
  OK(um_thermal_spin_variation_bound(help_context, network, PERIOD, SUN, 0.0, 0.0, &bound));
  assert_true(isinf(bound.error) && bound.node == foil);
  um_thermal_network_destroy(&network);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_wall),
                                     cmocka_unit_test(test_without_capacity)};
  return cmocka_run_group_tests_name("thermal_spin_variation", tests, help_setup, help_teardown);
}
