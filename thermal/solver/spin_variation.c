/* See spin_variation.h. */
#include "thermal/solver/spin_variation.h"

#include <math.h>

#include "base/core/constants.h"
#include "thermal/solver/load_row_impl.h"

#define HALF_WAVE   0.55  /* half the range of the integral of max(cos, 0) - 1/pi over the angle */
#define TEMPERATURE 300.0 /* at which what a node gives away is taken [K] */

/* What surfaces bring and take: q [nnode] [W], g [nnode] [W/K]. */
static void surfaces_add(const struct um_thermal_network *network, double of_sun, double of_earth,
                         double slope, double *q, double *g)
{
  for (size_t s = 0; s < network->nsurface; s++) {
    const struct um_thermal_surface *surface = &network->surface[s];
    for (int k = 0; network->attached[s] && k < 3; k++) {
      uint32_t node = surface->node[k];
      if (node == UM_THERMAL_SPACE) continue;
      double area = surface->weight[k] * surface->area;
      g[node] += slope * area * surface->emittance;
      if (s < network->noutside)
        q[node] += area * (surface->absorptance * of_sun + surface->emittance * of_earth);
    }
  }
}

static void links_add(const struct um_thermal_link *link, size_t n, double factor, double *g)
{
  for (size_t e = 0; e < n; e++) {
    double each = factor * fabs(link[e].value);
    g[link[e].a] += each;
    if (link[e].b != UM_THERMAL_SPACE) g[link[e].b] += each;
  }
}

static void worst_find(const struct um_thermal_network *network, double period, const double *q,
                       const double *g, struct um_thermal_spin_variation *out)
{
  for (size_t i = 0; i < network->nnode; i++) {
    const struct um_thermal_network_node *node = &network->node[i];
    if (node->kind == UM_NODE_BOUNDARY || !(q[i] > 0.0)) continue;
    double still = period / (2.0 * UM_PI * node->capacity); /* [K/W] */
    double amplitude = HALF_WAVE * q[i] * still;
    double error = amplitude * (2.0 * g[i] * still + 0.75 * amplitude / TEMPERATURE);
    if (!(node->capacity > 0.0)) amplitude = error = INFINITY;
    out->amplitude = fmax(out->amplitude, amplitude);
    if (!(error > out->error)) continue;
    out->error = error;
    out->node = (uint32_t)i;
  }
}

enum um_status um_thermal_spin_variation_bound(struct um_context *context,
                                               const struct um_thermal_network *network,
                                               double period, double sun, double albedo,
                                               double longwave,
                                               struct um_thermal_spin_variation *out)
{
  const double slope = 4.0 * UM_STEFAN_BOLTZMANN * TEMPERATURE * TEMPERATURE * TEMPERATURE;
  double *q = NULL;
  *out = (struct um_thermal_spin_variation){0.0, 0.0, 0};
  UM_TRY(um_core_allocate(context, 2 * network->nnode, sizeof *q, &q));
  double *g = q + network->nnode;
  surfaces_add(network, sun * (1.0 + albedo), longwave, slope, q, g);
  links_add(network->conductor, network->nconductor, 1.0, g);
  links_add(network->radiator, network->nradiator, slope, g);
  worst_find(network, period, q, g, out);
  um_core_free(context, q);
  return UM_OK;
}

enum um_status um_thermal_spin_variation_add(struct um_context *context,
                                             const struct um_thermal_network *network,
                                             const struct um_irradiation_loads *variation,
                                             const struct um_thermal_solve_options *options,
                                             size_t row, double factor, double *temperature)
{
  size_t n = network->nnode;
  double *sun = NULL, lit = variation->irradiance[row] * variation->sunlit[row];
  UM_TRY(um_core_allocate(context, 4 * n, sizeof *sun, &sun));
  double *albedo = sun + n, *planet = albedo + n, *gas = planet + n;
  um_thermal_load_row_sum(network, variation, NULL, NULL, row, sun, albedo, planet, gas);
  for (size_t i = 0; i < n; i++) {
    const struct um_thermal_network_node *node = &network->node[i];
    if (node->kind != UM_NODE_DIFFUSIVE || !(node->capacity > 0.0)) continue;
    double heat = lit * sun[i] + gas[i]; /* [J] */
    if (options->albedo_on) heat += albedo[i];
    if (options->planet_on) heat += planet[i];
    temperature[i] += factor * heat / node->capacity;
  }
  um_core_free(context, sun);
  return UM_OK;
}
