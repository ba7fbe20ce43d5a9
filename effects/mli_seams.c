/* Seams, edges and feed-throughs of MLI: heat conducted past the blanket,
 *
 *   q = e* sigma (T_inside^4 - T_skin^4) + u (T_inside - T_skin),
 *
 * u the conductance of all seams over the blanket's area: length of seam per area times conductance
 * per length of seam. */
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
  if (acts) mli->seam_conductance += use->value[0];
  return UM_OK;
}

static const struct um_effect_parameter parameters[] = {
    {.name = "conductance_W_m2_K",
     .unit = "W/m^2/K",
     .help = "added to that of the seams, over the blanket's area",
     .null_value = 0.0,
     .default_value = 0.05,
     .minimum = 0.0,
     .maximum = 5.0,
     .prior_sigma = 0.1,
     .prior = "large blankets 0.005, small ones 0.03 of e*: 0.15 at 300 K for what edges add"},
};

const struct um_effect um_effects_mli_seams = {
    UM_EFFECT_ABI,
    .name = "mli_seams",
    .summary = "Seams and edges of MLI conduct heat past the blanket",
    .reference = "Gilmore 2002, Spacecraft Thermal Control Handbook I, ch. 5",
    .validity = "parts or groups with MLI; conduction alone: seams that radiate are "
                "mli_emittance's",
    .separated_by = "mli_emittance: radiation through the blanket goes with T^3, conduction past "
                    "it does not; a blanket that is seen sunlit and in the umbra tells them apart",
    .targets = UM_TARGET_PART | UM_TARGET_PART_SIDE,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.group = add, .part = um_effects_mli_check},
};
