/* The Earth's infrared by wavelength and angle: ozone takes a third of it at 9.6 um, water vapour
 * and slant paths dim its limb, and what is under cloud is colder than what is not
 * (environment/earth_infrared.h). Without it every place is a Lambert black body of its brightness
 * temperature. */
#include "effects/list_impl.h"
#include "environment/environment.h"

UM_EFFECT_SWITCH(switch_off, environment->earth_spectrum_on = false)

const struct um_effect um_effects_earth_spectrum = {
    UM_EFFECT_ABI,
    .name = "earth_spectrum",
    .summary = "The Earth's infrared differs by wavelength and angle, of clear ground and of cloud",
    .reference = "Kneizys et al. 1988, AFGL-TR-88-0177; Smith et al. 1989",
    .validity = "where environment.earth.model is not uniform; clear ground is black, cloud is "
                "opaque; heat loads have the limb darkening of the mean Earth",
    .separated_by = "earth_brightness, which is one for all wavelengths and angles: light of "
                    "narrow bands in and beside 9.6 um, and of mirrors as they sweep from the "
                    "nadir to the limb",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
