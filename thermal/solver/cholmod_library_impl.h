/* Private to thermal/solver/: the functions of CHOLMOD. */
#ifndef UMBRA_THERMAL_CHOLMOD_LIBRARY_IMPL_H
#define UMBRA_THERMAL_CHOLMOD_LIBRARY_IMPL_H

#include <cholmod.h>

#include "base/core/context.h"

#define UM_THERMAL_CHOLMOD_LIST(X)                                                                 \
  X(start) X(finish) X(analyze) X(factorize) X(solve2) X(free_factor) X(free_dense)

/* Each is cholmod_l_NAME. */
struct um_thermal_cholmod_library {
#define UM_THERMAL_CHOLMOD_FIELD(name) __typeof__(cholmod_l_##name) *name;
  UM_THERMAL_CHOLMOD_LIST(UM_THERMAL_CHOLMOD_FIELD)
#undef UM_THERMAL_CHOLMOD_FIELD
};

/* Opened once for the process, with a BLAS of one thread. Borrowed for ever. UM_ERR_LIBRARY: none
 * of the name it was built with; UM_ERR_MEMORY. */
enum um_status um_thermal_cholmod_open(struct um_context *context,
                                       const struct um_thermal_cholmod_library **out);

#endif
