/* A part whose heat is a network of nodes and conductors that was stated as such (node model in
 * place of walls): nodes of groups carry the surfaces, the others are interiors (interior.c).
 * Everything is copied into the network of the body,
 *
 *   C_i dT_i/dt = P_i + sum GL_ij (T_j - T_i) + s sum GR_ij (T_j^4 - T_i^4) + loads of its
 * surfaces. */
#include "thermal/network/builder_impl.h"

#include <stdio.h>
#include <string.h>

#include "thermal/network/network_group.h"

#define NONE ((size_t)-1)

static bool is_only_group(const struct um_geometry *geometry, uint32_t group)
{
  uint32_t part = um_geometry_group(geometry, group)->part;
  for (uint32_t g = 0; g < um_geometry_group_count(geometry); g++)
    if (g != group && um_geometry_group(geometry, g)->part == part) return false;
  return true;
}

size_t um_thermal_body_group_node(const struct um_geometry *geometry,
                                  const struct um_thermal_network *network, uint32_t group,
                                  bool back)
{
  char name[512];
  snprintf(name, sizeof name, "%s%s", um_geometry_group(geometry, group)->name,
           back ? ".back" : "");
  size_t node = um_thermal_network_find(network, name);
  if (node == NONE && is_only_group(geometry, group))
    node = um_thermal_network_find(network, back ? "back" : "front");
  return node;
}

/* A node of the part's own network into that of the body. */
static enum um_status copy(struct um_thermal_builder *b, size_t part, size_t from, uint32_t *to)
{
  char name[1024];
  const struct um_thermal_network_node *node = &b->part[part]->network->node[from];
  snprintf(name, sizeof name, "%s.%s", um_thermal_builder_part_name(b, part), node->name);
  return um_thermal_network_node_add(b->network, name, node->kind, node->capacity,
                                     node->temperature, node->power, to);
}

static enum um_status group_copy(struct um_thermal_builder *b, size_t part, uint32_t group)
{
  const struct um_thermal_network *network = b->part[part]->network;
  const struct um_geometry_group *g = um_geometry_group(b->geometry, group);
  size_t front = um_thermal_body_group_node(b->geometry, network, group, false);
  size_t back = um_thermal_body_group_node(b->geometry, network, group, true);
  if (front == NONE)
    return um_core_fail(b->context, UM_ERR_INPUT, "part %s, group %s: its network has no such node",
                        um_thermal_builder_part_name(b, part), g->name);
  UM_TRY(copy(b, part, front, &b->group_front[group]));
  b->group_back[group] = b->group_front[group];
  return back == NONE ? UM_OK : copy(b, part, back, &b->group_back[group]);
}

enum um_status um_thermal_node_model_assemble(struct um_thermal_builder *b, size_t part)
{
  const struct um_thermal_part_spec *spec = b->part[part];
  for (size_t g = 0; g < spec->ngroup; g++) UM_TRY(group_copy(b, part, spec->groups[g].group));
  for (size_t f = 0; f < b->mesh->nfacet; f++) {
    if (b->mesh->facet_part[f] != part) continue;
    for (int c = 0; c < 3; c++) {
      b->front[f][c] = b->group_front[b->mesh->facet_group[f]];
      b->back[f][c] = b->group_back[b->mesh->facet_group[f]];
    }
  }
  return UM_OK;
}

/* Where every node of the part's network went. */
static enum um_status places_of(const struct um_thermal_builder *b, size_t part, uint32_t *to)
{
  const struct um_thermal_part_spec *spec = b->part[part];
  size_t next = 0;
  for (size_t i = 0; i < spec->network->nnode; i++) to[i] = UM_THERMAL_SPACE;
  for (size_t g = 0; g < spec->ngroup; g++)
    for (int back = 0; back < 2; back++) {
      uint32_t group = spec->groups[g].group;
      size_t node = um_thermal_body_group_node(b->geometry, spec->network, group, back == 1);
      if (node != NONE) to[node] = back == 1 ? b->group_back[group] : b->group_front[group];
    }
  for (size_t i = 0; i < spec->network->nnode; i++)
    if (to[i] == UM_THERMAL_SPACE && next < spec->ninterior)
      to[i] = um_thermal_builder_interiors(b, part)[next++];
  for (size_t i = 0; i < spec->network->nnode; i++)
    if (to[i] == UM_THERMAL_SPACE || (i + 1 == spec->network->nnode && next < spec->ninterior))
      return um_core_fail(b->context, UM_ERR_INPUT,
                          "part %s: %zu interiors beside a network of %zu nodes; accepted: one for "
                          "each node that is no group's",
                          um_thermal_builder_part_name(b, part), spec->ninterior,
                          spec->network->nnode);
  return UM_OK;
}

enum um_status um_thermal_node_model_links(struct um_thermal_builder *b, size_t part)
{
  enum um_status status;
  const struct um_thermal_network *network = b->part[part]->network;
  uint32_t *to = NULL;
  if (b->part[part]->kind != UM_THERMAL_NODES) return UM_OK;
  UM_CHECK(um_core_allocate(b->context, network->nnode, sizeof *to, &to));
  UM_CHECK(places_of(b, part, to));
  for (size_t k = 0; k < network->nconductor; k++) {
    const struct um_thermal_link *l = &network->conductor[k];
    UM_CHECK(um_thermal_network_conductor_add(b->network, to[l->a], to[l->b], l->value));
  }
  for (size_t k = 0; k < network->nradiator; k++) {
    const struct um_thermal_link *l = &network->radiator[k];
    uint32_t other = l->b == UM_THERMAL_SPACE ? UM_THERMAL_SPACE : to[l->b];
    UM_CHECK(um_thermal_network_radiator_add(b->network, to[l->a], other, l->value));
  }
done:
  um_core_free(b->context, to);
  return status;
}
