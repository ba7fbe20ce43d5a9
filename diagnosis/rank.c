/* Which candidates the residual points to, and which of them these rows cannot tell apart.
 *
 * A candidate promises the chi-square it explains less the price of its parameters, S - dof ln n
 * (Schwarz 1978, Ann. Stat. 6:461). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "diagnosis/diagnose_impl.h"
#include "diagnosis/directions_impl.h"

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
    if (c->dead || um_diagnosis_is_taken(state, c)) continue;
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
  struct um_diagnosis_directions d = {0};
  struct um_diagnosis_score *score = NULL;
  double *residual = NULL;
  UM_CHECK(um_diagnosis_directions_make(context, work, state, &d));
  UM_CHECK(um_core_allocate(context, count, sizeof *score, &score));
  UM_CHECK(um_core_allocate(context, n, sizeof *residual, &residual));
  um_diagnosis_residual_at_means(state, n, residual);
  UM_CHECK(um_diagnosis_score_test(context, n, residual, &d.nuisance, count, d.direction, score));
  for (size_t i = 0; i < count; i++)
    for (size_t k = 0; k < d.direction[i].ncolumn; k++) {
      double unit = um_diagnosis_unit(&work->candidates->candidate[i], k);
      score[i].estimate[k] *= unit;
      score[i].sigma[k] *= unit;
    }
  UM_CHECK(sort_rivals(context, work, state, score, rival, nrival));
done:
  um_core_free(context, residual);
  um_core_free(context, score);
  um_diagnosis_directions_release(context, &d);
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
  struct um_diagnosis_directions d = {0};
  double *separation = NULL;
  UM_CHECK(um_diagnosis_directions_make(context, work, state, &d));
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
                             r->score.statistic > winner->score.statistic - UM_DIAGNOSIS_EVIDENCE;
    tied += r->indistinguishable;
    credible += r->indistinguishable && !r->incredible;
  }
  step->by_prior = tied > 0 && credible == 0 && !winner->incredible;
done:
  um_core_free(context, separation);
  um_diagnosis_directions_release(context, &d);
  return status;
}
