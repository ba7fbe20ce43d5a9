/* The least p among many directions, of noise alone. Scores are linear in the residual: with Q_i an
 * orthonormal basis of a direction after the nuisances,
 *
 *   S_i = |Q_i' e|^2,   e ~ N(0, I) after the nuisances,
 *
 * so that a draw costs a product with the bases. */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "base/inference/algebra.h"
#include "base/inference/distributions.h"
#include "base/inference/policy.h"
#include "base/inference/projection.h"
#include "base/inference/score.h"

/* A direction after the nuisances. */
struct basis {
  double *q; /* [rank][nleft] */
  size_t rank;
  bool one_sided;
  double trials;
};

static enum um_status basis_make(struct um_context *context, struct um_inference_projection *p,
                                 const struct um_inference_direction *d, struct basis *out)
{
  enum um_status status;
  double *left = NULL, kept;
  struct um_inference_qr *qr = NULL;
  UM_CHECK(um_core_allocate(context, p->nleft * d->ncolumn, sizeof *left, &left));
  um_inference_projection_direction(p, d, left, &kept);
  UM_CHECK(um_inference_qr_create(context, p->nleft, d->ncolumn, left, UM_INFERENCE_RANK_TOLERANCE,
                                  &qr));
  if (kept < UM_INFERENCE_KEPT) goto done;
  out->rank = um_inference_qr_rank(qr);
  out->trials = d->trials > 1 ? (double)d->trials : 1.0;
  out->one_sided = d->ncolumn == 1 && (d->minimum_step[0] >= 0.0 || d->maximum_step[0] <= 0.0);
  UM_CHECK(um_core_allocate(context, out->rank * p->nleft, sizeof *out->q, &out->q));
  for (size_t k = 0; k < out->rank; k++) {
    out->q[k * p->nleft + k] = 1.0;
    um_inference_qr_rotate_back(qr, out->q + k * p->nleft);
  }
done:
  um_core_free(context, left);
  um_inference_qr_destroy(context, &qr);
  return status;
}

/* The p of a draw e [n]. A single column's sign is even odds: one side is the allowed one. */
static double p_of(const struct basis *b, const double *e, size_t n)
{
  double s = 0.0, last = 0.0;
  for (size_t k = 0; k < b->rank; k++) {
    last = um_inference_dot(n, b->q + k * n, e);
    s += last * last;
  }
  double p = um_inference_chi2_q(s, (double)b->rank);
  if (b->one_sided) p = last > 0.0 ? 0.5 * p : 1.0 - 0.5 * p;
  return -expm1(b->trials * log1p(-p));
}

static void draw(uint64_t key, double *e, size_t n)
{
  for (size_t i = 0; i < n; i++) { /* Box & Muller 1958 */
    double u = um_core_hash_uniform(um_core_hash(key, 2 * i));
    double v = um_core_hash_uniform(um_core_hash(key, 2 * i + 1));
    e[i] = sqrt(-2.0 * log(1.0 - u)) * cos(2.0 * UM_PI * v);
  }
}

enum um_status um_inference_search_p(struct um_context *context, size_t nobservation,
                                     const struct um_inference_nuisance *nuisance,
                                     size_t ndirection,
                                     const struct um_inference_direction *direction, double least_p,
                                     size_t draws, uint64_t seed, double *out)
{
  enum um_status status;
  struct um_inference_projection projection = {0};
  struct basis *basis = NULL;
  double *e = NULL;
  size_t below = 0;
  UM_CHECK(um_inference_projection_create(context, nobservation, nuisance, &projection));
  UM_CHECK(um_core_allocate(context, ndirection, sizeof *basis, &basis));
  UM_CHECK(um_core_allocate(context, projection.nleft, sizeof *e, &e));
  for (size_t i = 0; i < ndirection; i++)
    UM_CHECK(basis_make(context, &projection, &direction[i], &basis[i]));
  for (size_t k = 0; k < draws; k++) {
    double least = 1.0;
    draw(um_core_hash(seed, k), e, projection.nleft);
    for (size_t i = 0; i < ndirection; i++)
      if (basis[i].rank > 0) least = fmin(least, p_of(&basis[i], e, projection.nleft));
    below += least <= least_p;
  }
  *out = ((double)below + 1.0) / ((double)draws + 1.0);
done:
  for (size_t i = 0; basis != NULL && i < ndirection; i++) um_core_free(context, basis[i].q);
  UM_FREE(context, basis, e);
  um_inference_projection_destroy(context, &projection);
  return status;
}
