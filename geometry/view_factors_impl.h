/* Private to geometry/: closure of sampled exchange areas. */
#ifndef UMBRA_GEOMETRY_VIEW_FACTORS_IMPL_H
#define UMBRA_GEOMETRY_VIEW_FACTORS_IMPL_H

#include "geometry/view_factors.h"

/* Error of a row that counts as closed: rounding, and what a room of few rays keeps [1]. */
#define UM_GEOMETRY_VIEW_FACTORS_CLOSED 1e-9

/* Change area and space so that every row has the sum wanted[npatch]; see view_factors_close.c.
 * Sets unclosed and residual. UM_ERR_NUMERIC when it does not converge. */
enum um_status um_geometry_view_factors_close(struct um_context *context,
                                              struct um_geometry_view_factors *factors,
                                              const double *wanted);

#endif
