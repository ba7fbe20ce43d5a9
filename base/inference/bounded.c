/* Linear least squares within bounds by active sets (Stark & Parker 1995, Comput. Stat. 10:129):
 * the free unknowns are solved for; where the solution leaves the bounds the step ends at the first
 * it meets, which is then fixed; where it does not, the fixed unknown whose slope points inward
 * most is freed; when there is none, the conditions of Kuhn and Tucker hold.
 *
 * The rows are first compressed to as many as there are unknowns, so that all this costs nothing
 * beside them. Damping and priors are rows. */
#include "base/inference/bounded_impl.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/policy.h"

#define SLOPE_TOLERANCE 1e-10 /* of the product of lengths */

/* Columns J S over the prior rows S / w, and the right side (r, p / w); a row that does not count
 * is 0. */
static void fill(const struct um_inference_rows *rows, double *column, double *right)
{
  size_t total = rows->nrow + rows->n;
  for (size_t i = 0; i < rows->nrow; i++) {
    bool counts = rows->fold == NULL || rows->fold[i] != rows->without;
    right[i] = counts ? rows->residual[i] : 0.0;
    for (size_t j = 0; j < rows->n; j++)
      column[j * total + i] = counts ? rows->jacobian[j * rows->nrow + i] * rows->scale[j] : 0.0;
  }
  for (size_t j = 0; j < rows->n; j++) {
    if (isinf(rows->width[j])) continue;
    column[j * total + rows->nrow + j] = rows->scale[j] / rows->width[j];
    right[rows->nrow + j] = rows->pull[j] / rows->width[j];
  }
}

enum um_status um_inference_system_create(struct um_context *context,
                                          const struct um_inference_rows *rows,
                                          struct um_inference_system *out)
{
  enum um_status status;
  size_t n = rows->n, total = rows->nrow + n;
  double *column = NULL, *right = NULL;
  struct um_inference_qr *qr = NULL;
  *out = (struct um_inference_system){.n = n};
  UM_CHECK(um_core_allocate(context, n * n, sizeof *out->r, &out->r));
  UM_CHECK(um_core_allocate(context, n, sizeof *out->y, &out->y));
  UM_CHECK(um_core_allocate(context, n * total, sizeof *column, &column));
  UM_CHECK(um_core_allocate(context, total, sizeof *right, &right));
  fill(rows, column, right);
  UM_CHECK(um_inference_qr_create(context, total, n, column, UM_INFERENCE_RANK_TOLERANCE, &qr));
  um_inference_qr_rotate(qr, right);
  um_inference_qr_compress(qr, out->r);
  memcpy(out->y, right, n * sizeof *right);
  out->rest = um_inference_dot(total - n, right + n, right + n);
done:
  UM_FREE(context, column, right);
  um_inference_qr_destroy(context, &qr);
  return status;
}

void um_inference_system_release(struct um_context *context, struct um_inference_system *system)
{
  UM_FREE(context, system->r, system->y);
  *system = (struct um_inference_system){0};
}

/* The search: 2n rows, the lower half the damping. */
struct search {
  size_t n, nrow;
  double *column; /* [n][nrow] */
  double *right;  /* [nrow] */
  double *error;  /* [nrow] right - A u */
  double *part;   /* [n][nrow] columns of the free unknowns */
  double *target; /* [n] where the free unknowns want to go */
  bool *fixed;    /* [n] */
};

static enum um_status search_create(struct um_context *context,
                                    const struct um_inference_system *system, double damping,
                                    struct search *s)
{
  size_t n = system->n, nrow = 2 * n;
  *s = (struct search){.n = n, .nrow = nrow};
  UM_TRY(um_core_allocate(context, n * nrow, sizeof *s->column, &s->column));
  UM_TRY(um_core_allocate(context, nrow, sizeof *s->right, &s->right));
  UM_TRY(um_core_allocate(context, nrow, sizeof *s->error, &s->error));
  UM_TRY(um_core_allocate(context, n * nrow, sizeof *s->part, &s->part));
  UM_TRY(um_core_allocate(context, n, sizeof *s->target, &s->target));
  UM_TRY(um_core_allocate(context, n, sizeof *s->fixed, &s->fixed));
  memcpy(s->right, system->y, n * sizeof *s->right);
  for (size_t j = 0; j < n; j++) {
    memcpy(s->column + j * nrow, system->r + j * n, n * sizeof *s->column);
    s->column[j * nrow + n + j] = sqrt(damping);
  }
  return UM_OK;
}

static void search_release(struct um_context *context, struct search *s)
{
  UM_FREE(context, s->column, s->right, s->error, s->part, s->target, s->fixed);
}

/* error = right - A u over the fixed unknowns, or over all. */
static void subtract(struct search *s, const double *u, bool all)
{
  memcpy(s->error, s->right, s->nrow * sizeof *s->error);
  for (size_t j = 0; j < s->n; j++) {
    if (!all && !s->fixed[j]) continue;
    for (size_t i = 0; i < s->nrow; i++) s->error[i] -= s->column[j * s->nrow + i] * u[j];
  }
}

/* Free unknowns solved for, the fixed ones at u. */
static enum um_status solve_free(struct um_context *context, struct search *s, const double *u)
{
  struct um_inference_qr *qr = NULL;
  size_t k = 0;
  for (size_t j = 0; j < s->n; j++)
    if (!s->fixed[j])
      memcpy(s->part + k++ * s->nrow, s->column + j * s->nrow, s->nrow * sizeof *s->part);
  subtract(s, u, false);
  UM_TRY(um_inference_qr_create(context, s->nrow, k, s->part, UM_INFERENCE_RANK_TOLERANCE, &qr));
  um_inference_qr_rotate(qr, s->error);
  um_inference_qr_solve(qr, s->error, s->target);
  um_inference_qr_destroy(context, &qr);
  for (size_t j = s->n; j-- > 0;) s->target[j] = s->fixed[j] ? u[j] : s->target[--k];
  return UM_OK;
}

/* u towards the target as far as the bounds let it; whether it got there. */
static bool advance(struct search *s, const double *lower, const double *upper, double *u)
{
  double way = 1.0;
  size_t first = SIZE_MAX;
  for (size_t j = 0; j < s->n; j++) {
    double limit = s->target[j] < lower[j] ? lower[j] : upper[j];
    if (s->fixed[j] || (s->target[j] >= lower[j] && s->target[j] <= upper[j])) continue;
    double part = (limit - u[j]) / (s->target[j] - u[j]);
    if (first != SIZE_MAX && part >= way) continue;
    first = j;
    way = part;
  }
  for (size_t j = 0; j < s->n; j++)
    u[j] = fmin(fmax(u[j] + way * (s->target[j] - u[j]), lower[j]), upper[j]);
  if (first == SIZE_MAX) return true;
  u[first] = s->target[first] < lower[first] ? lower[first] : upper[first];
  s->fixed[first] = true;
  return false;
}

/* Frees the unknown that would gain most; false: none would. */
static bool release_one(struct search *s, const double *lower, const double *upper, const double *u)
{
  double most = SLOPE_TOLERANCE * sqrt(um_inference_dot(s->nrow, s->right, s->right));
  size_t best = SIZE_MAX;
  subtract(s, u, true);
  for (size_t j = 0; j < s->n; j++) {
    const double *c = s->column + j * s->nrow;
    if (!s->fixed[j] || !(lower[j] < upper[j])) continue;
    double length = sqrt(um_inference_dot(s->nrow, c, c));
    double slope = um_inference_dot(s->nrow, c, s->error) / (length > 0.0 ? length : 1.0);
    double inward = u[j] <= lower[j] ? slope : -slope;
    if (!(inward > most)) continue;
    most = inward;
    best = j;
  }
  if (best == SIZE_MAX) return false;
  s->fixed[best] = false;
  return true;
}

enum um_status um_inference_system_solve(struct um_context *context,
                                         const struct um_inference_system *system, double damping,
                                         const double *lower, const double *upper, double *u,
                                         double *left)
{
  enum um_status status;
  struct search s;
  size_t n = system->n, rounds = 20 + 10 * n;
  memset(u, 0, n * sizeof *u);
  UM_CHECK(search_create(context, system, damping, &s));
  for (size_t j = 0; j < n; j++) s.fixed[j] = !(lower[j] < upper[j]);
  for (;; rounds--) {
    if (rounds == 0) {
      status = um_core_fail(context, UM_ERR_NUMERIC,
                            "the bounds that %zu parameters meet in a fit did not settle", n);
      goto done;
    }
    UM_CHECK(solve_free(context, &s, u));
    if (advance(&s, lower, upper, u) && !release_one(&s, lower, upper, u)) break;
  }
  subtract(&s, u, true);
  *left = system->rest + um_inference_dot(n, s.error, s.error);
done:
  search_release(context, &s);
  return status;
}
