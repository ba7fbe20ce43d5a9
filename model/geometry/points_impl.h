/* Observations without a track. Private to model/geometry/. */
#ifndef UMBRA_MODEL_POINTS_IMPL_H
#define UMBRA_MODEL_POINTS_IMPL_H

#include "model/build/model.h"
#include "model/geometry/precompute.h"

/* Observations of points alone: no loads, no lines of sight. Errors of um_model_precompute_points;
 * the caller destroys. */
enum um_status um_model_points_plan(struct um_context *context, const struct um_model *model,
                                    const struct um_model_instants *instants,
                                    struct um_model_tables **out);
/* As um_model_precompute_points, with tables that serve the model (body_tables.h); NULL: they are
 * traced. */
enum um_status um_model_precompute_points_with(struct um_context *context,
                                               const struct um_model *model,
                                               const struct um_model_instants *instants,
                                               struct um_model_body_tables *body,
                                               struct um_model_tables **out);

#endif
