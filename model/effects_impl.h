/* Effects of a model in the making. Private to model/. */
#ifndef UMBRA_MODEL_EFFECTS_IMPL_H
#define UMBRA_MODEL_EFFECTS_IMPL_H

#include "model/model.h"

/* effect: the scenario's list, --with and --without. */
enum um_status um_model_build_effects(struct um_context *context, struct um_model *model,
                                      const struct um_model_options *options);
/* Additions to the effects of a variant, behind those in the order of the catalogue. */
enum um_status um_model_add_effects(struct um_context *context, struct um_model *model,
                                    const struct um_model_addition *addition, size_t naddition);
/* Every target names something that the built parts have (after um_model_build_parts). */
enum um_status um_model_check_effects(struct um_context *context, const struct um_model *model);
/* The next effect that is on, from *index, which moves behind it; false at the end. */
bool um_model_effect_next(const struct um_model *model, size_t *index, struct um_effect_use *use);

#endif
