/* Laws of a run: energy closes, heat flows add up to the change of temperature, the same bytes for
 * any number of threads, and what is refused. Subject: the spinning box of box_help.h. */
#include <stdlib.h>

#include "tests/thermal/box_help.h"

#define PERIOD 6000.0
#define ROWS   1201 /* every 5 s */

/* Solar heat [J] of nodes from the table: every interval is a product of linear functions of time,
 * at most cubic, so Simpson's rule is exact. */
static double solar_exact(const struct um_thermal_network *network,
                          const struct um_irradiation_loads *loads)
{
  double sum = 0.0;
  size_t surfaces = um_thermal_network_surfaces(network);
  double *row = calloc(loads->ntime, sizeof *row);
  assert_non_null(row);
  for (size_t k = 0; k < loads->ntime; k++)
    for (size_t s = 0; s < surfaces; s++) {
      const struct um_thermal_surface *surface = um_thermal_network_surface(network, (uint32_t)s);
      row[k] += surface->area * (surface->absorptance - surface->extraction) *
                (double)loads->sun[k * loads->nsurface + s];
    }
  for (size_t k = 0; k + 1 < loads->ntime; k++) {
    double a = row[k] * loads->sunlit[k] * loads->irradiance[k];
    double b = row[k + 1] * loads->sunlit[k + 1] * loads->irradiance[k + 1];
    double middle = 0.125 * (row[k] + row[k + 1]) * (loads->sunlit[k] + loads->sunlit[k + 1]) *
                    (loads->irradiance[k] + loads->irradiance[k + 1]);
    sum += (loads->t[k + 1] - loads->t[k]) * (a + 4.0 * middle + b) / 6.0;
  }
  free(row);
  return sum;
}

/* |in - out - stored| / (in + out) below 1e-6 with default tolerances, with skins that store heat
 * and with massless ones. And the integrator saw all of the Sun, although BDF steps over the kinks
 * of the table: 1 mK in all that stores heat (2.1 MJ/K) is 2.1 kJ of 34 MJ, or 6e-5. */
static void test_energy(void **state)
{
  (void)state;
  const double skin[2] = {77.39, 0.0};
  for (int c = 0; c < 2; c++) {
    uint32_t interior;
    struct um_thermal_network *network = box_network(3, skin[c], &interior);
    struct um_irradiation_loads *loads = box_loads(3, ROWS, PERIOD, PERIOD / 213.0);
    struct um_thermal_solve_options options;
    um_thermal_solve_defaults(&options);
    struct um_thermal_history *history = NULL;
    OK(um_thermal_solve(help_context, network, loads, &options, NULL, 0.0, loads->t, ROWS,
                        &history));
    double sun = solar_exact(network, loads);
    print_message(
        "skin %.0f J/m2/K: audit %.1e, sun %.3g J (%.1e), %zu steps, %zu rhs, %zu Jacobians\n",
        skin[c], history->audit_error, sun, history->audit.solar / sun - 1.0, history->steps,
        history->rhs_evaluations, history->jacobians);
    if (!(history->audit_error <= 1e-6)) fail_msg("audit %g", history->audit_error);
    NEAR("solar heat", history->audit.solar / sun, 1.0, 6e-5);
    um_thermal_history_destroy(help_context, &history);
    um_irradiation_loads_destroy(help_context, &loads);
    um_thermal_network_destroy(&network);
  }
}

/* stored of a node = C dT/dt: central difference of the history over +-0.5 s, where the loads are
 * smooth; second derivatives leave 1e-3 of the largest rate. The sum over nodes has no conducted
 * and no exchanged part. */
static void test_heat_of_nodes(void **state)
{
  (void)state;
  uint32_t interior;
  struct um_thermal_network *network = box_network(3, 77.39, &interior);
  struct um_irradiation_loads *loads = box_loads(3, ROWS, PERIOD, PERIOD / 213.0);
  struct um_thermal_solve_options options = help_options(1e-9, 1e-7, UM_SPACE_TEMPERATURE);
  const double times[3] = {1001.5, 1002.0, 1002.5};
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, loads, &options, NULL, 0.0, times, 3, &history));
  size_t n = um_thermal_network_nodes(network);
  struct um_thermal_heat *heat = calloc(n, sizeof *heat);
  assert_non_null(heat);
  OK(um_thermal_heat_of_nodes(help_context, network, loads, &options, times[1],
                              history->temperature + n, heat));
  double conducted = 0.0, exchanged = 0.0, gross = 0.0, worst = 0.0, largest = 0.0;
  for (size_t i = 0; i < n; i++) {
    double rate = history->temperature[2 * n + i] - history->temperature[i]; /* per 1 s */
    double capacity = um_thermal_network_capacity(network, (uint32_t)i);
    worst = fmax(worst, fabs(heat[i].stored / capacity - rate));
    largest = fmax(largest, fabs(rate));
    conducted += heat[i].conducted;
    exchanged += heat[i].exchanged;
    gross += fabs(heat[i].conducted) + fabs(heat[i].exchanged);
  }
  NEAR("C dT/dt", worst, 0.0, 1e-3 * largest);
  NEAR("conducted sum", conducted, 0.0, 1e-12 * gross);
  NEAR("exchanged sum", exchanged, 0.0, 1e-12 * gross);
  free(heat);
  um_thermal_history_destroy(help_context, &history);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}

static void test_threads(void **state)
{
  (void)state;
  uint32_t interior;
  struct um_thermal_network *network = box_network(3, 77.39, &interior);
  struct um_irradiation_loads *loads = box_loads(3, ROWS, PERIOD, PERIOD / 213.0);
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  struct um_thermal_history *history[2] = {NULL, NULL};
  int before = um_core_context_threads(help_context);
  for (int k = 0; k < 2; k++) {
    um_core_context_set_threads(help_context, k + 1);
    OK(um_thermal_solve(help_context, network, loads, &options, NULL, 0.0, loads->t, ROWS,
                        &history[k]));
  }
  um_core_context_set_threads(help_context, before);
  assert_memory_equal(history[0]->temperature, history[1]->temperature,
                      ROWS * history[0]->nnode * sizeof(double));
  assert_memory_equal(&history[0]->audit, &history[1]->audit, sizeof history[0]->audit);
  for (int k = 0; k < 2; k++) um_thermal_history_destroy(help_context, &history[k]);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}

/* Last temperatures and audit of one run over the table from its first row. */
static struct um_thermal_history *whole_run(const struct um_thermal_network *network,
                                            const struct um_irradiation_loads *loads,
                                            const struct um_thermal_solve_options *options)
{
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, loads, options, NULL, loads->t[0],
                      loads->t + loads->ntime - 1, 1, &history));
  return history;
}

/* A switched-off load is the same bytes as a table without it. */
static void test_switches(void **state)
{
  (void)state;
  uint32_t interior;
  struct um_thermal_network *network = box_network(2, 77.39, &interior);
  for (int c = 0; c < 2; c++) {
    struct um_irradiation_loads *loads = box_loads(2, 301, PERIOD, 5.0);
    struct um_thermal_solve_options options;
    um_thermal_solve_defaults(&options);
    struct um_thermal_history *with = whole_run(network, loads, &options);
    *(c == 0 ? &options.albedo_on : &options.planet_on) = false;
    struct um_thermal_history *off = whole_run(network, loads, &options);
    memset(c == 0 ? loads->albedo : loads->planet, 0,
           loads->ntime * loads->nsurface * sizeof(float));
    um_thermal_solve_defaults(&options);
    struct um_thermal_history *none = whole_run(network, loads, &options);
    assert_true((c == 0 ? off->audit.albedo : off->audit.planet) == 0.0);
    assert_memory_equal(off->temperature, none->temperature, off->nnode * sizeof(double));
    assert_true(with->temperature[1] > off->temperature[1] + 0.01);
    um_thermal_history_destroy(help_context, &with);
    um_thermal_history_destroy(help_context, &off);
    um_thermal_history_destroy(help_context, &none);
    um_irradiation_loads_destroy(help_context, &loads);
  }
  um_thermal_network_destroy(&network);
}

/* The origin of time does not matter: at 5.3e8 s (2016 in TAI from J2000) the table's times are
 * rounded by 6e-8 s, so the steps differ; either run is within 1e-5 K of the truth at these
 * tolerances. */
static void test_origin_of_time(void **state)
{
  (void)state;
  uint32_t interior;
  struct um_thermal_network *network = box_network(2, 77.39, &interior);
  struct um_irradiation_loads *loads = box_loads(2, 301, PERIOD, 5.0);
  struct um_thermal_solve_options options = help_options(1e-9, 1e-7, UM_SPACE_TEMPERATURE);
  struct um_thermal_history *here = whole_run(network, loads, &options);
  for (size_t k = 0; k < loads->ntime; k++) loads->t[k] += 5.3e8;
  for (size_t k = 0; k < loads->nedge; k++) loads->edge[k] += 5.3e8;
  struct um_thermal_history *there = whole_run(network, loads, &options);
  for (size_t i = 0; i < here->nnode; i++)
    NEAR("at 5.3e8 s", there->temperature[i], here->temperature[i], 2e-5);
  um_thermal_history_destroy(help_context, &here);
  um_thermal_history_destroy(help_context, &there);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}

/* A spin of 28.17 turns in the window: the state at its end is another attitude's. The iteration
 * still settles, and the interior's answer is the same as from another start. */
static void test_incommensurate_spin(void **state)
{
  (void)state;
  uint32_t interior;
  struct um_thermal_network *network = box_network(2, 77.39, &interior);
  struct um_irradiation_loads *loads = box_loads(2, 601, PERIOD, PERIOD / 213.0);
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  size_t n = um_thermal_network_nodes(network);
  double *temperature = calloc(3 * n, sizeof *temperature), *drift = temperature + 2 * n;
  assert_non_null(temperature);
  struct um_thermal_periodic report;
  OK(um_thermal_solve_periodic_report(help_context, network, loads, &options, NULL, 0.0, PERIOD,
                                      0.01, temperature, drift, NULL, &report));
  print_message("%zu orbits, drift %.1e K, distance %.1e K, interior %.4f K\n", report.orbits,
                report.drift, report.distance, temperature[interior]);
  assert_true(report.orbits <= 10);
  NEAR("largest drift", fabs(drift[report.drift_node]), report.drift, 0.0);
  /* fast nodes forget where the last orbit began, so its drift is none of theirs; an orbit from the
   * state that was found must lead back to it, to twice the distance asked for */
  OK(um_thermal_solve_periodic_report(help_context, network, loads, &options, temperature, 0.0,
                                      PERIOD, 0.01, temperature + n, drift, NULL, &report));
  NEAR("drift from the state found", report.drift, 0.0, 0.02);
  for (size_t i = 0; i < n; i++) temperature[n + i] = 200.0;
  double largest;
  OK(um_thermal_solve_periodic(help_context, network, loads, &options, temperature + n, 0.0, PERIOD,
                               0.01, temperature + n, &largest));
  for (size_t i = 0; i < n; i++) NEAR("from 200 K", temperature[n + i], temperature[i], 0.02);
  free(temperature);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}

/* Every refusal is one line that names what is wrong. */
static void expect_refused(struct um_thermal_network *network, struct um_irradiation_loads *loads,
                           double from, double to, const char *words)
{
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  struct um_thermal_history *history = NULL;
  um_core_message_clear(help_context);
  assert_int_equal(
      um_thermal_solve(help_context, network, loads, &options, NULL, from, &to, 1, &history),
      UM_ERR_INPUT);
  assert_null(history);
  if (strstr(um_core_message(help_context), words) == NULL)
    fail_msg("'%s' does not say '%s'", um_core_message(help_context), words);
  um_core_message_clear(help_context);
}
static void test_refused(void **state)
{
  (void)state;
  uint32_t interior;
  struct um_thermal_network *network = box_network(2, 77.39, &interior);
  struct um_irradiation_loads *loads = box_loads(2, 61, PERIOD, 3.0);
  loads->sun[40 * 3 + 3] = NAN;
  expect_refused(network, loads, 0.0, 1000.0, "sun on surface 3 at row 3");
  loads->sun[40 * 3 + 3] = 0.0f;
  loads->planet[7] = INFINITY;
  expect_refused(network, loads, 0.0, 1000.0, "planet on surface 7 at row 0");
  loads->planet[7] = 0.0f;
  loads->sunlit[5] = NAN;
  expect_refused(network, loads, 0.0, 1000.0, "sunlit fraction at row 5");
  loads->sunlit[5] = 1.0;
  expect_refused(network, loads, 0.0, PERIOD + 1.0, "inside its loads");
  expect_refused(network, loads, 10.0, 5.0, "not before the start");
  loads->t[9] = loads->t[7];
  expect_refused(network, loads, 0.0, 1000.0, "ascending");
  loads->t[9] = 900.0;
  loads->nsurface = 30;
  expect_refused(network, loads, 0.0, 1000.0, "30 surfaces");
  loads->nsurface = 40;
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}

/* A run whose books do not balance is refused: above 1e-4 at the tolerances of 0.1 K, above ten
 * times that at ten times these; a derivative's run, which leaves the care for it, never. */
static void test_limit(void **state)
{
  (void)state;
  struct um_thermal_history history = {.audit_error = 1.1e-4};
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  options.relative_tolerance = 1e-5;
  options.absolute_tolerance = 1e-3;
  assert_int_equal(um_thermal_history_audit_check(help_context, &history, &options),
                   UM_ERR_NUMERIC);
  assert_non_null(strstr(um_core_message(help_context), "at most 1.0e-04"));
  um_core_message_clear(help_context);
  options.tolerance_factor = 2.0;
  assert_int_equal(um_thermal_history_audit_check(help_context, &history, &options), UM_OK);
  options.tolerance_factor = 1.0;
  options.absolute_tolerance = 1e-2;
  assert_int_equal(um_thermal_history_audit_check(help_context, &history, &options), UM_OK);
  history.audit_error = 1.1e-3;
  assert_int_equal(um_thermal_history_audit_check(help_context, &history, &options),
                   UM_ERR_NUMERIC);
  um_core_message_clear(help_context);
  /* 200 J into 1 MJ that is there: 10 mK of it are a sixth of that */
  history = (struct um_thermal_history){
      .audit_error = 0.9 / 6.0, .content = 1e6, .audit = {.solar = 200.0}};
  options.absolute_tolerance = 1e-3;
  assert_int_equal(um_thermal_history_audit_check(help_context, &history, &options), UM_OK);
  history.audit_error = 1.1 / 6.0;
  assert_int_equal(um_thermal_history_audit_check(help_context, &history, &options),
                   UM_ERR_NUMERIC);
  um_core_message_clear(help_context);
  history.audit_error = NAN; /* not made */
  assert_int_equal(um_thermal_history_audit_check(help_context, &history, &options), UM_OK);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_energy),         cmocka_unit_test(test_heat_of_nodes),
      cmocka_unit_test(test_threads),        cmocka_unit_test(test_switches),
      cmocka_unit_test(test_origin_of_time), cmocka_unit_test(test_incommensurate_spin),
      cmocka_unit_test(test_refused),        cmocka_unit_test(test_limit)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
