/* What the satellite covers of its own sky. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_BLOCKED_IMPL_H
#define UMBRA_MODEL_BUILD_BLOCKED_IMPL_H

#include "model/build/model.h"

/* What of each surface's sky the satellite itself covers, into the heat network, where
 * mutual_radiation is off. */
enum um_status um_model_build_blocked(struct um_context *context, struct um_model *model);

#endif
