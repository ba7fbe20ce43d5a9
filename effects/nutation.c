/* Nutation: the axis of a spinning body stands at an angle from the angular momentum and goes about
 * it. The two angles tip it at the reference time of the law; how fast it goes about follows from
 * the inertia_ratio, the law's own and what is added to it: of a dead satellite it is hardly known.
 */
#include "base/core/constants.h"
#include "effects/list_impl.h"

#define TIP(NAME, HELP)                                                                            \
  {                                                                                                \
    .name = NAME, .unit = "deg", .help = HELP, .null_value = 0.0, .default_value = 0.0,            \
    .minimum = -60.0, .maximum = 60.0, .prior_sigma = 10.0,                                        \
    .prior = "dead satellites: 0 to some tens of degrees"                                          \
  }
static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  um_effect_state(out, "inertia ratio", "1", n->inertia_ratio + out->null_value, 0.05, 2.0);
}

static const struct um_effect_parameter parameters[] = {
    TIP("tip_deg", "of the axis from the angular momentum at at_utc, about one axis across it"),
    TIP("tip_across_deg", "the same about the other"),
    {.name = "inertia_shift",
     .unit = "1",
     .help = "added to the law's inertia_ratio: how fast the axis goes about",
     .null_value = 0.0,
     .default_value = 0.0,
     .minimum = -2.0,
     .maximum = 2.0,
     .prior_sigma = 0.5,
     .is_rate = true,
     .stated = stated,
     .prior = "0.3 of long bodies to 1.8 of flat ones"},
};

static enum um_status law(struct um_context *context, const struct um_effect_use *use,
                          struct um_orbit_attitude_law *to)
{
  (void)context;
  if (to->kind != UM_ATTITUDE_SPIN) return UM_OK;
  to->nutation[0] += use->value[0] * UM_DEG;
  to->nutation[1] += use->value[1] * UM_DEG;
  to->inertia_ratio += use->value[2];
  return UM_OK;
}

const struct um_effect um_effects_nutation = {
    UM_EFFECT_ABI,
    .name = "nutation",
    .summary = "The spin axis goes about the angular momentum instead of lying along it",
    .reference = "Goldstein, Poole & Safko 2001, Classical Mechanics, 5.6",
    .validity =
        "laws of the kind spin, of a body symmetric about its axis, whose moment of inertia "
        "is inertia_ratio times that across it (1: the tip is constant in space), up to 2; "
        "no torque",
    .separated_by = "attitude_offset and spin_period: glints that come at two periods, of turn and "
                    "of nutation, over many turns",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.law = law},
};
