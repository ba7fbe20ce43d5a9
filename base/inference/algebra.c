/* Dense linear least squares by QR with column pivoting (Golub & Van Loan 2013, Matrix
 * Computations, section 5.4.2; Businger & Golub 1965, Numer. Math. 7:269), Householder vectors by
 * GSL:
 *
 *   A S^-1 P = Q R,   S = diag |a_j|,   |R_11| >= |R_22| >= ...
 *
 * The rank is the number of |R_jj| above a tolerance. What follows those is 0 to within it, so the
 * unknowns beyond the rank are set to 0 (the basic solution). All memory of it is the context's.
 * Eigenvalues are GSL's. */
#include "base/inference/algebra.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <string.h>

struct um_inference_qr {
  size_t nrow, ncolumn, rank;
  double *a;     /* [nrow][ncolumn] packed as GSL has it */
  double *tau;   /* [min(nrow, ncolumn)] */
  double *norm;  /* [ncolumn] of GSL's */
  double *scale; /* [ncolumn] lengths of the columns; 1 for 0 */
  size_t *order; /* [ncolumn] column at place j */
};

double um_inference_dot(size_t n, const double *a, const double *b)
{
  double sum[4] = {0.0}; /* four chains that do not wait for each other */
  size_t i = 0;
  for (; i + 4 <= n; i += 4)
    for (size_t k = 0; k < 4; k++) sum[k] += a[i + k] * b[i + k];
  for (; i < n; i++) sum[0] += a[i] * b[i];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

static enum um_status reserve(struct um_context *context, struct um_inference_qr *qr)
{
  size_t least = qr->nrow < qr->ncolumn ? qr->nrow : qr->ncolumn;
  UM_TRY(um_core_allocate(context, qr->nrow * qr->ncolumn, sizeof *qr->a, &qr->a));
  UM_TRY(um_core_allocate(context, least, sizeof *qr->tau, &qr->tau));
  UM_TRY(um_core_allocate(context, qr->ncolumn, sizeof *qr->norm, &qr->norm));
  UM_TRY(um_core_allocate(context, qr->ncolumn, sizeof *qr->scale, &qr->scale));
  return um_core_allocate(context, qr->ncolumn, sizeof *qr->order, &qr->order);
}

/* Columns in, of length 1. */
static enum um_status fill(struct um_context *context, struct um_inference_qr *qr,
                           const double *column)
{
  for (size_t j = 0; j < qr->ncolumn; j++) {
    const double *c = column + j * qr->nrow;
    double length = sqrt(um_inference_dot(qr->nrow, c, c));
    if (!isfinite(length))
      return um_core_fail(context, UM_ERR_NUMERIC, "a column of a linear system is not finite");
    qr->scale[j] = length > 0.0 ? length : 1.0;
    for (size_t i = 0; i < qr->nrow; i++) qr->a[i * qr->ncolumn + j] = c[i] / qr->scale[j];
  }
  return UM_OK;
}

static enum um_status decompose(struct um_context *context, struct um_inference_qr *qr,
                                double tolerance)
{
  size_t least = qr->nrow < qr->ncolumn ? qr->nrow : qr->ncolumn;
  if (least == 0) return UM_OK;
  gsl_set_error_handler_off();
  gsl_matrix_view a = gsl_matrix_view_array(qr->a, qr->nrow, qr->ncolumn);
  gsl_vector_view tau = gsl_vector_view_array(qr->tau, least);
  gsl_vector_view norm = gsl_vector_view_array(qr->norm, qr->ncolumn);
  gsl_permutation order = {.size = qr->ncolumn, .data = qr->order};
  int sign, code;
  code = gsl_linalg_QRPT_decomp(&a.matrix, &tau.vector, &order, &sign, &norm.vector);
  if (code != GSL_SUCCESS)
    return um_core_fail(context, UM_ERR_LIBRARY, "GSL's QR decomposition: %s", gsl_strerror(code));
  while (qr->rank < least && fabs(qr->a[qr->rank * qr->ncolumn + qr->rank]) > tolerance) qr->rank++;
  return UM_OK;
}

enum um_status um_inference_qr_create(struct um_context *context, size_t nrow, size_t ncolumn,
                                      const double *column, double tolerance,
                                      struct um_inference_qr **out)
{
  enum um_status status;
  struct um_inference_qr *qr = NULL;
  *out = NULL;
  UM_CHECK(um_core_stop_check(context, "linear systems were solved"));
  UM_CHECK(um_core_allocate(context, 1, sizeof *qr, &qr));
  qr->nrow = nrow;
  qr->ncolumn = ncolumn;
  UM_CHECK(reserve(context, qr));
  UM_CHECK(fill(context, qr, column));
  UM_CHECK(decompose(context, qr, tolerance));
  *out = qr;
  return UM_OK;
done:
  um_inference_qr_destroy(context, &qr);
  return status;
}

void um_inference_qr_destroy(struct um_context *context, struct um_inference_qr **qr)
{
  if (*qr == NULL) return;
  UM_FREE(context, (*qr)->a, (*qr)->tau, (*qr)->norm, (*qr)->scale, (*qr)->order, *qr);
  *qr = NULL;
}

size_t um_inference_qr_rank(const struct um_inference_qr *qr) { return qr->rank; }

/* The Householder vectors applied by GSL; sizes agree by construction, so that nothing fails. */
static void turn(const struct um_inference_qr *qr, double *v,
                 int (*apply)(const gsl_matrix *, const gsl_vector *, gsl_vector *))
{
  size_t least = qr->nrow < qr->ncolumn ? qr->nrow : qr->ncolumn;
  if (least == 0) return;
  gsl_matrix_const_view a = gsl_matrix_const_view_array(qr->a, qr->nrow, qr->ncolumn);
  gsl_vector_const_view tau = gsl_vector_const_view_array(qr->tau, least);
  gsl_vector_view vector = gsl_vector_view_array(v, qr->nrow);
  (void)apply(&a.matrix, &tau.vector, &vector.vector);
}

void um_inference_qr_rotate(const struct um_inference_qr *qr, double *v)
{
  turn(qr, v, gsl_linalg_QR_QTvec);
}

void um_inference_qr_rotate_back(const struct um_inference_qr *qr, double *v)
{
  turn(qr, v, gsl_linalg_QR_Qvec);
}

/* R_11 x = b in place, x [rank]. */
static void substitute(const struct um_inference_qr *qr, double *x)
{
  for (size_t i = qr->rank; i-- > 0;) {
    const double *row = qr->a + i * qr->ncolumn;
    for (size_t j = i + 1; j < qr->rank; j++) x[i] -= row[j] * x[j];
    x[i] /= row[i];
  }
}

void um_inference_qr_solve(const struct um_inference_qr *qr, const double *rotated, double *x)
{
  double *y = qr->norm; /* GSL is done with it */
  memset(x, 0, qr->ncolumn * sizeof *x);
  if (qr->rank == 0) return;
  memcpy(y, rotated, qr->rank * sizeof *y);
  substitute(qr, y);
  for (size_t j = 0; j < qr->rank; j++) x[qr->order[j]] = y[j] / qr->scale[qr->order[j]];
}

/* An unknown within the rank is determined unless a column beyond it, R_11^-1 R_12 in those within,
 * has a part of it. */
static void find_determined(const struct um_inference_qr *qr, double *t, bool *determined)
{
  const double share = 1e-6; /* of a column of length 1; the tolerance of the rank is far below */
  for (size_t j = 0; j < qr->ncolumn; j++) determined[qr->order[j]] = j < qr->rank;
  for (size_t k = qr->rank; k < qr->ncolumn; k++) {
    for (size_t i = 0; i < qr->rank; i++) t[i] = qr->a[i * qr->ncolumn + k];
    substitute(qr, t);
    for (size_t i = 0; i < qr->rank; i++)
      if (!(fabs(t[i]) <= share)) determined[qr->order[i]] = false;
  }
}

void um_inference_qr_covariance(const struct um_inference_qr *qr, double *work, double *covariance,
                                bool *determined)
{
  size_t n = qr->ncolumn;
  memset(covariance, 0, n * n * sizeof *covariance);
  if (determined != NULL) find_determined(qr, work, determined);
  for (size_t j = 0; j < qr->rank; j++) { /* columns of R^-1 as rows of work */
    memset(work + j * n, 0, n * sizeof *work);
    work[j * n + j] = 1.0;
    substitute(qr, work + j * n);
  }
  for (size_t i = 0; i < qr->rank; i++)
    for (size_t j = 0; j < qr->rank; j++) {
      size_t a = qr->order[i], b = qr->order[j];
      double sum = 0.0;
      for (size_t k = i > j ? i : j; k < qr->rank; k++) sum += work[k * n + i] * work[k * n + j];
      covariance[a * n + b] = sum / (qr->scale[a] * qr->scale[b]);
    }
}

void um_inference_qr_compress(const struct um_inference_qr *qr, double *r)
{
  size_t n = qr->ncolumn;
  memset(r, 0, n * n * sizeof *r);
  for (size_t i = 0; i < n && i < qr->nrow; i++)
    for (size_t j = i; j < n; j++)
      r[qr->order[j] * n + i] = qr->a[i * n + j] * qr->scale[qr->order[j]];
}

enum um_status um_inference_eigen(struct um_context *context, size_t n, double *a, double *value,
                                  double *vector)
{
  enum um_status status = UM_OK;
  gsl_set_error_handler_off();
  gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(n);
  gsl_matrix *columns = gsl_matrix_alloc(n, n);
  if (work == NULL || columns == NULL) {
    status = um_core_fail(context, UM_ERR_MEMORY, "out of memory");
    goto done;
  }
  gsl_matrix_view matrix = gsl_matrix_view_array(a, n, n);
  gsl_vector_view values = gsl_vector_view_array(value, n);
  int error = gsl_eigen_symmv(&matrix.matrix, &values.vector, columns, work);
  if (error == 0) error = gsl_eigen_symmv_sort(&values.vector, columns, GSL_EIGEN_SORT_VAL_DESC);
  if (error != 0)
    status = um_core_fail(context, UM_ERR_LIBRARY, "eigenvalues: %s", gsl_strerror(error));
  for (size_t k = 0; k < n; k++)
    for (size_t i = 0; i < n; i++) vector[k * n + i] = gsl_matrix_get(columns, i, k);
done:
  if (work != NULL) gsl_eigen_symmv_free(work);
  if (columns != NULL) gsl_matrix_free(columns);
  return status;
}
