/* Reading a state: heat flows of the nodes and temperatures of the surfaces. */
#include <math.h>

#include "core/constants.h"
#include "core/interpolation.h"
#include "thermal/solve.h"
#include "thermal/system_impl.h"

/* Loads at t, constant outside the table; equation in system_loads.c. */
static void loads_add(const struct um_thermal_network *network,
                      const struct um_irradiation_loads *loads,
                      const struct um_thermal_solve_options *options, double t,
                      struct um_thermal_heat *out)
{
  size_t last = loads->ntime - 1;
  size_t k = last > 0 ? um_core_interval_find(loads->t, loads->ntime, t) : 0;
  size_t next = k < last ? k + 1 : k;
  double width = loads->t[next] - loads->t[k];
  double u = width > 0.0 ? (t - loads->t[k]) / width : 0.0;
  u = u < 0.0 ? 0.0 : u > 1.0 ? 1.0 : u;
  double irradiance = (1.0 - u) * loads->irradiance[k] + u * loads->irradiance[next];
  double sunlit = (1.0 - u) * loads->sunlit[k] + u * loads->sunlit[next];
  for (size_t s = 0; s < network->nsurface; s++) {
    if (!network->attached[s]) continue;
    const struct um_thermal_surface *surface = &network->surface[s];
    size_t a = k * loads->nsurface + s, b = next * loads->nsurface + s;
    double sun = (1.0 - u) * (double)loads->sun[a] + u * (double)loads->sun[b];
    double albedo = (1.0 - u) * (double)loads->albedo[a] + u * (double)loads->albedo[b];
    double planet = (1.0 - u) * (double)loads->planet[a] + u * (double)loads->planet[b];
    sun *= irradiance * sunlit;
    for (int c = 0; c < 3; c++) {
      uint32_t node = surface->node[c];
      if (node == UM_THERMAL_SPACE) continue;
      double area = surface->weight[c] * surface->area;
      out[node].solar += area * (surface->absorptance - surface->extraction) * sun;
      if (options->albedo_on) out[node].albedo += area * surface->absorptance * albedo;
      if (options->planet_on) out[node].planet += area * surface->emittance * planet;
    }
  }
}

static void links_add(const struct um_thermal_network *network, const double *temperature,
                      double space4, struct um_thermal_heat *out)
{
  for (size_t k = 0; k < network->nconductor; k++) {
    const struct um_thermal_link *link = &network->conductor[k];
    double flow = link->value * (temperature[link->b] - temperature[link->a]);
    out[link->a].conducted += flow;
    out[link->b].conducted -= flow;
  }
  for (size_t k = 0; k < network->nradiator; k++) {
    const struct um_thermal_link *link = &network->radiator[k];
    double factor = UM_STEFAN_BOLTZMANN * link->value;
    double own4 = pow(temperature[link->a], 4);
    if (link->b == UM_THERMAL_SPACE) {
      out[link->a].radiated -= factor * (own4 - space4);
    } else {
      double flow = factor * (pow(temperature[link->b], 4) - own4);
      out[link->a].exchanged += flow;
      out[link->b].exchanged -= flow;
    }
  }
}

/* Own emission of the surfaces. */
static void surfaces_add(const struct um_thermal_network *network, const double *temperature,
                         double space4, struct um_thermal_heat *out)
{
  for (size_t s = 0; s < network->nsurface; s++) {
    const struct um_thermal_surface *surface = &network->surface[s];
    for (int c = 0; c < 3 && network->attached[s]; c++) {
      uint32_t node = surface->node[c];
      if (node == UM_THERMAL_SPACE) continue;
      out[node].radiated -= UM_STEFAN_BOLTZMANN * surface->weight[c] *
                            um_thermal_surface_emission(surface) *
                            (pow(temperature[node], 4) - space4);
    }
  }
}

static void spread_add(const struct um_thermal_spread *at, double power,
                       struct um_thermal_heat *out)
{
  for (size_t i = 0; i < at->n; i++) out[at->node[i]].internal += at->weight[i] * power;
}

void um_thermal_heat_of_thermostats(const struct um_thermal_network *network, const bool *heating,
                                    struct um_thermal_heat *out)
{
  for (size_t k = 0; k < network->nthermostat; k++) {
    const struct um_thermal_spread *at = &network->thermostat[k].at;
    if (!heating[k]) continue;
    spread_add(at, network->thermostat[k].power, out);
    for (size_t i = 0; i < at->n; i++)
      out[at->node[i]].stored += at->weight[i] * network->thermostat[k].power;
  }
}

enum um_status um_thermal_heat_of_nodes(struct um_context *context,
                                        const struct um_thermal_network *network,
                                        const struct um_irradiation_loads *loads,
                                        const struct um_thermal_solve_options *options, double t,
                                        const double *temperature, struct um_thermal_heat *out)
{
  if (loads != NULL && loads->nsurface < network->nsurface)
    return um_core_fail(context, UM_ERR_INPUT,
                        "heat loads of %zu surfaces for a network with %zu; accepted: as many",
                        loads->nsurface, network->nsurface);
  double space4 = pow(options->space_temperature, 4);
  for (size_t i = 0; i < network->nnode; i++)
    out[i] = (struct um_thermal_heat){.internal = network->node[i].power};
  for (size_t k = 0; k < network->nsource; k++)
    spread_add(&network->source[k].at, um_thermal_source_power(&network->source[k], t), out);
  if (loads != NULL) loads_add(network, loads, options, t, out);
  links_add(network, temperature, space4, out);
  surfaces_add(network, temperature, space4, out);
  for (size_t i = 0; i < network->nnode; i++) {
    struct um_thermal_heat *h = &out[i];
    h->stored =
        h->solar + h->albedo + h->planet + h->internal + h->conducted + h->radiated + h->exchanged;
    if (!isfinite(h->stored))
      return um_core_fail(context, UM_ERR_NUMERIC, "heat of node %zu at t = %.6f s is not finite",
                          i, t);
  }
  return UM_OK;
}

/* T_s = (sum_k w_k T_k^4)^(1/4): a surface shows the temperature at which it radiates what the
 * heat balance lets it radiate. */
void um_thermal_surface_temperatures(const struct um_thermal_network *network,
                                     const double *node_temperature, double *surface_temperature)
{
  for (size_t s = 0; s < network->nsurface; s++) {
    const struct um_thermal_surface *surface = &network->surface[s];
    double sum = 0.0, only = 0.0;
    int used = 0;
    for (int k = 0; k < 3 && network->attached[s]; k++) {
      if (surface->node[k] == UM_THERMAL_SPACE) continue;
      only = node_temperature[surface->node[k]];
      sum += surface->weight[k] * only * only * only * only;
      used++;
    }
    surface_temperature[s] = used == 0 ? NAN : used == 1 ? only : sqrt(sqrt(sum));
  }
}
