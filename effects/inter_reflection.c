/* Light that leaves one surface and is reflected by another, any number of times, through lobes and
 * diffuse parts (optics/paths/interreflection.c): sunlight, the Earth's light and the satellite's
 * own emission. Without it every surface is seen as if it stood alone, though shadowed. Heat that
 * surfaces exchange is mutual_radiation and solar_multiple_reflection. */
#include "effects/list_impl.h"
#include "environment/environment.h"

static bool is_off(const struct um_environment *environment)
{
  return !environment->inter_reflection_on;
}

UM_EFFECT_SWITCH(switch_on, environment->inter_reflection_on = true)

UM_EFFECT_SWITCH(switch_off, environment->inter_reflection_on = false)

const struct um_effect um_effects_inter_reflection = {
    UM_EFFECT_ABI,
    .name = "inter_reflection",
    .summary = "Surfaces are lit by each other: sunlight, the Earth's light and their own emission",
    .reference = "Kajiya 1986, Computer Graphics 20:143; Veach 1997, PhD thesis, Stanford",
    .validity =
        "off where optics.interreflection_samples is 0; flat facets of one temperature; creased "
        "surfaces by their mean roughness; of a facet that is seen by way of another, the place of "
        "sunlight that mirrors throw on it is not told apart",
    .separated_by =
        "diffuse_level and emittance: light of one side only while another that faces it "
        "is lit or warm, of both their colours",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
    .is_off = is_off,
    .switch_on = switch_on,
};
