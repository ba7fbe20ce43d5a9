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

/* What runs over all couplings does with one. */
struct coupling {
  uint32_t i, j;
  double area; /* [m^2] */
};
typedef enum um_status (*visit)(void *self, const struct coupling *coupling);

/* Couplings of patch p with one pose of the parts, or of a room. */
static enum um_status visit_row(const struct um_thermal_system_exchange *x, size_t pose, size_t p,
                                double weight, visit call, void *self)
{
  struct um_thermal_exchange_row row = um_thermal_exchange_row(x->exchange, pose, p);
  for (size_t e = 0; e < row.n; e++)
    for (size_t a = x->patch_start[p]; a < x->patch_start[p + 1]; a++)
      for (size_t b = x->patch_start[row.other[e]]; b < x->patch_start[row.other[e] + 1]; b++) {
        const struct coupling c = {x->patch_node[a], x->patch_node[b],
                                   weight * x->patch_share[a] * row.area[e] * x->patch_share[b]};
        UM_TRY(call(self, &c));
      }
  return UM_OK;
}

static enum um_status visit_all(const struct um_thermal_system_exchange *x, visit call, void *self)
{
  for (size_t p = 0; p < x->exchange->npatch; p++)
    for (size_t m = 0; m < (p < x->exchange->noutside ? x->mix.n : 1); m++) {
      bool room = p >= x->exchange->noutside;
      UM_TRY(visit_row(x, room ? 0 : x->mix.pose[m], p, room ? 1.0 : x->mix.weight[m], call, self));
    }
  return UM_OK;
}

struct couplings {
  const struct um_thermal_system *system;
  struct um_thermal_network *flat;
  double *space;    /* [n] what is left for it [m^2] */
  double *received; /* [n] by the couplings [W] */
  size_t count;
};

static enum um_status count_one(void *self, const struct coupling *c)
{
  struct couplings *all = self;
  (void)c;
  if (++all->count <= MOST_COUPLINGS) return UM_OK;
  return um_core_fail(all->system->context, UM_ERR_INPUT,
                      "more than %d couplings between nodes of surfaces; accepted: fewer, as by "
                      "lumped parts or larger facets",
                      MOST_COUPLINGS);
}

static enum um_status add_one(void *self, const struct coupling *c)
{
  struct couplings *all = self;
  const struct um_thermal_system *system = all->system;
  all->space[c->i] -= c->area;
  all->received[c->i] += UM_STEFAN_BOLTZMANN * c->area * (system->power4[c->j] - system->space4);
  return c->i < c->j ? um_thermal_network_radiator_add(all->flat, c->i, c->j, c->area) : UM_OK;
}

/* Radiators between surfaces. Where emittances go with temperature, a surface sends with its own
 * and receives by that at the temperature of what arrives, which no one coupling says: what it
 * receives more or less than by them is power. */
static enum um_status couplings(const struct um_thermal_system *system, double *space,
                                struct um_thermal_network *flat)
{
  struct couplings all = {system, flat, space, NULL, 0};
  if (system->exchange == NULL) return UM_OK;
  UM_TRY(visit_all(system->exchange, count_one, &all));
  UM_TRY(um_core_allocate(system->context, system->n, sizeof *all.received, &all.received));
  enum um_status status = visit_all(system->exchange, add_one, &all);
  for (uint32_t i = 0; i < system->n && status == UM_OK && system->space_slope != NULL; i++)
    if (system->network->node[i].kind != UM_NODE_BOUNDARY)
      um_thermal_network_power_add(flat, i, system->exchange->gain[i] - all.received[i]);
  um_core_free(system->context, all.received);
  return status;
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
  if (system->exchange != NULL) {
    um_thermal_system_exchange_at(system, 0.0);
    (void)um_thermal_system_exchange_make(system);
  }
  UM_CHECK(fill(system, space, flat));
  *out = flat;
  flat = NULL;
done:
  um_core_free(context, space);
  um_thermal_network_destroy(&flat);
  um_thermal_system_destroy(&system);
  return status;
}
