/* The spinning box of box_help.h with everything by temperature: walls and panels store by two
 * laws, conduct in the plane by a table, blankets leak as Doenecke and Lockheed have it. */
#ifndef UMBRA_TESTS_THERMAL_LAW_HELP_H
#define UMBRA_TESTS_THERMAL_LAW_HELP_H

#include "base/core/constants.h"
#include "tests/thermal/box_help.h"
#include "thermal/network/network_group.h"

/* 1 + slope (T - 300 K): a line through the rows, no kinks. */
static inline struct um_thermal_ratio law_line(double slope)
{
  struct um_thermal_ratio ratio;
  for (size_t k = 0; k < UM_THERMAL_LAW_TEMPERATURES; k++)
    ratio.at[k] =
        fmax(0.05, 1.0 + slope * ((double)k * UM_THERMAL_LAW_STEP - UM_REFERENCE_TEMPERATURE));
  return ratio;
}

static inline void law_give(struct um_thermal_network *network)
{
  const struct um_thermal_ratio wall = law_line(1.4e-3), panel = law_line(2.7e-3),
                                metal = law_line(5e-4);
  const struct um_thermal_link_law conduction = {.power = 4.0, .table = &metal};
  const struct um_thermal_link_law law[2] = {
      {.power = 4.0, .factor = {0.55, 0.45}, .exponent = {-2.0, 0.667}},
      {.power = 4.67, .factor = {1.0}, .exponent = {0.3}}};
  uint32_t store[2], link, blanket[2];
  OK(um_thermal_network_capacity_law_add(network, &wall, &store[0]));
  OK(um_thermal_network_capacity_law_add(network, &panel, &store[1]));
  OK(um_thermal_network_link_law_add(network, &conduction, &link));
  for (int k = 0; k < 2; k++) OK(um_thermal_network_link_law_add(network, &law[k], &blanket[k]));
  for (uint32_t i = 1; i < network->nnode; i++) {
    double capacity = network->node[i].capacity;
    if (!(capacity > 0.0)) continue;
    OK(um_thermal_network_capacity_follow(network, i, 0.6 * capacity, store[i % 2]));
    if (i % 3 == 0) OK(um_thermal_network_capacity_follow(network, i, 0.3 * capacity, store[0]));
  }
  for (size_t k = 0; k < network->nconductor; k++)
    if (k % 3 != 1) network->conductor[k].law = link;
  for (size_t k = 0; k < network->nradiator; k++)
    if (network->radiator[k].b != UM_THERMAL_SPACE) network->radiator[k].law = blanket[k % 2];
}

#endif
