/* Linear equations on the pattern of a Jacobian: LU and Cholesky factors against the matrix itself,
 * whichever they are, and against each other in runs; a matrix that is not positive, a singular
 * one.
 *
 * Asked of a residual |A x - b| / (|A| |x| + |b|): 1e-13 of direct solutions (a few hundred
 * roundings), 1e-9 where GMRES is told 1e-11. */
#include <dirent.h>
#include <stdlib.h>

#include "base/core/child.h"
#include "tests/thermal/box_help.h"
#include "thermal/solver/linear_group.h"
#include "thermal/solver/solve.h"

#define COLUMNS 5

/* Walls and boards that conduct to each other and radiate to space alone. */
static struct um_thermal_network *grid_network(uint32_t m)
{
  struct um_thermal_network *network = help_network();
  for (uint32_t k = 0; k < m * m; k++) {
    uint32_t node = help_node(network, 100.0 + 10.0 * (k % 7), 250.0 + k % 50);
    OK(um_thermal_network_radiator_add(network, node, UM_THERMAL_SPACE, 0.02));
  }
  box_couple_grid(network, 0, m, m, 1, 0.4);
  return network;
}

static double residual(const struct um_thermal_system *system, const double *value, const double *x,
                       const double *b)
{
  size_t n = system->nunknown;
  double *sum = calloc(2 * n, sizeof *sum), worst = 0.0;
  assert_non_null(sum);
  for (size_t k = 0; k < n; k++)
    for (int64_t e = system->column[k]; e < system->column[k + 1]; e++) {
      sum[system->row[e]] += value[e] * x[k];
      sum[n + (size_t)system->row[e]] += fabs(value[e] * x[k]);
    }
  for (size_t k = 0; k < n; k++)
    worst = fmax(worst, fabs(sum[k] - b[k]) / (sum[n + k] + fabs(b[k])));
  free(sum);
  return worst;
}

/* I - gamma J of a network at uneven temperatures, by `factors`; returns the largest residual. */
static double solve_once(const struct um_thermal_network *network, enum um_thermal_factors factors,
                         double gamma, double tolerance)
{
  struct um_thermal_solve_options options;
  struct um_thermal_system *system = NULL;
  struct um_thermal_linear *linear = NULL;
  um_thermal_solve_defaults(&options);
  options.factors = factors;
  OK(um_thermal_system_create(help_context, network, NULL, &options, NULL, 0.0, UM_SYSTEM_RUN,
                              &system));
  size_t n = system->nunknown;
  double *value = calloc(system->nnonzero, sizeof *value), *y = calloc(n, sizeof *y);
  double *b = calloc(2 * COLUMNS * n, sizeof *b), *x = b + COLUMNS * n, worst = 0.0;
  assert_true(value != NULL && y != NULL && b != NULL);
  for (size_t k = 0; k < n; k++) y[k] = 250.0 + 90.0 * sin(1.7 * (double)k);
  assert_true(um_thermal_system_state_set(system, 0.0, y));
  assert_true(um_thermal_system_jacobian(system, value));
  for (size_t k = 0; k < system->nnonzero; k++) value[k] *= -gamma;
  for (size_t k = 0; k < n; k++) value[system->diagonal[k]] += 1.0;
  OK(um_thermal_linear_create(system, &linear));
  for (int twice = 0; twice < 2; twice++) {
    OK(um_thermal_linear_factor(linear, value));
    for (size_t k = 0; k < COLUMNS * n; k++) x[k] = b[k] = cos(0.3 * (double)k);
    OK(um_thermal_linear_solve(linear, COLUMNS, tolerance, x));
    for (size_t c = 0; c < COLUMNS; c++)
      worst = fmax(worst, residual(system, value, x + c * n, b + c * n));
  }
  assert_string_equal(um_thermal_linear_method(linear),
                      factors == UM_THERMAL_LU ? "KLU" : "CHOLMOD");
  um_thermal_linear_destroy(&linear);
  um_thermal_system_destroy(&system);
  free(value);
  free(y);
  free(b);
  return worst;
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/* In a child: what a Cholesky solution ends with. */
static int create(void *self, int pipe_end)
{
  struct um_thermal_solve_options options;
  struct um_thermal_system *system = NULL;
  struct um_thermal_linear *linear = NULL;
  (void)pipe_end;
  um_thermal_solve_defaults(&options);
  options.factors = UM_THERMAL_CHOLESKY;
  if (um_thermal_system_create(help_context, self, NULL, &options, NULL, 0.0, UM_SYSTEM_RUN,
                               &system) != UM_OK)
    return 100;
  return (int)um_thermal_linear_create(system, &linear);
}

/* OpenBLAS asks for its 128 MiB again and again, for ever, where it gets none: 150 MiB are room for
 * the libraries or for that, not for both. Before any other test, which leaves it open. */
static void test_short_of_memory(void **state)
{
  (void)state;
  struct um_thermal_network *network = grid_network(20);
  const struct um_core_child_limits little = {20.0, 150}, enough = {20.0, 1000};
  struct um_core_child_result result;
  OK(um_core_child_run(help_context, "a solver", create, network, &enough, &result));
  assert_int_equal(result.end, UM_CHILD_EXITED);
  assert_int_equal(result.code, UM_OK);
  OK(um_core_child_run(help_context, "a solver", create, network, &little, &result));
  assert_int_equal(result.end, UM_CHILD_EXITED);
  if (result.code != UM_ERR_MEMORY && result.code != UM_ERR_LIBRARY)
    assert_int_equal(result.code, UM_OK); /* a BLAS that needs less */
  um_thermal_network_destroy(&network);
}
#endif

static size_t count_threads(void)
{
  size_t n = 0;
  DIR *all = opendir("/proc/self/task");
  assert_non_null(all);
  while (readdir(all) != NULL) n++;
  closedir(all);
  return n;
}

/* The BLAS behind CHOLMOD starts none: one that it had begun is waited for at the end. */
static void test_no_threads(void **state)
{
  (void)state;
  struct um_thermal_network *network = grid_network(20);
  (void)solve_once(network, UM_THERMAL_LU, 1.0, 0.0);
  size_t before = count_threads();
  (void)solve_once(network, UM_THERMAL_CHOLESKY, 1.0, 0.0);
  assert_int_equal(count_threads(), before);
  um_thermal_network_destroy(&network);
}

static void test_residuals(void **state)
{
  (void)state;
  uint32_t interior;
  static const double gamma[3] = {1.0, 100.0, 1e5};
  struct um_thermal_network *plain = grid_network(20);
  struct um_thermal_network *skins = box_network(4, 77.4, &interior);
  struct um_thermal_network *massless = box_network(4, 0.0, &interior);
  for (int k = 0; k < 3; k++) {
    NEAR("conduction by KLU", solve_once(plain, UM_THERMAL_LU, gamma[k], 0.0), 0.0, 1e-13);
    NEAR("conduction by CHOLMOD", solve_once(plain, UM_THERMAL_CHOLESKY, gamma[k], 0.0), 0.0,
         1e-13);
    NEAR("skins by KLU", solve_once(skins, UM_THERMAL_LU, gamma[k], 0.0), 0.0, 1e-13);
    double skin = solve_once(skins, UM_THERMAL_CHOLESKY, gamma[k], 1e-11);
    double none = solve_once(massless, UM_THERMAL_CHOLESKY, gamma[k], 1e-11);
    print_message("gamma %g s: %.1e with skins, %.1e without mass\n", gamma[k], skin, none);
    NEAR("skins by CHOLMOD and GMRES", skin, 0.0, 1e-9);
    NEAR("massless skins by CHOLMOD and GMRES", none, 0.0, 1e-9);
  }
  um_thermal_network_destroy(&plain);
  um_thermal_network_destroy(&skins);
  um_thermal_network_destroy(&massless);
}

/* 25 conducting nodes are KLU's, 3600 CHOLMOD's; behind MLI 200 are KLU's. */
static void test_choice(void **state)
{
  (void)state;
  uint32_t interior;
  struct um_thermal_network *network[3] = {grid_network(5), grid_network(60),
                                           box_network(4, 77.4, &interior)};
  static const char *const method[3] = {"KLU", "CHOLMOD", "KLU"};
  for (int k = 0; k < 3; k++) {
    struct um_thermal_solve_options options;
    struct um_thermal_system *system = NULL;
    struct um_thermal_linear *linear = NULL;
    um_thermal_solve_defaults(&options);
    OK(um_thermal_system_create(help_context, network[k], NULL, &options, NULL, 0.0, UM_SYSTEM_RUN,
                                &system));
    OK(um_thermal_linear_create(system, &linear));
    assert_string_equal(um_thermal_linear_method(linear), method[k]);
    um_thermal_linear_destroy(&linear);
    um_thermal_system_destroy(&system);
    um_thermal_network_destroy(&network[k]);
  }
}

/* What is not positive definite is KLU's, solved all the same; a zero row is singular at its node.
 */
static void test_indefinite_and_singular(void **state)
{
  (void)state;
  struct um_thermal_network *network = grid_network(60);
  struct um_thermal_solve_options options;
  struct um_thermal_system *system = NULL;
  struct um_thermal_linear *linear = NULL;
  char text[256];
  um_thermal_solve_defaults(&options);
  OK(um_thermal_system_create(help_context, network, NULL, &options, NULL, 0.0, UM_SYSTEM_RUN,
                              &system));
  OK(um_thermal_linear_create(system, &linear));
  size_t n = system->nunknown;
  double *value = calloc(system->nnonzero + 2 * n, sizeof *value), *x = value + system->nnonzero;
  assert_non_null(value);
  for (size_t k = 0; k < n; k++) {
    value[system->diagonal[k]] = k % 2 == 0 ? 1.0 : -2.0;
    x[k] = x[n + k] = 1.0 + (double)k;
  }
  OK(um_thermal_linear_factor(linear, value));
  assert_string_equal(um_thermal_linear_method(linear), "KLU");
  OK(um_thermal_linear_solve(linear, 1, 1e-12, x));
  NEAR("residual", residual(system, value, x, x + n), 0.0, 1e-15);
  assert_string_equal(um_thermal_linear_fault(linear, text, sizeof text), "");
  value[system->diagonal[17]] = 0.0;
  assert_int_equal(um_thermal_linear_factor(linear, value), UM_ERR_NUMERIC);
  if (strstr(um_thermal_linear_fault(linear, text, sizeof text), "singular at node 17") == NULL)
    fail_msg("'%s'", text);
  free(value);
  um_thermal_linear_destroy(&linear);
  um_thermal_system_destroy(&system);
  um_thermal_network_destroy(&network);
}

/* One orbit by either: Newton's iteration ends at 1e-4 of the error test of 2e-7 and 2e-5 K, and
 * both take the same steps but for that; 1e-5 K. */
static void test_runs(void **state)
{
  (void)state;
  uint32_t interior;
  struct um_thermal_network *network = box_network(4, 77.4, &interior);
  struct um_irradiation_loads *loads = box_loads(4, 61, 6000.0, 3.0);
  struct um_thermal_history *history[2];
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  const double times[2] = {2500.0, 6000.0};
  double *steady[2], *periodic[2], drift, worst[3] = {0.0, 0.0, 0.0};
  size_t n = um_thermal_network_nodes(network);
  for (int k = 0; k < 2; k++) {
    options.factors = k == 0 ? UM_THERMAL_LU : UM_THERMAL_CHOLESKY;
    steady[k] = calloc(2 * n, sizeof(double));
    assert_non_null(steady[k]);
    periodic[k] = steady[k] + n;
    OK(um_thermal_solve(help_context, network, loads, &options, NULL, 0.0, times, 2, &history[k]));
    OK(um_thermal_solve_steady(help_context, network, loads, 0, &options, NULL, steady[k]));
    OK(um_thermal_solve_periodic(help_context, network, loads, &options, NULL, 0.0, 6000.0, 1e-4,
                                 periodic[k], &drift));
  }
  for (size_t i = 0; i < 2 * n; i++)
    worst[0] = fmax(worst[0], fabs(history[0]->temperature[i] - history[1]->temperature[i]));
  for (size_t i = 0; i < n; i++) {
    worst[1] = fmax(worst[1], fabs(steady[0][i] - steady[1][i]));
    worst[2] = fmax(worst[2], fabs(periodic[0][i] - periodic[1][i]));
  }
  print_message("LU to Cholesky: run %.1e K, steady %.1e K, periodic %.1e K\n", worst[0], worst[1],
                worst[2]);
  NEAR("run", worst[0], 0.0, 5e-4);
  NEAR("steady", worst[1], 0.0, 1e-6);
  NEAR("periodic", worst[2], 0.0, 1e-3); /* of several orbits */
  for (int k = 0; k < 2; k++) {
    um_thermal_history_destroy(help_context, &history[k]);
    free(steady[k]);
  }
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    cmocka_unit_test(test_short_of_memory),
#endif
    cmocka_unit_test(test_no_threads),
    cmocka_unit_test(test_residuals),
    cmocka_unit_test(test_choice),
    cmocka_unit_test(test_indefinite_and_singular),
    cmocka_unit_test(test_runs),
  };
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
