/* A heat balance as nodes and conductors alone. Of node i, with its shares g_ip of patches
 * (system_exchange.c),
 *
 *   R_ij = sum_pq g_ip (eps B eps)_pq g_jq,   R_i,space = emission of i - sum_j R_ij. */
#include "thermal/solver/flat.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/sort.h"
#include "thermal/solver/system_group.h"

#define MOST_COUPLINGS 20000000
#define SAME           1e-6 /* [K] ends this near: a link is its slope there */

static const char *part_of(const struct um_thermal_network *network, uint32_t node, uint32_t *first)
{
  const char *part = "node";
  *first = 0;
  for (size_t k = 0; k < network->nsection && network->section[k].first <= node; k++) {
    part = network->section[k].name;
    *first = network->section[k].first;
  }
  return part;
}

static enum um_status nodes(const struct um_thermal_system *system, struct um_thermal_network *flat)
{
  const struct um_thermal_network *network = system->network;
  char name[600];
  for (uint32_t i = 0; i < network->nnode; i++) {
    const struct um_thermal_network_node *node = &network->node[i];
    uint32_t first, index;
    const char *part = part_of(network, i, &first);
    if (node->name == NULL)
      snprintf(name, sizeof name, "%s-%lu", part, (unsigned long)(i - first + 1));
    double power = system->power[i] + (system->made != NULL ? system->made[i] : 0.0);
    UM_TRY(um_thermal_network_node_add(flat, node->name != NULL ? node->name : name, node->kind,
                                       node->capacity, system->temperature[i],
                                       node->kind == UM_NODE_BOUNDARY ? 0.0 : power, &index));
  }
  return UM_OK;
}

/* A link by temperature as what it is now. */
static enum um_status link_now(const struct um_thermal_system *system, size_t e, uint32_t i,
                               struct um_thermal_network *flat)
{
  uint32_t j = system->other[e];
  const double *t = system->temperature, *p = system->power4;
  bool linear = system->fourth[e] == 0.0, same = fabs(t[j] - t[i]) < SAME;
  double heat = um_thermal_system_link_heat(system, e, i, j);
  double out = um_thermal_system_link_out(system, e, i, j, system->cube);
  if (linear)
    return um_thermal_network_conductor_add(flat, i, j, same ? out : heat / (t[j] - t[i]));
  double fourth = same ? out / (4.0 * system->cube[i]) : heat / (p[j] - p[i]);
  return um_thermal_network_radiator_add(flat, i, j, fourth / UM_STEFAN_BOLTZMANN);
}

static enum um_status links(const struct um_thermal_system *system, struct um_thermal_network *flat)
{
  for (uint32_t i = 0; i < system->n; i++)
    for (size_t e = system->start[i]; e < system->start[i + 1]; e++) {
      uint32_t j = system->other[e];
      if (j < i) continue; /* the same from the other end */
      if (um_thermal_system_link_varies(system, e)) {
        UM_TRY(link_now(system, e, i, flat));
        continue;
      }
      if (system->linear[e] != 0.0)
        UM_TRY(um_thermal_network_conductor_add(flat, i, j, system->linear[e]));
      if (system->fourth[e] != 0.0)
        UM_TRY(
            um_thermal_network_radiator_add(flat, i, j, system->fourth[e] / UM_STEFAN_BOLTZMANN));
    }
  return UM_OK;
}

static enum um_status couplings_check(const struct um_thermal_system *system)
{
  const struct um_thermal_system_exchange *x = system->exchange;
  double count = 0.0;
  for (size_t p = 0; p < x->exchange->npatch; p++) {
    struct um_thermal_exchange_row row = um_thermal_exchange_row(x->exchange, 0, p);
    double here = (double)(x->patch_start[p + 1] - x->patch_start[p]);
    for (size_t e = 0; e < row.n; e++)
      count += here * (double)(x->patch_start[row.other[e] + 1] - x->patch_start[row.other[e]]);
  }
  if (count <= MOST_COUPLINGS) return UM_OK;
  return um_core_fail(system->context, UM_ERR_INPUT,
                      "%.3g couplings between nodes of surfaces; accepted: %d, as by lumped parts "
                      "or larger facets",
                      count, MOST_COUPLINGS);
}

/* Radiators between surfaces; what they take of space[n] [m^2]. */
static enum um_status couplings(const struct um_thermal_system *system, double *space,
                                struct um_thermal_network *flat)
{
  const struct um_thermal_system_exchange *x = system->exchange;
  if (x == NULL) return UM_OK;
  UM_TRY(couplings_check(system));
  for (size_t p = 0; p < x->exchange->npatch; p++) {
    struct um_thermal_exchange_row row = um_thermal_exchange_row(x->exchange, 0, p);
    for (size_t e = 0; e < row.n; e++)
      for (size_t a = x->patch_start[p]; a < x->patch_start[p + 1]; a++)
        for (size_t b = x->patch_start[row.other[e]]; b < x->patch_start[row.other[e] + 1]; b++) {
          double area = x->patch_share[a] * row.area[e] * x->patch_share[b];
          uint32_t i = x->patch_node[a], j = x->patch_node[b];
          space[i] -= area;
          if (i < j) UM_TRY(um_thermal_network_radiator_add(flat, i, j, area));
        }
  }
  return UM_OK;
}

static enum um_status to_space(const struct um_thermal_system *system, const double *space,
                               struct um_thermal_network *flat)
{
  for (uint32_t i = 0; i < system->n; i++) {
    /* what is left of a node that sees no space is rounding */
    double whole = system->space[i] / UM_STEFAN_BOLTZMANN;
    if (space[i] > 1e-12 * whole && system->network->node[i].kind != UM_NODE_BOUNDARY)
      UM_TRY(um_thermal_network_radiator_add(flat, i, UM_THERMAL_SPACE, space[i]));
  }
  return UM_OK;
}

static int link_compare(const void *pa, const void *pb)
{
  const struct um_thermal_link *a = pa, *b = pb;
  if (a->a != b->a) return a->a < b->a ? -1 : 1;
  if (a->b != b->b) return a->b < b->b ? -1 : 1;
  return (a->value > b->value) - (a->value < b->value);
}

/* One link where several join the same two nodes. */
static enum um_status merge(struct um_context *context, struct um_thermal_link *link, size_t *n)
{
  size_t at = 0;
  UM_TRY(um_core_sort(context, link, *n, sizeof *link, link_compare));
  for (size_t k = 0; k < *n; k++)
    if (at > 0 && link[at - 1].a == link[k].a && link[at - 1].b == link[k].b)
      link[at - 1].value += link[k].value;
    else
      link[at++] = link[k];
  *n = at;
  return UM_OK;
}

static enum um_status fill(const struct um_thermal_system *system, double *space,
                           struct um_thermal_network *flat)
{
  for (size_t i = 0; i < system->n; i++) space[i] = system->space[i] / UM_STEFAN_BOLTZMANN;
  UM_TRY(nodes(system, flat));
  UM_TRY(links(system, flat));
  UM_TRY(couplings(system, space, flat));
  UM_TRY(to_space(system, space, flat));
  UM_TRY(merge(system->context, flat->conductor, &flat->nconductor));
  return merge(system->context, flat->radiator, &flat->nradiator);
}

enum um_status um_thermal_flatten(struct um_context *context,
                                  const struct um_thermal_network *network, const double *power,
                                  const struct um_thermal_solve_options *options,
                                  const double *temperature, struct um_thermal_network **out)
{
  enum um_status status;
  struct um_thermal_system *system = NULL;
  struct um_thermal_network *flat = NULL;
  double *space = NULL;
  *out = NULL;
  UM_CHECK(um_thermal_system_create(context, network, NULL, options, temperature, 0.0,
                                    UM_SYSTEM_STEADY, &system));
  UM_CHECK(um_thermal_network_create(context, &flat));
  UM_CHECK(um_core_allocate(context, system->n, sizeof *space, &space));
  memcpy(system->power, power, system->n * sizeof *power);
  memcpy(system->temperature, temperature, system->n * sizeof *temperature);
  um_thermal_system_powers(system);
  if (system->made != NULL) um_thermal_system_heat_make(system, 0.0);
  UM_CHECK(fill(system, space, flat));
  *out = flat;
  flat = NULL;
done:
  um_core_free(context, space);
  um_thermal_network_destroy(&flat);
  um_thermal_system_destroy(&system);
  return status;
}
