/* What the walls, blankets and heaters of a body ask of it while it is built. */
#include "thermal/network/builder_impl.h"

enum um_status um_thermal_builder_node(struct um_thermal_builder *b, const char *name,
                                       double capacity, double temperature, double power,
                                       uint32_t *index)
{
  return um_thermal_network_node_add(b->network, name,
                                     capacity > 0.0 ? UM_NODE_DIFFUSIVE : UM_NODE_ARITHMETIC,
                                     capacity, temperature, power, index);
}

const struct um_thermal_shell *um_thermal_builder_shell(const struct um_thermal_builder *b,
                                                        uint32_t group)
{
  const struct um_thermal_group_spec *spec = b->group[group];
  if (spec->shell != NULL) return spec->shell;
  return &b->part[um_geometry_group(b->geometry, group)->part]->shell;
}

bool um_thermal_builder_radiates_inside(const struct um_thermal_builder *b, size_t facet)
{
  return b->part[b->mesh->facet_part[facet]]->inside;
}

bool um_thermal_builder_two_layers(const struct um_thermal_builder *b, size_t facet)
{
  if (b->part[b->mesh->facet_part[facet]]->kind == UM_THERMAL_NODES)
    return b->front[facet][0] != b->back[facet][0];
  return b->mesh->surface_of_front[facet] != UM_GEOMETRY_NONE &&
         (b->mesh->surface_of_back[facet] != UM_GEOMETRY_NONE ||
          um_thermal_builder_radiates_inside(b, facet)) &&
         b->part[b->mesh->facet_part[facet]]->kind != UM_THERMAL_SOLID &&
         isfinite(um_thermal_builder_shell(b, b->mesh->facet_group[facet])->through_conductance);
}

bool um_thermal_builder_wall_left_out(const struct um_thermal_builder *b, uint32_t group)
{
  return b->group[group]->mli != NULL && b->group[group]->mli->wraps_interior;
}

const uint32_t *um_thermal_builder_interiors(const struct um_thermal_builder *b, size_t part)
{
  return b->interior + b->first_interior[part];
}

uint32_t um_thermal_builder_wrapped(const struct um_thermal_builder *b, uint32_t group)
{
  if (!um_thermal_builder_wall_left_out(b, group)) return UM_THERMAL_SPACE;
  uint32_t part = um_geometry_group(b->geometry, group)->part;
  return um_thermal_builder_interiors(b, part)[b->group[group]->mli->interior];
}

const char *um_thermal_builder_part_name(const struct um_thermal_builder *b, size_t part)
{
  return um_geometry_part_name(b->geometry, part);
}
