/* Reading a state: heat flows of the nodes and temperatures of the surfaces. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "thermal/network/surface_aging_group.h"
#include "thermal/solver/load_row_impl.h"
#include "thermal/solver/solve.h"
#include "thermal/solver/system_group.h"

/* u times the emission to space at a row. */
static void emission_add(const struct um_thermal_network *network,
                         const struct um_thermal_aging *aging, size_t row, double u,
                         const double *temperature, double space4, struct um_thermal_heat *out)
{
  for (size_t s = 0; s < network->nsurface; s++) {
    const struct um_thermal_surface *surface = &network->surface[s];
    for (int k = 0; k < 3 && network->attached[s]; k++) {
      uint32_t node = surface->node[k];
      double slope;
      if (node == UM_THERMAL_SPACE) continue;
      out[node].radiated -=
          u * um_thermal_load_row_emission(network, aging, row, s, k) *
          um_thermal_surface_law_emittance(surface->law, temperature[node], &slope) *
          (pow(temperature[node], 4) - space4);
    }
  }
}

/* Loads at t, constant outside the table, and emission of the surfaces to space; equations in
 * load_row_impl.h. */
static enum um_status surfaces_add(struct um_context *context,
                                   const struct um_thermal_network *network,
                                   const struct um_irradiation_loads *loads,
                                   const struct um_thermal_solve_options *options, double t,
                                   const double *temperature, double space4,
                                   struct um_thermal_heat *out)
{
  size_t n = network->nnode;
  double *memory = NULL;
  const struct um_thermal_aging *aging = loads == NULL ? NULL : options->aging;
  struct um_thermal_load_interval at = {0, 0, 0.0};
  UM_TRY(um_core_allocate(context, 4 * n, sizeof *memory, &memory));
  double *sun = memory, *albedo = sun + n, *planet = albedo + n, *gas = planet + n;
  if (loads != NULL) at = um_thermal_load_interval_find(loads, t);
  for (int k = 0; k < 2; k++) {
    size_t row = k == 0 ? at.low : at.high;
    double u = k == 0 ? 1.0 - at.u : at.u;
    emission_add(network, aging, row, u, temperature, space4, out);
    if (loads == NULL) break;
    double irradiance =
        (1.0 - at.u) * loads->irradiance[at.low] + at.u * loads->irradiance[at.high];
    double sunlit = (1.0 - at.u) * loads->sunlit[at.low] + at.u * loads->sunlit[at.high];
    um_thermal_load_row_sum(network, loads, aging, options->exchange, row, sun, albedo, planet,
                            loads->gas == NULL ? NULL : gas);
    for (size_t i = 0; i < n; i++) {
      out[i].solar += u * irradiance * sunlit * sun[i];
      if (options->albedo_on) out[i].albedo += u * albedo[i];
      if (options->planet_on) out[i].planet += u * planet[i];
      if (loads->gas != NULL) out[i].planet += u * gas[i];
    }
  }
  um_core_free(context, memory);
  return UM_OK;
}

static double by_law(const struct um_thermal_network *network, const struct um_thermal_link *link,
                     bool conducts, const double *temperature)
{
  double out, in;
  double linear = conducts ? link->value : 0.0;
  double fourth = conducts ? 0.0 : UM_STEFAN_BOLTZMANN * link->value;
  return um_thermal_link_law_heat(&network->link_law[link->law], linear, fourth,
                                  temperature[link->a], temperature[link->b], &out, &in);
}

static void links_add(const struct um_thermal_network *network, const double *temperature,
                      double space4, struct um_thermal_heat *out)
{
  for (size_t k = 0; k < network->nconductor; k++) {
    const struct um_thermal_link *link = &network->conductor[k];
    double flow = link->value * (temperature[link->b] - temperature[link->a]);
    if (link->law != UM_THERMAL_NO_LAW) flow = by_law(network, link, true, temperature);
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
      if (link->law != UM_THERMAL_NO_LAW) flow = by_law(network, link, false, temperature);
      out[link->a].exchanged += flow;
      out[link->b].exchanged -= flow;
    }
  }
}

/* Emittance of a surface without its law at t over that of the exchange. */
static double emittance_ratio(const struct um_thermal_network *network,
                              const struct um_irradiation_loads *loads,
                              const struct um_thermal_solve_options *options, double t, size_t s)
{
  const struct um_thermal_surface *surface = &network->surface[s];
  double made = options->exchange->emittance[s];
  if (!(made > 0.0)) return 0.0;
  if (loads == NULL || options->aging == NULL || surface->inside) return surface->emittance / made;
  struct um_thermal_load_interval at = um_thermal_load_interval_find(loads, t);
  double aged = (1.0 - at.u) * um_thermal_aged_emittance(options->aging, at.low, s) +
                at.u * um_thermal_aged_emittance(options->aging, at.high, s);
  return surface->emittance * aged / made;
}

/* What patches receive of each other, and what of their emission is received: that is exchanged,
 * and not lost to space as surfaces_add has it. */
static enum um_status exchange_add(struct um_context *context,
                                   const struct um_thermal_network *network,
                                   const struct um_irradiation_loads *loads,
                                   const struct um_thermal_solve_options *options, double t,
                                   const double *temperature, double space4,
                                   struct um_thermal_heat *out)
{
  enum um_status status;
  const struct um_thermal_exchange *x = options->exchange;
  struct um_thermal_mix mix;
  double *work = NULL;
  size_t n = x->npatch;
  UM_CHECK(um_core_allocate(context, 4 * n, sizeof *work, &work));
  double *power4 = work, *heat = work + n, *one = work + 2 * n, *sent = work + 3 * n;
  for (size_t p = 0; p < n; p++) one[p] = 1.0;
  um_thermal_exchange_mix(x, t, &mix);
  um_thermal_exchange_apply(x, x->between, &mix, 1, one, sent); /* [W/K^4] */
  for (int pass = 0; pass < 2; pass++) {
    for (size_t s = 0; s < network->nsurface; s++) {
      const struct um_thermal_surface *surface = &network->surface[s];
      uint32_t p = x->patch[s];
      double ratio = p != UM_THERMAL_NO_PATCH && network->attached[s]
                         ? emittance_ratio(network, loads, options, t, s)
                         : 0.0;
      for (int c = 0; c < 3 && network->attached[s] && p != UM_THERMAL_NO_PATCH; c++) {
        uint32_t node = surface->node[c];
        if (node == UM_THERMAL_SPACE) continue;
        double share = surface->weight[c] * surface->area / x->area[p];
        double slope, own = ratio * (pow(temperature[node], 4) - space4);
        own *= um_thermal_surface_law_emittance(surface->law, temperature[node], &slope);
        if (pass == 0) {
          power4[p] += share * own;
        } else {
          out[node].exchanged += share * (heat[p] - sent[p] * own);
          out[node].radiated += share * sent[p] * own;
        }
      }
    }
    if (pass == 0) um_thermal_exchange_apply(x, x->between, &mix, 1, power4, heat);
  }
done:
  um_core_free(context, work);
  return status;
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
  if (loads != NULL && loads->nsurface < network->noutside)
    return um_core_fail(context, UM_ERR_INPUT,
                        "heat loads of %zu surfaces for a network with %zu; accepted: as many",
                        loads->nsurface, network->noutside);
  double space4 = pow(options->space_temperature, 4);
  for (size_t i = 0; i < network->nnode; i++)
    out[i] = (struct um_thermal_heat){.internal = network->node[i].power};
  for (size_t k = 0; k < network->nsource; k++)
    spread_add(&network->source[k].at, um_thermal_source_power(&network->source[k], t), out);
  links_add(network, temperature, space4, out);
  UM_TRY(surfaces_add(context, network, loads, options, t, temperature, space4, out));
  if (options->exchange != NULL && options->exchange->between != NULL)
    UM_TRY(exchange_add(context, network, loads, options, t, temperature, space4, out));
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
double um_thermal_surface_temperature(const struct um_thermal_surface *surface,
                                      const double *node_temperature)
{
  double sum = 0.0, only = 0.0;
  int used = 0;
  for (int k = 0; k < 3; k++) {
    if (surface->node[k] == UM_THERMAL_SPACE) continue;
    only = node_temperature[surface->node[k]];
    sum += surface->weight[k] * only * only * only * only;
    used++;
  }
  return used == 0 ? NAN : used == 1 ? only : sqrt(sqrt(sum));
}

void um_thermal_surface_temperatures(const struct um_thermal_network *network,
                                     const double *node_temperature, double *surface_temperature)
{
  for (size_t s = 0; s < network->noutside; s++)
    surface_temperature[s] =
        network->attached[s]
            ? um_thermal_surface_temperature(&network->surface[s], node_temperature)
            : NAN;
}

void um_thermal_surface_answers(const struct um_thermal_network *network,
                                const double *node_temperature, const float *answer,
                                double *surface_answer)
{
  for (size_t s = 0; s < network->noutside; s++) {
    const struct um_thermal_surface *surface = &network->surface[s];
    double sum = 0.0, slope = 0.0, only = 0.0;
    int used = 0;
    for (int k = 0; k < 3 && network->attached[s]; k++) {
      if (surface->node[k] == UM_THERMAL_SPACE) continue;
      double t = node_temperature[surface->node[k]], cube = surface->weight[k] * t * t * t;
      only = (double)answer[surface->node[k]];
      sum += cube * t;
      slope += cube * only;
      used++;
    }
    surface_answer[s] = used == 0 ? 0.0 : used == 1 ? only : slope / pow(sum, 0.75);
  }
}
