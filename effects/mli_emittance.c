/* Effective emittance of MLI: seams, compression and damage multiply the leak between blanket and
 * what it wraps,
 *
 *   q = f e* sigma (T_inside^4 - T_skin^4).
 *
 * It shows in eclipse on blankets that face space; a sunlit blanket hardly feels it. */
#include "effects/list_impl.h"
#include "effects/mli_impl.h"

static enum um_status scale(struct um_context *context, const struct um_effect_use *use,
                            const char *part, const char *group, struct um_thermal_group_spec *spec,
                            struct um_thermal_shell *wall, struct um_thermal_mli *mli)
{
  (void)spec;
  (void)wall;
  bool acts;
  UM_TRY(um_effects_mli_acts(context, use, part, group, mli, &acts));
  if (!acts) return UM_OK;
  mli->effective_emittance *= use->value[0];
  if (mli->effective_emittance <= 1.0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'mli_emittance': factor %g makes the effective emittance "
                      "of '%s.%s' %g; accepted: up to 1",
                      use->value[0], part, group, mli->effective_emittance);
}

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "effective emittance of the MLI", "1", n->mli_emittance * out->null_value,
                  0.0, 1.0);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "factor",
     .unit = "1",
     .help = "of the effective emittance e* that the scenario states",
     .null_value = 1.0,
     .default_value = 2.0,
     .minimum = 0.01,
     .maximum = 100.0,
     .prior_sigma = 1.0,
     .logarithmic = true,
     .stated = stated,
     .change = UM_CHANGE_SCALES,
     .prior = "0.005 to 0.05 about 0.016, a factor of 3 either way",
     .formerly = "emittance_factor"},
};

const struct um_effect um_effects_mli_emittance = {
    UM_EFFECT_ABI,
    .name = "mli_emittance",
    .summary = "MLI leaks more or less heat than stated: seams, compression, damage",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 5",
    .validity = "parts or groups with MLI; e* after the factor up to 1",
    .separated_by =
        "internal_power and emittance: in the umbra, blankets that face space warm more than those "
        "that face the Earth, and the temperature inside falls while theirs rises",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.group = scale, .part = um_effects_mli_check},
};
