/* See surface_aging_group.h. */
#include "thermal/network/surface_aging_group.h"

double um_thermal_aged_absorptance(const struct um_thermal_network *network,
                                   const struct um_thermal_aging *aging, size_t row, size_t s)
{
  double own = network->surface[s].absorptance;
  return aging == NULL ? own
                       : own + aging->absorptance[row * aging->nmaterial + aging->material[s]];
}

double um_thermal_aged_emittance(const struct um_thermal_aging *aging, size_t row, size_t s)
{
  return aging == NULL ? 1.0 : aging->emittance[row * aging->nmaterial + aging->material[s]];
}
