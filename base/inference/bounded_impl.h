/* Linear least squares with priors and within bounds: the problem within each
 * step of a fit. Private to base/inference/. */
#ifndef UMBRA_INFERENCE_BOUNDED_IMPL_H
#define UMBRA_INFERENCE_BOUNDED_IMPL_H

#include <stddef.h>

#include "base/core/context.h"

/* |r - J S u|^2 + sum_j ((p_j - s_j u_j) / w_j)^2 = |y - R u|^2 + rest in the scaled unknowns u. */
struct um_inference_system {
  size_t n;
  double *r; /* [n][n] by columns */
  double *y; /* [n] */
  double rest;
};
struct um_inference_rows {
  size_t nrow, n;
  const double *jacobian; /* [n][nrow] J */
  const double *residual; /* [nrow] r */
  const size_t *fold;     /* [nrow] NULL: all rows count; otherwise those whose fold is not .. */
  size_t without;
  const double *scale; /* [n] s > 0 */
  const double *pull;  /* [n] p: from here to the prior's mean */
  const double *width; /* [n] w of the prior; INFINITY: none */
};
/* UM_ERR_NUMERIC: a row is not finite; UM_ERR_LIBRARY; UM_ERR_MEMORY. The caller releases what was
 * begun, after an error too. */
enum um_status um_inference_system_create(struct um_context *context,
                                          const struct um_inference_rows *rows,
                                          struct um_inference_system *out);
void um_inference_system_release(struct um_context *context, struct um_inference_system *system);

/* u [n] that minimises |y - R u|^2 + damping |u|^2 with lower <= u <= upper, lower <= 0 <= upper;
 * left: |y - R u|^2 + rest there. UM_ERR_NUMERIC: the active set did not settle. UM_ERR_MEMORY. */
enum um_status um_inference_system_solve(struct um_context *context,
                                         const struct um_inference_system *system, double damping,
                                         const double *lower, const double *upper, double *u,
                                         double *left);

#endif
