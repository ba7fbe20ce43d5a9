/* Instants that stand alone, each with an attitude of its own: light of a body that is turned as
 * the caller wants it, without a history of heat. */
#ifndef UMBRA_MODEL_POSED_H
#define UMBRA_MODEL_POSED_H

#include "model/geometry/precompute.h"

/* Instants of the caller's own, samples[n] with an observer, copied; they need no order. Time, air
 * and what the observer's place hides are not in such tables. UM_ERR_MEMORY. */
enum um_status um_model_precompute_instants(struct um_context *context,
                                            const struct um_environment_sample *samples, size_t n,
                                            struct um_model_tables **out);
/* Loads of the Earth and lines of sight of the samples as they stand in the tables, one row of
 * loads each, numbered; what the tables had of both is freed. Heat is not followed. light_alone:
 * the loads of the Sun, which only heat and reports ask for, are left 0. Errors of
 * um_irradiation_loads_make and um_optics_view_trace. Test: model/run/cold. */
enum um_status um_model_precompute_posed(struct um_context *context, const struct um_model *model,
                                         struct um_model_sampling sampling, bool light_alone,
                                         struct um_model_tables *tables);

#endif
