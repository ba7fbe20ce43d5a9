/* Heat that a network releases on its own account: power histories and thermostats. */
#include <math.h>
#include <string.h>

#include "thermal/network/network_group.h"

#define WEIGHTS_OFF 1e-9 /* of 1 */

static enum um_status spread_check(const struct um_thermal_network *network, const char *what,
                                   const uint32_t *node, const double *weight, size_t n,
                                   bool diffusive)
{
  struct um_context *context = network->context;
  double sum = 0.0;
  for (size_t i = 0; i < n; i++) {
    char label[96];
    um_thermal_network_label(network, node[i], label, sizeof label);
    if (node[i] >= network->nnode)
      return um_core_fail(context, UM_ERR_INPUT, "%s on %s; accepted: one of the %zu nodes", what,
                          label, network->nnode);
    if (!(weight[i] >= 0.0) || !isfinite(weight[i]))
      return um_core_fail(context, UM_ERR_INPUT, "%s on %s: weight %g; accepted: 0 or more", what,
                          label, weight[i]);
    if (diffusive && network->node[node[i]].kind != UM_NODE_DIFFUSIVE)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s on %s, which stores no heat; accepted: nodes with a heat capacity",
                          what, label);
    sum += weight[i];
  }
  if (!(fabs(sum - 1.0) <= WEIGHTS_OFF))
    return um_core_fail(context, UM_ERR_INPUT, "%s: weights add to %.12g; accepted: 1", what, sum);
  return UM_OK;
}

static enum um_status rows_check(struct um_context *context, const struct um_thermal_source *source)
{
  if (source->nrow < 2)
    return um_core_fail(context, UM_ERR_INPUT,
                        "power history of %zu rows; accepted: 2 or more, it is 0 outside its rows",
                        source->nrow);
  for (size_t k = 0; k < source->nrow; k++) {
    if (!isfinite(source->t[k]) || !isfinite(source->power[k]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "power history: row %zu is %g W at %g s; accepted: finite", k,
                          source->power[k], source->t[k]);
    if (k > 0 && !(source->t[k] >= source->t[k - 1]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "power history: time %.6f s at row %zu is before the row above; "
                          "accepted: ascending",
                          source->t[k], k);
  }
  return UM_OK;
}

static enum um_status numbers_copy(struct um_context *context, const double *from, size_t n,
                                   double **out)
{
  UM_TRY(um_core_allocate(context, n, sizeof *from, out));
  memcpy(*out, from, n * sizeof *from);
  return UM_OK;
}

static enum um_status spread_copy(struct um_context *context, const uint32_t *node,
                                  const double *weight, size_t n, struct um_thermal_spread *out)
{
  out->n = n;
  UM_TRY(um_core_allocate(context, n, sizeof *node, &out->node));
  memcpy(out->node, node, n * sizeof *node);
  return numbers_copy(context, weight, n, &out->weight);
}

enum um_status um_thermal_network_source_add(struct um_thermal_network *network,
                                             const struct um_thermal_source *source)
{
  struct um_context *context = network->context;
  UM_TRY(
      spread_check(network, "power history", source->node, source->weight, source->nnode, false));
  UM_TRY(rows_check(context, source));
  UM_TRY(
      um_core_reallocate(context, network->nsource + 1, sizeof *network->source, &network->source));
  struct um_thermal_network_source *to = &network->source[network->nsource++];
  *to = (struct um_thermal_network_source){.nrow = source->nrow, .stepwise = source->stepwise};
  UM_TRY(spread_copy(context, source->node, source->weight, source->nnode, &to->at));
  UM_TRY(numbers_copy(context, source->t, source->nrow, &to->t));
  return numbers_copy(context, source->power, source->nrow, &to->power);
}

enum um_status um_thermal_network_thermostat_add(struct um_thermal_network *network,
                                                 const struct um_thermal_thermostat *thermostat)
{
  struct um_context *context = network->context;
  struct um_thermal_thermostat t = *thermostat;
  if (t.sensor == NULL) {
    t.sensor = t.node;
    t.sensor_weight = t.weight;
    t.nsensor = t.nnode;
  }
  UM_TRY(spread_check(network, "thermostat heats", t.node, t.weight, t.nnode, true));
  UM_TRY(spread_check(network, "thermostat senses", t.sensor, t.sensor_weight, t.nsensor, true));
  if (!(t.power >= 0.0) || !isfinite(t.power))
    return um_core_fail(context, UM_ERR_INPUT, "thermostat: power %g W; accepted: 0 or more",
                        t.power);
  if (!(t.on >= 0.0) || !(t.off > t.on) || !isfinite(t.off))
    return um_core_fail(context, UM_ERR_INPUT,
                        "thermostat: on at %g K, off at %g K; accepted: off above on, 0 or more",
                        t.on, t.off);
  if (!(t.phase >= 0.0 && t.phase <= 1.0))
    return um_core_fail(context, UM_ERR_INPUT, "thermostat: phase %g; accepted: 0 to 1", t.phase);
  UM_TRY(um_core_reallocate(context, network->nthermostat + 1, sizeof *network->thermostat,
                            &network->thermostat));
  struct um_thermal_network_thermostat *to = &network->thermostat[network->nthermostat++];
  *to = (struct um_thermal_network_thermostat){
      .power = t.power, .on = t.on, .off = t.off, .start = t.start, .phase = t.phase};
  UM_TRY(spread_copy(context, t.node, t.weight, t.nnode, &to->at));
  return spread_copy(context, t.sensor, t.sensor_weight, t.nsensor, &to->sensor);
}

size_t um_thermal_network_thermostats(const struct um_thermal_network *network)
{
  return network->nthermostat;
}

bool um_thermal_network_phases_stated(const struct um_thermal_network *network)
{
  for (size_t k = 0; k < network->nthermostat; k++)
    if (!(network->thermostat[k].phase > 0.0)) return false;
  return true;
}
