/* Electrical extraction: of the direct sunlight that falls on solar cells a share eta leaves as
 * electricity and is not heat,
 *
 *   q = (alpha - eta) S nu cos(theta).
 *
 * The visible does not know of it, which tells it from a lower absorptance. */
#include "effects/list_impl.h"
#include "thermal/body.h"

static bool acts_on(const struct um_effect_use *use, const char *part, const char *group)
{
  return um_effect_acts_on_group(use, part, group) || um_effect_acts_on_group(use, part, "front");
}

static enum um_status extract(struct um_context *context, const struct um_effect_use *use,
                              const char *part, const char *group,
                              struct um_thermal_group_spec *spec, struct um_thermal_shell *wall,
                              struct um_thermal_mli *mli)
{
  (void)wall;
  (void)mli;
  if (!acts_on(use, part, group)) return UM_OK;
  spec->extraction_front += use->value[0];
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
     .help = "share of direct sunlight on the front that leaves as electricity, added to the "
             "part's own",
     .null_value = 0.0,
     .fallback = 0.18,
     .minimum = 0.0,
     .maximum = 0.4,
     .prior_sigma = 0.15,
     .prior = "0 on a dead satellite, up to 0.3"},
};

const struct um_effect um_effects_panel_extraction = {
    .abi_version = UM_EFFECT_ABI_VERSION,
    .struct_size = sizeof(struct um_effect),
    .name = "panel_extraction",
    .summary = "Solar cells turn part of the sunlight into electricity that is spent elsewhere",
    .reference = "Rauschenbach 1980, Solar Cell Array Design Handbook",
    .validity = "direct sunlight on fronts; power follows the Sun, no shunting; extraction in all "
                "up to the absorptance; where the power is spent is for internal_power to say",
    .separated_by = "solar_absorptance: visible light of the panel stays when electricity is drawn "
                    "and changes with the absorptance",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    .parameters = parameters,
    .nparameter = 1,
    .hooks = {.group = extract},
};
