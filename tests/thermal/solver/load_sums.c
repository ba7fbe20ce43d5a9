/* Kept rows of the loads serve a network next to theirs: its own sums to rounding. */
#include <math.h>
#include <stdlib.h>

#include "tests/thermal/box_help.h"
#include "thermal/solver/load_sums_impl.h"
#include "thermal/solver/solve.h"

#define CELLS   2u
#define ROWS    13
#define PATCHES 5

enum move { AS_IT_IS, EMITS, ABSORBS, EXTRACTS, BY_ANGLE, ANOTHER_NODE };

static struct um_thermal_surface_law law_of(void)
{
  struct um_thermal_surface_law law = {.albedo = 0.9, .planet = 1.1};
  for (size_t i = 0; i < UM_THERMAL_LAW_ANGLES; i++) law.absorptance[i] = 1.0 - 0.002 * (double)i;
  for (size_t i = 0; i < UM_THERMAL_LAW_TEMPERATURES; i++) law.emittance[i] = 1.0;
  return law;
}

static struct um_thermal_network *moved(enum move move, const struct um_thermal_surface_law *law)
{
  uint32_t interior;
  struct um_thermal_network *network = box_network(CELLS, 77.4, &interior);
  for (size_t s = 3; s < 9; s++) {
    struct um_thermal_surface *surface = &network->surface[s];
    if (move == EMITS) surface->emittance *= 0.7;
    if (move == ABSORBS) surface->absorptance *= 0.6;
    if (move == EXTRACTS) surface->extraction = 0.1;
    if (move == BY_ANGLE) surface->law = law;
    if (move == ANOTHER_NODE) surface->node[0] = interior;
  }
  return network;
}

/* What patches of five surfaces each receive of each other's light. */
static void exchange_fill(struct um_thermal_exchange *x, size_t nsurface)
{
  *x = (struct um_thermal_exchange){.nsurface = nsurface, .npatch = PATCHES};
  x->patch = calloc(nsurface, sizeof *x->patch);
  double **table[3] = {&x->reflected.sun, &x->reflected.albedo, &x->reflected.planet};
  for (size_t s = 0; s < nsurface; s++)
    x->patch[s] = s % 7 == 0 ? UM_THERMAL_NO_PATCH : (uint32_t)(s % PATCHES);
  for (size_t k = 0; k < 3; k++) {
    *table[k] = calloc((size_t)ROWS * PATCHES, sizeof **table[k]);
    for (size_t i = 0; i < (size_t)ROWS * PATCHES; i++)
      (*table[k])[i] = (k == 0 ? 0.01 : 9.0) * (1.0 + sin((double)(i + 40 * k)));
  }
}

static void rows_agree(const struct um_thermal_load_near *near,
                       const struct um_thermal_network *network,
                       const struct um_irradiation_loads *loads,
                       const struct um_thermal_exchange *exchange)
{
  size_t n = network->nnode;
  double *all = calloc(6 * n, sizeof *all), *kept[3], *own[3];
  assert_non_null(all);
  for (size_t k = 0; k < 3; k++) {
    kept[k] = all + k * n;
    own[k] = all + (3 + k) * n;
  }
  for (size_t row = 0; row < ROWS; row++) {
    um_thermal_load_near_row(near, network, exchange, row, kept[0], kept[1], kept[2]);
    um_thermal_load_row_sum(network, loads, NULL, exchange, row, own[0], own[1], own[2], NULL);
    for (size_t k = 0; k < 3; k++)
      for (size_t i = 0; i < n; i++)
        NEAR("load of a node", kept[k][i], own[k][i], 1e-13 * (k == 0 ? 10.0 : 1e3));
  }
  free(all);
}

static void test_rows(void **state)
{
  (void)state;
  struct um_thermal_surface_law law = law_of();
  struct um_thermal_network *base = moved(AS_IT_IS, &law);
  struct um_irradiation_loads *loads = box_loads(CELLS, ROWS, 6000.0, 3.0);
  struct um_thermal_exchange exchange;
  struct um_thermal_load_sums *sums = NULL;
  exchange_fill(&exchange, base->nsurface);
  OK(um_thermal_load_sums_create(help_context, base, loads, &sums));
  assert_non_null(sums);
  for (int move = AS_IT_IS; move <= BY_ANGLE; move++)
    for (int reflects = 0; reflects < 2; reflects++) {
      const struct um_thermal_exchange *between = reflects == 1 ? &exchange : NULL;
      struct um_thermal_network *network = moved((enum move)move, &law);
      struct um_thermal_load_near *near = NULL;
      OK(um_thermal_load_near_make(help_context, sums, network, loads, NULL, between, &near));
      assert_non_null(near);
      rows_agree(near, network, loads, between);
      um_thermal_load_near_destroy(help_context, &near);
      um_thermal_network_destroy(&network);
    }
  um_thermal_load_sums_destroy(help_context, &sums);
  free(exchange.patch);
  free(exchange.reflected.sun);
  free(exchange.reflected.albedo);
  free(exchange.reflected.planet);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&base);
}

/* Other loads, other nodes, surfaces that age: they do not serve. */
static void test_where_they_do_not_serve(void **state)
{
  (void)state;
  struct um_thermal_surface_law law = law_of();
  struct um_thermal_network *base = moved(AS_IT_IS, &law), *other = moved(ANOTHER_NODE, &law);
  struct um_irradiation_loads *loads = box_loads(CELLS, ROWS, 6000.0, 3.0);
  struct um_irradiation_loads *alike = box_loads(CELLS, ROWS, 6000.0, 3.0);
  const struct um_thermal_aging aging = {0};
  struct um_thermal_load_sums *sums = NULL;
  struct um_thermal_load_near *near = NULL;
  OK(um_thermal_load_sums_create(help_context, base, loads, &sums));
  OK(um_thermal_load_near_make(help_context, sums, other, loads, NULL, NULL, &near));
  assert_null(near);
  OK(um_thermal_load_near_make(help_context, sums, base, alike, NULL, NULL, &near));
  assert_null(near);
  OK(um_thermal_load_near_make(help_context, sums, base, loads, &aging, NULL, &near));
  assert_null(near);
  OK(um_thermal_load_near_make(help_context, NULL, base, loads, NULL, NULL, &near));
  assert_null(near);
  um_thermal_load_sums_destroy(help_context, &sums);
  um_irradiation_loads_destroy(help_context, &loads);
  um_irradiation_loads_destroy(help_context, &alike);
  um_thermal_network_destroy(&base);
  um_thermal_network_destroy(&other);
}

/* A solution takes them, and differs by rounding alone. */
static void test_solution(void **state)
{
  (void)state;
  static const double times[2] = {3000.0, 6000.0};
  struct um_thermal_surface_law law = law_of();
  struct um_thermal_network *base = moved(AS_IT_IS, &law), *network = moved(EMITS, &law);
  struct um_irradiation_loads *loads = box_loads(CELLS, ROWS, 6000.0, 3.0);
  struct um_thermal_load_sums *sums = NULL;
  struct um_thermal_history *own = NULL, *kept = NULL;
  struct um_thermal_solve_options options = help_options(1e-9, 1e-8, 2.7);
  OK(um_thermal_load_sums_create(help_context, base, loads, &sums));
  OK(um_thermal_solve(help_context, network, loads, &options, NULL, 0.0, times, 2, &own));
  options.sums = sums;
  options.no_audit = true;
  OK(um_thermal_solve(help_context, network, loads, &options, NULL, 0.0, times, 2, &kept));
  for (size_t i = 0; i < 2 * own->nnode; i++)
    NEAR("temperature", kept->temperature[i], own->temperature[i], 1e-5);
  assert_true(own->audit_error < 1e-6);
  assert_true(isnan(kept->audit_error)); /* nobody asked */
  um_thermal_history_destroy(help_context, &own);
  um_thermal_history_destroy(help_context, &kept);
  um_thermal_load_sums_destroy(help_context, &sums);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&base);
  um_thermal_network_destroy(&network);
}

/* The audit looks on: temperatures have the same bits without it. */
static void test_no_audit(void **state)
{
  (void)state;
  static const double times[2] = {3000.0, 6000.0};
  struct um_thermal_surface_law law = law_of();
  struct um_thermal_network *network = moved(AS_IT_IS, &law);
  struct um_irradiation_loads *loads = box_loads(CELLS, ROWS, 6000.0, 3.0);
  struct um_thermal_history *history[2] = {NULL, NULL};
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  for (int k = 0; k < 2; k++) {
    options.no_audit = k == 1;
    OK(um_thermal_solve(help_context, network, loads, &options, NULL, 0.0, times, 2, &history[k]));
  }
  assert_memory_equal(history[0]->temperature, history[1]->temperature,
                      2 * network->nnode * sizeof(double));
  for (int k = 0; k < 2; k++) um_thermal_history_destroy(help_context, &history[k]);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&network);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_rows), cmocka_unit_test(test_where_they_do_not_serve),
      cmocka_unit_test(test_solution), cmocka_unit_test(test_no_audit)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
