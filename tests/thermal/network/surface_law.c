/* Surfaces whose absorptance goes with the angle and whose emittance goes with the temperature,
 * against closed forms. */
#include <string.h>

#include "base/core/constants.h"
#include "tests/thermal/box_help.h"
#include "thermal/solver/solve.h"

static struct um_thermal_surface_law constant(void)
{
  struct um_thermal_surface_law law = {.albedo = 1.0, .planet = 1.0};
  for (size_t i = 0; i < UM_THERMAL_LAW_ANGLES; i++) law.absorptance[i] = 1.0;
  for (size_t i = 0; i < UM_THERMAL_LAW_TEMPERATURES; i++) law.emittance[i] = 1.0;
  return law;
}

/* Temperature of node i of the tables. */
static double node_temperature(size_t i)
{
  return UM_THERMAL_LAW_HOTTEST * (double)i / (UM_THERMAL_LAW_TEMPERATURES - 1);
}

#define CAPACITY  2000.0 /* [J/K] */
#define AREA      1.5    /* [m^2] */
#define EMITTANCE 0.8
#define START     400.0 /* [K] */

static struct um_thermal_network *plate(const struct um_thermal_surface_law *law,
                                        double absorptance, double extraction)
{
  struct um_thermal_network *network = NULL;
  uint32_t node;
  OK(um_thermal_network_create(help_context, &network));
  OK(um_thermal_network_node_add(network, "plate", UM_NODE_DIFFUSIVE, CAPACITY, START, 0.0, &node));
  const struct um_thermal_surface surface = {.node = {node, UM_THERMAL_SPACE, UM_THERMAL_SPACE},
                                             .weight = {1.0, 0.0, 0.0},
                                             .area = AREA,
                                             .absorptance = absorptance,
                                             .emittance = EMITTANCE,
                                             .extraction = extraction,
                                             .law = law};
  OK(um_thermal_network_surface_attach(network, 0, &surface));
  return network;
}

/* A metal below its Debye temperature, eps ~ T: C dT/dt = -k T^5 / T_0 with k = sigma A eps, so
 * T(t)^-4 = T_0^-4 + 4 k t / (C T_0). The table is exact for a line through nodes. */
static void metal_cools(void **state)
{
  (void)state;
  struct um_thermal_surface_law law = constant();
  for (size_t i = 0; i < UM_THERMAL_LAW_TEMPERATURES; i++)
    law.emittance[i] = node_temperature(i) / START;
  struct um_thermal_network *network = plate(&law, 0.0, 0.0);
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  struct um_thermal_history *history = NULL;
  const double times[] = {0.0, 500.0, 3000.0, 20000.0};
  OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, times, 4, &history));
  double k = UM_STEFAN_BOLTZMANN * AREA * EMITTANCE;
  for (size_t i = 0; i < 4; i++)
    NEAR("T", history->temperature[i],
         pow(pow(START, -4.0) + 4.0 * k * times[i] / (CAPACITY * START), -0.25), 2e-6);
  assert_true(history->temperature[3] < 250.0);
  assert_true(history->audit_error < 1e-8);
  struct um_thermal_heat heat;
  double t = history->temperature[2];
  OK(um_thermal_heat_of_nodes(help_context, network, NULL, &options, 0.0, &t, &heat));
  NEAR("radiated", heat.radiated / (-k * pow(t, 5.0) / START), 1.0, 1e-12);
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
}

#define SUN 1000.0 /* [W/m^2] */

static struct um_irradiation_loads *slanted(double cosine)
{
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_create(help_context, 1, 1, 0, &loads));
  loads->sunlit[0] = 1.0;
  loads->irradiance[0] = SUN;
  loads->sun[0] = (float)(0.5 * cosine); /* half of it in shadow: the angle is not the product */
  loads->incidence[0] = (float)cosine;
  loads->albedo[0] = 100.0f;
  loads->planet[0] = 200.0f;
  return loads;
}

/* Every load times its own ratio; the extraction goes with the absorptance. In balance
 * eps(T) sigma T^4 = (alpha - x) k(theta) S/2 cos + alpha k_a 100 + eps k_p 200 [W/m^2]. */
static void loads_follow_the_law(void **state)
{
  (void)state;
  const double absorptance = 0.9, extraction = 0.2;
  struct um_thermal_surface_law law = constant();
  for (size_t i = 0; i < UM_THERMAL_LAW_ANGLES; i++)
    law.absorptance[i] = 0.4 + 0.6 * (double)i / (UM_THERMAL_LAW_ANGLES - 1); /* in sqrt(cos) */
  law.albedo = 0.7;
  law.planet = 1.1;
  for (size_t i = 0; i < UM_THERMAL_LAW_TEMPERATURES; i++)
    law.emittance[i] = 0.5 + node_temperature(i) / 600.0;
  for (double cosine = 0.1; cosine < 1.05; cosine += 0.3) {
    struct um_thermal_network *network = plate(&law, absorptance, extraction);
    struct um_irradiation_loads *loads = slanted(cosine);
    struct um_thermal_solve_options options = help_options(1e-9, 1e-8, 0.0);
    struct um_thermal_heat heat;
    double t = START;
    double sun = (absorptance - extraction) * (0.4 + 0.6 * sqrt(cosine)) * SUN * 0.5 * cosine;
    double albedo = absorptance * 0.7 * 100.0, planet = EMITTANCE * 1.1 * 200.0;
    OK(um_thermal_heat_of_nodes(help_context, network, loads, &options, 0.0, &t, &heat));
    NEAR("solar", heat.solar / (AREA * sun), 1.0, 2e-7);
    NEAR("albedo", heat.albedo / (AREA * albedo), 1.0, 1e-12);
    NEAR("planet", heat.planet / (AREA * planet), 1.0, 1e-12);
    OK(um_thermal_solve_steady(help_context, network, loads, 0, &options, NULL, &t));
    double emitted = EMITTANCE * (0.5 + t / 600.0) * UM_STEFAN_BOLTZMANN * pow(t, 4);
    NEAR("balance", emitted / (sun + albedo + planet), 1.0, 1e-6);
    um_irradiation_loads_destroy(help_context, &loads);
    um_thermal_network_destroy(&network);
  }
}

/* A law by angle adds sum a_k E_k of both loads: alpha_start of the albedo's, eps of the Earth's.
 * It acts where loads have moments alone. */
static void earth_loads_go_by_angle(void **state)
{
  (void)state;
  struct um_thermal_surface_law law = constant();
  struct um_irradiation_loads *loads = slanted(0.5);
  struct um_thermal_solve_options options = help_options(1e-9, 1e-8, 0.0);
  struct um_thermal_heat heat;
  double t = START, albedo = 0.6 * 0.7 * 100.0, planet = EMITTANCE * 1.1 * 200.0;
  law.albedo = 0.7;
  law.planet = 1.1;
  law.by_angle = true;
  OK(um_core_allocate(help_context, UM_ANGULAR_MOMENTS, sizeof(float), &loads->albedo_moments));
  OK(um_core_allocate(help_context, UM_ANGULAR_MOMENTS, sizeof(float), &loads->planet_moments));
  for (int k = 0; k < UM_ANGULAR_MOMENTS; k++) {
    law.albedo_angle[k] = 0.01 * (k + 1);
    law.planet_angle[k] = -0.02 * (k + 2);
    loads->albedo_moments[k] = (float)(3 * k - 5);
    loads->planet_moments[k] = (float)(4 - k);
    albedo += 0.6 * 0.01 * (k + 1) * (3 * k - 5);
    planet -= EMITTANCE * 0.02 * (k + 2) * (4 - k);
  }
  struct um_thermal_network *network = plate(&law, 0.6, 0.0);
  OK(um_thermal_heat_of_nodes(help_context, network, loads, &options, 0.0, &t, &heat));
  NEAR("albedo", heat.albedo / (AREA * albedo), 1.0, 1e-12);
  NEAR("planet", heat.planet / (AREA * planet), 1.0, 1e-12);
  law.by_angle = false;
  OK(um_thermal_heat_of_nodes(help_context, network, loads, &options, 0.0, &t, &heat));
  NEAR("albedo", heat.albedo / (AREA * 0.6 * 0.7 * 100.0), 1.0, 1e-12);
  NEAR("planet", heat.planet / (AREA * EMITTANCE * 1.1 * 200.0), 1.0, 1e-12);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}

/* Laws count where networks are compared, and only their numbers do. */
static void laws_are_compared(void **state)
{
  (void)state;
  struct um_thermal_surface_law a = constant(), b = constant();
  struct um_thermal_network *one = plate(&a, 0.5, 0.0), *two = plate(&b, 0.5, 0.0);
  struct um_thermal_network *none = plate(NULL, 0.5, 0.0);
  assert_true(um_thermal_network_equal(one, two));
  assert_false(um_thermal_network_equal(one, none));
  b.emittance[200] = 0.99;
  assert_false(um_thermal_network_equal(one, two));
  b = constant();
  assert_true(um_thermal_network_equal(one, two));
  b.planet_angle[2] = 0.01;
  assert_false(um_thermal_network_equal(one, two));
  um_thermal_network_destroy(&one);
  um_thermal_network_destroy(&two);
  um_thermal_network_destroy(&none);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(metal_cools),
      cmocka_unit_test(loads_follow_the_law),
      cmocka_unit_test(earth_loads_go_by_angle),
      cmocka_unit_test(laws_are_compared),
  };
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
