/* View factors between the surfaces of the satellite. Private to model/geometry/. */
#ifndef UMBRA_MODEL_PRECOMPUTE_EXCHANGE_IMPL_H
#define UMBRA_MODEL_PRECOMPUTE_EXCHANGE_IMPL_H

#include "geometry/view_factor_table.h"
#include "model/build/model.h"
#include "model/geometry/tables.h"

/* Has the part inner surfaces that see each other? limit: patches of them, 0: no clusters. */
bool um_model_room(const struct um_model *model, uint32_t part, size_t *limit);
/* Would the keys of both trace view factors of equal surfaces by the same rays, or read the same
 * file, with the same rooms? */
bool um_model_exchange_options_equal(const struct um_model *a, const struct um_model *b);
/* tables->view_factors, of its body's tables if they have them: joints as they stand at
 * samples[n], the times of the loads. */
enum um_status um_model_precompute_view_factors(struct um_context *context,
                                                const struct um_model *model,
                                                const struct um_environment_sample *samples,
                                                size_t n, struct um_model_tables *tables);

#endif
