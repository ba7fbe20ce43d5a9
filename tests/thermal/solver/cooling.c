/* Lumped cooling against closed forms.
 *
 *   o  C dT/dt = -eps sigma (T^4 - T_s^4)     t = -(C / eps sigma) (g(T) - g(T_0)),
 *   |  g(x) = ln((x - T_s)/(x + T_s)) / (4 T_s^3) - atan(x/T_s) / (2 T_s^3)
 * space                                       to 0 K: T = (T_0^-3 + 3 eps sigma t / C)^(-1/3)
 *
 * Expected values: these forms evaluated with sigma = 5.670374419e-8, printed to 1e-5 K (25 um:
 * half of the 50 um blanket, 38.695 J/m^2/K). */
#include "tests/thermal/network_help.h"

static const struct row {
  const char *name;
  double capacity, emittance, start, t, to_zero, to_180; /* [J/m^2/K], [1], [K], [s], [K], [K] */
} rows[] = {{"MLI outer 50 um", 77.39, 0.78, 300.0, 60.0, 192.62775, 211.67977},
            {"MLI outer 25 um", 38.695, 0.64, 300.0, 60.0, 169.36178, 197.00400},
            {"solar panel", 3240.0, 1.65, 320.0, 1800.0, 175.04255, 200.43154},
            {"aluminium 2 mm", 4860.0, 0.8, 300.0, 1800.0, 225.30077, 236.42169}};

static double cool(const struct row *row, double space,
                   const struct um_thermal_solve_options *options)
{
  struct um_thermal_network *network = help_network();
  uint32_t node = help_node(network, row->capacity, row->start);
  OK(um_thermal_network_radiator_add(network, node, UM_THERMAL_SPACE, row->emittance));
  struct um_thermal_history *history = NULL;
  struct um_thermal_solve_options used = *options;
  used.space_temperature = space;
  OK(um_thermal_solve(help_context, network, NULL, &used, NULL, 0.0, &row->t, 1, &history));
  double temperature = history->temperature[0];
  if (!(history->audit_error <= 1e-6)) fail_msg("%s: audit %g", row->name, history->audit_error);
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
  return temperature;
}

/* Tight tolerances: to the last printed digit. */
static void test_closed_forms(void **state)
{
  (void)state;
  struct um_thermal_solve_options tight = help_options(1e-10, 1e-9, 0.0);
  for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
    NEAR(rows[k].name, cool(&rows[k], 0.0, &tight), rows[k].to_zero, 1e-5);
    NEAR(rows[k].name, cool(&rows[k], 180.0, &tight), rows[k].to_180, 1e-5);
  }
}

/* Default tolerances: 5 mK is what the light curve needs (1 K is 1.9 % of 8-12 um radiance). */
static void test_defaults(void **state)
{
  (void)state;
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  double worst = 0.0;
  for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
    double a = fabs(cool(&rows[k], 0.0, &options) - rows[k].to_zero);
    double b = fabs(cool(&rows[k], 180.0, &options) - rows[k].to_180);
    worst = fmax(worst, fmax(a, b));
    NEAR(rows[k].name, a, 0.0, 5e-3);
    NEAR(rows[k].name, b, 0.0, 5e-3);
  }
  print_message("largest error with default tolerances: %.2e K\n", worst);
}

/* Newton cooling: dT/dt = -(K/C)(T - T_b), T = T_b + (T_0 - T_b) exp(-K t / C). */
static void test_newton(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t node = help_node(network, 500.0, 350.0), wall = help_boundary(network, 290.0);
  OK(um_thermal_network_conductor_add(network, node, wall, 1.0));
  OK(um_thermal_network_conductor_add(network, wall, node, 1.5)); /* parallel ones add */
  double expected = 290.0 + 60.0 * exp(-2.5 * 300.0 / 500.0);
  NEAR("Newton cooling", help_temperature_at(network, 0.0, node, 300.0), expected, 1e-6);
  um_thermal_network_destroy(&network);
}

/* A massless node half way: 1/K = 1/K_1 + 1/K_2, exactly; so is its own temperature. */
static void test_massless_between(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t node = help_node(network, 500.0, 350.0), wall = help_boundary(network, 290.0);
  uint32_t middle = help_arithmetic(network, 100.0);
  OK(um_thermal_network_conductor_add(network, node, middle, 2.0));
  OK(um_thermal_network_conductor_add(network, middle, wall, 3.0));
  double rate = 2.0 * 3.0 / 5.0 / 500.0;
  double expected = 290.0 + 60.0 * exp(-rate * 300.0);
  NEAR("through a massless node", help_temperature_at(network, 0.0, node, 300.0), expected, 1e-6);
  double between = (2.0 * expected + 3.0 * 290.0) / 5.0;
  NEAR("the massless node", help_temperature_at(network, 0.0, middle, 300.0), between, 1e-6);
  um_thermal_network_destroy(&network);
}

/* Two massless shields between a cooling body and 0 K act like one radiator of a third of R:
 * sigma R (T^4 - T_1^4) = sigma R (T_1^4 - T_2^4) = sigma R T_2^4. Closed form with R/3. */
static void test_massless_shields(void **state)
{
  (void)state;
  struct um_thermal_network *network = help_network();
  uint32_t body = help_node(network, 1000.0, 300.0);
  uint32_t first = help_arithmetic(network, 0.0), second = help_arithmetic(network, 0.0);
  OK(um_thermal_network_radiator_add(network, body, first, 0.9));
  OK(um_thermal_network_radiator_add(network, first, second, 0.9));
  OK(um_thermal_network_radiator_add(network, second, UM_THERMAL_SPACE, 0.9));
  double t = 3000.0;
  double expected =
      pow(pow(300.0, -3.0) + 3.0 * 0.3 * UM_STEFAN_BOLTZMANN * t / 1000.0, -1.0 / 3.0);
  NEAR("behind two shields", help_temperature_at(network, 0.0, body, t), expected, 1e-6);
  NEAR("outer shield", help_temperature_at(network, 0.0, second, t),
       expected * pow(1.0 / 3.0, 0.25), 1e-6);
  um_thermal_network_destroy(&network);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_closed_forms),
                                     cmocka_unit_test(test_defaults), cmocka_unit_test(test_newton),
                                     cmocka_unit_test(test_massless_between),
                                     cmocka_unit_test(test_massless_shields)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
