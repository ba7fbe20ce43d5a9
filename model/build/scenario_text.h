/* A scenario as it is used, for another folder. */
#ifndef UMBRA_MODEL_SCENARIO_TEXT_H
#define UMBRA_MODEL_SCENARIO_TEXT_H

#include "model/build/model.h"

/* The model's scenario as YAML that runs from `folder`, which exists: with its overrides, with the
 * effects of use[nuse] (those of the model, or what is to be in their place), and with the effect
 * files of the options (NULL: none); names of files lead to the same files from there. Everything
 * else stays as the user wrote it. The caller frees. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_model_scenario_text(struct um_context *context, const struct um_model *model,
                                      const struct um_model_effect *use, size_t nuse,
                                      const struct um_model_options *options, const char *folder,
                                      char **out);

#endif
