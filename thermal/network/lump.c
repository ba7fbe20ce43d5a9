/* Lumped parts: one isothermal node per group and side.
 *
 *   A c share dT/dt = loads - emission + A U (T_other - T)
 *
 * A group whose MLI wraps the interior is its blanket: the node has the blanket's capacity, and
 * the wall is left out. */
#include "thermal/network/builder_impl.h"

#include <stdio.h>

#define NAME_SIZE 512

/* "part.group", or for the only group of a part "part.front"/"part.back", "part" with one layer. */
static void node_name(const struct um_thermal_builder *b, size_t part, uint32_t group, bool two,
                      bool back, char *name)
{
  const char *p = um_thermal_builder_part_name(b, part);
  const char *g = um_geometry_group(b->geometry, group)->name;
  if (b->part[part]->ngroup > 1)
    snprintf(name, NAME_SIZE, "%s.%s%s", p, g, back ? ".back" : "");
  else if (two)
    snprintf(name, NAME_SIZE, "%s.%s", p, back ? "back" : "front");
  else
    snprintf(name, NAME_SIZE, "%s", p);
}

static bool group_two_layers(const struct um_thermal_builder *b, uint32_t group)
{
  for (size_t f = 0; f < b->mesh->nfacet; f++)
    if (b->mesh->facet_group[f] == group) return um_thermal_builder_two_layers(b, f);
  return false;
}

static enum um_status assemble_group(struct um_thermal_builder *b, size_t part, uint32_t group,
                                     uint32_t *core)
{
  const struct um_thermal_shell *shell = um_thermal_builder_shell(b, group);
  double area = b->group_area[group], start = b->part[part]->start_temperature;
  double capacity = shell->areal_heat_capacity * area; /* [J/K] */
  bool two = group_two_layers(b, group);
  double share = two ? shell->front_share : 1.0;
  double back = 1.0 - share - um_thermal_core_share(b, group);
  char name[NAME_SIZE];
  node_name(b, part, group, two, false, name);
  UM_TRY(um_thermal_builder_node(b, name, capacity * share, start, 0.0, &b->group_front[group]));
  b->group_back[group] = b->group_front[group];
  UM_TRY(
      um_thermal_bulk_capacity(b, &b->group_law[group], b->group_front[group], capacity * share));
  if (!two) return UM_OK;
  node_name(b, part, group, two, true, name);
  UM_TRY(um_thermal_builder_node(b, name, capacity * back, start, 0.0, &b->group_back[group]));
  UM_TRY(um_thermal_bulk_capacity(b, &b->group_law[group], b->group_back[group], capacity * back));
  node_name(b, part, group, two, false, name);
  return um_thermal_core_join(b, group, name, b->group_front[group], b->group_back[group], area,
                              shell->through_conductance * area, core);
}

enum um_status um_thermal_lump_assemble(struct um_thermal_builder *b, size_t part)
{
  const struct um_thermal_part_spec *spec = b->part[part];
  for (size_t g = 0; g < spec->ngroup; g++) {
    uint32_t group = spec->groups[g].group, core = UM_THERMAL_SPACE;
    if (um_thermal_builder_wall_left_out(b, group)) continue;
    UM_TRY(assemble_group(b, part, group, &core));
    for (size_t f = 0; f < b->mesh->nfacet; f++)
      if (b->mesh->facet_group[f] == group) b->core[f] = core;
  }
  for (size_t f = 0; f < b->mesh->nfacet; f++) {
    if (b->mesh->facet_part[f] != part) continue;
    uint32_t group = b->mesh->facet_group[f];
    if (!um_thermal_builder_wall_left_out(b, group)) UM_TRY(um_thermal_core_check(b, f));
    for (int c = 0; c < 3; c++) {
      b->front[f][c] = b->group_front[group];
      b->back[f][c] = b->group_back[group];
    }
  }
  return UM_OK;
}
