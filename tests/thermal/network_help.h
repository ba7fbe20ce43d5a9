/* Small networks for the tests of thermal/: nothing here may fail, so failures stop the test. */
#ifndef UMBRA_TESTS_THERMAL_NETWORK_HELP_H
#define UMBRA_TESTS_THERMAL_NETWORK_HELP_H

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "tests/support/near.h"
#include "thermal/solver/solve.h"

#define OK(call)                                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(help_context));                 \
  } while (0)

#define NEAR(what, value, expected, tolerance) check_near(what, value, expected, tolerance)

static struct um_context *help_context;

static int help_setup(void **state)
{
  (void)state;
  return um_core_context_create(NULL, &help_context) == UM_OK ? 0 : 1;
}
static int help_teardown(void **state)
{
  (void)state;
  um_core_context_destroy(&help_context);
  return 0;
}

static inline struct um_thermal_network *help_network(void)
{
  struct um_thermal_network *network = NULL;
  OK(um_thermal_network_create(help_context, &network));
  return network;
}

static inline uint32_t help_node(struct um_thermal_network *network, double capacity,
                                 double temperature)
{
  uint32_t index = 0;
  OK(um_thermal_network_node_add(network, NULL, UM_NODE_DIFFUSIVE, capacity, temperature, 0.0,
                                 &index));
  return index;
}
static inline uint32_t help_boundary(struct um_thermal_network *network, double temperature)
{
  uint32_t index = 0;
  OK(um_thermal_network_node_add(network, NULL, UM_NODE_BOUNDARY, 0.0, temperature, 0.0, &index));
  return index;
}
static inline uint32_t help_arithmetic(struct um_thermal_network *network, double temperature)
{
  uint32_t index = 0;
  OK(um_thermal_network_node_add(network, NULL, UM_NODE_ARITHMETIC, 0.0, temperature, 0.0, &index));
  return index;
}

/* One surface on one node. */
static inline void help_surface(struct um_thermal_network *network, uint32_t surface, uint32_t node,
                                double area, double absorptance, double emittance)
{
  struct um_thermal_surface s = {.node = {node, UM_THERMAL_SPACE, UM_THERMAL_SPACE},
                                 .weight = {1.0, 0.0, 0.0},
                                 .area = area,
                                 .absorptance = absorptance,
                                 .emittance = emittance};
  OK(um_thermal_network_surface_attach(network, surface, &s));
}

static inline struct um_thermal_solve_options help_options(double relative, double absolute,
                                                           double space)
{
  struct um_thermal_solve_options options;
  um_thermal_solve_defaults(&options);
  options.relative_tolerance = relative;
  options.absolute_tolerance = absolute;
  options.space_temperature = space;
  return options;
}

/* Temperature of `node` at time t of a run from 0 with tight tolerances, no loads. */
static inline double help_temperature_at(const struct um_thermal_network *network, double space,
                                         uint32_t node, double t)
{
  struct um_thermal_solve_options options = help_options(1e-10, 1e-9, space);
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, network, NULL, &options, NULL, 0.0, &t, 1, &history));
  double temperature = history->temperature[node];
  if (!(history->audit_error <= 1e-6)) fail_msg("audit %g", history->audit_error);
  um_thermal_history_destroy(help_context, &history);
  return temperature;
}

#endif
