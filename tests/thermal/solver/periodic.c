/* Quasi-steady orbits.
 *
 *        Sun ->     o   isothermal sphere, circular orbit at 765 km, beta 0, period P
 *               (Earth)   shadow |u - pi| < 63.24049 deg (cylinder), u = 0 over the sub-solar point
 *
 * Loads per unit of sphere area: alpha S/4 in sunlight, alpha 0.3 F S max(cos u, 0),
 * eps 237 F; F = 0.2748766, S = 1361 W/m^2. The load table has rows at both sides of the shadow's
 * edges at the same time, so the Sun jumps exactly. Expected temperatures: an independent
 * integration of the same equation (scipy, to 1e-10), printed to 0.1 mK. Where the highest one is
 * follows from itself: dT/dt = 0 there, so cos u = (sigma T^4 - S/4 - 237 F)/(0.3 F S), u/2pi =
 * 0.17324 (alpha = eps). */
#include "tests/thermal/network_help.h"

#define GRID 2000 /* cos u is interpolated to (2 pi / GRID)^2 / 8 = 1.2e-6 of 112 W/m^2 */

static double orbit_period(void)
{
  return 2.0 * UM_PI * sqrt(pow(6378.137e3 + 765e3, 3) / UM_EARTH_GM);
}

/* Loads of `orbits` orbits on `nsurface` surfaces, all as on the sphere. */
static struct um_irradiation_loads *sphere_loads(size_t orbits, size_t nsurface)
{
  const double factor = 0.2748766, half = 63.24049 * UM_DEG, period = orbit_period();
  struct um_irradiation_loads *loads = NULL;
  size_t ntime = orbits * (GRID + 4) + 1, k = 0, edges = 0;
  OK(um_irradiation_loads_create(help_context, ntime, nsurface, 2 * orbits, &loads));
  const double edge[2] = {(UM_PI - half) / (2.0 * UM_PI), (UM_PI + half) / (2.0 * UM_PI)};
  for (size_t orbit = 0; orbit < orbits; orbit++) {
    double sunlit = 1.0;
    int passed = 0;
    for (size_t g = 0; g < GRID + (orbit + 1 == orbits); g++) {
      double phase = (double)g / GRID;
      while (passed < 2 && edge[passed] <= phase) {
        loads->edge[edges++] = ((double)orbit + edge[passed]) * period;
        for (int side = 0; side < 2; side++) {
          loads->t[k] = ((double)orbit + edge[passed]) * period;
          loads->sunlit[k++] = side == 0 ? sunlit : 1.0 - sunlit;
        }
        sunlit = 1.0 - sunlit;
        passed++;
      }
      loads->t[k] = ((double)orbit + phase) * period;
      loads->sunlit[k++] = sunlit;
    }
  }
  assert_int_equal(k, ntime);
  for (k = 0; k < ntime; k++) {
    double u = 2.0 * UM_PI * loads->t[k] / period;
    loads->irradiance[k] = 1361.0;
    for (size_t s = 0; s < nsurface; s++) {
      loads->sun[k * nsurface + s] = 0.25f;
      loads->albedo[k * nsurface + s] = (float)(0.3 * factor * 1361.0 * fmax(cos(u), 0.0));
      loads->planet[k * nsurface + s] = (float)(237.0 * factor);
    }
  }
  return loads;
}

static struct um_thermal_network *sphere(double capacity, double absorptance, double emittance)
{
  struct um_thermal_network *network = help_network();
  uint32_t node = help_node(network, capacity, 280.0);
  help_surface(network, 0, node, 1.0, absorptance, emittance);
  return network;
}

/* 280 K at u = 0: temperature after one, two, three orbits. */
static void test_waiting(void **state)
{
  (void)state;
  const double expected[3] = {289.4761, 289.5773, 289.5784};
  struct um_irradiation_loads *loads = sphere_loads(3, 1);
  struct um_thermal_network *network = sphere(4860.0, 0.8, 0.8);
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  double times[3];
  for (int k = 0; k < 3; k++) times[k] = (k + 1) * orbit_period();
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, loads, &options, NULL, 0.0, times, 3, &history));
  for (int k = 0; k < 3; k++) {
    print_message("after orbit %d: %.4f K (expected %.4f)\n", k + 1, history->temperature[k],
                  expected[k]);
    NEAR("end of orbit", history->temperature[k], expected[k], 5e-3);
  }
  print_message("audit %.2e, %zu steps, %zu rhs, %zu Jacobians\n", history->audit_error,
                history->steps, history->rhs_evaluations, history->jacobians);
  if (!(history->audit_error <= 1e-6)) fail_msg("audit %g", history->audit_error);
  um_thermal_history_destroy(help_context, &history);
  um_thermal_network_destroy(&network);
  um_irradiation_loads_destroy(help_context, &loads);
}

/* The periodic orbit: extremes and mean. */
static void test_sphere(void **state)
{
  (void)state;
  static const struct {
    double capacity, absorptance, emittance, highest, lowest, mean, at; /* 0: not stated */
  } rows[3] = {{4860.0, 0.8, 0.8, 299.6970, 230.8374, 271.5632, 0.17324},
               {77.39, 0.38, 0.78, 266.3944, 184.1063, 0.0, 0.0},
               {4860.0, 0.2, 0.8, 226.8721, 206.8098, 0.0, 0.0}};
  struct um_irradiation_loads *loads = sphere_loads(1, 1);
  double period = orbit_period();
  for (int c = 0; c < 3; c++) {
    struct um_thermal_network *network =
        sphere(rows[c].capacity, rows[c].absorptance, rows[c].emittance);
    struct um_thermal_solve_options options;
    um_thermal_solve_defaults(&options);
    double start, drift;
    OK(um_thermal_solve_periodic(help_context, network, loads, &options, NULL, 0.0, period, 1e-3,
                                 &start, &drift));
    if (!(drift <= 1e-3)) fail_msg("drift %g", drift);
    /* at the rows of the table, shadow edges included, by the trapezoid */
    struct um_thermal_solve_options fine = help_options(1e-9, 1e-7, UM_SPACE_TEMPERATURE);
    struct um_thermal_history *history = NULL, *check = NULL;
    OK(um_thermal_solve(help_context, network, loads, &options, &start, 0.0, loads->t, loads->ntime,
                        &history));
    OK(um_thermal_solve(help_context, network, loads, &fine, &start, 0.0, loads->t, loads->ntime,
                        &check));
    double highest = 0.0, lowest = 1e9, mean = 0.0, at = 0.0, top = 0.0, error = 0.0;
    for (size_t k = 0; k < loads->ntime; k++) {
      double t = history->temperature[k];
      highest = fmax(highest, t);
      lowest = fmin(lowest, t);
      error = fmax(error, fabs(t - check->temperature[k]));
      if (k > 0)
        mean += 0.5 * (t + history->temperature[k - 1]) * (loads->t[k] - loads->t[k - 1]) / period;
      /* where it is highest, from the fine run: a flat top does not show 1e-4 of u otherwise */
      if (check->temperature[k] > top) at = loads->t[k] / period;
      top = fmax(top, check->temperature[k]);
    }
    print_message("largest error of the default tolerances %.1e K\n", error);
    print_message("max %.4f min %.4f mean %.4f at %.4f, audit %.1e, %zu steps\n", highest, lowest,
                  mean, at, history->audit_error, history->steps);
    NEAR("highest", highest, rows[c].highest, 5e-3);
    NEAR("lowest", lowest, rows[c].lowest, 5e-3);
    if (rows[c].mean > 0.0) {
      NEAR("mean", mean, rows[c].mean, 5e-3);
      NEAR("u/2pi of the highest", at, rows[c].at, 0.6 / GRID);
    }
    if (!(history->audit_error <= 1e-6)) fail_msg("audit %g", history->audit_error);
    um_thermal_history_destroy(help_context, &history);
    um_thermal_history_destroy(help_context, &check);
    um_thermal_network_destroy(&network);
  }
  um_irradiation_loads_destroy(help_context, &loads);
}

/* An interior behind MLI: tau = C / (4 e* sigma A T^3) of some 300 orbits. The periodic state is
 * checked against its definition, that the orbit-mean heat through the blanket equals the power,
 * and starts from 293 K, 150 K and 230 K agree. */
static struct um_thermal_network *wrapped(double effective_emittance, double start, double power)
{
  const double area = 150.0, capacity = 7900.0 * 900.0;
  struct um_thermal_network *network = help_network();
  uint32_t skin = help_node(network, 77.39 * area, 280.0);
  uint32_t interior = help_node(network, capacity, start);
  help_surface(network, 0, skin, area, 0.38, 0.78);
  OK(um_thermal_network_radiator_add(network, skin, interior, effective_emittance * area));
  um_thermal_network_power_set(network, interior, power);
  return network;
}
/* Orbit-mean heat [W] from the interior through the blanket, one orbit from `start`. */
static double mean_leak(struct um_thermal_network *network,
                        const struct um_irradiation_loads *loads, double effective_emittance,
                        const double *start)
{
  struct um_thermal_solve_options options = help_options(1e-8, 1e-6, UM_SPACE_TEMPERATURE);
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, loads, &options, start, 0.0, loads->t, loads->ntime,
                      &history));
  double sum = 0.0, before = 0.0;
  for (size_t k = 0; k < loads->ntime; k++) {
    const double *t = history->temperature + 2 * k;
    double leak = effective_emittance * 150.0 * UM_STEFAN_BOLTZMANN * (pow(t[1], 4) - pow(t[0], 4));
    if (k > 0) sum += 0.5 * (leak + before) * (loads->t[k] - loads->t[k - 1]);
    before = leak;
  }
  um_thermal_history_destroy(help_context, &history);
  return sum / orbit_period();
}
static void test_wrapped_interior(void **state)
{
  (void)state;
  struct um_irradiation_loads *loads = sphere_loads(1, 1);
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  const double emittance[2] = {0.005, 0.05}, starts[3] = {293.0, 150.0, 230.0};
  size_t orbits = 0;
  for (int e = 0; e < 2; e++) {
    double found[3];
    for (int s = 0; s < 3; s++) {
      struct um_thermal_network *network = wrapped(emittance[e], starts[s], 100.0);
      double temperature[2], drift[2];
      struct um_thermal_periodic report;
      OK(um_thermal_solve_periodic_report(help_context, network, loads, &options, NULL, 0.0,
                                          orbit_period(), 1e-2, temperature, drift, NULL, &report));
      found[s] = temperature[1];
      print_message("e* %.3f from %.0f K: %.4f K after %zu orbits, drift %.1e K, distance %.1e K\n",
                    emittance[e], starts[s], found[s], report.orbits, report.drift,
                    report.distance);
      orbits += report.orbits;
      /* 300 orbits turn a distance into as much less of a drift */
      assert_true(report.drift < 1e-4);
      /* 0.02 K off: twice the tolerance asked for */
      double slope = 4.0 * emittance[e] * 150.0 * UM_STEFAN_BOLTZMANN * pow(found[s], 3);
      NEAR("mean leak", mean_leak(network, loads, emittance[e], temperature), 100.0, 0.02 * slope);
      um_thermal_network_destroy(&network);
    }
    NEAR("independent of the start", found[1], found[0], 2e-2);
    NEAR("independent of the start", found[2], found[0], 2e-2);
  }
  assert_true(orbits <= 26);
  um_irradiation_loads_destroy(help_context, &loads);
}

/* What is asked is met whatever an orbit leaves of an error, from exp(-0.2) to exp(-20) of it, and
 * on either side: the correction of an orbit knows a mode within 9 % of the drift, and where
 * exp(-3) is left does not see it at all. */
static void test_judged_in_full(void **state)
{
  (void)state;
  struct um_irradiation_loads *loads = sphere_loads(1, 1);
  struct um_thermal_solve_options options = help_options(1e-9, 1e-7, UM_SPACE_TEMPERATURE);
  for (double capacity = 1100.0; capacity < 1.2e5; capacity *= 1.15) {
    double found, exact, drift;
    static const double begins[] = {260.0, 285.0, 292.0, 296.0, 303.0, 309.5, 320.0};
    for (size_t b = 0; b < sizeof begins / sizeof *begins; b++) {
      struct um_thermal_network *network = sphere(capacity, 0.8, 0.8);
      double begin = begins[b];
      OK(um_thermal_solve_periodic(help_context, network, loads, &options, &begin, 0.0,
                                   orbit_period(), 0.01, &found, &drift));
      OK(um_thermal_solve_periodic(help_context, network, loads, &options, &begin, 0.0,
                                   orbit_period(), 1e-5, &exact, &drift));
      NEAR("periodic start", found, exact, 0.01);
      um_thermal_network_destroy(&network);
    }
  }
  um_irradiation_loads_destroy(help_context, &loads);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_waiting), cmocka_unit_test(test_sphere),
                                     cmocka_unit_test(test_judged_in_full),
                                     cmocka_unit_test(test_wrapped_interior)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
