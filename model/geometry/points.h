/* Observations that stand alone (orbit.points). */
#ifndef UMBRA_MODEL_POINTS_H
#define UMBRA_MODEL_POINTS_H

#include "model/build/timeline.h"
#include "model/geometry/tables.h"

/* Of a scenario with orbit.points, at points [npoint] in order of time (times may be equal). The
 * satellite's motion is not known, so an exposure is its middle. sampling: as of
 * um_model_precompute_at. UM_ERR_INPUT: no points, out of
 * order, or a scenario with an orbit; the two above refuse orbit.points. */
enum um_status um_model_precompute_points(struct um_context *context, const struct um_model *model,
                                          const struct um_model_point *points, size_t npoint,
                                          struct um_model_sampling sampling,
                                          struct um_model_tables **out);

#endif
