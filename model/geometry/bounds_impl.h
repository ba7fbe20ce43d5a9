/* What a timeline asks of memory. Private to model/geometry/. */
#ifndef UMBRA_MODEL_BOUNDS_IMPL_H
#define UMBRA_MODEL_BOUNDS_IMPL_H

#include "model/build/model.h"
#include "model/geometry/tables.h"

/* UM_ERR_INPUT for a scenario of points, naming what it wants. */
enum um_status um_model_check_track(struct um_context *context, const struct um_model *model);
/* What the instants that are observed ask of memory. UM_ERR_INPUT naming the key. */
enum um_status um_model_check_instants(struct um_context *context, const struct um_model *model,
                                       size_t nobs, size_t nsub);
/* The same of the heat loads over `span` [s], one instant every `step` [s]. */
enum um_status um_model_check_load_rows(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables, double span,
                                        double step);

#endif
