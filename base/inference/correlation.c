/* Correlation of a channel's rows by few eigenvectors: a pivoted Cholesky factor G of few columns,
 * K = GG' to within a small trace (Harbrecht, Peters & Schneider 2012, Appl. Numer. Math. 62:428),
 * and the eigenvectors V of the small matrix G'G = V L V':
 *
 *   U = G V L^-1/2,   K = U L U'. */
#include "base/inference/correlation.h"

#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/policy.h"

struct rows {
  size_t n, ndimension;
  const size_t *row;
  const double *z;
};

static double kernel(const struct rows *r, size_t i, size_t j)
{
  double square = 0.0;
  for (size_t d = 0; d < r->ndimension; d++) {
    double away = r->z[r->row[i] * r->ndimension + d] - r->z[r->row[j] * r->ndimension + d];
    square += away * away;
  }
  double away = sqrt(3.0 * square);
  return 0.5 * ((1.0 + away) * exp(-away) + 1.0);
}

/* Columns of G: [rank][n]; left: [n] diagonal of K - GG'. *rank: above the most where it is not
 * enough. */
static void factor(const struct rows *r, size_t most, double *g, double *left, size_t *rank)
{
  double trace = (double)r->n;
  for (size_t i = 0; i < r->n; i++) left[i] = 1.0;
  for (*rank = 0; trace > UM_INFERENCE_CORRELATION_LEFT * (double)r->n; (*rank)++) {
    if (*rank == most) {
      *rank = most + 1;
      return;
    }
    double *column = g + *rank * r->n;
    size_t pivot = 0;
    for (size_t i = 1; i < r->n; i++)
      if (left[i] > left[pivot]) pivot = i;
    double root = sqrt(left[pivot]);
    for (size_t i = 0; i < r->n; i++) {
      double sum = kernel(r, i, pivot);
      for (size_t k = 0; k < *rank; k++) sum -= g[k * r->n + i] * g[k * r->n + pivot];
      column[i] = sum / root;
    }
    trace = 0.0;
    for (size_t i = 0; i < r->n; i++) {
      left[i] = fmax(0.0, left[i] - column[i] * column[i]);
      trace += left[i];
    }
  }
}

static enum um_status eigen(struct um_context *context, const double *g, size_t n, size_t rank,
                            struct um_inference_correlation_part *part)
{
  enum um_status status;
  double *small = NULL, *vector = NULL;
  UM_CHECK(um_core_allocate(context, rank * rank, sizeof *small, &small));
  UM_CHECK(um_core_allocate(context, rank * rank, sizeof *vector, &vector));
  UM_CHECK(um_core_allocate(context, rank, sizeof *part->value, &part->value));
  UM_CHECK(um_core_allocate(context, rank * n, sizeof *part->basis, &part->basis));
  for (size_t a = 0; a < rank; a++)
    for (size_t b = 0; b <= a; b++)
      small[a * rank + b] = small[b * rank + a] = um_inference_dot(n, g + a * n, g + b * n);
  UM_CHECK(um_inference_eigen(context, rank, small, part->value, vector));
  for (size_t k = 0; k < rank; k++) {
    double *u = part->basis + k * n, root = sqrt(part->value[k]);
    memset(u, 0, n * sizeof *u);
    for (size_t a = 0; a < rank; a++)
      for (size_t i = 0; i < n; i++) u[i] += g[a * n + i] * vector[k * rank + a] / root;
  }
  part->rank = rank;
done:
  UM_FREE(context, small, vector);
  return status;
}

static enum um_status part_make(struct um_context *context, const struct rows *rows, bool *enough,
                                struct um_inference_correlation_part *part)
{
  enum um_status status;
  double *g = NULL, *left = NULL;
  size_t rank = 0, n = rows->n;
  size_t most = n < UM_INFERENCE_CORRELATION_RANK ? n : UM_INFERENCE_CORRELATION_RANK;
  *enough = true;
  if (n == 0) return UM_OK;
  UM_CHECK(um_core_allocate(context, most * n, sizeof *g, &g));
  UM_CHECK(um_core_allocate(context, n, sizeof *left, &left));
  factor(rows, most, g, left, &rank);
  *enough = rank <= most;
  if (*enough) UM_CHECK(eigen(context, g, n, rank, part));
done:
  UM_FREE(context, g, left);
  return status;
}

enum um_status um_inference_correlation_create(struct um_context *context, const char *name,
                                               size_t nobservation, const size_t *channel,
                                               size_t nchannel, size_t ndimension, const double *z,
                                               struct um_inference_correlation **out)
{
  enum um_status status;
  struct um_inference_correlation *c = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *c, &c));
  c->name = name;
  c->nchannel = nchannel;
  UM_CHECK(um_core_allocate(context, nchannel, sizeof *c->part, &c->part));
  for (size_t k = 0; k < nchannel; k++) {
    struct um_inference_correlation_part *part = &c->part[k];
    bool enough;
    UM_CHECK(um_core_allocate(context, nobservation, sizeof *part->row, &part->row));
    for (size_t j = 0; j < nobservation; j++)
      if (channel[j] == k) part->row[part->nrow++] = j;
    const struct rows rows = {part->nrow, ndimension, part->row, z};
    UM_CHECK(part_make(context, &rows, &enough, part));
    if (!enough) goto done;
  }
  *out = c;
  c = NULL;
done:
  um_inference_correlation_destroy(context, &c);
  return status;
}

void um_inference_correlation_destroy(struct um_context *context,
                                      struct um_inference_correlation **correlation)
{
  struct um_inference_correlation *c = *correlation;
  if (c == NULL) return;
  for (size_t k = 0; c->part != NULL && k < c->nchannel; k++)
    UM_FREE(context, c->part[k].row, c->part[k].basis, c->part[k].value);
  UM_FREE(context, c->part, c);
  *correlation = NULL;
}
