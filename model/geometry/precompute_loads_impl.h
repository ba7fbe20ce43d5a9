/* Private to model/geometry/: loads along a timeline, resolved or as means over the turns of the
 * body. */
#ifndef UMBRA_MODEL_PRECOMPUTE_LOADS_IMPL_H
#define UMBRA_MODEL_PRECOMPUTE_LOADS_IMPL_H

#include "model/build/model.h"
#include "model/geometry/tables.h"

#define UM_MODEL_LOADS_LONGEST_STEP 10.0 /* between rows [s]; the orbit turns by 0.6 deg */

/* Turn over which the loads are to be means, as thermal.spin_loads has it [s]; 0: none. The log
 * says what that leaves. UM_ERR_INPUT: means that are wanted and cannot be. */
enum um_status um_model_spin_period(struct um_context *context, const struct um_model *model,
                                    const struct um_model_tables *tables, double *period);
/* Does anything absorb by the angle at which light arrives? Then loads have angular moments. */
bool um_model_loads_by_angle(const struct um_model *model);
/* The scene at times [n] of loads; the caller frees *out [n]. */
enum um_status um_model_load_samples(struct um_context *context, const struct um_model *model,
                                     const double *times, size_t n,
                                     struct um_environment_sample **out);
/* Loads and view factors at times [ntime]; edge [nevent] of the tables, whose observed
 * instants, events and spin_period are set. */
enum um_status um_model_precompute_loads(struct um_context *context, const struct um_model *model,
                                         const double *times, size_t ntime, const double *edge,
                                         struct um_model_tables *tables);
#endif
