/* Descriptors of the built-in effects, private to the registry. */
#ifndef UMBRA_EFFECTS_LIST_IMPL_H
#define UMBRA_EFFECTS_LIST_IMPL_H

#include "core/effect.h"

extern const struct um_effect um_effects_albedo;
extern const struct um_effect um_effects_earth_ir;
extern const struct um_effect um_effects_earthshine;
extern const struct um_effect um_effects_reflected_earth_ir;
extern const struct um_effect um_effects_penumbra;
extern const struct um_effect um_effects_oblateness;

#endif
