/* Walls of a part: shells, blankets, solids, from their keys. Private to model/build/. */
#ifndef UMBRA_MODEL_BUILD_WALL_IMPL_H
#define UMBRA_MODEL_BUILD_WALL_IMPL_H

#include "model/build/model.h"

/* What the part states for one of its groups, or NULL. */
const struct um_scenario_group *um_model_group_named(const struct um_scenario_part *part,
                                                     const char *name);

enum um_status um_model_build_shell(struct um_context *context, struct um_model *model,
                                    const struct um_scenario_shell *from,
                                    struct um_thermal_shell *to);
enum um_status um_model_build_shell_of_materials(struct um_context *context, struct um_model *model,
                                                 const struct um_scenario_part *part,
                                                 const struct um_geometry_group *group,
                                                 struct um_thermal_shell *to);
enum um_status um_model_build_solid(struct um_context *context, struct um_model *model,
                                    const struct um_scenario_part *part,
                                    struct um_thermal_part_spec *to);
void um_model_warn_of_bare_blanket(struct um_context *context, const struct um_model *model,
                                   const struct um_scenario_part *part,
                                   const struct um_thermal_group_spec *groups, size_t n);

#endif
