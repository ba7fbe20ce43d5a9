/* What effects on surfaces of tilted patches share. Private to effects/. */
#ifndef UMBRA_EFFECTS_TILTS_IMPL_H
#define UMBRA_EFFECTS_TILTS_IMPL_H

#include "effects/effect.h"

/* Hook of an effect whose first value is a mean square of tilts [deg^2], its second the edge of a
 * patch [m]: the tilt's mean square adds to that of the scenario, t^2 = t_0^2 + v, as light goes
 * with it and not with the tilt: in v = 0 the lobe widens by d(alpha^2) = 2 dv
 * (geometry/creases.h). It is never less than none. A patch of 0 leaves the scenario's. Does not
 * fail. */
enum um_status um_effects_tilt(struct um_context *context, const struct um_effect_use *use,
                               const char *part, const char *group,
                               struct um_geometry_creasing *creasing);

/* What a scenario states of the groups of a target that are of sheet, or of those that are not
 * [deg^2]. The most tilted of them leads: a flatter one has no less than none. */
void um_effects_tilt_state(const struct um_effect_nominal *n, bool sheet, const char *what,
                           struct um_effect_stated *out);

#endif
