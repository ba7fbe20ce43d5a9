/* View factors of the satellite as it stands. Private to the rooms of model/. */
#ifndef UMBRA_MODEL_VIEW_FACTORS_GROUP_H
#define UMBRA_MODEL_VIEW_FACTORS_GROUP_H

#include "geometry/view_factor_table.h"
#include "model/build/model.h"

/* By the keys of the scenario; view factors of earlier runs stand in the context's cache. */
struct um_geometry_view_factor_options
um_model_view_factor_options(const struct um_context *context, const struct um_model *model);
/* At joint angles [ntime][njoint], by the keys of the scenario. The caller destroys. */
enum um_status um_model_view_factors(struct um_context *context, const struct um_model *model,
                                     const double *angles, size_t ntime,
                                     struct um_geometry_view_factor_table **out);

#endif
