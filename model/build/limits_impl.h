/* Limits of temperatures. Private to model/build/. */
#ifndef UMBRA_MODEL_LIMITS_IMPL_H
#define UMBRA_MODEL_LIMITS_IMPL_H

#include "model/build/model.h"

/* UM_ERR_INPUT: a limit of an unknown place or of one that has a limit, without a bound, or with a
 * minimum above its maximum. */
enum um_status um_model_check_limits(struct um_context *context, const struct um_model *model);

#endif
