/* Steps over tabulated loads: a table finer than its loads does not hold the integration up, and a
 * flash that a single row of it knows is not passed over.
 *
 * A plate of 5e5 J/K, 1 m^2, absorptance 1, emittance 0, a day of rows 10 s apart. Slow: the Sun's
 * share goes as (1 - cos(2 pi t / day)) / 2, the heat is exactly S A t / 2 at the end of a day.
 * Flash: no Sun but in row 4321, a triangle of 10 s S A. */
#include "tests/thermal/network_help.h"

#define DAY      86400.0
#define ROWS     8641
#define CAPACITY 5e5
#define SUN      1361.0

static struct um_irradiation_loads *table(bool flash)
{
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_create(help_context, ROWS, 1, 0, &loads));
  for (size_t k = 0; k < ROWS; k++) {
    loads->t[k] = 10.0 * (double)k;
    loads->sunlit[k] = 1.0;
    loads->irradiance[k] = SUN;
    loads->sun[k] = flash ? (k == 4321 ? 1.0F : 0.0F)
                          : (float)(0.5 - 0.5 * cos(2.0 * UM_PI * loads->t[k] / DAY));
  }
  return loads;
}

static struct um_thermal_history *day(bool flash)
{
  struct um_thermal_network *network = help_network();
  uint32_t plate = help_node(network, CAPACITY, 200.0);
  help_surface(network, 0, plate, 1.0, 1.0, 0.0);
  struct um_irradiation_loads *loads = table(flash);
  struct um_thermal_solve_options options = help_options(1e-8, 1e-6, 0.0);
  struct um_thermal_history *history = NULL;
  const double end = DAY;
  OK(um_thermal_solve(help_context, network, loads, &options, NULL, 0.0, &end, 1, &history));
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
  return history;
}

/* 1e-4 K: thirty times what the error test allows a step. The steps: a tenth of what two rows a
 * step would be. */
static void test_slow(void **state)
{
  (void)state;
  struct um_thermal_history *history = day(false);
  print_message("%zu steps over %d rows\n", history->steps, ROWS);
  NEAR("a slow day", history->temperature[0], 200.0 + 0.5 * SUN * DAY / CAPACITY, 1e-4);
  assert_true(history->steps < ROWS / 20);
  um_thermal_history_destroy(help_context, &history);
}

static void test_flash(void **state)
{
  (void)state;
  struct um_thermal_history *history = day(true);
  print_message("%zu steps over %d rows\n", history->steps, ROWS);
  NEAR("a flash", history->temperature[0], 200.0 + 10.0 * SUN / CAPACITY, 1e-5);
  um_thermal_history_destroy(help_context, &history);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_slow), cmocka_unit_test(test_flash)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
