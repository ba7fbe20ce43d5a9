/* Multi-layer insulation over the front of a wall, two-node model (Gilmore 2002, ch. 5): the outer
 * layer is a skin of its own that radiates to space and exchanges with what it wraps by an
 * effective emittance,
 *
 *   C_o dT_o/dt = alpha q_s + eps q_IR - eps sigma T_o^4 - e* sigma (T_o^4 - T_i^4) - u (T_o -
 * T_i),
 *
 * u the conductance of its seams over its area; e* may go with temperature (mli_law.h).
 *
 * n sheets under it may store heat, C_s in all. They stand in a row, and of the n + 1 gaps on the
 * way in each has (n + 1) e*, so that in a steady state the blanket lets through what e* says:
 *
 *   C_s/n dT_k/dt = (n + 1) e* sigma (T_(k-1)^4 - 2 T_k^4 + T_(k+1)^4),
 *
 * T_0 the outer layer, T_(n+1) what is wrapped; seams pass them by. A law of e* is taken at each
 * gap's own mean temperature.
 *
 * One skin node per facet on finite-element parts, one per group on lumped parts. What is wrapped
 * is the wall (e* A / 3 to each corner) or, where the wall is left out, an interior. */
#include "thermal/network/builder_impl.h"

#include <math.h>
#include <stdio.h>

#include "base/core/constants.h"

/* A link between skin and what is wrapped that may follow a law; value [W/K] or [m^2]. */
static enum um_status link(struct um_thermal_builder *b, bool conducts, uint32_t skin,
                           uint32_t wrapped, double value, const struct um_thermal_link_law *law)
{
  uint32_t index = UM_THERMAL_NO_LAW;
  if (!(value > 0.0)) return UM_OK;
  if (law != NULL) UM_TRY(um_thermal_network_link_law_add(b->network, law, &index));
  if (conducts)
    UM_TRY(um_thermal_network_conductor_add(b->network, skin, wrapped, value));
  else
    UM_TRY(um_thermal_network_radiator_add(b->network, skin, wrapped, value));
  if (law == NULL) return UM_OK;
  if (conducts)
    um_thermal_network_conductor_follow(b->network, index);
  else
    um_thermal_network_radiator_follow(b->network, index);
  return UM_OK;
}

/* A gap of a blanket of `area` [m^2], between a layer and the next or one of `nodes` that share it.
 * With c the conducted
 * share of e* at 300 K,
 *
 *   Doenecke: r = c (T_m / 300)^-2 + (1 - c) (T_m / 300)^0.667 on e* sigma (T^4 - T^4),
 *   Lockheed: c 4 sigma (300 K)^3 e* (T_m / 300) (T - T)
 *             + (1 - c) (4 / 4.67) e* sigma (300 K)^-0.67 (T^4.67 - T^4.67),
 *
 * all times (T_m / 300)^exponent. */
static enum um_status blanket(struct um_thermal_builder *b, uint32_t skin, uint32_t wrapped,
                              const struct um_thermal_mli *mli, double area, double nodes)
{
  double gaps = 1.0 + (double)mli->sheets;
  double radiator = gaps * mli->effective_emittance * area / nodes, n = mli->exponent; /* [m^2] */
  double black = 4.0 * UM_STEFAN_BOLTZMANN * pow(UM_REFERENCE_TEMPERATURE, 3); /* [W/m^2/K] */
  struct um_thermal_link_law law = {.power = 4.0, .factor = {1.0}, .exponent = {n}};
  switch (mli->law) {
  case UM_MLI_CONSTANT:
    return link(b, false, skin, wrapped, radiator, n == 0.0 ? NULL : &law);
  case UM_MLI_DOENECKE:
    law = (struct um_thermal_link_law){.power = 4.0,
                                       .factor = {mli->conducted, 1.0 - mli->conducted},
                                       .exponent = {n - 2.0, n + 0.667}};
    return link(b, false, skin, wrapped, radiator, &law);
  case UM_MLI_LOCKHEED:
    law.power = 4.67;
    UM_TRY(link(b, false, skin, wrapped, (1.0 - mli->conducted) * 4.0 / 4.67 * radiator, &law));
    law = (struct um_thermal_link_law){.power = 4.0, .factor = {1.0}, .exponent = {n + 1.0}};
    return link(b, true, skin, wrapped, mli->conducted * black * radiator, &law);
  }
  return UM_OK;
}

/* The sheets under a skin of `area` [m^2], the outer one first; *outer: that one, *inner: what
 * faces what is wrapped, which is the skin where there are none. name: of the skin, or NULL. */
static enum um_status sheets_add(struct um_thermal_builder *b, size_t part, const char *name,
                                 uint32_t skin, const struct um_thermal_mli *mli, double area,
                                 uint32_t *outer, uint32_t *inner)
{
  *outer = UM_THERMAL_SPACE;
  *inner = skin;
  for (size_t k = 0; k < mli->sheets; k++) {
    char own[600];
    uint32_t node;
    if (name != NULL) snprintf(own, sizeof own, "%s.sheet%zu", name, k + 1);
    UM_TRY(um_thermal_builder_node(b, name == NULL ? NULL : own,
                                   mli->sheet_heat_capacity * area / (double)mli->sheets,
                                   b->part[part]->start_temperature, 0.0, &node));
    UM_TRY(blanket(b, *inner, node, mli, area, 1.0));
    if (k == 0) *outer = node;
    *inner = node;
  }
  return UM_OK;
}

/* What holds what is wrapped, one of `nodes` that share it: seams the skin, the blanket what faces
 * it. */
static enum um_status couple_node(struct um_thermal_builder *b, uint32_t skin, uint32_t inner,
                                  uint32_t wrapped, const struct um_thermal_mli *mli, double area,
                                  double nodes)
{
  UM_TRY(link(b, true, skin, wrapped, mli->seam_conductance * area / nodes, NULL));
  return blanket(b, inner, wrapped, mli, area, nodes);
}

/* What is wrapped under a facet: the corners of the wall, or the interior. */
static void wrapped(const struct um_thermal_builder *b, size_t facet,
                    const struct um_thermal_mli *mli, uint32_t out[3])
{
  uint32_t inside = um_thermal_builder_wrapped(b, b->mesh->facet_group[facet]);
  for (int c = 0; c < 3; c++)
    out[c] =
        mli->wraps_interior ? um_thermal_interior_met(b, inside, facet, c) : b->front[facet][c];
}

static enum um_status couple(struct um_thermal_builder *b, uint32_t skin, uint32_t inner,
                             const uint32_t wall[3], const struct um_thermal_mli *mli, double area)
{
  if (wall[0] == wall[1] && wall[0] == wall[2])
    return couple_node(b, skin, inner, wall[0], mli, area, 1.0);
  for (int c = 0; c < 3; c++) UM_TRY(couple_node(b, skin, inner, wall[c], mli, area, 3.0));
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
  uint32_t skin, sheet, inner, inside[3];
  UM_TRY(um_thermal_builder_node(b, name, mli->areal_heat_capacity * area,
                                 b->part[part]->start_temperature, 0.0, &skin));
  UM_TRY(sheets_add(b, part, name, skin, mli, area, &sheet, &inner));
  for (size_t f = 0; f < b->mesh->nfacet; f++) {
    if (b->mesh->facet_group[f] != group->group) continue;
    b->skin[f] = skin;
    b->sheet[f] = sheet;
  }
  if (mli->wraps_interior &&
      um_thermal_filled_find(b, um_thermal_builder_wrapped(b, group->group)) != NULL) {
    for (size_t f = 0; f < b->mesh->nfacet; f++) {
      if (b->mesh->facet_group[f] != group->group) continue;
      wrapped(b, f, mli, inside);
      UM_TRY(couple(b, skin, inner, inside, mli, b->mesh->area[f]));
    }
    return UM_OK;
  }
  uint32_t one = mli->wraps_interior ? um_thermal_builder_wrapped(b, group->group)
                                     : b->group_front[group->group];
  return couple(b, skin, inner, (uint32_t[3]){one, one, one}, mli, area);
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
    uint32_t inner, inside[3];
    UM_TRY(sheets_add(b, part, NULL, b->skin[f], mli, area, &b->sheet[f], &inner));
    wrapped(b, f, mli, inside);
    UM_TRY(couple(b, b->skin[f], inner, inside, mli, area));
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
