/* How the satellite is lit and seen at an observation, for effects. */
#ifndef UMBRA_MODEL_EFFECT_VIEW_H
#define UMBRA_MODEL_EFFECT_VIEW_H

#include "effects/view.h"
#include "model/build/model.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"

/* Names of the materials of a result: *out [result->nmaterial], the array freed by the caller, its
 * texts borrowed from the model. UM_ERR_MEMORY. */
enum um_status um_model_material_names(struct um_context *context, const struct um_model *model,
                                       const char ***out);
/* Of observation k in a band, at the instant nearest mid-exposure; its light is that of the result,
 * before effects on observations. Without an observer its vectors are 0. Borrows from result and
 * material. Does not fail. */
struct um_effect_view um_model_effect_view(const struct um_model_tables *tables,
                                           const struct um_model_result *result,
                                           const char *const *material, size_t k, size_t band);

#endif
