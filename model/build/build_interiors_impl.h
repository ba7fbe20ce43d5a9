/* What is inside a part, from its keys. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_INTERIORS_IMPL_H
#define UMBRA_MODEL_BUILD_INTERIORS_IMPL_H

#include "model/build/model.h"

/* to->interior; index: of the part in the geometry. UM_ERR_INPUT at the key. */
enum um_status um_model_build_interiors(struct um_context *context, struct um_model *model,
                                        const struct um_scenario_part *part, uint32_t index,
                                        struct um_thermal_part_spec *to);
/* What a group states of its conductances to the interiors; own NULL: nothing. */
enum um_status um_model_build_conductances(struct um_context *context, struct um_model *model,
                                           const struct um_scenario_part *part,
                                           const struct um_scenario_group *own,
                                           struct um_thermal_group_spec *to);
/* The conductance of each interior goes to the groups that state none, by area [m^2]. */
void um_model_share_conductances(const struct um_model *model, const struct um_scenario_part *part,
                                 const double *group_area, struct um_thermal_group_spec *groups,
                                 size_t n);
/* Heat that is released inside must get out; a node without capacity must be held by something. */
enum um_status um_model_check_way_out(struct um_context *context, const struct um_model *model,
                                      const struct um_scenario_part *part,
                                      const struct um_thermal_part_spec *to);

#endif
