/* Loading effects. Private to model/build/. */
#ifndef UMBRA_MODEL_EFFECT_FILES_IMPL_H
#define UMBRA_MODEL_EFFECT_FILES_IMPL_H

#include "model/build/model.h"

/* registry: effect_files of the scenario, then those of the command line. */
enum um_status um_model_build_effect_files(struct um_context *context, struct um_model *model,
                                           const struct um_model_options *options);

#endif
