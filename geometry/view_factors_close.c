/* Closure of exchange areas by least squares.
 *
 * Rays are counts, so the variance of a sampled area s_pq is proportional to it, and the smallest
 * change in the sense of its errors that gives every row its sum A_p minimises
 *
 *   sum_{p <= q} (S_pq - s_pq)^2 / s_pq   with   sum_q S_pq = A_p   (space and p itself included),
 *
 * a quadratic problem with the answer
 *
 *   S_pq = s_pq (1 + l_p + l_q),  S_p,space = s_p,space (1 + l_p),  S_pp = s_pp (1 + l_p),
 *   sum_{q /= p} s_pq (l_p + l_q) + (s_p,space + s_pp) l_p = A_p - sum_q s_pq:
 *
 * a symmetric matrix without a negative eigenvalue, solved by conjugate gradients on the diagonal's
 * scale. Zeros stay zero. Where a factor would be negative, which wants rows that are wrong by more
 * than half, the entry stays at a hundredth of itself and the step is made again from there.
 * (Lawson and Hanson 1995 treat bounds like these; van Leersum 1989, Int. J. Heat Fluid Flow 10:83,
 * and Taylor and Luck 1995, J. Thermophys. Heat Transfer 9:660, rectify view factors this way.) */
#include "geometry/view_factors_impl.h"

#include <math.h>
#include <string.h>

#define SMALLEST   0.01                            /* factor of one step */
#define CLOSED     1e-13                           /* residual of a row that is good enough [1] */
#define ACCEPTED   UM_GEOMETRY_VIEW_FACTORS_CLOSED /* a room of few rays without a way out */
#define STEPS      50
#define ITERATIONS 2000

struct closure {
  struct um_geometry_view_factors *f;
  const double *wanted;            /* [npatch] [m^2] */
  double *diagonal, *right, *l;    /* [npatch] */
  double *residual, *along, *turn; /* [npatch] of conjugate gradients */
};

/* y = M x. */
static void multiply(const struct closure *c, const double *x, double *y)
{
  const struct um_geometry_view_factors *f = c->f;
  for (size_t p = 0; p < f->npatch; p++) {
    double sum = c->diagonal[p] * x[p];
    for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++)
      if (f->other[e] != p) sum += f->area[e] * x[f->other[e]];
    y[p] = sum;
  }
}

/* Fills diagonal and right; the largest relative error of a row. */
static double rows_sum(struct closure *c)
{
  const struct um_geometry_view_factors *f = c->f;
  double worst = 0.0;
  for (size_t p = 0; p < f->npatch; p++) {
    double sum = f->space[p];
    for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++) sum += f->area[e];
    c->diagonal[p] = sum;
    c->right[p] = c->wanted[p] - sum;
    worst = fmax(worst, fabs(c->right[p]) / c->wanted[p]);
  }
  return worst;
}

static double product(const double *a, const double *b, size_t n)
{
  double sum = 0.0;
  for (size_t i = 0; i < n; i++) sum += a[i] * b[i];
  return sum;
}

/* l = M^-1 right, preconditioned with the diagonal. */
static void solve(struct closure *c)
{
  size_t n = c->f->npatch;
  memset(c->l, 0, n * sizeof *c->l);
  memcpy(c->residual, c->right, n * sizeof *c->right);
  for (size_t p = 0; p < n; p++) c->along[p] = c->residual[p] / c->diagonal[p];
  double before = product(c->residual, c->along, n), first = before;
  for (int k = 0; k < ITERATIONS && before > 1e-30 * first; k++) {
    multiply(c, c->along, c->turn);
    double curvature = product(c->along, c->turn, n);
    if (!(curvature > 0.0)) return; /* along a null direction: what is left cannot be closed */
    double step = before / curvature, after = 0.0;
    for (size_t p = 0; p < n; p++) {
      c->l[p] += step * c->along[p];
      c->residual[p] -= step * c->turn[p];
      after += c->residual[p] * c->residual[p] / c->diagonal[p];
    }
    for (size_t p = 0; p < n; p++)
      c->along[p] = c->residual[p] / c->diagonal[p] + after / before * c->along[p];
    before = after;
  }
}

static void take(struct closure *c)
{
  struct um_geometry_view_factors *f = c->f;
  for (size_t p = 0; p < f->npatch; p++) {
    for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++) {
      size_t q = f->other[e];
      /* the same sum for both directions: the larger index last */
      double factor = q == p  ? 1.0 + c->l[p]
                      : q > p ? 1.0 + (c->l[p] + c->l[q])
                              : 1.0 + (c->l[q] + c->l[p]);
      f->area[e] *= fmax(factor, SMALLEST);
    }
    f->space[p] *= fmax(1.0 + c->l[p], SMALLEST);
  }
}

/* A patch of which no ray is left sees space alone. */
static void fill_empty(struct um_geometry_view_factors *f, const double *wanted)
{
  for (size_t p = 0; p < f->npatch; p++) {
    double sum = f->space[p];
    for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++) sum += f->area[e];
    if (!(sum > 0.0)) f->space[p] = wanted[p];
  }
}

enum um_status um_geometry_view_factors_close(struct um_context *context,
                                              struct um_geometry_view_factors *factors,
                                              const double *wanted)
{
  enum um_status status = UM_OK;
  struct closure c = {.f = factors, .wanted = wanted};
  double *block = NULL;
  size_t n = factors->npatch;
  UM_CHECK(um_core_allocate(context, 6 * n, sizeof *block, &block));
  double **const vectors[6] = {&c.diagonal, &c.right, &c.l, &c.residual, &c.along, &c.turn};
  for (size_t k = 0; k < 6; k++) *vectors[k] = block + k * n;
  fill_empty(factors, wanted);
  factors->unclosed = factors->residual = rows_sum(&c);
  for (int k = 0; k < STEPS && !(factors->residual <= CLOSED); k++) {
    UM_CHECK(um_core_stop_check(context, "view factors were closed"));
    solve(&c);
    take(&c);
    double after = rows_sum(&c);
    bool stuck = after <= ACCEPTED && after >= 0.5 * factors->residual;
    factors->residual = after;
    if (stuck) break;
  }
  if (!(factors->residual <= ACCEPTED))
    status = um_core_fail(context, UM_ERR_NUMERIC,
                          "view factors do not close: a row is wrong by %.3g; accepted: more rays",
                          factors->residual);
done:
  um_core_free(context, block);
  return status;
}
