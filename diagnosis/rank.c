/* Which candidates the residual points to, and which of them these rows cannot tell apart.
 *
 * The residual is taken with every uncertain parameter at the mean of its prior,
 *
 *   r0 = r + sum_k J_k (x_k - m_k),     J = d(model)/dx / sigma,
 *
 * so that the prior of a nuisance is a pseudo-row of value 0. A candidate promises the chi-square
 * it explains less the price of its parameters, S - dof ln n (Schwarz 1978, Ann. Stat. 6:461). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "diagnosis/diagnose_impl.h"

/* Directions of the candidates, and what they borrow. */
struct directions {
  struct um_diagnosis_direction *direction; /* [count of candidates] */
  double *column;                           /* whitened signatures, one after another */
  double *bound;                            /* [3][columns] lowest, highest step, prior sigma */
  struct um_diagnosis_nuisance nuisance;
  double *nuisance_sigma; /* [nparameter of the state] */
};

static void directions_release(struct um_context *context, struct directions *d)
{
  um_core_free(context, d->direction);
  um_core_free(context, d->column);
  um_core_free(context, d->bound);
  um_core_free(context, d->nuisance_sigma);
}

/* Inner unit in which a direction is handed over: the step of its difference, so that a length says
 * what a step does, whatever the unit of the parameter. */
static double unit_of(const struct um_diagnosis_candidate *c, size_t k)
{
  if (c->is_switch || c->step[k] == 0.0) return 1.0;
  size_t p = c->parameter[k];
  return fabs(c->step[k]) / um_diagnosis_slope(&c->effect->parameters[p], c->null_value[p]);
}

/* A switch has one column: 0 is off and 1 is on. Others in units of their step. */
static void bounds_of(const struct um_diagnosis_candidate *c, double *low, double *high,
                      double *prior, double *slope)
{
  for (size_t k = 0; k < c->ncolumn; k++) {
    low[k] = 0.0;
    high[k] = prior[k] = INFINITY;
    slope[k] = 1.0;
    if (c->is_switch) continue;
    const struct um_effect_parameter *of = &c->effect->parameters[c->parameter[k]];
    double null_value = c->null_value[c->parameter[k]];
    double unit = unit_of(c, k);
    low[k] = (um_diagnosis_inner(of, of->minimum) - um_diagnosis_inner(of, null_value)) / unit;
    high[k] = (um_diagnosis_inner(of, of->maximum) - um_diagnosis_inner(of, null_value)) / unit;
    prior[k] = of->prior_sigma / unit;
    slope[k] = um_diagnosis_slope(of, null_value) * unit;
  }
}

static enum um_status directions_make(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state, struct directions *d)
{
  const struct um_diagnosis_candidates *all = work->candidates;
  size_t n = work->forward->nrow, columns = 0, at = 0;
  for (size_t i = 0; i < all->count; i++) columns += all->candidate[i].ncolumn;
  UM_TRY(um_core_allocate(context, all->count, sizeof *d->direction, &d->direction));
  UM_TRY(um_core_allocate(context, columns * n, sizeof *d->column, &d->column));
  UM_TRY(um_core_allocate(context, 3 * columns, sizeof *d->bound, &d->bound));
  UM_TRY(um_core_allocate(context, state->nparameter, sizeof(double), &d->nuisance_sigma));
  for (size_t i = 0; i < all->count; i++) {
    const struct um_diagnosis_candidate *c = &all->candidate[i];
    double *low = d->bound + at, *high = low + columns, *prior = high + columns;
    double slope[UM_EFFECT_PARAMETERS_MAX];
    bounds_of(c, low, high, prior, slope);
    for (size_t k = 0; k < c->ncolumn; k++)
      for (size_t j = 0; j < n; j++)
        d->column[(at + k) * n + j] =
            c->dead ? 0.0 : slope[k] * c->signature[k * n + j] / work->forward->sigma[j];
    d->direction[i] =
        (struct um_diagnosis_direction){c->ncolumn, d->column + at * n, low, high, prior};
    at += c->ncolumn;
  }
  for (size_t b = 0, k = 0; b < state->nblock; b++)
    for (size_t p = 0; p < state->block[b].nfree; p++)
      d->nuisance_sigma[k++] = state->block[b].prior_sigma[p];
  d->nuisance =
      (struct um_diagnosis_nuisance){state->nparameter, state->fit->jacobian, d->nuisance_sigma};
  return UM_OK;
}

/* Residual with the parameters at the means of their priors. */
static void residual_at_means(const struct um_diagnosis_state *state, size_t n, double *out)
{
  const struct um_diagnosis_fit *fit = state->fit;
  memcpy(out, fit->residual, n * sizeof *out);
  for (size_t b = 0, k = 0; b < state->nblock; b++)
    for (size_t p = 0; p < state->block[b].nfree; p++, k++) {
      double away = fit->x[k] - state->block[b].prior_mean[p];
      if (isinf(state->block[b].prior_sigma[p])) continue;
      for (size_t j = 0; j < n; j++) out[j] += fit->jacobian[k * n + j] * away;
    }
}

static bool same_text(const char *a, const char *b)
{
  return strcmp(a == NULL ? "" : a, b == NULL ? "" : b) == 0;
}

/* An effect on a target that is fitted already. */
static bool is_taken(const struct um_diagnosis_state *state, const struct um_diagnosis_candidate *c)
{
  for (size_t b = 0; b < state->nblock; b++)
    if (strcmp(state->block[b].addition.effect->name, c->effect->name) == 0 &&
        same_text(state->block[b].addition.target, c->target))
      return true;
  return false;
}

struct promise {
  double worth;
  struct um_diagnosis_rival rival;
};

static int compare_promises(const void *pa, const void *pb)
{
  const struct promise *a = pa, *b = pb;
  if (a->worth != b->worth) return a->worth > b->worth ? -1 : 1;
  return a->rival.candidate < b->rival.candidate ? -1 : a->rival.candidate > b->rival.candidate;
}

static enum um_status sort_rivals(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_diagnosis_state *state,
                                  const struct um_diagnosis_score *score,
                                  struct um_diagnosis_rival *rival, size_t *nrival)
{
  const struct um_diagnosis_candidates *all = work->candidates;
  double price = log((double)work->forward->nrow);
  struct promise *promise = NULL;
  UM_TRY(um_core_allocate(context, all->count, sizeof *promise, &promise));
  *nrival = 0;
  for (size_t i = 0; i < all->count; i++) {
    const struct um_diagnosis_candidate *c = &all->candidate[i];
    if (c->dead || is_taken(state, c)) continue;
    struct promise *p = &promise[(*nrival)++];
    p->rival = (struct um_diagnosis_rival){
        .candidate = i, .score = score[i], .chi2 = NAN, .bic = NAN, .held_out = NAN};
    p->rival.separation = NAN;
    /* a switch has no parameter to pay for */
    p->worth = score[i].absorbed ? -INFINITY
                                 : score[i].statistic - (c->is_switch ? 0.0 : score[i].dof) * price;
    /* the wrong side of a bound explains nothing */
    if (!score[i].absorbed && score[i].p >= 0.5) p->worth = -score[i].p;
  }
  qsort(promise, *nrival, sizeof *promise, compare_promises);
  for (size_t i = 0; i < *nrival; i++) rival[i] = promise[i].rival;
  um_core_free(context, promise);
  return UM_OK;
}

enum um_status um_diagnosis_rank(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state,
                                 struct um_diagnosis_rival *rival, size_t *nrival)
{
  enum um_status status;
  size_t n = work->forward->nrow, count = work->candidates->count;
  struct directions d = {0};
  struct um_diagnosis_score *score = NULL;
  double *residual = NULL;
  UM_CHECK(directions_make(context, work, state, &d));
  UM_CHECK(um_core_allocate(context, count, sizeof *score, &score));
  UM_CHECK(um_core_allocate(context, n, sizeof *residual, &residual));
  residual_at_means(state, n, residual);
  UM_CHECK(um_diagnosis_score_test(context, n, residual, &d.nuisance, count, d.direction, score));
  for (size_t i = 0; i < count; i++)
    for (size_t k = 0; k < d.direction[i].ncolumn; k++) {
      double unit = unit_of(&work->candidates->candidate[i], k);
      score[i].estimate[k] *= unit;
      score[i].sigma[k] *= unit;
    }
  UM_CHECK(sort_rivals(context, work, state, score, rival, nrival));
done:
  um_core_free(context, residual);
  um_core_free(context, score);
  directions_release(context, &d);
  return status;
}

/* A value further from null than three prior widths. */
static bool is_incredible(const struct um_diagnosis_candidate *c,
                          const struct um_diagnosis_rival *rival)
{
  for (size_t k = 0; k < c->ncolumn && !c->is_switch; k++) {
    size_t p = c->parameter[k];
    const struct um_effect_parameter *of = &c->effect->parameters[p];
    double away =
        um_diagnosis_inner(of, rival->value[p]) - um_diagnosis_inner(of, c->null_value[p]);
    if (fabs(away) > 3.0 * of->prior_sigma) return true;
  }
  return false;
}

enum um_status um_diagnosis_rank_groups(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        const struct um_diagnosis_state *state,
                                        const double *signal, struct um_diagnosis_step *step)
{
  enum um_status status;
  size_t count = work->candidates->count;
  struct directions d = {0};
  double *separation = NULL;
  UM_CHECK(directions_make(context, work, state, &d));
  UM_CHECK(um_core_allocate(context, count, sizeof *separation, &separation));
  UM_CHECK(um_diagnosis_separation(context, work->forward->nrow, signal, &d.nuisance, count,
                                   d.direction, separation));
  const struct um_diagnosis_rival *winner = &step->rival[0];
  size_t credible = 0, tied = 0;
  for (size_t i = 0; i < step->nrival; i++) {
    struct um_diagnosis_rival *r = &step->rival[i];
    const struct um_diagnosis_candidate *c = &work->candidates->candidate[r->candidate];
    r->separation = i == 0 ? 0.0 : separation[r->candidate];
    r->incredible = r->fitted && is_incredible(c, r);
    if (i == 0) continue;
    if (r->fitted)
      r->indistinguishable = r->bic - winner->bic < UM_DIAGNOSIS_EVIDENCE;
    else
      r->indistinguishable = !r->score.absorbed && r->separation < UM_DIAGNOSIS_SEPARABLE &&
                             r->score.statistic > winner->score.statistic - UM_DIAGNOSIS_SEPARABLE;
    tied += r->indistinguishable;
    credible += r->indistinguishable && !r->incredible;
  }
  step->by_prior = tied > 0 && credible == 0 && !winner->incredible;
done:
  um_core_free(context, separation);
  directions_release(context, &d);
  return status;
}
