/* The analytic Jacobian of dT/dt against central differences, with and without eliminated nodes:
 * entries on the pattern agree, and nothing is off it.
 *
 * Differences of +-0.05 K: T^4 leaves a relative error of (h/T)^2 = 4e-8 of the radiative slopes,
 * and rounding 1e-13 K/s / 0.1 K; eliminated nodes are solved to 1e-11. Asked: 1e-6 of the largest
 * entry of the column. Ratios by temperature are straight lines: no kinks within a difference. */
#include <stdlib.h>

#include "tests/thermal/law_help.h"
#include "thermal/solver/solve.h"
#include "thermal/solver/system_group.h"

/* A law for every surface of the box: its emittance rises with temperature. */
static struct um_thermal_surface_law rising;

static void give_laws(struct um_thermal_network *network)
{
  for (size_t i = 0; i < UM_THERMAL_LAW_TEMPERATURES; i++)
    rising.emittance[i] = 0.3 + 3e-3 * (double)i; /* a line: no kink within a difference */
  rising.albedo = rising.planet = 1.0;
  for (size_t i = 0; i < UM_THERMAL_LAW_ANGLES; i++) rising.absorptance[i] = 1.0;
  for (size_t s = 0; s < network->nsurface; s++) network->surface[s].law = &rising;
}

static void compare(double skin_capacity, bool laws)
{
  uint32_t interior;
  struct um_thermal_network *network = box_network(2, skin_capacity, &interior);
  /* chains of massless nodes that several unknowns touch, radiating between them */
  uint32_t hub = help_arithmetic(network, 250.0), far = help_arithmetic(network, 250.0);
  OK(um_thermal_network_conductor_add(network, hub, 1, 3.0));
  OK(um_thermal_network_conductor_add(network, hub, 5, 2.0));
  OK(um_thermal_network_radiator_add(network, hub, far, 0.7));
  OK(um_thermal_network_radiator_add(network, far, 9, 0.4));
  OK(um_thermal_network_radiator_add(network, far, UM_THERMAL_SPACE, 0.3));
  OK(um_thermal_network_radiator_add(network, far, help_boundary(network, 290.0), 0.2));
  if (laws) {
    give_laws(network);
    law_give(network);
  }
  struct um_irradiation_loads *loads = box_loads(2, 61, 6000.0, 3.0);
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  struct um_thermal_system *system = NULL;
  OK(um_thermal_system_create(help_context, network, loads, &options, NULL, 0.0, false, &system));
  size_t n = system->nunknown;
  double *y = calloc(4 * n + system->nnonzero, sizeof *y);
  assert_non_null(y);
  double *up = y + n, *down = y + 2 * n, *column = y + 3 * n, *value = y + 4 * n;
  for (size_t k = 0; k < n; k++) y[k] = 240.0 + 60.0 * sin(1.7 * (double)k);
  const double t = 1234.5, h = 0.05;
  assert_true(um_thermal_system_state_set(system, t, y));
  assert_true(um_thermal_system_jacobian(system, value));
  double worst = 0.0;
  for (size_t j = 0; j < n; j++) {
    double kept = y[j], largest = 0.0;
    y[j] = kept + h;
    assert_true(um_thermal_system_state_set(system, t, y));
    um_thermal_system_rate(system, up);
    y[j] = kept - h;
    assert_true(um_thermal_system_state_set(system, t, y));
    um_thermal_system_rate(system, down);
    y[j] = kept;
    memset(column, 0, n * sizeof *column);
    for (int64_t e = system->column[j]; e < system->column[j + 1]; e++)
      column[system->row[e]] = value[e];
    for (size_t i = 0; i < n; i++) largest = fmax(largest, fabs(column[i]));
    for (size_t i = 0; i < n; i++)
      worst = fmax(worst, fabs(column[i] - (up[i] - down[i]) / (2.0 * h)) / largest);
  }
  print_message("skin %.0f J/m2/K: %zu unknowns, %zu clusters, worst %.1e\n", skin_capacity, n,
                system->ncluster, worst);
  NEAR("Jacobian", worst, 0.0, 1e-6);
  free(y);
  um_thermal_system_destroy(&system);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}

static void test_differences(void **state)
{
  (void)state;
  for (int laws = 0; laws < 2; laws++) {
    compare(77.39, laws == 1);
    compare(0.0, laws == 1);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_differences)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
