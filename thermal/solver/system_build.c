/* From a network to equations: who is unknown, merged links, storage. The balance of node i,
 *
 *   H_i = P_i + Q_i(t) + sum_j K_ij (T_j - T_i) + sum_j s R_ij (T_j^4 - T_i^4)
 *         - s R_i,space (T_i^4 - T_space^4),      s = Stefan-Boltzmann constant,
 *
 * is C_i dT_i/dt for an unknown and 0 for an eliminated node. Emission of the surfaces is part of
 * R_i,space: a surface adds w A eps for its share w. */
#include "thermal/solver/system_group.h"

#include "thermal/solver/load_sums_impl.h"

#include <math.h>

/* Sort the nodes into unknown, eliminated and fixed. */
static enum um_status nodes_sort(struct um_thermal_system *system, const double *start, bool steady)
{
  struct um_context *context = system->context;
  const struct um_thermal_network *network = system->network;
  size_t n = system->n;
  UM_TRY(um_core_allocate(context, n, sizeof(uint32_t), &system->node));
  UM_TRY(um_core_allocate(context, n, sizeof(uint32_t), &system->unknown));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &system->capacity));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &system->power));
  UM_TRY(um_core_allocate(context, n, sizeof(bool), &system->fixed));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &system->temperature));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &system->first));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &system->power4));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &system->cube));
  for (size_t i = 0; i < n; i++) {
    const struct um_thermal_network_node *node = &network->node[i];
    double temperature = start != NULL ? start[i] : node->temperature;
    char label[96] = "";
    bool finite = isfinite(node->capacity) && isfinite(temperature) && isfinite(node->power);
    bool stores = node->kind != UM_NODE_DIFFUSIVE || node->capacity > 0.0;
    if (!finite || !(temperature >= 0.0) || !stores)
      um_thermal_network_label(network, (uint32_t)i, label, sizeof label);
    if (!finite || !(temperature >= 0.0))
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s: capacity %g J/K, temperature %g K, power %g W; accepted: finite, "
                          "temperature 0 or more",
                          label, node->capacity, temperature, node->power);
    if (!stores)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s: capacity %g J/K; accepted: more than 0 for a diffusive node", label,
                          node->capacity);
    system->unknown[i] = UM_THERMAL_NONE;
    system->fixed[i] = node->kind == UM_NODE_BOUNDARY;
    system->power[i] = node->power;
    system->capacity[i] = steady ? 1.0 : node->capacity;
    system->temperature[i] = system->first[i] = temperature;
    if (node->kind == UM_NODE_DIFFUSIVE || (steady && !system->fixed[i])) {
      system->unknown[i] = (uint32_t)system->nunknown;
      system->node[system->nunknown++] = (uint32_t)i;
    }
  }
  if (system->nunknown == 0)
    return um_core_fail(
        context, UM_ERR_INPUT,
        "no node of the thermal network stores heat; accepted: 1 or more diffusive");
  return UM_OK;
}

static enum um_status options_check(struct um_context *context,
                                    const struct um_thermal_solve_options *options)
{
  if (!(options->relative_tolerance > 0.0 && options->relative_tolerance < 1.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "relative tolerance %g; accepted: more than 0, less than 1",
                        options->relative_tolerance);
  if (!(options->absolute_tolerance > 0.0) || !isfinite(options->absolute_tolerance))
    return um_core_fail(context, UM_ERR_INPUT, "absolute tolerance %g K; accepted: more than 0",
                        options->absolute_tolerance);
  if (!(options->tolerance_factor > 0.0) || !isfinite(options->tolerance_factor))
    return um_core_fail(context, UM_ERR_INPUT, "factor on tolerances %g; accepted: more than 0",
                        options->tolerance_factor);
  if (!(options->space_temperature >= 0.0) || !isfinite(options->space_temperature))
    return um_core_fail(context, UM_ERR_INPUT, "space temperature %g K; accepted: 0 or more",
                        options->space_temperature);
  return UM_OK;
}

enum um_status um_thermal_system_create(struct um_context *context,
                                        const struct um_thermal_network *network,
                                        const struct um_irradiation_loads *loads,
                                        const struct um_thermal_solve_options *options,
                                        const double *start, double from,
                                        enum um_thermal_system_kind kind,
                                        struct um_thermal_system **out)
{
  enum um_status status;
  struct um_thermal_system *system = NULL;
  *out = NULL;
  UM_TRY(options_check(context, options));
  if (loads != NULL) UM_TRY(um_thermal_system_loads_check(context, network, loads, options->aging));
  UM_CHECK(um_core_allocate(context, 1, sizeof *system, &system));
  system->context = context;
  system->network = network;
  system->loads = loads;
  system->options = *options;
  system->from = from;
  system->space4 = pow(options->space_temperature, 4);
  system->n = network->nnode;
  system->kind = kind;
  UM_CHECK(nodes_sort(system, start, kind == UM_SYSTEM_STEADY));
  UM_CHECK(um_thermal_system_emission_build(system));
  UM_CHECK(um_thermal_system_links_build(system));
  UM_CHECK(um_thermal_system_store_build(system));
  UM_CHECK(um_thermal_system_clusters_build(system));
  UM_CHECK(um_thermal_system_exchange_build(system));
  UM_CHECK(um_thermal_system_heat_build(system));
  UM_CHECK(um_thermal_system_pattern_build(system));
  UM_CHECK(um_thermal_system_loads_build(system));
  um_thermal_system_powers(system);
  *out = system;
  return UM_OK;
done:
  um_thermal_system_destroy(&system);
  return status;
}

void um_thermal_system_destroy(struct um_thermal_system **system)
{
  if (system == NULL || *system == NULL) return;
  struct um_thermal_system *s = *system;
  struct um_context *context = s->context;
  um_thermal_system_clusters_destroy(s);
  um_thermal_system_heat_destroy(s);
  um_thermal_system_exchange_destroy(s);
  um_thermal_system_store_destroy(s);
  um_thermal_load_near_destroy(context, &s->near);
  void *const block[] = {s->node,
                         s->unknown,
                         s->capacity,
                         s->power,
                         s->fixed,
                         s->start,
                         s->other,
                         s->linear,
                         s->fourth,
                         (void *)s->link_law,
                         s->warming,
                         s->space,
                         s->column,
                         s->row,
                         s->link_slot,
                         s->diagonal,
                         s->grid,
                         s->now.q,
                         s->planet,
                         s->gas,
                         s->space_slope,
                         s->emission,
                         s->emission_start,
                         s->emission_of,
                         s->emission_held,
                         s->load_row[0].space,
                         s->load_row[1].space,
                         s->load_row[0].sun,
                         s->load_row[1].sun,
                         s->load_row[0].earth,
                         s->load_row[1].earth,
                         s->temperature,
                         s->first,
                         s->power4,
                         s->cube};
  for (size_t k = 0; k < sizeof block / sizeof block[0]; k++) um_core_free(context, block[k]);
  um_core_free(context, s);
  *system = NULL;
}
