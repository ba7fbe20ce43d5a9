/* Heat pipes in a wall: the vapour is one node, of the fluid's capacity, and joined to the wall of
 * its group by area,
 *
 *   C_v dT_v/dt = sum_i g_i (T_i - T_v),   g_i = G A_i / A,
 *
 * G the conductance of all evaporators and condensers between wall and vapour. A wall with two
 * layers is joined on both, half each. (Gilmore 2002, Spacecraft Thermal Control Handbook I, ch.
 * 14: conductances of walls and wicks about an isothermal vapour. No limit of transport.) A node
 * that stores hardly anything couples its neighbours one by one; an arithmetic one would couple
 * each with each. */
#include "thermal/network/builder_impl.h"

#include <stdio.h>

static enum um_status join(struct um_thermal_builder *b, uint32_t vapour, const uint32_t wall[3],
                           double conductance)
{
  for (int c = 0; c < 3; c++)
    UM_TRY(um_thermal_network_conductor_add(b->network, vapour, wall[c], conductance / 3.0));
  return UM_OK;
}

static enum um_status pipe_of(struct um_thermal_builder *b, size_t part,
                              const struct um_thermal_group_spec *group)
{
  const char *part_name = um_thermal_builder_part_name(b, part);
  const char *group_name = um_geometry_group(b->geometry, group->group)->name;
  char name[512];
  uint32_t vapour;
  if (um_thermal_builder_wall_left_out(b, group->group))
    return um_core_fail(b->context, UM_ERR_INPUT,
                        "part %s, group %s: a heat pipe, but MLI wraps the interior and there is "
                        "no wall; accepted: mli that wraps the wall",
                        part_name, group_name);
  snprintf(name, sizeof name, "%s.%s.heat_pipe", part_name, group_name);
  UM_TRY(um_thermal_builder_node(b, name, group->heat_pipe_capacity,
                                 b->part[part]->start_temperature, 0.0, &vapour));
  for (size_t f = 0; f < b->mesh->nfacet; f++) {
    if (b->mesh->facet_group[f] != group->group) continue;
    double share =
        group->heat_pipe_conductance * b->mesh->area[f] / b->group_area[group->group]; /* [W/K] */
    bool two = um_thermal_builder_two_layers(b, f);
    UM_TRY(join(b, vapour, b->front[f], two ? 0.5 * share : share));
    if (two) UM_TRY(join(b, vapour, b->back[f], 0.5 * share));
  }
  return UM_OK;
}

enum um_status um_thermal_heat_pipes_assemble(struct um_thermal_builder *b, size_t part)
{
  const struct um_thermal_part_spec *spec = b->part[part];
  for (size_t g = 0; g < spec->ngroup; g++)
    if (spec->groups[g].heat_pipe_conductance > 0.0) UM_TRY(pipe_of(b, part, &spec->groups[g]));
  return UM_OK;
}
