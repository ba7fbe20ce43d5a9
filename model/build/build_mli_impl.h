/* Blankets of MLI from their keys. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_MLI_IMPL_H
#define UMBRA_MODEL_BUILD_MLI_IMPL_H

#include "model/build/model.h"

/* area: of all groups that `from` covers [m^2], over which its seams spread. *out lives as long as
 * the model. */
enum um_status um_model_build_mli(struct um_context *context, struct um_model *model,
                                  const struct um_scenario_part *part,
                                  const struct um_scenario_mli *from, double area,
                                  struct um_thermal_mli **out);

#endif
