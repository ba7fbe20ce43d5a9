/* What a variant has from its origin. Private to model/build/. */
#ifndef UMBRA_MODEL_ORIGIN_IMPL_H
#define UMBRA_MODEL_ORIGIN_IMPL_H

#include "model/build/model.h"

/* Does the scenario of a variant say the same as its origin's at these paths of keys, so that what
 * is built of them alone may be borrowed? paths: NULL-terminated. false: there is no origin. */
bool um_model_origin_says(const struct um_model *model, const char *const *paths);

#endif
