/* Effective emittance of MLI that goes with the mean temperature T_m of its sides, beside what its
 * law says:
 *
 *   e*(T_m) = e* (T_m / 300 K)^n.
 *
 * Spacers conduct in proportion to T_m and radiation goes with T_m^3 and a little more, so e* of a
 * real blanket rises toward the cold, n = -2 (spacers alone) to 0.67 (shields alone). It leaks most
 * in an eclipse, where one e* fitted in sunlight is too small. */
#include "effects/list_impl.h"
#include "effects/mli_impl.h"

static enum um_status add(struct um_context *context, const struct um_effect_use *use,
                          const char *part, const char *group, struct um_thermal_group_spec *spec,
                          struct um_thermal_shell *wall, struct um_thermal_mli *mli)
{
  (void)spec;
  (void)wall;
  bool acts;
  UM_TRY(um_effects_mli_acts(context, use, part, group, mli, &acts));
  if (acts) mli->exponent += use->value[0];
  return UM_OK;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "exponent",
     .unit = "1",
     .help = "n of e* (T_m / 300 K)^n, T_m the mean temperature of the blanket's sides",
     .null_value = 0.0,
     .default_value = -1.0,
     .minimum = -3.0,
     .maximum = 3.0,
     .prior_sigma = 1.0,
     .prior = "-2 (spacers conduct) to 0.67 (shields radiate); -1.1 of Doenecke's fit at 250 K"},
};

const struct um_effect um_effects_mli_temperature_law = {
    UM_EFFECT_ABI,
    .name = "mli_temperature_law",
    .summary = "Effective emittance of MLI goes with its mean temperature",
    .reference = "Doenecke 1993, SAE 932117; Keller, Cunnington and Glassford 1974, NASA CR-134477",
    .validity = "parts or groups with MLI; the stated e* is that of 300 K",
    .separated_by = "mli_emittance: the same factor warm and cold; a blanket that is seen sunlit "
                    "and in the umbra tells them apart",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.group = add, .part = um_effects_mli_check},
};
