/* What one facet of a rough surface throws to another goes on, so that a surface that absorbs
 * nothing reflects everything: with the lobe, f' = s(i) s(o) f, of facets with Smith's masking
 * (materials/compensation.c); to all sides of other lobes (materials/spectrum.c). Without it that
 * light is lost: to 13 % of a surface of alpha 0.5. */
#include "effects/list_impl.h"

UM_EFFECT_SWITCH(switch_off, environment->multiple_scattering_on = false)

const struct um_effect um_effects_multiple_scattering = {
    UM_EFFECT_ABI,
    .name = "multiple_scattering",
    .summary = "Light that facets of a rough surface pass on to each other leaves it all the same",
    .reference = "Sinkhorn 1967; Turquin 2019, Industrial Light & Magic; Kulla & Conty 2017; "
                 "Heitz et al. 2016, ACM Trans. Graph. 35:58",
    .validity =
        "lobes of records with spectra: numbers of grey records are taken as they stand; "
        "reflected light alone, absorptance and emittance never have the loss. Its energy is "
        "right; it keeps the shape of the lobe, where light that is passed on twice and more is "
        "spread wider by facets rougher than alpha 0.5",
    .separated_by = "specular_level and roughness: it grows toward grazing angles, most of the "
                    "roughest surfaces",
    .targets = UM_TARGET_GLOBAL,
    .on_by_default = 1,
    .switch_off = switch_off,
};
