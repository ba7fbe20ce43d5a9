/* Effects on targets of a model. */
#ifndef UMBRA_MODEL_EFFECTS_H
#define UMBRA_MODEL_EFFECTS_H

#include "model/build/model.h"

/* May the effect be used on this target (NULL: none) of this model? UM_ERR_INPUT saying what is
 * accepted. */
enum um_status um_model_check_target(struct um_context *context, const struct um_model *model,
                                     const struct um_effect *effect, const char *target);

#endif
