/* What lies between the two layers of a wall: a row of nodes, each with a share of its capacity,
 * behind shares of its resistance. The in-plane conductance is that of the layers. */
#include "thermal/network/builder_impl.h"

#include <stdio.h>

size_t um_thermal_core_nodes(const struct um_thermal_builder *b, uint32_t group)
{
  const struct um_thermal_core *core = um_thermal_builder_shell(b, group)->core;
  return core == NULL ? 0 : core->n;
}

double um_thermal_core_share(const struct um_thermal_builder *b, uint32_t group)
{
  const struct um_thermal_core *core = um_thermal_builder_shell(b, group)->core;
  double sum = 0.0;
  for (size_t k = 0; core != NULL && k < core->n; k++) sum += core->capacity[k];
  return sum;
}

static enum um_status conduct(struct um_thermal_builder *b, uint32_t one, uint32_t other,
                              double conductance)
{
  if (!(conductance > 0.0)) return UM_OK;
  return um_thermal_network_conductor_add(b->network, one, other, conductance);
}

enum um_status um_thermal_core_join(struct um_thermal_builder *b, uint32_t group, const char *name,
                                    uint32_t front, uint32_t back, double area, double through,
                                    uint32_t *first)
{
  const struct um_thermal_shell *shell = um_thermal_builder_shell(b, group);
  const struct um_thermal_core *core = shell->core;
  double start = b->part[um_geometry_group(b->geometry, group)->part]->start_temperature;
  uint32_t from = front;
  if (core == NULL) return conduct(b, front, back, through);
  for (size_t k = 0; k < core->n; k++) {
    double capacity = core->capacity[k] * shell->areal_heat_capacity * area; /* [J/K] */
    char own[600];
    uint32_t node;
    if (name != NULL) snprintf(own, sizeof own, "%s.core%zu", name, k + 1);
    UM_TRY(um_thermal_builder_node(b, name == NULL ? NULL : own, capacity, start, 0.0, &node));
    UM_TRY(um_thermal_bulk_capacity(b, &b->group_law[group], node, capacity));
    UM_TRY(conduct(b, from, node, through / core->resistance[k]));
    if (k == 0 && first != NULL) *first = node;
    from = node;
  }
  return conduct(b, from, back, through / core->resistance[core->n]);
}

enum um_status um_thermal_core_check(const struct um_thermal_builder *b, size_t facet)
{
  uint32_t group = b->mesh->facet_group[facet];
  if (um_thermal_core_nodes(b, group) == 0 || um_thermal_builder_two_layers(b, facet)) return UM_OK;
  return um_core_fail(b->context, UM_ERR_INPUT,
                      "part %s, group %s: a wall of nodes in its thickness, whose back meets "
                      "nothing; accepted: a part with a back, or that radiates inside",
                      um_thermal_builder_part_name(b, b->mesh->facet_part[facet]),
                      um_geometry_group(b->geometry, group)->name);
}
