/* Cloud where lobes look: c' = c + d, within 0 to 1. The cover of a month is that of no instant; a
 * mirror sees a place that is clear or is not, while heat loads and rough surfaces have the mean of
 * thousands of kilometres. */
#include "effects/list_impl.h"
#include "environment/environment.h"

UM_EFFECT_ON_ENVIRONMENT(change, if (um_environment_earth_is_spectral(environment))
                                     environment->mirror_cloud += use->value[0])

static const struct um_effect_parameter parameters[] = {
    {.name = "cover",
     .unit = "1",
     .help = "added to the cover of cloud where lobes look",
     .null_value = 0.0,
     .default_value = 0.35,
     .minimum = -1.0,
     .maximum = 1.0,
     .prior_sigma = 0.4,
     .prior = "a spot of a hundred kilometres is clear or under cloud, 0.64 in the mean"},
};

const struct um_effect um_effects_cloud_in_mirror = {
    UM_EFFECT_ABI,
    .name = "cloud_in_mirror",
    .summary =
        "More or less cloud than its month has stands where smooth surfaces mirror the Earth",
    .reference = "Rossow & Schiffer 1999, Bull. Amer. Meteor. Soc. 80:2261",
    .validity = "where the Earth is not uniform, while earth_spectrum is on; infrared alone, the "
                "albedo stays; one change for all "
                "places that are mirrored",
    .separated_by = "earth_brightness and roughness: light of mirrors of the Earth while that of "
                    "rough surfaces, and the times at which they find the Earth, stay",
    .targets = UM_TARGET_GLOBAL,
    UM_EFFECT_PARAMETERS(parameters),
    .hooks = {.environment = change},
};
