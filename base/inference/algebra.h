/* Dense linear least squares by rank-revealing QR: with fit.c, score.c and what is built on them
 * the only user, and the only place, of GSL's linear algebra here. */
#ifndef UMBRA_INFERENCE_ALGEBRA_H
#define UMBRA_INFERENCE_ALGEBRA_H

#include <stddef.h>

#include "base/core/context.h"

struct um_inference_qr; /* opaque */

/* Pivoted QR of ncolumn columns of nrow rows, column [ncolumn][nrow], each scaled to length 1 first
 * so that units do not matter. Columns that the others express to within `tolerance` of their
 * length, and columns of length 0, do not count to the rank. UM_ERR_NUMERIC: a column is not
 * finite; UM_ERR_LIBRARY; UM_ERR_MEMORY. The caller destroys. */
enum um_status um_inference_qr_create(struct um_context *context, size_t nrow, size_t ncolumn,
                                      const double *column, double tolerance,
                                      struct um_inference_qr **out);
void um_inference_qr_destroy(struct um_context *context, struct um_inference_qr **qr);
size_t um_inference_qr_rank(const struct um_inference_qr *qr);

/* v [nrow] <- Q'v: its first `rank` numbers lie in the span of the columns, the others outside;
 * lengths and angles stay. And back. */
void um_inference_qr_rotate(const struct um_inference_qr *qr, double *v);
void um_inference_qr_rotate_back(const struct um_inference_qr *qr, double *v);

/* Least-squares solution x [ncolumn] for a rotated right side; 0 for columns beyond the rank. */
void um_inference_qr_solve(const struct um_inference_qr *qr, const double *rotated, double *x);

/* (A'A)^-1, covariance [ncolumn][ncolumn]. Rows and columns of those beyond the rank are 0.
 * determined [ncolumn] may be NULL: whether the rows determine the unknown, false for those beyond
 * the rank and for all that trade off against them. work [ncolumn][ncolumn]. */
void um_inference_qr_covariance(const struct um_inference_qr *qr, double *work, double *covariance,
                                bool *determined);

/* A as a square system: r [ncolumn][ncolumn] by columns in A's own order, r'r = A'A. */
void um_inference_qr_compress(const struct um_inference_qr *qr, double *r);

/* Eigenvalues [n] of a symmetric matrix a [n][n], falling, and their orthonormal vectors [n][n]; a
 * is overwritten. UM_ERR_LIBRARY, UM_ERR_MEMORY. */
enum um_status um_inference_eigen(struct um_context *context, size_t n, double *a, double *value,
                                  double *vector);

double um_inference_dot(size_t n, const double *a, const double *b);

#endif
