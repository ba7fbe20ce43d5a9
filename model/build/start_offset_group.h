/* What interiors have stored. Private to the rooms of model/. */
#ifndef UMBRA_MODEL_START_OFFSET_GROUP_H
#define UMBRA_MODEL_START_OFFSET_GROUP_H

#include "model/build/model.h"

/* start_offset, from what effects did to the parts. */
enum um_status um_model_build_start_offset(struct um_context *context, struct um_model *model,
                                           const struct um_thermal_part_spec *parts, size_t npart);
/* What interiors have stored from before: added to start temperatures [nnode]; the same in both
 * models, whose networks are equal. UM_ERR_INPUT below 0 K. */
enum um_status um_model_start_offset_add(struct um_context *context, const struct um_model *model,
                                         double *temperature);
bool um_model_start_offset_equal(const struct um_model *a, const struct um_model *b);

#endif
