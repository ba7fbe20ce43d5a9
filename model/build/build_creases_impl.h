/* Creased surfaces of a model in the making. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_CREASES_IMPL_H
#define UMBRA_MODEL_BUILD_CREASES_IMPL_H

#include "model/build/model.h"

/* What the scenario says of a group of a part; NULL: it is flat. */
const struct um_scenario_creases *um_model_creases_of(const struct um_scenario_part *part,
                                                      const char *group);
/* model->creasing and model->creases; after parts and their records. UM_ERR_INPUT with file and
 * line of the part. */
enum um_status um_model_build_creases(struct um_context *context, struct um_model *model);

#endif
