/* Arrays of a run, of a scenario or of a variant. Private to library/. */
#ifndef UMBRA_LIBRARY_RUN_IMPL_H
#define UMBRA_LIBRARY_RUN_IMPL_H

#include "library/result_impl.h"
#include "model/geometry/tables.h"
#include "model/run/result.h"

/* What a result shows of a run; all of it outlives the result. UM_ERR_MEMORY. */
enum um_status um_library_run_arrays(struct um_context *context, const struct um_model *model,
                                     const struct um_model_tables *tables,
                                     const struct um_model_result *run, struct umbra_result *to);

#endif
