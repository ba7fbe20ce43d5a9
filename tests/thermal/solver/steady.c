/* Steady states against closed balances. */
#include "tests/thermal/network_help.h"

static void steady(const struct um_thermal_network *network,
                   const struct um_irradiation_loads *loads, double space, double *temperature)
{
  struct um_thermal_solve_options options = help_options(1e-6, 1e-4, space);
  OK(um_thermal_solve_steady(help_context, network, loads, 0, &options, NULL, temperature));
}

/* One time, loads as given on every surface. */
static struct um_irradiation_loads *constant(size_t nsurface, double sun, double planet)
{
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_create(help_context, 1, nsurface, 0, &loads));
  loads->irradiance[0] = sun;
  loads->sunlit[0] = 1.0;
  for (size_t s = 0; s < nsurface; s++) {
    loads->sun[s] = 1.0f;
    loads->planet[s] = (float)planet;
  }
  return loads;
}

/* MLI: alpha q_s + eps q_IR = eps sigma T_o^4 + e* sigma (T_o^4 - T_i^4), T_i = 293 K given; alpha
 * 0.38, eps 0.78. Skin massless, with capacity 0 as an arithmetic node, and as a diffusive one.
 * The table is printed to 1e-4. Its nadir column takes the Earth's view factor as 0.797. */
static void test_mli(void **state)
{
  (void)state;
  static const struct {
    double e, sun, sun_leak, dark, dark_leak, nadir; /* [1], [K], [W/m^2], [K], [W/m^2], [K] */
  } rows[] = {{0.005, 328.6456, 1.2179, 82.7738, 2.0762, 240.7044},
              {0.01, 328.4540, 2.4204, 98.2790, 4.1262, 241.1584},
              {0.03, 327.7079, 7.0819, 128.5366, 12.0729, 242.8947},
              {0.05, 326.9929, 11.5187, 145.1579, 19.6367, 244.5134}};
  struct um_irradiation_loads *loads[3] = {constant(1, 1361.0, 0.0), constant(1, 0.0, 0.0),
                                           constant(1, 0.0, 237.0 * 0.797)};
  for (size_t c = 0; c < 4; c++)
    for (int massless = 0; massless < 2; massless++) {
      struct um_thermal_network *network = help_network();
      uint32_t inner = help_boundary(network, 293.0);
      uint32_t skin = massless ? help_arithmetic(network, 300.0) : help_node(network, 77.39, 300.0);
      help_surface(network, 0, skin, 1.0, 0.38, 0.78);
      OK(um_thermal_network_radiator_add(network, skin, inner, rows[c].e));
      double temperature[2];
      const double expected[3] = {rows[c].sun, rows[c].dark, rows[c].nadir};
      for (int l = 0; l < 3; l++) {
        steady(network, loads[l], 0.0, temperature);
        NEAR("MLI skin", temperature[skin], expected[l], 1e-4);
        double leak = rows[c].e * UM_STEFAN_BOLTZMANN *
                      (pow(temperature[skin], 4) - pow(temperature[inner], 4));
        if (l == 0) NEAR("leak in sunlight", leak, rows[c].sun_leak, 1e-4);
        if (l == 1) NEAR("leak in the dark", -leak, rows[c].dark_leak, 1e-4);
      }
      um_thermal_network_destroy(&network);
    }
  for (int l = 0; l < 3; l++) um_irradiation_loads_destroy(help_context, &loads[l]);
}

/* Solar array facing the Sun, eps 0.85 on both sides, alpha 0.92, extraction 0.18 (of the incident
 * light), conductance U through. Printed to 1e-4 K. */
static void array(double through, double extraction, double *temperature)
{
  struct um_thermal_network *network = help_network();
  uint32_t front = help_node(network, 1.0, 300.0);
  uint32_t back = isinf(through) ? front : help_node(network, 1.0, 300.0);
  struct um_thermal_surface surface = {.node = {front, UM_THERMAL_SPACE, UM_THERMAL_SPACE},
                                       .weight = {1.0, 0.0, 0.0},
                                       .area = 1.0,
                                       .absorptance = 0.92,
                                       .emittance = 0.85,
                                       .extraction = extraction};
  OK(um_thermal_network_surface_attach(network, 0, &surface));
  OK(um_thermal_network_radiator_add(network, back, UM_THERMAL_SPACE, 0.85));
  if (back != front) OK(um_thermal_network_conductor_add(network, front, back, through));
  struct um_irradiation_loads *loads = constant(1, 1361.0, 0.0);
  steady(network, loads, 0.0, temperature);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}
static void test_solar_array(void **state)
{
  (void)state;
  double t[2];
  array(INFINITY, 0.18, t);
  NEAR("isothermal array", t[0], 319.7108, 1e-4);
  array(INFINITY, 0.0, t);
  NEAR("dead array", t[0], 337.5952, 1e-4);
  array(100.0, 0.18, t);
  NEAR("front, U 100", t[0], 322.1238, 1e-4);
  NEAR("back, U 100", t[1], 317.2419, 1e-4);
  array(30.0, 0.18, t);
  NEAR("front, U 30", t[0], 327.0368, 1e-4);
  NEAR("back, U 30", t[1], 311.8434, 1e-4);
}

/* Infinite plates 400 K and 300 K, eps 0.8 and 0.3, with 0, 1 and 10 floating shields of eps 0.05:
 * R = 1/(1/eps_a + 1/eps_b - 1) in series. Net flux printed to 1e-5 W/m^2 (sigma CODATA). */
static void test_shields(void **state)
{
  (void)state;
  const int shields[3] = {0, 1, 10};
  const double expected[3] = {276.92526, 23.30291, 2.521234};
  for (int c = 0; c < 3; c++) {
    struct um_thermal_network *network = help_network();
    uint32_t before = help_boundary(network, 400.0);
    double emittance = 0.8;
    for (int k = 0; k < shields[c]; k++) {
      uint32_t shield = help_arithmetic(network, 350.0);
      OK(um_thermal_network_radiator_add(network, before, shield,
                                         1.0 / (1.0 / emittance + 1.0 / 0.05 - 1.0)));
      before = shield;
      emittance = 0.05;
    }
    uint32_t sink = help_node(network, 1.0, 300.0), cold = help_boundary(network, 300.0);
    double last = 1.0 / (1.0 / emittance + 1.0 / 0.3 - 1.0);
    OK(um_thermal_network_radiator_add(network, before, cold, last));
    OK(um_thermal_network_conductor_add(network, sink, cold, 1.0)); /* something must store heat */
    double t[16];
    steady(network, NULL, 0.0, t);
    double flux = last * UM_STEFAN_BOLTZMANN * (pow(t[before], 4) - pow(300.0, 4));
    NEAR("flux between plates", flux, expected[c], 1e-5);
    um_thermal_network_destroy(&network);
  }
}

/* 6.5 kW rejected by radiators of eps 0.8: T = (P / (eps sigma A))^(1/4). Also a cold start and
 * equilibrium with space. */
static void test_radiator(void **state)
{
  (void)state;
  const double area[3] = {50.0, 100.0, 150.0}, expected[3] = {231.37, 194.56, 175.80};
  for (int c = 0; c < 3; c++) {
    struct um_thermal_network *network = help_network();
    uint32_t node = help_node(network, 1e4, c == 0 ? 0.0 : 300.0);
    um_thermal_network_power_set(network, node, 6500.0);
    OK(um_thermal_network_radiator_add(network, node, UM_THERMAL_SPACE, 0.8 * area[c]));
    double t;
    steady(network, NULL, 0.0, &t);
    NEAR("radiator", t, expected[c], 5.1e-3);
    um_thermal_network_power_set(network, node, 0.0);
    steady(network, NULL, 2.7, &t);
    NEAR("in space", t, 2.7, 1e-3);
    um_thermal_network_destroy(&network);
  }
}

static void test_refused(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t index;
  OK(um_thermal_network_node_add(network, "lonely", UM_NODE_DIFFUSIVE, 1.0, 300.0, 1.0, &index));
  struct um_thermal_solve_options options = help_options(1e-6, 1e-4, 0.0);
  double t;
  assert_int_equal(um_thermal_solve_steady(help_context, network, NULL, 0, &options, NULL, &t),
                   UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(help_context), "node 'lonely'"));
  um_core_message_clear(help_context);
  um_thermal_network_destroy(&network);
}

/* Ten watts taken from a plate that no more than its sky reaches: a steady state and a run say
 * which node, of which part, when and why. */
static void test_below_zero(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  OK(um_thermal_network_section_begin(network, "radiator"));
  uint32_t node = help_node(network, 50.0, 200.0);
  um_thermal_network_power_set(network, node, -10.0);
  OK(um_thermal_network_radiator_add(network, node, UM_THERMAL_SPACE, 0.01));
  struct um_thermal_solve_options options = help_options(1e-6, 1e-4, 100.0);
  struct um_thermal_history *history = NULL;
  double temperature;
  const double end = 5000.0;
  static const char *const words[] = {"node 0 of part 'radiator'", "power -10 W",
                                      "s after the start"};
  assert_int_equal(
      um_thermal_solve_steady(help_context, network, NULL, 0, &options, NULL, &temperature),
      UM_ERR_NUMERIC);
  assert_non_null(strstr(um_core_message(help_context), words[0]));
  um_core_message_clear(help_context);
  assert_int_equal(
      um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, &end, 1, &history),
      UM_ERR_NUMERIC);
  for (size_t k = 0; k < 3; k++)
    if (strstr(um_core_message(help_context), words[k]) == NULL)
      fail_msg("'%s' lacks '%s'", um_core_message(help_context), words[k]);
  assert_null(history);
  um_core_message_clear(help_context);
  um_thermal_network_destroy(&network);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_mli),     cmocka_unit_test(test_solar_array),
      cmocka_unit_test(test_shields), cmocka_unit_test(test_radiator),
      cmocka_unit_test(test_refused), cmocka_unit_test(test_below_zero)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
