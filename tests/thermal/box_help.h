/* A spinning box with MLI and an interior on an orbit with a shadow, any number of nodes: enough
 * of a satellite for laws and timing. Loads are plausible, not traced.
 *
 *    face of m x m cells, six faces:  skin -- e* sigma --> wall cell -- in plane --> next wall cell
 *                                                        \-- K --> interior (slow)
 *    two-sided panel of 2 m x m cells: front -- U --> back, in plane on both */
#ifndef UMBRA_TESTS_THERMAL_BOX_HELP_H
#define UMBRA_TESTS_THERMAL_BOX_HELP_H

#include "tests/thermal/network_help.h"

static inline void box_couple_grid(struct um_thermal_network *network, uint32_t first, uint32_t nx,
                                   uint32_t ny, uint32_t stride, double conductance)
{
  for (uint32_t y = 0; y < ny; y++)
    for (uint32_t x = 0; x < nx; x++) {
      uint32_t a = first + stride * (y * nx + x);
      if (x + 1 < nx) OK(um_thermal_network_conductor_add(network, a, a + stride, conductance));
      if (y + 1 < ny)
        OK(um_thermal_network_conductor_add(network, a, a + stride * nx, conductance));
    }
}

/* Surfaces 0 .. 6 m^2 - 1: skins by face; then panel fronts and backs alternating, 4 m^2. */
static inline struct um_thermal_network *box_network(uint32_t m, double skin_capacity,
                                                     uint32_t *interior)
{
  struct um_thermal_network *network = help_network();
  double cell = 4.0 / (double)(m * m); /* 2 m faces [m^2] */
  OK(um_thermal_network_node_add(network, "interior", UM_NODE_DIFFUSIVE, 2e6, 285.0, 60.0,
                                 interior));
  uint32_t surface = 0;
  for (int face = 0; face < 6; face++) {
    uint32_t first = (uint32_t)um_thermal_network_nodes(network);
    for (uint32_t c = 0; c < m * m; c++) {
      uint32_t wall = help_node(network, 4860.0 * cell, 285.0);
      uint32_t skin = skin_capacity > 0.0 ? help_node(network, skin_capacity * cell, 260.0)
                                          : help_arithmetic(network, 260.0);
      help_surface(network, surface++, skin, cell, 0.38, 0.78);
      OK(um_thermal_network_radiator_add(network, skin, wall, 0.02 * cell));
      OK(um_thermal_network_conductor_add(network, wall, *interior, 1.0 * cell));
    }
    box_couple_grid(network, first, m, m, 2, 167.0 * 2e-3);
  }
  uint32_t first = (uint32_t)um_thermal_network_nodes(network);
  for (uint32_t c = 0; c < 2 * m * m; c++) {
    uint32_t front = help_node(network, 1600.0 * cell, 290.0);
    uint32_t back = help_node(network, 1600.0 * cell, 290.0);
    help_surface(network, surface++, front, cell, 0.8, 0.85);
    help_surface(network, surface++, back, cell, 0.6, 0.85);
    OK(um_thermal_network_conductor_add(network, front, back, 100.0 * cell));
  }
  box_couple_grid(network, first, 2 * m, m, 2, 0.5);
  box_couple_grid(network, first + 1, 2 * m, m, 2, 0.5);
  OK(um_thermal_network_conductor_add(network, first, *interior, 0.5));
  return network;
}

/* One period from 0 in ntime - 1 intervals; spins [1] turns per period, need not be whole. Penumbra
 * of two intervals at both ends of the shadow, edges given. */
static inline struct um_irradiation_loads *box_loads(uint32_t m, size_t ntime, double period,
                                                     double spins)
{
  const double normal[6] = {0.0, 90.0, 180.0, 270.0, 85.0, 95.0}; /* azimuth of faces [deg] */
  struct um_irradiation_loads *loads = NULL;
  size_t per_face = (size_t)m * m, nsurface = 10 * per_face;
  double step = period / (double)(ntime - 1);
  OK(um_irradiation_loads_create(help_context, ntime, nsurface, 4, &loads));
  const double edge[4] = {0.35 * period, 0.35 * period + 2.0 * step, 0.65 * period,
                          0.65 * period + 2.0 * step};
  memcpy(loads->edge, edge, sizeof edge);
  for (size_t k = 0; k < ntime; k++) {
    double t = step * (double)k, u = 2.0 * UM_PI * t / period;
    double in = fmin(1.0, fmax(0.0, (edge[1] - t) / (edge[1] - edge[0])));
    double out = fmin(1.0, fmax(0.0, (t - edge[2]) / (edge[3] - edge[2])));
    loads->t[k] = t;
    loads->sunlit[k] = fmax(in, out);
    loads->irradiance[k] = 1361.0;
    for (size_t s = 0; s < nsurface; s++) {
      size_t group = s < 6 * per_face ? s / per_face : 6 + s % 2;
      double azimuth = group < 6 ? normal[group] * UM_DEG : (double)(group - 6) * UM_PI + 0.3;
      azimuth += 2.0 * UM_PI * spins * t / period;
      double tilt = 0.9 + 0.1 * sin((double)(s % per_face)); /* no two cells alike */
      loads->sun[k * nsurface + s] = (float)(tilt * fmax(cos(azimuth), 0.0));
      loads->albedo[k * nsurface + s] =
          (float)(100.0 * tilt * fmax(cos(u), 0.0) * (1.0 + cos(azimuth + u)));
      loads->planet[k * nsurface + s] = (float)(90.0 * tilt * (1.0 + cos(azimuth + u)));
    }
  }
  return loads;
}

#endif
