/* Effects that a model may use, its own and those of files. */
#ifndef UMBRA_MODEL_EFFECT_FILES_H
#define UMBRA_MODEL_EFFECT_FILES_H

#include "model/build/model.h"

/* Effects that the model may use: the built-in ones, then those of its effect files in order;
 * borrowed, they live as long as the model. find: NULL when there is none of that name. */
size_t um_model_effects_count(const struct um_model *model);
const struct um_effect *um_model_effects_at(const struct um_model *model, size_t index);
const struct um_effect *um_model_effects_find(const struct um_model *model, const char *name);
/* Uses in the order of those effects, and of one effect by target: what is added to a scenario acts
 * in this order, whatever order it was found in. */
void um_model_effects_sort(const struct um_model *model, struct um_model_effect *use, size_t n);

#endif
