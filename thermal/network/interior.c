/* What is inside a part: one node a mass (frame, boards, battery), each held to groups of the
 * part's walls by its own conductances, to each other and to other parts by contacts (Gilmore 2002,
 * ch. 15):
 *
 *   C_i dT_i/dt = P_i + sum_g G_ig (T_g - T_i) + contacts + blankets that wrap it.
 *
 * C = 0 makes it an arithmetic node, a given temperature a boundary node. Where a share s of it
 * lags by l, that share is a node of its own behind the rest, which alone meets walls, blankets and
 * contacts:
 *
 *   s C dT'/dt = s P + (s C / l) (T - T').
 *
 * With a conductivity it is a solid that fills the part (solid.c): each facet holds the nodes at
 * its corners. */
#include "thermal/network/builder_impl.h"

#include <stdio.h>
#include <string.h>

static enum um_status name_check(const struct um_thermal_builder *b,
                                 const struct um_thermal_part_spec *spec, size_t i)
{
  static const char *const taken[] = {"front", "back", "wall", "inside"};
  const char *name = spec->interior[i].name;
  const char *part = um_thermal_builder_part_name(b, spec->part);
  const char *why = name == NULL || *name == '\0' ? "has no name" : NULL;
  for (size_t k = 0; why == NULL && k < sizeof taken / sizeof taken[0]; k++)
    if (strcmp(name, taken[k]) == 0) why = "has the name of a side";
  for (size_t k = 0; why == NULL && k < i; k++)
    if (strcmp(name, spec->interior[k].name) == 0) why = "has the name of another";
  for (size_t g = 0; why == NULL && g < b->ngroup; g++) {
    const struct um_geometry_group *group = um_geometry_group(b->geometry, g);
    if (group->part == spec->part && strcmp(name, group->name) == 0)
      why = "has the name of a group";
  }
  if (why == NULL && strchr(name, '.') != NULL) why = "has a dot in its name";
  if (why == NULL) return UM_OK;
  return um_core_fail(b->context, UM_ERR_INPUT,
                      "part %s: the interior '%.100s' %s; accepted: a name of its own without dots",
                      part, name == NULL ? "" : name, why);
}

/* An interior that is a solid has a capacity of its own, and the part for itself. */
static enum um_status solid_check(const struct um_thermal_builder *b,
                                  const struct um_thermal_part_spec *spec, size_t i)
{
  const struct um_thermal_interior_spec *s = &spec->interior[i];
  const char *part = um_thermal_builder_part_name(b, spec->part), *why = NULL;
  if (!(s->conductivity >= 0.0) || !isfinite(s->conductivity) || !(s->tetrahedron_size >= 0.0) ||
      !isfinite(s->tetrahedron_size))
    return um_core_fail(b->context, UM_ERR_INPUT,
                        "part %s, %s: conductivity %g W/m/K, tetrahedra of %g m; accepted: finite, "
                        "0 or more",
                        part, s->name, s->conductivity, s->tetrahedron_size);
  if (s->conductivity == 0.0) return UM_OK;
  if (!(s->capacity > 0.0)) why = "no heat capacity";
  if (s->held > 0.0) why = "a temperature that is given";
  if (s->lag != 0.0) why = "a share that lags";
  if (spec->kind == UM_THERMAL_SOLID) why = "a part that is solid itself";
  if (spec->inside) why = "a part that radiates inside, which is empty";
  for (size_t k = 0; k < i; k++)
    if (spec->interior[k].conductivity > 0.0) why = "another that fills the part";
  if (why == NULL) return UM_OK;
  return um_core_fail(b->context, UM_ERR_INPUT,
                      "part %s, %s: conductivity %g W/m/K with %s; accepted: 0, which makes it one "
                      "node, or one solid with a heat capacity inside a shell or lumped part",
                      part, s->name, s->conductivity, why);
}

enum um_status um_thermal_interiors_check(const struct um_thermal_builder *b,
                                          const struct um_thermal_part_spec *spec)
{
  const char *part = um_thermal_builder_part_name(b, spec->part);
  for (size_t i = 0; i < spec->ninterior; i++) {
    const struct um_thermal_interior_spec *s = &spec->interior[i];
    UM_TRY(name_check(b, spec, i));
    if (!(s->capacity >= 0.0) || !isfinite(s->capacity))
      return um_core_fail(b->context, UM_ERR_INPUT,
                          "part %s, %s: heat capacity %g J/K; accepted: finite, 0 or more", part,
                          s->name, s->capacity);
    if (!isfinite(s->power))
      return um_core_fail(b->context, UM_ERR_INPUT, "part %s, %s: power %g W; accepted: finite",
                          part, s->name, s->power);
    if (!(s->held >= 0.0 && s->held <= 1e5))
      return um_core_fail(b->context, UM_ERR_INPUT,
                          "part %s, %s: held at %g K; accepted: 0 to 1e5 K", part, s->name,
                          s->held);
    bool lags = s->lag > 0.0 && isfinite(s->lag) && s->lag_share > 0.0 && s->lag_share < 1.0;
    if (s->lag != 0.0 && !lags)
      return um_core_fail(
          b->context, UM_ERR_INPUT,
          "part %s, %s: %g of it lag by %g s; accepted: a share above 0 and below 1, "
          "0 s or more",
          part, s->name, s->lag_share, s->lag);
    UM_TRY(solid_check(b, spec, i));
  }
  return UM_OK;
}

enum um_status um_thermal_interiors_allocate(struct um_thermal_builder *b)
{
  UM_TRY(um_core_allocate(b->context, b->npart + 1, sizeof *b->first_interior, &b->first_interior));
  for (size_t p = 0; p < b->npart; p++)
    b->first_interior[p + 1] = b->first_interior[p] + b->part[p]->ninterior;
  size_t n = b->first_interior[b->npart];
  UM_TRY(um_core_allocate(b->context, n, sizeof *b->interior, &b->interior));
  UM_TRY(um_core_allocate(b->context, n, sizeof *b->behind, &b->behind));
  for (size_t i = 0; i < n; i++) b->interior[i] = b->behind[i] = UM_THERMAL_SPACE;
  return UM_OK;
}

/* Of an interior that stores heat; a given temperature has nothing behind it. */
static double behind(const struct um_thermal_interior_spec *s)
{
  return s->lag > 0.0 && s->capacity > 0.0 && !(s->held > 0.0) ? s->lag_share : 0.0;
}

size_t um_thermal_interior_nodes(const struct um_thermal_builder *b, size_t part, size_t i,
                                 uint32_t node[2], double share[2])
{
  size_t at = b->first_interior[part] + i;
  share[1] = behind(&b->part[part]->interior[i]);
  share[0] = 1.0 - share[1];
  node[0] = b->interior[at];
  node[1] = b->behind[at];
  return node[1] == UM_THERMAL_SPACE ? 1 : 2;
}

/* What lags, and what holds it to the rest. */
static enum um_status add_behind(struct um_thermal_builder *b, size_t part, size_t i)
{
  const struct um_thermal_interior_spec *s = &b->part[part]->interior[i];
  size_t at = b->first_interior[part] + i;
  double share = behind(s);
  if (!(share > 0.0)) return UM_OK;
  UM_TRY(um_thermal_builder_node(b, NULL, share * s->capacity, b->part[part]->start_temperature,
                                 share * s->power, &b->behind[at]));
  return um_thermal_network_conductor_add(b->network, b->interior[at], b->behind[at],
                                          share * s->capacity / s->lag);
}

enum um_status um_thermal_interiors_add(struct um_thermal_builder *b, size_t part)
{
  const struct um_thermal_part_spec *spec = b->part[part];
  for (size_t i = 0; i < spec->ninterior; i++) {
    const struct um_thermal_interior_spec *s = &spec->interior[i];
    uint32_t *node = &b->interior[b->first_interior[part] + i];
    char name[512];
    double front = 1.0 - behind(s);
    snprintf(name, sizeof name, "%s.%s", um_thermal_builder_part_name(b, part), s->name);
    if (s->conductivity > 0.0)
      UM_TRY(um_thermal_solid_interior(b, part, s, node));
    else if (s->held > 0.0)
      UM_TRY(um_thermal_network_node_add(b->network, name, UM_NODE_BOUNDARY, s->capacity, s->held,
                                         s->power, node));
    else
      UM_TRY(um_thermal_builder_node(b, name, front * s->capacity,
                                     s->start > 0.0 ? s->start : spec->start_temperature,
                                     front * s->power, node));
    UM_TRY(add_behind(b, part, i));
  }
  return UM_OK;
}

/* A group's conductance to an interior, by area: to the inner layer of its wall, or to the blanket
 * where the wall is left out (its seams and feed-throughs). */
static enum um_status couple(struct um_thermal_builder *b, size_t part, size_t interior)
{
  uint32_t inside = um_thermal_builder_interiors(b, part)[interior];
  for (size_t f = 0; f < b->mesh->nfacet; f++) {
    uint32_t group = b->mesh->facet_group[f];
    if (b->mesh->facet_part[f] != part || b->group[group]->interior_conductance == NULL) continue;
    double total = b->group[group]->interior_conductance[interior]; /* [W/K] */
    if (!(total > 0.0)) continue;
    double share = total * b->mesh->area[f] / b->group_area[group];
    for (int c = 0; c < 3; c++) {
      uint32_t node = b->back[f][c] == UM_THERMAL_SPACE ? b->skin[f] : b->back[f][c];
      UM_TRY(um_thermal_network_conductor_add(b->network, um_thermal_interior_met(b, inside, f, c),
                                              node, share / 3.0));
    }
  }
  return UM_OK;
}

enum um_status um_thermal_interiors_couple(struct um_thermal_builder *b, size_t part)
{
  for (size_t i = 0; i < b->part[part]->ninterior; i++) UM_TRY(couple(b, part, i));
  return UM_OK;
}
