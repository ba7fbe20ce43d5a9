/* Multi-layer insulation over the front of a wall, two-node model (Gilmore 2002, ch. 5): the outer
 * layer is a skin of its own that radiates to space and exchanges with what it wraps by an
 * effective emittance,
 *
 *   C_o dT_o/dt = alpha q_s + eps q_IR - eps sigma T_o^4 - e* sigma (T_o^4 - T_i^4).
 *
 * One skin node per facet on finite-element parts, one per group on lumped parts. What is wrapped
 * is the wall (e* A / 3 to each corner) or, where the wall is left out, an interior. */
#include "thermal/mli_impl.h"

#include <stdio.h>

static enum um_status couple(struct um_thermal_builder *b, uint32_t skin, size_t part,
                             const uint32_t wall[3], const struct um_thermal_mli *mli, double area)
{
  double radiator = mli->effective_emittance * area; /* [m^2] */
  if (!(radiator > 0.0)) return UM_OK;
  if (mli->wraps_interior)
    return um_thermal_network_radiator_add(
        b->network, skin, um_thermal_builder_interiors(b, part)[mli->interior], radiator);
  if (wall[0] == wall[1] && wall[0] == wall[2])
    return um_thermal_network_radiator_add(b->network, skin, wall[0], radiator);
  for (int c = 0; c < 3; c++)
    UM_TRY(um_thermal_network_radiator_add(b->network, skin, wall[c], radiator / 3.0));
  return UM_OK;
}

static enum um_status skin_of_group(struct um_thermal_builder *b, size_t part,
                                    const struct um_thermal_group_spec *group)
{
  const struct um_thermal_mli *mli = group->mli;
  const char *part_name = um_thermal_builder_part_name(b, part);
  const char *group_name = um_geometry_group(b->geometry, group->group)->name;
  const char *suffix = mli->wraps_interior ? "" : ".mli";
  double area = b->group_area[group->group];
  char name[512];
  if (b->part[part]->ngroup > 1)
    snprintf(name, sizeof name, "%s.%s%s", part_name, group_name, suffix);
  else
    snprintf(name, sizeof name, "%s%s", part_name, suffix);
  uint32_t skin, front = b->group_front[group->group];
  UM_TRY(um_thermal_builder_node(b, name, mli->areal_heat_capacity * area,
                                 b->part[part]->start_temperature, 0.0, &skin));
  for (size_t f = 0; f < b->mesh->nfacet; f++)
    if (b->mesh->facet_group[f] == group->group) b->skin[f] = skin;
  return couple(b, skin, part, (uint32_t[3]){front, front, front}, mli, area);
}

static enum um_status skins_of_facets(struct um_thermal_builder *b, size_t part,
                                      const struct um_thermal_group_spec *group)
{
  const struct um_thermal_mli *mli = group->mli;
  for (size_t f = 0; f < b->mesh->nfacet; f++) {
    if (b->mesh->facet_group[f] != group->group) continue;
    double area = b->mesh->area[f];
    UM_TRY(um_thermal_builder_node(b, NULL, mli->areal_heat_capacity * area,
                                   b->part[part]->start_temperature, 0.0, &b->skin[f]));
    UM_TRY(couple(b, b->skin[f], part, b->front[f], mli, area));
  }
  return UM_OK;
}

enum um_status um_thermal_mli_assemble(struct um_thermal_builder *b, size_t part)
{
  const struct um_thermal_part_spec *spec = b->part[part];
  for (size_t g = 0; g < spec->ngroup; g++) {
    if (spec->groups[g].mli == NULL) continue;
    if (spec->kind == UM_THERMAL_LUMPED)
      UM_TRY(skin_of_group(b, part, &spec->groups[g]));
    else
      UM_TRY(skins_of_facets(b, part, &spec->groups[g]));
  }
  return UM_OK;
}
