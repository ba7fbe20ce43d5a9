/* Adaptive multiple importance sampling (Cornuet, Marin, Mira & Robert 2012, Scand. J. Stat.
 * 39:798). Round k draws from a Student t of NU degrees of freedom, mean m_k and scale matrix WIDER
 * S_k, first those of the problem, then those of all weighted draws so far. A draw outside the
 * bounds costs nothing, is counted, and is made anew. With n_k the count of round k, those outside
 * with it, the weight of any draw is that of the mixture of all rounds (Veach & Guibas 1995; Owen &
 * Zhou 2000, J. Am. Stat. Assoc. 95:135),
 *
 *   w(x) = p(x) / sum_k n_k q_k(x),
 *
 * which is bounded where one of the rounds covers p. */
#include "base/uncertainty/posterior.h"

#include <math.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "base/uncertainty/statistics.h"

#define ROUNDS 4
/* Degrees of freedom: heavier tails than a posterior that is nearly normal; even, so that chi2
 * comes by logarithms. */
#define NU 6
/* Of the scale matrix: tails of few draws are not missed, for an eighth of their worth. */
#define WIDER 1.5
/* For a draw within the bounds, at most. */
#define TRIES 1000

/* One round's proposal: its scale matrix is the inverse of L L'. */
struct round {
  double *mean, *lower; /* [d], [d][d] L */
  double log_determinant, count;
};

struct work {
  const struct um_uncertainty_posterior_problem *problem;
  struct um_uncertainty_posterior *out;
  struct round round[ROUNDS];
  size_t nround;
  double *log_density, *log_weight; /* [ndraw] */
  double *room;                     /* [d][d] and more */
  uint64_t drawn;
};

/* a [d][d] <- L below its diagonal and on it; false: not positive. */
static bool factor(size_t d, double *a)
{
  gsl_matrix_view m = gsl_matrix_view_array(a, d, d);
  gsl_set_error_handler_off();
  return gsl_linalg_cholesky_decomp1(&m.matrix) == GSL_SUCCESS;
}

/* a [d][d] <- the inverse of L L'. */
static void invert(size_t d, const double *lower, double *a)
{
  gsl_matrix_view m = gsl_matrix_view_array(a, d, d);
  memcpy(a, lower, d * d * sizeof *a);
  gsl_linalg_cholesky_invert(&m.matrix);
}

/* ---- proposals ---- */

/* The next round, about a mean with a precision. */
static enum um_status propose(struct um_context *context, struct work *w, const double *mean,
                              const double *precision)
{
  size_t d = w->problem->nparameter;
  struct round *r = &w->round[w->nround++];
  UM_TRY(um_core_allocate(context, d, sizeof *r->mean, &r->mean));
  UM_TRY(um_core_allocate(context, d * d, sizeof *r->lower, &r->lower));
  memcpy(r->mean, mean, d * sizeof *mean);
  for (size_t i = 0; i < d * d; i++) r->lower[i] = precision[i] / WIDER;
  if (!factor(d, r->lower))
    return um_core_fail(context, UM_ERR_NUMERIC,
                        "no draws from a posterior that the fit does not determine");
  for (size_t i = 0; i < d; i++) r->log_determinant += log(r->lower[i * d + i]);
  return UM_OK;
}

/* Logarithm of q_k, but for a constant that all rounds share. */
static double log_proposal(size_t d, const struct round *r, const double *x)
{
  double square = 0.0;
  for (size_t j = 0; j < d; j++) { /* |L'(x - m)|^2 */
    double y = 0.0;
    for (size_t i = j; i < d; i++) y += r->lower[i * d + j] * (x[i] - r->mean[i]);
    square += y * y;
  }
  return r->log_determinant - 0.5 * ((double)NU + (double)d) * log1p(square / NU);
}

static double uniform(struct work *w)
{
  return um_core_hash_uniform(um_core_hash(w->problem->seed, w->drawn++));
}

static double normal(struct work *w)
{
  double u = 1.0 - uniform(w), v = uniform(w);
  return sqrt(-2.0 * log(u)) * cos(2.0 * UM_PI * v);
}

/* A draw of the round, wherever it lies: m + L'^-1 z sqrt(NU / chi2_NU). */
static void draw(struct work *w, const struct round *r, double *x)
{
  size_t d = w->problem->nparameter;
  double chi2 = 0.0;
  for (int k = 0; k < NU / 2; k++) chi2 -= 2.0 * log(1.0 - uniform(w));
  double stretch = sqrt(NU / chi2);
  for (size_t i = 0; i < d; i++) x[i] = normal(w);
  for (size_t i = d; i-- > 0;) {
    for (size_t k = i + 1; k < d; k++) x[i] -= r->lower[k * d + i] * x[k];
    x[i] /= r->lower[i * d + i];
  }
  for (size_t i = 0; i < d; i++) x[i] = r->mean[i] + stretch * x[i];
}

static bool within(const struct um_uncertainty_posterior_problem *problem, const double *x)
{
  for (size_t i = 0; i < problem->nparameter; i++)
    if (!(x[i] >= problem->least[i] && x[i] <= problem->most[i])) return false;
  return true;
}

static enum um_status draw_within(struct um_context *context, struct work *w, struct round *r,
                                  double *x)
{
  for (int k = 0; k < TRIES; k++) {
    draw(w, r, x);
    r->count += 1.0;
    if (within(w->problem, x)) return UM_OK;
  }
  return um_core_fail(context, UM_ERR_NUMERIC,
                      "no draws from a posterior of which hardly anything lies within its ranges");
}

/* ---- rounds ---- */

/* Draw and compute up to draw `end`, by the last proposal. */
static enum um_status compute(struct um_context *context, struct work *w, size_t end)
{
  size_t d = w->problem->nparameter;
  struct um_uncertainty_posterior *out = w->out;
  while (out->n < end) {
    size_t n = end - out->n < UM_UNCERTAINTY_AT_ONCE ? end - out->n : UM_UNCERTAINTY_AT_ONCE;
    double *x = out->x + out->n * d;
    for (size_t i = 0; i < n; i++)
      UM_TRY(draw_within(context, w, &w->round[w->nround - 1], x + i * d));
    UM_TRY(w->problem->density(context, w->problem->user, n, x, w->log_density + out->n));
    UM_TRY(um_core_progress_step(context, n));
    out->n += n;
  }
  return UM_OK;
}

static enum um_status weigh(struct um_context *context, struct work *w)
{
  struct um_uncertainty_posterior *out = w->out;
  for (size_t i = 0; i < out->n; i++) {
    double most = -INFINITY, sum = 0.0, log_q[ROUNDS];
    for (size_t k = 0; k < w->nround; k++) {
      log_q[k] = log(w->round[k].count) +
                 log_proposal(out->nparameter, &w->round[k], out->x + i * out->nparameter);
      most = fmax(most, log_q[k]);
    }
    for (size_t k = 0; k < w->nround; k++) sum += exp(log_q[k] - most);
    w->log_weight[i] = w->log_density[i] - most - log(sum);
  }
  enum um_status status =
      um_uncertainty_weights(context, out->n, w->log_weight, out->weight, &out->effective);
  return status == UM_ERR_INPUT ? UM_ERR_NUMERIC : status;
}

/* The proposal of the next round: moments of the draws so far, and beside them, as much as d + 1
 * draws, those of the last one, so that a few heavy draws do not make it narrow. */
static enum um_status adapt(struct um_context *context, struct work *w)
{
  size_t d = w->problem->nparameter;
  const struct round *last = &w->round[w->nround - 1];
  double *mean = w->room, *s = mean + d, *before = s + d * d;
  double share = w->out->effective / (w->out->effective + (double)d + 1.0);
  um_uncertainty_covariance(w->out->n, d, w->out->x, w->out->weight, mean, s);
  invert(d, last->lower, before);
  for (size_t i = 0; i < d * d; i++) s[i] = share * s[i] + (1.0 - share) * before[i] / WIDER;
  for (size_t i = 0; i < d; i++) mean[i] = share * mean[i] + (1.0 - share) * last->mean[i];
  if (!factor(d, s))
    return um_core_fail(context, UM_ERR_NUMERIC, "draws from a posterior all lie in a plane");
  invert(d, s, before);
  return propose(context, w, mean, before);
}

static enum um_status reserve(struct um_context *context, struct work *w)
{
  size_t d = w->problem->nparameter, n = w->problem->ndraw;
  struct um_uncertainty_posterior *out = w->out;
  out->nparameter = d;
  UM_TRY(um_core_allocate(context, n * d, sizeof *out->x, &out->x));
  UM_TRY(um_core_allocate(context, n, sizeof *out->weight, &out->weight));
  UM_TRY(um_core_allocate(context, n, sizeof *w->log_density, &w->log_density));
  UM_TRY(um_core_allocate(context, n, sizeof *w->log_weight, &w->log_weight));
  return um_core_allocate(context, d + 2 * d * d, sizeof *w->room, &w->room);
}

enum um_status
um_uncertainty_posterior_create(struct um_context *context,
                                const struct um_uncertainty_posterior_problem *problem,
                                struct um_uncertainty_posterior **out)
{
  enum um_status status;
  struct work w = {.problem = problem};
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *w.out, &w.out));
  UM_CHECK(reserve(context, &w));
  UM_CHECK(propose(context, &w, problem->centre, problem->precision));
  for (size_t k = 1; k <= ROUNDS; k++) {
    UM_CHECK(compute(context, &w, (problem->ndraw * k + ROUNDS - 1) / ROUNDS));
    UM_CHECK(weigh(context, &w));
    if (k < ROUNDS) UM_CHECK(adapt(context, &w));
  }
  UM_CHECK(um_uncertainty_tail(context, w.out->n, w.out->weight, &w.out->tail));
  *out = w.out;
  w.out = NULL;
done:
  for (size_t k = 0; k < ROUNDS; k++) UM_FREE(context, w.round[k].mean, w.round[k].lower);
  UM_FREE(context, w.log_density, w.log_weight, w.room);
  um_uncertainty_posterior_destroy(context, &w.out);
  return status;
}

void um_uncertainty_posterior_destroy(struct um_context *context,
                                      struct um_uncertainty_posterior **posterior)
{
  if (*posterior == NULL) return;
  UM_FREE(context, (*posterior)->x, (*posterior)->weight, *posterior);
  *posterior = NULL;
}

bool um_uncertainty_posterior_is_sound(const struct um_uncertainty_posterior *posterior)
{
  return posterior->effective >= UM_UNCERTAINTY_EFFECTIVE_LEAST &&
         !(posterior->tail > UM_UNCERTAINTY_TAIL_MOST);
}
