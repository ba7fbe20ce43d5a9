/* Sheets of MLI under its outer layer store heat: films of Mylar and the nets between them.
 *
 *   C_o dT_o/dt = loads - eps sigma T_o^4 - (n + 1) e* sigma (T_o^4 - T_1^4),
 *   C_s/n dT_k/dt = (n + 1) e* sigma (T_(k-1)^4 - 2 T_k^4 + T_(k+1)^4)
 *
 * of n sheets that store C_s in all (thermal/network/mli.c). A steady state does not feel them.
 * After the edge of the shadow the outer layer falls as fast as before, and then follows what the
 * sheets give back over minutes. */
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
  if (!acts || use->value[0] == 0.0) return UM_OK;
  mli->sheet_heat_capacity += use->value[0];
  if (mli->sheets == 0) mli->sheets = (size_t)use->value[1];
  return UM_OK;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "areal_heat_capacity_J_m2_K",
     .unit = "J/m^2/K",
     .help = "added to what all sheets under the outer layer store",
     .null_value = 0.0,
     .default_value = 60.0,
     .minimum = 0.0,
     .maximum = 1e4,
     .prior_sigma = 100.0,
     .prior = "10 J/m^2/K a film of 6 um Mylar, as much its net: 100 to 300 of 5 to 15 sheets"},
    {.name = "sheets",
     .unit = "1",
     .help = "a whole number of them, alike and in a row, where the scenario states none",
     .null_value = 3.0,
     .default_value = 3.0,
     .minimum = 1.0,
     .maximum = 50.0,
     .prior_sigma = INFINITY,
     .chosen = true,
     .prior = "5 to 30 in a blanket; few stand for many"},
};

const struct um_effect um_effects_mli_sheets = {
    UM_EFFECT_ABI,
    .name = "mli_sheets",
    .summary = "Sheets of MLI under its outer layer store heat",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 5",
    .validity = "parts or groups with MLI; the gaps share e* evenly, so that (sheets + 1) e* is at "
                "most 1; nothing to see in a steady state",
    .separated_by = "heat_capacity: the first seconds after the edge of the shadow go with the "
                    "outer layer alone, the minutes after them with the sheets",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.group = add, .part = um_effects_mli_check},
};
