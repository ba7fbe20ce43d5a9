/* Times of the rows of the loads. Private to model/geometry/. */
#ifndef UMBRA_MODEL_LOAD_GRID_IMPL_H
#define UMBRA_MODEL_LOAD_GRID_IMPL_H

#include "model/build/model.h"
#include "model/geometry/tables.h"

/* Longest time between two rows [s], of what has its turn period. */
double um_model_load_step(const struct um_model *model, const struct um_model_tables *tables);
/* May rows stand as they need to? Not where thermal.step_s says how far apart, nor where they are
 * means over a turn. Of what has its turn period. */
bool um_model_load_rows_vary(const struct um_model *model, const struct um_model_tables *tables);
/* Times (*out)[*count], ascending, of what has its observations, span, turn and events; the caller
 * frees them. UM_ERR_MEMORY. */
enum um_status um_model_load_grid(struct um_context *context, const struct um_model *model,
                                  const struct um_model_tables *tables, double step, double **out,
                                  size_t *count);
/* Times (*out)[tables->nevent] at which the integration stops; likewise. */
enum um_status um_model_load_edges(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables, double **out);

#endif
