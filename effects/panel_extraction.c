/* Electrical extraction: of the direct sunlight that falls on solar cells a share eta leaves as
 * electricity and is not heat,
 *
 *   q = (alpha - eta) S nu cos(theta).
 *
 * eta is what the scenario states and what is added; it never falls below 0, since cells give no
 * heat back. The visible does not know of it, which tells it from a lower absorptance. */
#include "effects/list_impl.h"
#include "thermal/network/body.h"

#define CELLS    0.5   /* solar absorptance below which a side is no solar cell */
#define ROUNDING 1e-12 /* of a sum that is nothing */

static bool acts_on(const struct um_effect_use *use, const char *part, const char *group)
{
  return um_effect_acts_on_group(use, part, group) || um_effect_acts_on_group(use, part, "front");
}

/* There are no cells on a blanket: a part's other sides are meant, a side that is named is not. */
static enum um_status blanket(struct um_context *context, const struct um_effect_use *use,
                              const char *part, const char *group)
{
  if (use->target == NULL || strcmp(use->target, part) == 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'panel_extraction': '%s.%s' is MLI; accepted: a side with cells",
                      part, group);
}

/* A part that is named has a side without a blanket. */
static enum um_status check(struct um_context *context, const struct um_effect_use *use,
                            const char *part, struct um_thermal_part_spec *spec)
{
  if (use->target == NULL || strcmp(use->target, part) != 0 || use->value[0] == 0.0) return UM_OK;
  for (size_t g = 0; g < spec->ngroup; g++)
    if (spec->groups[g].mli == NULL) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'panel_extraction': the part '%s' is all MLI; accepted: a part with "
                      "cells",
                      part);
}

static enum um_status extract(struct um_context *context, const struct um_effect_use *use,
                              const char *part, const char *group,
                              struct um_thermal_group_spec *spec, struct um_thermal_shell *wall,
                              struct um_thermal_mli *mli)
{
  (void)wall;
  if (!acts_on(use, part, group)) return UM_OK;
  if (mli != NULL && use->value[0] != 0.0) return blanket(context, use, part, group);
  spec->extraction_front += use->value[0];
  if (spec->extraction_front < 0.0 && spec->extraction_front > -ROUNDING)
    spec->extraction_front = 0.0;
  if (spec->extraction_front < 0.0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect 'panel_extraction': efficiency %g makes the extraction of '%s.%s' "
                        "%g; accepted: 0 or more in all",
                        use->value[0], part, group, spec->extraction_front);
  if (spec->extraction_front <= spec->absorptance_front) return UM_OK;
  return um_core_fail(
      context, UM_ERR_INPUT,
      "effect 'panel_extraction': efficiency %g makes the extraction of '%s.%s' %g, "
      "more than it absorbs; accepted: up to %g in all",
      use->value[0], part, group, spec->extraction_front, spec->absorptance_front);
}

/* Is the facet of what the target names: a part, its front, one of its groups? */
static bool is_of(const struct um_effect_nominal *n, const struct um_geometry_mesh *mesh,
                  size_t facet)
{
  const char *part = um_geometry_part_name(n->geometry, mesh->facet_part[facet]);
  return acts_on(&n->use, part, um_geometry_group(n->geometry, mesh->facet_group[facet])->name);
}

/* Fronts of a target: least and most of what they extract, most of what they absorb; false: none.
 */
static bool fronts(const struct um_effect_nominal *n, double *least, double *most, double *absorbed)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(n->geometry);
  *least = INFINITY;
  *most = *absorbed = 0.0;
  for (size_t f = 0; f < mesh->nfacet; f++) {
    const struct um_thermal_surface *surface;
    if (mesh->surface_of_front[f] == UM_GEOMETRY_NONE || !is_of(n, mesh, f)) continue;
    surface = um_thermal_network_surface(n->network, mesh->surface_of_front[f]);
    if (surface == NULL) continue;
    *least = fmin(*least, surface->extraction);
    *most = fmax(*most, surface->extraction);
    *absorbed = fmax(*absorbed, surface->absorptance);
  }
  return isfinite(*least);
}

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  double least, most, absorbed;
  if (n->network == NULL || !fronts(n, &least, &most, &absorbed)) return;
  /* the side that gives least gives nothing at the minimum */
  um_effect_state(out, "electrical extraction", "1", most, most - least, absorbed);
}

static const char *refusal(const struct um_effect_nominal *n)
{
  double least, most, absorbed;
  if (n->network == NULL) return NULL;
  if (!fronts(n, &least, &most, &absorbed)) return "no side of it can hold solar cells";
  if (most > 0.0 || absorbed >= CELLS) return NULL;
  return "no side of it extracts or is dark enough for solar cells";
}

static const struct um_effect_parameter parameters[] = {
    {.name = "efficiency",
     .unit = "1",
     .help = "share of direct sunlight on the front that leaves as electricity, added to what the "
             "scenario states; below 0: less than stated",
     .null_value = 0.0,
     .default_value = 0.18,
     .minimum = -0.4,
     .maximum = 0.4,
     .prior_sigma = 0.15,
     .stated = stated,
     .prior = "0 on a dead satellite, up to 0.3"},
};

const struct um_effect um_effects_panel_extraction = {
    UM_EFFECT_ABI,
    .name = "panel_extraction",
    .summary = "Solar cells turn part of the sunlight into electricity that is spent elsewhere",
    .reference = "Rauschenbach 1980, Solar Cell Array Design Handbook",
    .validity = "direct sunlight on fronts; power follows the Sun, no shunting; extraction in all "
                "from 0 up to the absorptance, not on MLI; where the power is spent is for "
                "internal_power to say",
    .separated_by = "solar_absorptance: visible light of the panel stays when electricity is drawn "
                    "and changes with the absorptance",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.group = extract, .part = check},
    .refusal = refusal,
};
