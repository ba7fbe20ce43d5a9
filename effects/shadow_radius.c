/* Radius of the Earth's shadow: R' = R + d. Entry comes earlier and exit later; a clock error would
 * move both the same way. Radii in use differ by 7 km, the limb of the ellipsoid by 21 km;
 * refraction and absorption in the atmosphere act like some 10 km more. */
#include "effects/list_impl.h"
#include "environment/environment.h"

static enum um_status shift(struct um_context *context, const struct um_effect_use *use,
                            struct um_environment *environment)
{
  if (environment->shadow == UM_SHADOW_NONE)
    return um_core_fail(context, UM_ERR_INPUT,
                        "effect 'shadow_radius': the scenario has no shadow; accepted: "
                        "environment.shadow cylinder, sphere or oblate");
  environment->shadow_radius += use->value[0] * 1e3; /* km -> m */
  if (environment->shadow_radius > 0.0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "effect 'shadow_radius': shift_km %g makes the radius %g km; "
                      "accepted: above 0",
                      use->value[0], environment->shadow_radius * 1e-3);
}

static void stated(const struct um_effect_nominal *n, struct um_effect_stated *out)
{
  if (n->environment->shadow != UM_SHADOW_NONE)
    um_effect_state(out, "radius of the shadow", "km", 1e-3 * n->environment->shadow_radius, 0.0,
                    INFINITY);
}

static const struct um_effect_parameter parameters[] = {
    {.name = "shift_km",
     .unit = "km",
     .help = "added to the radius of the body that casts the shadow; of the ellipsoid, the "
             "equatorial one",
     .null_value = 0.0,
     .default_value = 10.0,
     .minimum = -60.0,
     .maximum = 60.0,
     .prior_sigma = 10.0,
     .stated = stated,
     .prior =
         "21 km between sphere and ellipsoid, 7 km between radii in use, some 10 km of atmosphere",
     .formerly = "shadow_radius_shift_km"},
};

const struct um_effect um_effects_shadow_radius = {
    UM_EFFECT_ABI,
    .name = "shadow_radius",
    .summary = "The Earth casts a larger or smaller shadow than stated",
    .reference = "Adhya, Sibthorpe, Ziebart & Cross 2004, J. Spacecraft Rockets 41:168",
    .validity = "cylinder, sphere or ellipsoid; acts within seconds of the edges only",
    .separated_by = "time_tag and along_track: both edges of one eclipse; a larger shadow moves "
                    "entry and exit apart, a clock or the orbit moves both the same way",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = shift},
};
