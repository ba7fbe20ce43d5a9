/* Descriptors of the built-in effects, declared from the one list. Private to effects/. */
#ifndef UMBRA_EFFECTS_LIST_IMPL_H
#define UMBRA_EFFECTS_LIST_IMPL_H

#include "effects/effect.h"

#define UM_EFFECT_VISIBLE 0.55e-6 /* wavelength that reflectances are stated at [m] */

#define UM_EFFECT(name) extern const struct um_effect um_effects_##name;
#include "effects/list.def"
#undef UM_EFFECT

#endif
