/* Effects of a model in the making. Private to the rooms of model/. */
#ifndef UMBRA_MODEL_EFFECTS_GROUP_H
#define UMBRA_MODEL_EFFECTS_GROUP_H

#include "model/build/model.h"

/* effect: the scenario's list, --with and --without. */
enum um_status um_model_build_effects(struct um_context *context, struct um_model *model,
                                      const struct um_model_options *options);
/* Effects of a variant: those of its origin, or of its own scenario where that lists others, then
 * those of the changes; additions in the order of the catalogue. */
enum um_status um_model_vary_effects(struct um_context *context, struct um_model *model,
                                     const struct um_model_changes *changes);
/* Every target names something that the built parts have (after um_model_build_parts). */
enum um_status um_model_check_effects(struct um_context *context, const struct um_model *model);
/* The next effect that is on, from *index, which moves behind it; false at the end. */
bool um_model_effect_next(const struct um_model *model, size_t *index, struct um_effect_use *use);
/* The same of those that act on an observation of this set of measurements; NULL: of none. */
bool um_model_effect_next_in(const struct um_model *model, const char *set, size_t *index,
                             struct um_effect_use *use);

#endif
