/* Temperatures against what material records hold for. Private to model/run/. */
#ifndef UMBRA_MODEL_RECORD_RANGE_IMPL_H
#define UMBRA_MODEL_RECORD_RANGE_IMPL_H

#include "model/build/model.h"
#include "model/geometry/precomputed.h"
#include "model/run/result.h"

/* Every material whose record states a range and that leaves it at an observation: a warning, or
 * with thermal.outside_range: error UM_ERR_NUMERIC, with part, time and range. */
enum um_status um_model_check_record_ranges(struct um_context *context,
                                            const struct um_model *model,
                                            const struct um_model_precomputed *precomputed,
                                            const struct um_model_result *result);

#endif
