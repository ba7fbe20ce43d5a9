/* Rao's score test for Gaussian observations of unit sigma (Rao 1948, Proc. Camb. Phil. Soc.
 * 44:50). With r the residual and D the columns of a direction, both after the nuisances, and D =
 * QR,
 *
 *   S = |Q'r|^2 ~ chi-square, dof = rank D;   estimate R^-1 Q'r, covariance (D'D)^-1.
 *
 * A single column whose parameter can only go one way, z = sign * sqrt(S) ~ N(0, 1): p = P(Z > z),
 * half the chi-square tail where the sign is the allowed one, above 1/2 and S = 0 where it is not.
 *
 * The best of m directions of one test: p becomes 1 - (1 - p)^m, which bounds that of the largest
 * (Sidak).
 *
 * Family-wise p by Holm's steps (1979, Scand. J. Stat. 6:65) with Sidak's exponents (1967, JASA
 * 62:626): sorted, p~_(j) = max over i <= j of 1 - (1 - p_(i))^(m - i + 1). Single columns that
 * are one direction after the nuisances, with the same side allowed, are one test. */
#include "base/inference/score.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/distributions.h"
#include "base/inference/policy.h"
#include "base/inference/projection.h"

#define COLUMNS_MAX 8

/* A direction after the test, as the family needs it. */
struct member {
  double *unit; /* [nleft] its only direction in the observations; NULL: several, or absorbed */
  int side;     /* of unit, allowed to the parameter: -1, 1, or 0 for both */
  size_t leader;
};

/* Side that the bounds leave a single parameter: 0 for both. */
static int allowed_side(const struct um_inference_direction *d)
{
  if (d->ncolumn != 1) return 0;
  if (d->minimum_step[0] >= 0.0 && d->maximum_step[0] > 0.0) return 1;
  if (d->maximum_step[0] <= 0.0 && d->minimum_step[0] < 0.0) return -1;
  return 0;
}

static void absorb(const struct um_inference_direction *d, struct um_inference_score *out)
{
  out->absorbed = true;
  out->statistic = out->dof = 0.0;
  out->p = out->p_corrected = 1.0;
  for (size_t j = 0; j < d->ncolumn; j++) out->estimate[j] = out->sigma[j] = NAN;
}

/* Statistic, p and estimate from the QR of what is left of the columns; r [nleft] is rotated. */
static void evaluate(const struct um_inference_direction *d, const struct um_inference_qr *qr,
                     const double *r, struct um_inference_score *out)
{
  double covariance[COLUMNS_MAX * COLUMNS_MAX], work[COLUMNS_MAX * COLUMNS_MAX];
  bool determined[COLUMNS_MAX];
  size_t rank = um_inference_qr_rank(qr), n = d->ncolumn;
  out->dof = (double)rank;
  out->statistic = um_inference_dot(rank, r, r);
  out->p = um_inference_chi2_q(out->statistic, out->dof);
  um_inference_qr_solve(qr, r, out->estimate);
  um_inference_qr_covariance(qr, work, covariance, determined);
  for (size_t j = 0; j < n; j++) {
    out->sigma[j] = determined[j] ? sqrt(covariance[j * n + j]) : NAN;
    if (!determined[j]) out->estimate[j] = NAN;
  }
  int side = allowed_side(d);
  if (side == 0) return;
  bool inside = side * out->estimate[0] > 0.0;
  out->p = inside ? 0.5 * out->p : 1.0 - 0.5 * out->p;
  if (!inside) out->statistic = 0.0;
}

/* Unit vector of a direction that has one only. */
static void keep_unit(const struct um_inference_qr *qr, const struct um_inference_direction *d,
                      const double *left, size_t nleft, struct member *member)
{
  memset(member->unit, 0, nleft * sizeof *left);
  member->unit[0] = 1.0;
  um_inference_qr_rotate_back(qr, member->unit);
  member->side = allowed_side(d);
  if (um_inference_dot(nleft, member->unit, left) < 0.0) member->side = -member->side;
}

static enum um_status test_one(struct um_context *context, struct um_inference_projection *p,
                               const double *r, const struct um_inference_direction *d,
                               struct member *member, struct um_inference_score *out)
{
  enum um_status status;
  struct um_inference_qr *qr = NULL;
  double *left = NULL, *rotated = NULL;
  assert(d->ncolumn <= COLUMNS_MAX);
  *out = (struct um_inference_score){0};
  UM_CHECK(um_core_allocate(context, p->nleft * d->ncolumn, sizeof *left, &left));
  um_inference_projection_direction(p, d, left, &out->kept);
  UM_CHECK(um_inference_qr_create(context, p->nleft, d->ncolumn, left, UM_INFERENCE_RANK_TOLERANCE,
                                  &qr));
  if (out->kept < UM_INFERENCE_KEPT || um_inference_qr_rank(qr) == 0) {
    absorb(d, out);
    goto done;
  }
  UM_CHECK(um_core_allocate(context, p->nleft, sizeof *rotated, &rotated));
  memcpy(rotated, r, p->nleft * sizeof *r);
  um_inference_qr_rotate(qr, rotated);
  evaluate(d, qr, rotated, out);
  if (d->trials > 1) out->p = -expm1((double)d->trials * log1p(-out->p));
  if (d->ncolumn == 1) {
    UM_CHECK(um_core_allocate(context, p->nleft, sizeof *member->unit, &member->unit));
    keep_unit(qr, d, left, p->nleft, member);
  }
done:
  UM_FREE(context, left, rotated);
  um_inference_qr_destroy(context, &qr);
  return status;
}

static bool same_test(const struct member *a, const struct member *b, size_t nleft)
{
  if (a->unit == NULL || b->unit == NULL) return false;
  double cosine = um_inference_dot(nleft, a->unit, b->unit);
  if (!(fabs(cosine) > UM_INFERENCE_ONE_TEST)) return false;
  return b->side == (cosine > 0.0 ? a->side : -a->side);
}

/* Each direction follows the first that is the same test. */
static void find_leaders(size_t n, size_t nleft, struct member *member)
{
  for (size_t i = 0; i < n; i++) {
    member[i].leader = i;
    for (size_t k = 0; k < i && member[i].leader == i; k++)
      if (member[k].leader == k && same_test(&member[k], &member[i], nleft)) member[i].leader = k;
  }
}

/* Whether a is the more significant: p first, then the statistic, which does not underflow. */
static bool before(const struct um_inference_score *a, const struct um_inference_score *b)
{
  return a->p != b->p ? a->p < b->p : a->statistic > b->statistic;
}

/* order [n]: place for the leaders, sorted. */
static void correct(size_t n, const struct member *member, struct um_inference_score *score,
                    size_t *order)
{
  size_t count = 0;
  for (size_t i = 0; i < n; i++) {
    if (score[i].absorbed || member[i].leader != i) continue;
    size_t at = count++;
    for (; at > 0 && before(&score[i], &score[order[at - 1]]); at--) order[at] = order[at - 1];
    order[at] = i;
  }
  double last = 0.0;
  for (size_t j = 0; j < count; j++) {
    struct um_inference_score *s = &score[order[j]];
    /* 1 - (1 - p)^(m - j) without loss where p is small */
    last = fmax(last, -expm1((double)(count - j) * log1p(-s->p)));
    s->p_corrected = last;
  }
  for (size_t i = 0; i < n; i++)
    if (!score[i].absorbed) score[i].p_corrected = score[member[i].leader].p_corrected;
}

enum um_status um_inference_score_test(struct um_context *context, size_t nobservation,
                                       const double *residual,
                                       const struct um_inference_nuisance *nuisance,
                                       size_t ndirection,
                                       const struct um_inference_direction *direction,
                                       struct um_inference_score *out)
{
  enum um_status status;
  struct um_inference_projection projection = {0};
  struct member *member = NULL;
  double *r = NULL;
  size_t *order = NULL;
  UM_CHECK(um_inference_projection_create(context, nobservation, nuisance, &projection));
  UM_CHECK(um_core_allocate(context, ndirection, sizeof *member, &member));
  UM_CHECK(um_core_allocate(context, ndirection, sizeof *order, &order));
  UM_CHECK(um_core_allocate(context, projection.nleft, sizeof *r, &r));
  um_inference_projection_apply(&projection, residual, r);
  for (size_t i = 0; i < ndirection; i++)
    UM_CHECK(test_one(context, &projection, r, &direction[i], &member[i], &out[i]));
  find_leaders(ndirection, projection.nleft, member);
  correct(ndirection, member, out, order);
done:
  for (size_t i = 0; member != NULL && i < ndirection; i++) um_core_free(context, member[i].unit);
  UM_FREE(context, member, order, r);
  um_inference_projection_destroy(context, &projection);
  return status;
}
