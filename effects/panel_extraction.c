/* Electrical extraction: of the direct sunlight that falls on solar cells a share eta leaves as
 * electricity and is not heat,
 *
 *   q = (alpha - eta) S nu cos(theta).
 *
 * eta is what the scenario states and what is added; it never falls below 0, since cells give no
 * heat back. The visible does not know of it, which tells it from a lower absorptance. */
#include "effects/list_impl.h"
#include "thermal/body.h"

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
     .stated = UM_STATED_EXTRACTION,
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
    .parameters = parameters,
    .nparameter = 1,
    .hooks = {.group = extract, .part = check},
};
