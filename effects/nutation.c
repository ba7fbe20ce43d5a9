/* Nutation: the axis of a spinning body stands at an angle from the angular momentum and goes about
 * it. The two angles tip it at the reference time of the law; how fast it goes about follows from
 * the law's inertia_ratio. */
#include "base/core/constants.h"
#include "effects/list_impl.h"

#define TIP(NAME, HELP)                                                                            \
  {                                                                                                \
    .name = NAME, .unit = "deg", .help = HELP, .null_value = 0.0, .default_value = 0.0,            \
    .minimum = -60.0, .maximum = 60.0, .prior_sigma = 10.0,                                        \
    .prior = "dead satellites: 0 to some tens of degrees"                                          \
  }
static const struct um_effect_parameter parameters[] = {
    TIP("tip_deg", "of the axis from the angular momentum at at_utc, about one axis across it"),
    TIP("tip_across_deg", "the same about the other"),
};

static enum um_status law(struct um_context *context, const struct um_effect_use *use,
                          struct um_orbit_attitude_law *to)
{
  (void)context;
  if (to->kind != UM_ATTITUDE_SPIN) return UM_OK;
  to->nutation[0] += use->value[0] * UM_DEG;
  to->nutation[1] += use->value[1] * UM_DEG;
  return UM_OK;
}

const struct um_effect um_effects_nutation = {
    UM_EFFECT_ABI,
    .name = "nutation",
    .summary = "The spin axis goes about the angular momentum instead of lying along it",
    .reference = "Goldstein, Poole & Safko 2001, Classical Mechanics, 5.6",
    .validity = "laws of the kind spin, of a body symmetric about its axis, with the law's "
                "inertia_ratio (1: the tip is constant in space); no torque",
    .separated_by = "attitude_offset and spin_period: glints that come at two periods, of turn and "
                    "of nutation, over many turns",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.law = law},
};
