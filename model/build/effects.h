/* Effects on targets of a model. */
#ifndef UMBRA_MODEL_EFFECTS_H
#define UMBRA_MODEL_EFFECTS_H

#include "model/build/model.h"

/* May the effect be used on this target (NULL: none) of this model? UM_ERR_INPUT saying what is
 * accepted. */
enum um_status um_model_check_target(struct um_context *context, const struct um_model *model,
                                     const struct um_effect *effect, const char *target);
/* May a text as of --with be used on this model? For texts that are used later, where nobody hears
 * the log. That the target exists is checked when the model is varied. UM_ERR_INPUT saying what is
 * accepted; UM_ERR_MEMORY. */
enum um_status um_model_check_with(struct um_context *context, const struct um_model *model,
                                   const char *typed);

#endif
