/* Building a thermal network: nodes, conductors, radiators and the surfaces that lie on nodes.
 * Nothing is solved here; thermal/solver/system_build.c turns a network into equations. */
#include "thermal/network/network.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "thermal/network/network_group.h"

enum um_status um_thermal_network_grow(struct um_context *context, void *block, size_t count,
                                       size_t *room, size_t size)
{
  if (count < *room) return UM_OK;
  size_t wanted = *room == 0 ? 64 : 2 * *room;
  UM_TRY(um_core_reallocate(context, wanted, size, block));
  *room = wanted;
  return UM_OK;
}

/* NULL: of none. */
static const char *part_of(const struct um_thermal_network *network, uint32_t node)
{
  const char *part = NULL;
  for (size_t k = 0; k < network->nsection && network->section[k].first <= node; k++)
    part = network->section[k].name;
  return part;
}

const char *um_thermal_network_label(const struct um_thermal_network *network, uint32_t node,
                                     char *text, size_t size)
{
  const char *name = node < network->nnode ? network->node[node].name : NULL;
  if (node == UM_THERMAL_SPACE)
    snprintf(text, size, "space");
  else if (name != NULL)
    snprintf(text, size, "node '%s'", name);
  else if (part_of(network, node) != NULL)
    snprintf(text, size, "node %lu of part '%s'", (unsigned long)node, part_of(network, node));
  else
    snprintf(text, size, "node %lu", (unsigned long)node);
  return text;
}

enum um_status um_thermal_network_section_begin(struct um_thermal_network *network,
                                                const char *part)
{
  UM_TRY(um_core_reallocate(network->context, network->nsection + 1, sizeof *network->section,
                            &network->section));
  struct um_thermal_section *section = &network->section[network->nsection];
  UM_TRY(um_core_strdup(network->context, part, &section->name));
  section->first = (uint32_t)network->nnode;
  network->nsection++;
  return UM_OK;
}

enum um_status um_thermal_network_create(struct um_context *context,
                                         struct um_thermal_network **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  (*out)->context = context;
  return UM_OK;
}

static void heat_free(struct um_thermal_network *network)
{
  struct um_context *context = network->context;
  for (size_t k = 0; k < network->nsource; k++) {
    UM_FREE(context, network->source[k].at.node, network->source[k].at.weight, network->source[k].t,
            network->source[k].power);
  }
  for (size_t k = 0; k < network->nthermostat; k++) {
    UM_FREE(context, network->thermostat[k].at.node, network->thermostat[k].at.weight,
            network->thermostat[k].sensor.node, network->thermostat[k].sensor.weight);
  }
  UM_FREE(context, network->source, network->thermostat);
}

void um_thermal_network_destroy(struct um_thermal_network **network)
{
  if (network == NULL || *network == NULL) return;
  struct um_thermal_network *n = *network;
  struct um_context *context = n->context;
  for (size_t i = 0; i < n->nnode; i++) um_core_free(context, n->node[i].name);
  for (size_t k = 0; k < n->nsection; k++) um_core_free(context, n->section[k].name);
  UM_FREE(context, n->section, n->node, n->conductor, n->radiator, n->surface, n->attached);
  heat_free(n);
  um_thermal_network_laws_free(n);
  um_core_free(context, n);
  *network = NULL;
}

static enum um_status node_check(const struct um_thermal_network *network, const char *name,
                                 enum um_thermal_node_kind kind, double capacity,
                                 double temperature, double power)
{
  struct um_context *context = network->context;
  char number[32];
  snprintf(number, sizeof number, "%zu", network->nnode);
  const char *who = name != NULL ? name : number;
  if (!(capacity >= 0.0) || !isfinite(capacity))
    return um_core_fail(context, UM_ERR_INPUT,
                        "node '%s': capacity %g J/K; accepted: finite, 0 or more", who, capacity);
  if (kind == UM_NODE_ARITHMETIC && capacity != 0.0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "node '%s': capacity %g J/K; accepted: 0 for an arithmetic node", who,
                        capacity);
  if (!(temperature >= 0.0) || !isfinite(temperature))
    return um_core_fail(context, UM_ERR_INPUT,
                        "node '%s': temperature %g K; accepted: finite, 0 or more", who,
                        temperature);
  if (!isfinite(power))
    return um_core_fail(context, UM_ERR_INPUT, "node '%s': power %g W; accepted: finite", who,
                        power);
  if (network->nnode >= UM_THERMAL_SPACE)
    return um_core_fail(context, UM_ERR_INPUT, "more than %lu nodes",
                        (unsigned long)UM_THERMAL_SPACE);
  return UM_OK;
}

enum um_status um_thermal_network_node_add(struct um_thermal_network *network, const char *name,
                                           enum um_thermal_node_kind kind, double capacity,
                                           double temperature, double power, uint32_t *index)
{
  UM_TRY(node_check(network, name, kind, capacity, temperature, power));
  UM_TRY(um_thermal_network_grow(network->context, &network->node, network->nnode,
                                 &network->node_room, sizeof *network->node));
  struct um_thermal_network_node node = {NULL, kind, capacity, temperature, power};
  if (name != NULL) UM_TRY(um_core_strdup(network->context, name, &node.name));
  network->node[network->nnode] = node;
  *index = (uint32_t)network->nnode++;
  return UM_OK;
}

void um_thermal_network_power_set(struct um_thermal_network *network, uint32_t node, double power)
{
  assert(node < network->nnode);
  network->node[node].power = power;
}

double um_thermal_network_power(const struct um_thermal_network *network, uint32_t node)
{
  assert(node < network->nnode);
  return network->node[node].power;
}

void um_thermal_network_power_add(struct um_thermal_network *network, uint32_t node, double power)
{
  assert(node < network->nnode);
  network->node[node].power += power;
}

/* What both kinds of link must satisfy. */
static enum um_status link_check(const struct um_thermal_network *network, const char *what,
                                 const char *unit, const struct um_thermal_link *link,
                                 bool space_allowed, bool negative_allowed)
{
  char a[96], b[96];
  bool a_known = link->a < network->nnode;
  bool b_known = link->b < network->nnode || (space_allowed && link->b == UM_THERMAL_SPACE);
  um_thermal_network_label(network, link->a, a, sizeof a);
  um_thermal_network_label(network, link->b, b, sizeof b);
  if (!a_known || !b_known)
    return um_core_fail(network->context, UM_ERR_INPUT,
                        "%s between %s and %s; accepted: one of the %zu nodes%s", what, a, b,
                        network->nnode, space_allowed ? " or space" : "");
  if (link->a == link->b)
    return um_core_fail(network->context, UM_ERR_INPUT,
                        "%s between %s and itself; accepted: two different nodes", what, a);
  if (!isfinite(link->value) || (!negative_allowed && !(link->value >= 0.0)))
    return um_core_fail(network->context, UM_ERR_INPUT,
                        "%s between %s and %s: %g %s; accepted: finite%s", what, a, b, link->value,
                        unit, negative_allowed ? "" : ", 0 or more");
  return UM_OK;
}

enum um_status um_thermal_network_conductor_add(struct um_thermal_network *network, uint32_t a,
                                                uint32_t b, double conductance)
{
  struct um_thermal_link link = {a, b, conductance, UM_THERMAL_NO_LAW};
  UM_TRY(link_check(network, "conductance", "W/K", &link, false, true));
  UM_TRY(um_thermal_network_grow(network->context, &network->conductor, network->nconductor,
                                 &network->conductor_room, sizeof *network->conductor));
  network->conductor[network->nconductor++] = link;
  return UM_OK;
}

enum um_status um_thermal_network_radiator_add(struct um_thermal_network *network, uint32_t a,
                                               uint32_t b, double radiator)
{
  struct um_thermal_link link = {a, b, radiator, UM_THERMAL_NO_LAW};
  UM_TRY(link_check(network, "radiative conductance", "m2", &link, true, false));
  UM_TRY(um_thermal_network_grow(network->context, &network->radiator, network->nradiator,
                                 &network->radiator_room, sizeof *network->radiator));
  network->radiator[network->nradiator++] = link;
  return UM_OK;
}

static enum um_status surface_check(const struct um_thermal_network *network, uint32_t surface,
                                    const struct um_thermal_surface *s)
{
  struct um_context *context = network->context;
  double sum = 0.0;
  for (int k = 0; k < 3; k++) {
    if (s->node[k] == UM_THERMAL_SPACE) continue;
    if (s->node[k] >= network->nnode)
      return um_core_fail(context, UM_ERR_INPUT, "surface %lu lies on node %lu of %zu",
                          (unsigned long)surface, (unsigned long)s->node[k], network->nnode);
    sum += s->weight[k];
  }
  if (!(fabs(sum - 1.0) <= 1e-9))
    return um_core_fail(context, UM_ERR_INPUT,
                        "surface %lu: node weights add to %.12g; accepted: 1",
                        (unsigned long)surface, sum);
  if (!(s->area >= 0.0) || !isfinite(s->area))
    return um_core_fail(context, UM_ERR_INPUT,
                        "surface %lu: area %g m2; accepted: finite, 0 or more",
                        (unsigned long)surface, s->area);
  const double property[4] = {s->absorptance, s->emittance, s->extraction, s->blocked};
  const char *const word[4] = {"absorptance", "emittance", "extraction", "blocked share"};
  for (int k = 0; k < 4; k++)
    if (!(property[k] >= 0.0 && property[k] <= 1.0))
      return um_core_fail(context, UM_ERR_INPUT, "surface %lu: %s %g; accepted: 0 to 1",
                          (unsigned long)surface, word[k], property[k]);
  return UM_OK;
}

enum um_status um_thermal_network_surface_attach(struct um_thermal_network *network,
                                                 uint32_t surface,
                                                 const struct um_thermal_surface *attachment)
{
  struct um_context *context = network->context;
  UM_TRY(surface_check(network, surface, attachment));
  if (surface >= network->surface_room) {
    size_t room = 2 * ((size_t)surface + 32);
    UM_TRY(um_core_reallocate(context, room, sizeof *network->surface, &network->surface));
    UM_TRY(um_core_reallocate(context, room, sizeof *network->attached, &network->attached));
    size_t more = room - network->surface_room;
    memset(network->surface + network->surface_room, 0, more * sizeof *network->surface);
    memset(network->attached + network->surface_room, 0, more * sizeof *network->attached);
    network->surface_room = room;
  }
  if (network->attached[surface])
    return um_core_fail(context, UM_ERR_INPUT, "surface %lu is attached twice",
                        (unsigned long)surface);
  if (!attachment->inside && surface >= network->noutside) {
    for (size_t s = network->noutside; s <= surface && s < network->nsurface; s++)
      if (network->attached[s] && network->surface[s].inside)
        return um_core_fail(context, UM_ERR_INPUT,
                            "surface %lu lies outside and surface %zu before it inside",
                            (unsigned long)surface, s);
    network->noutside = (size_t)surface + 1;
  }
  network->surface[surface] = *attachment;
  network->attached[surface] = true;
  if (surface >= network->nsurface) network->nsurface = (size_t)surface + 1;
  return UM_OK;
}

enum um_status um_thermal_network_surface_block(struct um_thermal_network *network,
                                                uint32_t surface, double blocked)
{
  if (surface >= network->nsurface || !network->attached[surface])
    return um_core_fail(network->context, UM_ERR_INPUT, "surface %lu is not attached",
                        (unsigned long)surface);
  struct um_thermal_surface changed = network->surface[surface];
  changed.blocked = blocked;
  UM_TRY(surface_check(network, surface, &changed));
  network->surface[surface] = changed;
  return UM_OK;
}

size_t um_thermal_network_nodes(const struct um_thermal_network *network) { return network->nnode; }

size_t um_thermal_network_surfaces(const struct um_thermal_network *network)
{
  return network->noutside;
}

const char *um_thermal_network_name(const struct um_thermal_network *network, uint32_t node)
{
  assert(node < network->nnode);
  return network->node[node].name;
}

size_t um_thermal_network_find(const struct um_thermal_network *network, const char *name)
{
  for (size_t i = 0; i < network->nnode; i++)
    if (network->node[i].name != NULL && strcmp(network->node[i].name, name) == 0) return i;
  return (size_t)-1;
}

enum um_thermal_node_kind um_thermal_network_kind(const struct um_thermal_network *network,
                                                  uint32_t node)
{
  assert(node < network->nnode);
  return network->node[node].kind;
}

double um_thermal_network_capacity(const struct um_thermal_network *network, uint32_t node)
{
  assert(node < network->nnode);
  return network->node[node].capacity;
}

double um_thermal_network_temperature(const struct um_thermal_network *network, uint32_t node)
{
  assert(node < network->nnode);
  return network->node[node].temperature;
}

const struct um_thermal_surface *
um_thermal_network_surface(const struct um_thermal_network *network, uint32_t surface)
{
  if (surface >= network->nsurface || !network->attached[surface]) return NULL;
  return &network->surface[surface];
}
