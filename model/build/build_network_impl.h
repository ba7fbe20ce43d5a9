/* Parts that are stated as nodes and conductors. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_NETWORK_IMPL_H
#define UMBRA_MODEL_BUILD_NETWORK_IMPL_H

#include "model/build/model.h"

/* to->network, which the caller destroys, and its interiors; index: of the part in the geometry.
 * UM_ERR_INPUT with file and line. */
enum um_status um_model_build_network(struct um_context *context, struct um_model *model,
                                      const struct um_scenario_part *part, uint32_t index,
                                      struct um_thermal_part_spec *to);

#endif
