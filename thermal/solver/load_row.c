/* See load_row_impl.h. */
#include "thermal/solver/load_row_impl.h"

#include <string.h>

#include "base/core/constants.h"
#include "base/core/interpolation.h"
#include "thermal/network/load_angle_group.h"
#include "thermal/network/surface_aging_group.h"

void um_thermal_load_row_take(const struct um_thermal_network *network,
                              const struct um_irradiation_loads *loads,
                              const struct um_thermal_aging *aging, size_t row, size_t s,
                              struct um_thermal_load_taken *out)
{
  const struct um_thermal_surface *surface = &network->surface[s];
  size_t at = row * loads->nsurface + s;
  double absorptance = um_thermal_aged_absorptance(network, aging, row, s);
  double emittance = surface->emittance * um_thermal_aged_emittance(aging, row, s);
  double taken = absorptance - surface->extraction;
  out->albedo = um_thermal_load_albedo(surface, loads, at, absorptance);
  out->planet = um_thermal_load_planet(surface, loads, at, emittance);
  if (surface->law != NULL) {
    taken *= um_thermal_load_angle(surface->law, loads, at);
    absorptance *= surface->law->albedo;
    emittance *= surface->law->planet;
  }
  out->sun = taken * (double)loads->sun[at];
  out->absorptance = absorptance;
  out->emittance = emittance;
}

void um_thermal_load_row_sum(const struct um_thermal_network *network,
                             const struct um_irradiation_loads *loads,
                             const struct um_thermal_aging *aging,
                             const struct um_thermal_exchange *exchange, size_t row, double *sun,
                             double *albedo, double *planet, double *gas)
{
  size_t n = network->nnode, at = row * loads->nsurface;
  memset(sun, 0, n * sizeof *sun);
  memset(albedo, 0, n * sizeof *albedo);
  memset(planet, 0, n * sizeof *planet);
  if (gas != NULL) memset(gas, 0, n * sizeof *gas);
  for (size_t s = 0; s < network->noutside; s++) {
    const struct um_thermal_surface *surface = &network->surface[s];
    struct um_thermal_load_taken of;
    if (!network->attached[s]) continue;
    um_thermal_load_row_take(network, loads, aging, row, s, &of);
    if (exchange != NULL) {
      const struct um_thermal_reflected *r = &exchange->reflected;
      of.sun += of.absorptance * um_thermal_reflected_at(exchange, r->sun, row, s);
      of.albedo += of.absorptance * um_thermal_reflected_at(exchange, r->albedo, row, s);
      of.planet += of.emittance * um_thermal_reflected_at(exchange, r->planet, row, s);
    }
    for (int k = 0; k < 3; k++) {
      uint32_t node = surface->node[k];
      if (node == UM_THERMAL_SPACE) continue;
      double area = surface->weight[k] * surface->area;
      sun[node] += area * of.sun;
      albedo[node] += area * of.albedo;
      planet[node] += area * of.planet;
      if (loads->gas != NULL) gas[node] += area * (double)loads->gas[at + s];
    }
  }
}

double um_thermal_load_row_emission(const struct um_thermal_network *network,
                                    const struct um_thermal_aging *aging, size_t row,
                                    size_t surface, int k)
{
  const struct um_thermal_surface *at = &network->surface[surface];
  return UM_STEFAN_BOLTZMANN * at->weight[k] * um_thermal_surface_emission(at) *
         (at->inside ? 1.0 : um_thermal_aged_emittance(aging, row, surface));
}

struct um_thermal_load_interval
um_thermal_load_interval_find(const struct um_irradiation_loads *loads, double t)
{
  size_t last = loads->ntime - 1;
  size_t low = last > 0 ? um_core_interval_find(loads->t, loads->ntime, t) : 0;
  size_t high = low < last ? low + 1 : low;
  double width = loads->t[high] - loads->t[low];
  double u = width > 0.0 ? (t - loads->t[low]) / width : 0.0;
  return (struct um_thermal_load_interval){low, high, u < 0.0 ? 0.0 : u > 1.0 ? 1.0 : u};
}
