/* What sensitivities refuse of variants, pulses and options. */
#include <math.h>
#include <string.h>

#include "thermal/tangent/sensitivity_impl.h"

static enum um_status nodes_check(struct um_context *context,
                                  const struct um_thermal_network *network,
                                  const struct um_thermal_network *variant, size_t k)
{
  bool same = variant->nnode == network->nnode && variant->nthermostat == network->nthermostat &&
              variant->nsource == network->nsource;
  for (size_t i = 0; i < network->nnode && same; i++)
    same = variant->node[i].kind == network->node[i].kind;
  if (same) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "heat sensitivity %zu: the variant has other nodes, thermostats or power "
                      "histories; accepted: the same, with other values",
                      k);
}

static enum um_status loads_check(struct um_context *context,
                                  const struct um_irradiation_loads *loads,
                                  const struct um_irradiation_loads *variant, size_t k)
{
  if (loads == variant) return UM_OK;
  bool same = loads != NULL && variant != NULL && loads->ntime == variant->ntime &&
              loads->nedge == variant->nedge &&
              memcmp(loads->t, variant->t, loads->ntime * sizeof *loads->t) == 0 &&
              (loads->nedge == 0 ||
               memcmp(loads->edge, variant->edge, loads->nedge * sizeof *loads->edge) == 0);
  if (same) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "heat sensitivity %zu: the variant's loads have other times or edges; "
                      "accepted: the same, a moved edge has no derivative",
                      k);
}

static enum um_status pulse_check(struct um_context *context,
                                  const struct um_thermal_network *network,
                                  const struct um_thermal_pulse *pulse, size_t k)
{
  if (!(pulse->t_from <= pulse->t_to) || !isfinite(pulse->t_from) || !isfinite(pulse->t_to))
    return um_core_fail(context, UM_ERR_INPUT,
                        "heat pulse %zu from %g s to %g s; accepted: finite, in this order", k,
                        pulse->t_from, pulse->t_to);
  for (size_t i = 0; i < pulse->nnode; i++)
    if (pulse->node[i] >= network->nnode || !isfinite(pulse->weight[i]))
      return um_core_fail(context, UM_ERR_INPUT,
                          "heat pulse %zu: node %lu with weight %g; accepted: below %zu, finite", k,
                          (unsigned long)pulse->node[i], pulse->weight[i], network->nnode);
  return UM_OK;
}

/* Variants of surfaces that exchange radiation bring the exchange that their optics make. */
static enum um_status exchange_check(const struct um_thermal_sensitivity_subject *of,
                                     const struct um_thermal_variant *variant, size_t nvariant)
{
  const struct um_thermal_exchange *own = of->options->exchange;
  for (size_t k = 0; k < nvariant; k++) {
    const struct um_thermal_solve_options *options = variant[k].options;
    const struct um_thermal_exchange *x = options != NULL ? options->exchange : own;
    if ((x == NULL) != (own == NULL))
      return um_core_fail(of->context, UM_ERR_INPUT,
                          "heat sensitivity %zu: radiation between surfaces is %s the base and %s "
                          "the variant; accepted: in both or in none",
                          k, own != NULL ? "in" : "not in", x != NULL ? "in" : "not in");
    if (x != NULL && x == own && !um_thermal_network_optics_equal(of->network, variant[k].network))
      return um_core_fail(
          of->context, UM_ERR_INPUT,
          "heat sensitivity %zu: the variant has other optics and the base's "
          "exchange between surfaces; accepted: options with an exchange of its own",
          k);
  }
  return UM_OK;
}

enum um_status um_thermal_sensitivity_check(const struct um_thermal_sensitivity_subject *of,
                                            const struct um_thermal_forcings *forcings,
                                            const struct um_thermal_sensitivity_options *how)
{
  struct um_context *context = of->context;
  const struct um_thermal_variant *variant = forcings->variant;
  for (size_t k = 0; k < forcings->npulse; k++)
    UM_TRY(pulse_check(context, of->network, &forcings->pulse[k], k));
  for (size_t k = 0; k < forcings->nvariant; k++) {
    if (!isfinite(variant[k].step) || variant[k].step == 0.0)
      return um_core_fail(context, UM_ERR_INPUT,
                          "heat sensitivity %zu: step %g; accepted: finite, not 0", k,
                          variant[k].step);
    UM_TRY(nodes_check(context, of->network, variant[k].network, k));
    UM_TRY(loads_check(context, of->loads, variant[k].loads, k));
  }
  if (how != NULL && !(how->tolerance >= 0.0 && how->tolerance < 1.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "heat sensitivities: tolerance %g; accepted: 0 or more, below 1",
                        how->tolerance);
  return exchange_check(of, variant, forcings->nvariant);
}
