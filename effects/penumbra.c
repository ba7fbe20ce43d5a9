/* Penumbra: sunlit fraction of the solar disc behind the limb of the Earth, nu = 1 - A / (pi a^2).
 */
#include "effects/list_impl.h"
#include "environment/environment.h"

static enum um_status switch_off(struct um_context *context, struct um_environment *environment)
{
  (void)context;
  environment->disc = UM_DISC_POINT;
  return UM_OK;
}

static bool is_off(const struct um_environment *environment)
{
  return environment->disc == UM_DISC_POINT;
}

static enum um_status switch_on(struct um_context *context, struct um_environment *environment)
{
  (void)context;
  if (is_off(environment)) environment->disc = UM_DISC_LIMB_DARKENED;
  return UM_OK;
}

const struct um_effect um_effects_penumbra = {
    .abi_version = UM_EFFECT_ABI_VERSION,
    .struct_size = sizeof(struct um_effect),
    .name = "penumbra",
    .summary = "The Sun is a disc: sunlight fades over seconds at the edge of the shadow",
    .reference = "Montenbruck & Gill 2000, section 3.4.2",
    .validity =
        "off: the Sun is a point and the shadow has an edge; off where environment.disc is "
        "point, until it is switched on, which gives a limb-darkened disc; of no effect with "
        "a cylinder",
    .separated_by = "shadow_radius and time_tag: light sampled every second or faster through an "
                    "edge of the shadow shows whether it fades or is cut off",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
    .is_off = is_off,
    .switch_on = switch_on,
};
