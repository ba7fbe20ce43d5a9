/* Interiors as targets of effects. Private to effects/. */
#ifndef UMBRA_EFFECTS_INTERIOR_IMPL_H
#define UMBRA_EFFECTS_INTERIOR_IMPL_H

#include "effects/effect.h"

/* The interior that the use acts on in this part: `interior` by the part's name, others by
 * "part.NAME"; *out NULL: the use acts on another part. wanted: what it is to do, for the message.
 * UM_ERR_INPUT: the part has no such interior, or its temperature is given. */
enum um_status um_effects_interior_find(struct um_context *context, const struct um_effect_use *use,
                                        const char *part, struct um_thermal_part_spec *spec,
                                        const char *wanted, struct um_thermal_interior_spec **out);

#endif
