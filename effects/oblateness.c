/* Oblate shadow: rays to the solar disc are tested against the ellipsoid; near the poles the limb
 * is up to 21 km lower than the equatorial radius, seconds in time. */
#include "effects/list_impl.h"
#include "environment/environment.h"

static enum um_status switch_off(struct um_context *context, struct um_environment *environment)
{
  (void)context;
  if (environment->shadow == UM_SHADOW_OBLATE) environment->shadow = UM_SHADOW_SPHERE;
  return UM_OK;
}

/* The scenario's shadow is round. */
static bool is_off(const struct um_environment *environment)
{
  return environment->shadow == UM_SHADOW_SPHERE || environment->shadow == UM_SHADOW_CYLINDER;
}

static enum um_status switch_on(struct um_context *context, struct um_environment *environment)
{
  (void)context;
  if (is_off(environment)) environment->shadow = UM_SHADOW_OBLATE;
  return UM_OK;
}

const struct um_effect um_effects_oblateness = {
    UM_EFFECT_ABI,
    .name = "oblateness",
    .summary = "The shadow of the Earth is cast by the WGS-84 ellipsoid",
    .reference = "Adhya, Sibthorpe, Ziebart & Cross 2004, J. Spacecraft Rockets 41:168",
    .validity = "off: a sphere of the scenario's shadow_radius_km; off where environment.shadow is "
                "sphere or cylinder, until it is switched on; no shadow stays none",
    .separated_by = "shadow_radius and time_tag: both edges of one eclipse, sampled every second "
                    "or faster, move by amounts that depend on the latitude of the limb",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
    .is_off = is_off,
    .switch_on = switch_on,
};
