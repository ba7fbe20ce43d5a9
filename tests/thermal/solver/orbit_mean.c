/* Where the periodic state of a spinning box moves to when the box moves, from the mean balance
 * alone, against periodic states: slow nodes are met to a thousandth of their way. */
#include "tests/thermal/box_help.h"

#include <stdlib.h>

#include "thermal/network/network_group.h"

#define CELLS  2
#define PERIOD 6000.0
#define SKINS  (6 * CELLS * CELLS)

enum move { AS_IT_IS, POWER, SKINS_EMIT, BLANKETS, HISTORY };

static struct um_thermal_network *moved(enum move move, uint32_t *interior)
{
  struct um_thermal_network *network = box_network(CELLS, 77.4, interior);
  static const double t[3] = {-1.0, 1500.0, PERIOD}, power[3] = {0.0, 240.0, 240.0};
  const double one = 1.0;
  const struct um_thermal_source history = {.node = interior,
                                            .weight = &one,
                                            .nnode = 1,
                                            .t = t,
                                            .power = power,
                                            .nrow = 3,
                                            .stepwise = true};
  if (move == POWER) network->node[*interior].power += 180.0; /* the mean of the history */
  for (size_t s = 0; s < SKINS && move == SKINS_EMIT; s++) network->surface[s].emittance *= 0.85;
  for (size_t k = 0; k < network->nradiator && move == BLANKETS; k++)
    network->radiator[k].value *= 2.0;
  if (move == HISTORY) OK(um_thermal_network_source_add(network, &history));
  return network;
}

static void mean_find(const struct um_thermal_network *network,
                      const struct um_irradiation_loads *loads,
                      const struct um_thermal_solve_options *options, double *start, double *mean)
{
  struct um_thermal_periodic report;
  OK(um_thermal_solve_periodic_report(help_context, network, loads, options, NULL, 0.0, PERIOD,
                                      1e-3, start, NULL, mean, &report));
}

static void test_moves(void **state)
{
  (void)state;
  static const struct {
    enum move move;
    const char *name;
    double least; /* the interior moves by more than that [K] */
  } all[] = {{AS_IT_IS, "as it is", 0.0},
             {POWER, "180 W inside", 5.0},
             {SKINS_EMIT, "emittance of skins", 2.0},
             {BLANKETS, "blankets", 1.0},
             {HISTORY, "a power history", 5.0}};
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  uint32_t interior;
  struct um_thermal_network *base = moved(AS_IT_IS, &interior);
  struct um_irradiation_loads *loads = box_loads(CELLS, 121, PERIOD, 3.0);
  size_t n = base->nnode;
  double *work = calloc(5 * n, sizeof *work), *start = work, *mean = work + n,
         *residual = work + 2 * n, *found = work + 3 * n, *expected = work + 4 * n;
  assert_non_null(work);
  mean_find(base, loads, &options, start, mean);
  OK(um_thermal_orbit_mean_residual(help_context, base, loads, &options, 0.0, PERIOD, mean,
                                    residual));
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) {
    struct um_thermal_network *network = moved(all[k].move, &interior);
    memcpy(found, mean, n * sizeof *found);
    OK(um_thermal_orbit_mean_solve(help_context, network, loads, &options, 0.0, PERIOD, residual,
                                   found));
    mean_find(network, loads, &options, start, expected);
    double way = expected[interior] - mean[interior], off = found[interior] - expected[interior];
    print_message("%-20s the interior moves %8.3f K, found %8.4f K beside it\n", all[k].name, way,
                  off);
    assert_true(fabs(way) >= all[k].least);
    if (all[k].move == AS_IT_IS)
      for (size_t i = 0; i < n; i++) NEAR("node", found[i], mean[i], 1e-6);
    NEAR(all[k].name, off, 0.0, 2e-3 + 1e-3 * fabs(way));
    um_thermal_network_destroy(&network);
  }
  free(work);
  um_irradiation_loads_destroy(help_context, &loads);
  um_thermal_network_destroy(&base);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_moves)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
