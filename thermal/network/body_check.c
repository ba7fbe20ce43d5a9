/* Specs of a body against the geometry, and their ranges; messages name the user's part. */
#include <stdio.h>

#include "thermal/network/builder_impl.h"

#define COUNT(array) (sizeof(array) / sizeof(array)[0])
static const double huge = 1e300;

struct range {
  const char *what, *unit;
  double value, low, high;
};

static enum um_status check_ranges(struct um_context *context, const char *part, const char *group,
                                   const struct range *r, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    if (r[i].value >= r[i].low && r[i].value <= r[i].high) continue;
    char accepted[64];
    if (r[i].high < huge)
      snprintf(accepted, sizeof accepted, "%g to %g", r[i].low, r[i].high);
    else if (r[i].low > -huge)
      snprintf(accepted, sizeof accepted, "%g or more", r[i].low);
    else
      snprintf(accepted, sizeof accepted, "finite");
    return um_core_fail(context, UM_ERR_INPUT, "part %s%s%s: %s %g%s%s; accepted: %s", part,
                        group == NULL ? "" : ", group ", group == NULL ? "" : group, r[i].what,
                        r[i].value, *r[i].unit == '\0' ? "" : " ", r[i].unit, accepted);
  }
  return UM_OK;
}

static enum um_status check_shell(struct um_context *context, const char *part, const char *group,
                                  const struct um_thermal_shell *s)
{
  struct range r[] = {
      {"areal heat capacity", "J/m2/K", s->areal_heat_capacity, 0.0, huge},
      {"front share of the capacity", "", s->front_share, 0.0, 1.0},
      {"in-plane conductance", "W/K", s->conductance, 0.0, huge},
      {"conductance through the wall", "W/m2/K", s->through_conductance, 0.0, INFINITY}};
  return check_ranges(context, part, group, r, COUNT(r));
}

static enum um_status check_group(const struct um_thermal_builder *b,
                                  const struct um_thermal_part_spec *spec,
                                  const struct um_thermal_group_spec *g)
{
  const char *part = um_thermal_builder_part_name(b, spec->part);
  const struct um_geometry_group *group = um_geometry_group(b->geometry, g->group);
  if (g->shell != NULL) UM_TRY(check_shell(b->context, part, group->name, g->shell));
  struct range r[] = {{"absorptance of the front", "", g->absorptance_front, 0.0, 1.0},
                      {"emittance of the front", "", g->emittance_front, 0.0, 1.0},
                      {"electrical extraction of the front", "", g->extraction_front, 0.0, 1.0},
                      {"absorptance of the back", "", g->absorptance_back, 0.0, 1.0},
                      {"emittance of the back", "", g->emittance_back, 0.0, 1.0},
                      {"electrical extraction of the back", "", g->extraction_back, 0.0, 1.0},
                      {"emittance inside", "", g->inside_emittance, 0.0, 1.0}};
  size_t n = COUNT(r);
  if (group->back_material == UM_GEOMETRY_NONE) { /* no back: its values do not act */
    r[3] = r[6];
    n = 4;
  }
  UM_TRY(check_ranges(b->context, part, group->name, r, n));
  for (size_t i = 0; g->interior_conductance != NULL && i < spec->ninterior; i++) {
    const struct range c = {"conductance to the inside", "W/K", g->interior_conductance[i], 0.0,
                            huge};
    UM_TRY(check_ranges(b->context, part, group->name, &c, 1));
  }
  if (g->interior_conductance != NULL && spec->ninterior == 0)
    return um_core_fail(b->context, UM_ERR_INPUT,
                        "part %s, group %s: conductance to an interior, but the part has no "
                        "interior",
                        part, group->name);
  struct range pipe[] = {
      {"conductance of the heat pipe", "W/K", g->heat_pipe_conductance, 0.0, huge},
      {"heat capacity of the heat pipe", "J/K", g->heat_pipe_capacity, 1e-6, huge}};
  UM_TRY(check_ranges(b->context, part, group->name, pipe, g->heat_pipe_conductance > 0.0 ? 2 : 1));
  if (g->mli == NULL) return UM_OK;
  struct range m[] = {
      {"effective emittance of the MLI", "", g->mli->effective_emittance, 0.0, 1.0},
      {"areal heat capacity of the MLI", "J/m2/K", g->mli->areal_heat_capacity, 0.0, huge},
      {"conducted share of the MLI", "", g->mli->conducted, 0.0, 1.0},
      {"exponent of the MLI's effective emittance", "", g->mli->exponent, -10.0, 10.0},
      {"seam conductance of the MLI", "W/m2/K", g->mli->seam_conductance, 0.0, huge},
      {"heat capacity of the MLI's sheets", "J/m2/K", g->mli->sheet_heat_capacity, 0.0, huge},
      {"effective emittance of a gap of the MLI, that of the MLI times its gaps,", "",
       (1.0 + (double)g->mli->sheets) * g->mli->effective_emittance, 0.0,
       g->mli->sheets == 0 ? huge : 1.0}};
  UM_TRY(check_ranges(b->context, part, group->name, m, COUNT(m)));
  const char *why = NULL;
  if (spec->kind == UM_THERMAL_NODES)
    return um_core_fail(b->context, UM_ERR_INPUT,
                        "part %s, group %s: MLI on a part that is stated as nodes; accepted: nodes "
                        "of the MLI in its network",
                        part, group->name);
  if (g->mli->wraps_interior && g->mli->interior >= spec->ninterior)
    why = "the part has no such interior";
  else if (g->mli->wraps_interior && group->back_material != UM_GEOMETRY_NONE)
    why = "its back is a radiating surface, which needs a wall";
  else if (g->mli->wraps_interior && spec->kind == UM_THERMAL_SOLID)
    why = "a solid part is its own interior";
  else if (g->mli->wraps_interior && spec->inside)
    why = "the part radiates inside, which needs walls all around";
  if (why != NULL)
    return um_core_fail(b->context, UM_ERR_INPUT,
                        "part %s, group %s: MLI is to wrap the interior, but %s", part, group->name,
                        why);
  return UM_OK;
}

/* An inside is empty and has walls all around. */
static enum um_status check_inside(const struct um_thermal_builder *b,
                                   const struct um_thermal_part_spec *spec)
{
  const char *why = NULL;
  if (!um_geometry_report(b->geometry, spec->part).closed)
    why = "its walls are not closed";
  else if (spec->kind == UM_THERMAL_SOLID)
    why = "it is solid";
  if (!spec->inside || why == NULL) return UM_OK;
  return um_core_fail(b->context, UM_ERR_INPUT, "part %s: is to radiate inside, but %s",
                      um_thermal_builder_part_name(b, spec->part), why);
}

static enum um_status check_part(struct um_thermal_builder *b,
                                 const struct um_thermal_part_spec *spec)
{
  const char *part = um_thermal_builder_part_name(b, spec->part);
  if (spec->kind == UM_THERMAL_NODES && spec->network == NULL)
    return um_core_fail(b->context, UM_ERR_INPUT, "part %s: no network of nodes", part);
  if (spec->kind == UM_THERMAL_SOLID) {
    struct range r[] = {{"density", "kg/m3", spec->density, 1e-6, huge},
                        {"specific heat", "J/kg/K", spec->specific_heat, 1e-6, huge},
                        {"conductivity", "W/m/K", spec->conductivity, 1e-12, huge},
                        {"tetrahedron size", "m", spec->tetrahedron_size, 0.0, huge}};
    UM_TRY(check_ranges(b->context, part, NULL, r, COUNT(r)));
  } else {
    UM_TRY(check_shell(b->context, part, NULL, &spec->shell));
  }
  UM_TRY(check_inside(b, spec));
  const struct range start = {"start temperature", "K", spec->start_temperature, 1e-3, 1e5};
  UM_TRY(check_ranges(b->context, part, NULL, &start, 1));
  UM_TRY(um_thermal_interiors_check(b, spec));
  for (size_t g = 0; g < spec->ngroup; g++) {
    const struct um_thermal_group_spec *group = &spec->groups[g];
    if (group->group >= b->ngroup ||
        um_geometry_group(b->geometry, group->group)->part != spec->part)
      return um_core_fail(
          b->context, UM_ERR_INPUT,
          "part %s: a thermal spec names group number %u, which is not of this part", part,
          (unsigned)group->group);
    if (b->group[group->group] != NULL)
      return um_core_fail(b->context, UM_ERR_INPUT, "part %s, group %s: two thermal specs", part,
                          um_geometry_group(b->geometry, group->group)->name);
    b->group[group->group] = group;
    UM_TRY(check_group(b, spec, group));
  }
  return UM_OK;
}

enum um_status um_thermal_body_check(struct um_thermal_builder *b,
                                     const struct um_thermal_part_spec *parts, size_t npart)
{
  for (size_t p = 0; p < npart; p++) {
    if (parts[p].part >= b->npart)
      return um_core_fail(b->context, UM_ERR_INPUT,
                          "a thermal spec names part number %u; accepted: below %zu",
                          (unsigned)parts[p].part, b->npart);
    if (b->part[parts[p].part] != NULL)
      return um_core_fail(b->context, UM_ERR_INPUT, "part %s: two thermal specs",
                          um_thermal_builder_part_name(b, parts[p].part));
    b->part[parts[p].part] = &parts[p];
    UM_TRY(check_part(b, &parts[p]));
  }
  for (size_t p = 0; p < b->npart; p++)
    if (b->part[p] == NULL)
      return um_core_fail(b->context, UM_ERR_INPUT, "part %s: no thermal spec",
                          um_thermal_builder_part_name(b, p));
  for (size_t g = 0; g < b->ngroup; g++)
    if (b->group[g] == NULL)
      return um_core_fail(b->context, UM_ERR_INPUT, "part %s, group %s: no thermal spec",
                          um_thermal_builder_part_name(b, um_geometry_group(b->geometry, g)->part),
                          um_geometry_group(b->geometry, g)->name);
  return UM_OK;
}
