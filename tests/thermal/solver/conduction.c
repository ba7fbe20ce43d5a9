/* Conduction through a chain of nodes against exact solutions of the heat equation.
 *
 *   x=0                         x=L      cells of h = L/N; end nodes hold half a cell;
 *    o---o---o---o---o---o---o---o       conductors k A / h, capacities rho c A h
 *
 * Second order in h. Sources: Carslaw & Jaeger 1959; NAFEMS T2, T3 (Cameron, Casey & Simpson 1986).
 */
#include "tests/thermal/network_help.h"

/* First node of a chain of n + 1 nodes over length L, unit cross-section. */
static uint32_t chain_add(struct um_thermal_network *network, size_t n, double length,
                          double conductivity, double volume_capacity, double temperature)
{
  double h = length / (double)n;
  uint32_t first = 0;
  for (size_t k = 0; k <= n; k++) {
    double share = k == 0 || k == n ? 0.5 : 1.0;
    uint32_t node = help_node(network, volume_capacity * h * share, temperature);
    if (k == 0)
      first = node;
    else
      OK(um_thermal_network_conductor_add(network, node - 1, node, conductivity / h));
  }
  return first;
}

/* A wall at a given temperature, tied so well (1e9 W/K) that the node follows to 1e-8. */
static void hold(struct um_thermal_network *network, uint32_t node, double temperature)
{
  OK(um_thermal_network_conductor_add(network, node, help_boundary(network, temperature), 1e9));
}

/* NAFEMS T2: 0.1 m, 1000 K at A, radiates to 300 K at B, eps 0.98, k 55.6. The steady state is
 * linear in x, so the chain is exact. With this program's sigma: 927.004 K (k 55.6), 926.967 K
 * (k 55.563); the published 927.0 to its digits. */
static void test_nafems_t2(void **state)
{
  (void)state;
  const double conductivity[2] = {55.6, 55.563}, expected[2] = {927.004, 926.967};
  for (int c = 0; c < 2; c++) {
    struct um_thermal_network *network = help_network();
    uint32_t first = help_boundary(network, 1000.0);
    for (uint32_t k = 1; k <= 10; k++) {
      help_node(network, 7850.0 * 460.0 * 0.01 * (k == 10 ? 0.5 : 1.0), 1000.0);
      OK(um_thermal_network_conductor_add(network, k - 1, k, conductivity[c] / 0.01));
    }
    OK(um_thermal_network_radiator_add(network, 10, help_boundary(network, 300.0), 0.98));
    struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
    double temperature[12];
    OK(um_thermal_solve_steady(help_context, network, NULL, 0, &options, NULL, temperature));
    NEAR("NAFEMS T2, steady", temperature[first + 10], expected[c], 5e-4);
    NEAR("NAFEMS T2, at rest", help_temperature_at(network, 0.0, 10, 1e5), expected[c], 5e-4);
    um_thermal_network_destroy(&network);
  }
}

/* NAFEMS T3: T(0) = 0, T(0.1 m) = 100 sin(pi t / 40) degC, k 35, rho 7200, c 440.5;
 * T(0.08 m, 32 s) = 36.6031 degC by the exact series, 36.60 published. The driven end is a
 * conductor of 1e9 W/K to a node heated so that it follows: a massless node with a load table
 * Q = 1e9 W/K * T(t), sampled every 0.02 s (interpolation error 100 (pi/40 * 0.02)^2 / 8 = 3e-5 K).
 */
static double nafems_t3(size_t n)
{
  const double stiff = 1e9, origin = 1000.0; /* [W/K]; [K] far from 0 K, radiation is off */
  struct um_thermal_network *network = help_network();
  uint32_t first = chain_add(network, n, 0.1, 35.0, 7200.0 * 440.5, origin);
  hold(network, first, origin);
  uint32_t driven = first + (uint32_t)n;
  OK(um_thermal_network_conductor_add(network, driven, help_boundary(network, origin), stiff));
  help_surface(network, 0, driven, 1.0, 1.0, 0.0);
  const size_t ntime = 1601;
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_create(help_context, ntime, 1, 0, &loads));
  for (size_t k = 0; k < ntime; k++) {
    loads->t[k] = 0.02 * (double)k;
    loads->irradiance[k] = stiff * 100.0 * sin(UM_PI * loads->t[k] / 40.0);
    loads->sunlit[k] = 1.0;
    loads->sun[k] = 1.0f;
  }
  struct um_thermal_solve_options options = help_options(1e-9, 1e-7, 0.0);
  double t = 32.0;
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, loads, &options, NULL, 0.0, &t, 1, &history));
  double temperature = history->temperature[first + n * 8 / 10] - origin;
  um_thermal_history_destroy(help_context, &history);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
  return temperature;
}
static void test_nafems_t3(void **state)
{
  (void)state;
  /* the end lags by k dT/dx / stiff = 7e-5 K; second order in h */
  double coarse = nafems_t3(40), fine = nafems_t3(80), finest = nafems_t3(160);
  double exact = 36.6031;
  print_message("NAFEMS T3: %.5f %.5f %.5f degC, order %.3f\n", coarse, fine, finest,
                log2((coarse - fine) / (fine - finest)));
  NEAR("observed order in space", log2((coarse - fine) / (fine - finest)), 2.0, 0.1);
  NEAR("NAFEMS T3 to the published digits", finest, exact, 5e-3);
  NEAR("extrapolated", finest + (finest - fine) / 3.0, exact, 2e-4);
}

/* Slab, step of T at x = 0, insulated at L; theta = (T - Ts)/(T0 - Ts) at Fo = kappa t / L^2. */
static const double fourier[4] = {0.1, 0.2, 0.5, 1.0};

/* Errors against the exact solution at the four Fourier numbers; out[2][4]: back and mean. */
static void slab_step(size_t n, double out[2][4])
{
  struct um_thermal_network *network = help_network();
  uint32_t first = help_boundary(network, 200.0);
  double h = 1.0 / (double)n;
  for (size_t k = 1; k <= n; k++) {
    uint32_t node = help_node(network, h * (k == n ? 0.5 : 1.0), 300.0);
    OK(um_thermal_network_conductor_add(network, node - 1, node, 1.0 / h));
  }
  struct um_thermal_solve_options options = help_options(1e-10, 1e-8, 0.0);
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, fourier, 4, &history));
  for (size_t f = 0; f < 4; f++) {
    const double *t = history->temperature + f * history->nnode + first;
    double mean = 0.0;
    for (size_t k = 0; k < n; k++) mean += 0.5 * h * (t[k] + t[k + 1]);
    out[0][f] = (t[n] - 200.0) / 100.0;
    out[1][f] = (mean - 200.0) / 100.0;
  }
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
}
static void test_slab_step(void **state)
{
  (void)state;
  const double expected[2][4] = {{0.949305, 0.772312, 0.370777, 0.107977},
                                 {0.643177, 0.495912, 0.236050, 0.068740}};
  double coarse[2][4], fine[2][4];
  slab_step(40, coarse);
  slab_step(80, fine);
  for (int place = 0; place < 2; place++)
    for (int f = 0; f < 4; f++) {
      /* second-order extrapolation; 1e-6 is the printed digit, 2e-6 the fourth-order rest */
      double extrapolated = fine[place][f] + (fine[place][f] - coarse[place][f]) / 3.0;
      NEAR(place == 0 ? "slab step, back" : "slab step, mean", extrapolated, expected[place][f],
           2e-6);
    }
}

/* Slab, constant flux q at x = 0, insulated at L: (T - T0) k / (q L), front and back. */
static void slab_flux(size_t n, double out[2][4])
{
  struct um_thermal_network *network = help_network();
  uint32_t first = chain_add(network, n, 1.0, 1.0, 1.0, 300.0);
  um_thermal_network_power_set(network, first, 100.0);
  struct um_thermal_solve_options options = help_options(1e-10, 1e-8, 0.0);
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, fourier, 4, &history));
  for (size_t f = 0; f < 4; f++) {
    const double *t = history->temperature + f * history->nnode + first;
    out[0][f] = (t[0] - 300.0) / 100.0;
    out[1][f] = (t[n] - 300.0) / 100.0;
  }
  if (!(history->audit_error <= 1e-9)) fail_msg("audit %g", history->audit_error);
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
}
static void test_slab_flux(void **state)
{
  (void)state;
  const double expected[2][4] = {{0.356826, 0.505165, 0.831876, 1.333323},
                                 {0.007885, 0.061464, 0.334791, 0.833344}};
  double coarse[2][4], fine[2][4];
  slab_flux(40, coarse);
  slab_flux(80, fine);
  for (int place = 0; place < 2; place++)
    for (int f = 0; f < 4; f++) {
      double extrapolated = fine[place][f] + (fine[place][f] - coarse[place][f]) / 3.0;
      NEAR(place == 0 ? "slab flux, front" : "slab flux, back", extrapolated, expected[place][f],
           2e-6);
    }
}

/* Semi-infinite, 1000 W/m^2, k 1, kappa 1e-6, t 100 s. 0.2 m is 10 diffusion lengths: erfc(10). */
static void semi_infinite(size_t n, double out[2])
{
  struct um_thermal_network *network = help_network();
  uint32_t first = chain_add(network, n, 0.2, 1.0, 1e6, 300.0);
  um_thermal_network_power_set(network, first, 1000.0);
  struct um_thermal_solve_options options = help_options(1e-11, 1e-9, 0.0);
  struct um_thermal_history *history = NULL;
  double t = 100.0;
  OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, &t, 1, &history));
  out[0] = history->temperature[first] - 300.0;
  out[1] = history->temperature[first + n / 20] - 300.0;
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
}
static void test_semi_infinite(void **state)
{
  (void)state;
  const double a = 2.0 * sqrt(1e-6 * 100.0 / UM_PI) * 1000.0; /* 2 q sqrt(kappa t / pi) / k */
  const double x = 0.01;
  const double b = a * exp(-x * x / 4e-4) - 1000.0 * x * erfc(x / 0.02);
  NEAR("front, printed", a, 11.28379, 1e-5);
  NEAR("at 0.01 m, printed", b, 3.99282, 1e-5);
  double error[3][2];
  for (int level = 0; level < 3; level++) {
    double out[2];
    semi_infinite((size_t)100 << level, out);
    error[level][0] = fabs(out[0] - a);
    error[level][1] = fabs(out[1] - b);
  }
  NEAR("front", error[2][0], 0.0, 5e-3);
  NEAR("at 0.01 m", error[2][1], 0.0, 5e-3);
  for (int place = 0; place < 2; place++)
    for (int level = 0; level < 2; level++)
      NEAR("observed order in space", log2(error[level][place] / error[level + 1][place]), 2.0,
           0.1);
}

/* Radiating plate fin: L 0.1 m, 1 mm, k 167, eps 0.85 on both sides, root 400 K, sink 0 K.
 * Tip 351.69619 K, root 176.89097 W per metre of width, efficiency 0.716812 (shooting). */
static void fin(uint32_t n, double out[2])
{
  struct um_thermal_network *network = help_network();
  uint32_t root = help_boundary(network, 400.0);
  double h = 0.1 / (double)n, conductance = 167.0 * 1e-3 / h;
  for (uint32_t k = 1; k <= n; k++) {
    uint32_t node = help_node(network, 1.0, 400.0);
    OK(um_thermal_network_conductor_add(network, node - 1, node, conductance));
    OK(um_thermal_network_radiator_add(network, node, UM_THERMAL_SPACE,
                                       2.0 * 0.85 * h * (k == n ? 0.5 : 1.0)));
  }
  /* the root's own half cell radiates from the boundary: part of the root heat */
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, 0.0);
  double temperature[512];
  OK(um_thermal_solve_steady(help_context, network, NULL, 0, &options, NULL, temperature));
  out[0] = temperature[root + n];
  out[1] = conductance * (400.0 - temperature[root + 1]) +
           UM_STEFAN_BOLTZMANN * 0.85 * h * pow(400.0, 4);
  um_thermal_network_destroy(&network);
}
static void test_fin(void **state)
{
  (void)state;
  double coarse[2], fine[2];
  fin(200, coarse);
  fin(400, fine);
  double tip = fine[0] + (fine[0] - coarse[0]) / 3.0;
  double heat = fine[1] + (fine[1] - coarse[1]) / 3.0;
  NEAR("fin tip", tip, 351.69619, 1e-5);
  NEAR("fin root heat", heat, 176.89097, 1e-5);
  NEAR("fin efficiency", heat / (2.0 * 0.85 * 0.1 * UM_STEFAN_BOLTZMANN * pow(400.0, 4)), 0.716812,
       1e-6);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_nafems_t2),     cmocka_unit_test(test_nafems_t3),
      cmocka_unit_test(test_slab_step),     cmocka_unit_test(test_slab_flux),
      cmocka_unit_test(test_semi_infinite), cmocka_unit_test(test_fin)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
