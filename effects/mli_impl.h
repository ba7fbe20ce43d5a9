/* What effects on MLI share. Private to effects/. */
#ifndef UMBRA_EFFECTS_MLI_IMPL_H
#define UMBRA_EFFECTS_MLI_IMPL_H

#include "effects/effect.h"
#include "thermal/network/body.h"

/* *acts: the effect is to change this group's MLI (NULL: it has none). UM_ERR_INPUT where the
 * effect names a group without MLI. */
enum um_status um_effects_mli_acts(struct um_context *context, const struct um_effect_use *use,
                                   const char *part, const char *group,
                                   const struct um_thermal_mli *mli, bool *acts);
/* hooks.part: a part that is named has MLI somewhere, or UM_ERR_INPUT. */
enum um_status um_effects_mli_check(struct um_context *context, const struct um_effect_use *use,
                                    const char *part, struct um_thermal_part_spec *spec);

#endif
