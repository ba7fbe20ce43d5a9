/* What of a model answers a channel. Private to evidence/comparison/. */
#ifndef UMBRA_COMPARE_PREDICT_SOURCE_IMPL_H
#define UMBRA_COMPARE_PREDICT_SOURCE_IMPL_H

#include "evidence/measurements/set.h"
#include "model/build/model.h"

/* Band or place of a channel; UM_COMPARE_NOWHERE when no row of it is in use. UM_ERR_INPUT names
 * file and line of its first row. */
enum um_status um_compare_source_find(struct um_context *context, const struct um_model *model,
                                      const struct um_compare_measurements *measurements,
                                      size_t channel, size_t *out);

#endif
