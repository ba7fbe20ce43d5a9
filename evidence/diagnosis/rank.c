/* Ranks candidates by what they explain of the residual, and marks those that cannot be told apart.
 *
 * A candidate's predicted reduction is the chi-square it explains less the BIC penalty of its
 * parameters, S - dof ln n (Schwarz 1978, Ann. Stat. 6:461). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"
#include "evidence/diagnosis/value_text.h"

/* Prior widths from the null value. */

struct predicted_reduction {
  double worth;
  struct um_diagnosis_alternative alternative;
};

static int compare_predicted(const void *pa, const void *pb)
{
  const struct predicted_reduction *a = pa, *b = pb;
  if (a->worth != b->worth) return a->worth > b->worth ? -1 : 1;
  return a->alternative.candidate < b->alternative.candidate
             ? -1
             : a->alternative.candidate > b->alternative.candidate;
}

static enum um_status
sort_alternatives(struct um_context *context, const struct um_diagnosis_work *work,
                  const struct um_diagnosis_state *state, const struct um_inference_score *score,
                  struct um_diagnosis_alternative *alternative, size_t *nalternative)
{
  const struct um_sensitivity_candidates *all = work->candidates;
  double penalty = log((double)work->forward->observations.count);
  struct predicted_reduction *predicted_reduction = NULL;
  UM_TRY(um_core_allocate(context, all->count, sizeof *predicted_reduction, &predicted_reduction));
  *nalternative = 0;
  for (size_t i = 0; i < all->count; i++) {
    const struct um_sensitivity_candidate *c = &all->candidate[i];
    if (c->insensitive || um_diagnosis_is_taken(state, c)) continue;
    struct predicted_reduction *p = &predicted_reduction[(*nalternative)++];
    p->alternative = (struct um_diagnosis_alternative){
        .candidate = i, .score = score[i], .chi2 = NAN, .bic = NAN, .held_out = NAN};
    p->alternative.chi2_difference = NAN;
    /* a switch has no parameter to pay for */
    p->worth = score[i].absorbed
                   ? -INFINITY
                   : score[i].statistic - (c->is_switch ? 0.0 : score[i].dof) * penalty -
                         (c->off ? UM_DIAGNOSIS_OFF : 0.0);
    /* beyond a bound it explains nothing */
    if (!score[i].absorbed && score[i].p >= UM_INFERENCE_WRONG_SIDE) p->worth = -score[i].p;
  }
  qsort(predicted_reduction, *nalternative, sizeof *predicted_reduction, compare_predicted);
  for (size_t i = 0; i < *nalternative; i++) alternative[i] = predicted_reduction[i].alternative;
  um_core_free(context, predicted_reduction);
  return UM_OK;
}

enum um_status um_diagnosis_rank(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state,
                                 struct um_diagnosis_alternative *alternative, size_t *nalternative)
{
  enum um_status status;
  size_t n = work->forward->observations.count, count = work->candidates->count;
  struct um_diagnosis_directions d = {0};
  struct um_inference_score *score = NULL;
  double *residual = NULL;
  UM_CHECK(um_diagnosis_directions_make(context, work, state, &d));
  UM_CHECK(um_core_allocate(context, count, sizeof *score, &score));
  UM_CHECK(um_core_allocate(context, n, sizeof *residual, &residual));
  um_diagnosis_residual_at_means(work, state, n, residual);
  UM_CHECK(um_inference_score_test(context, n, residual, &d.nuisance, count, d.direction, score));
  for (size_t i = 0; i < count; i++)
    for (size_t k = 0; k < d.direction[i].ncolumn; k++) {
      double unit = um_diagnosis_unit(&work->candidates->candidate[i], k);
      score[i].estimate[k] *= unit;
      score[i].sigma[k] *= unit;
    }
  UM_CHECK(sort_alternatives(context, work, state, score, alternative, nalternative));
done:
  UM_FREE(context, residual, score);
  um_diagnosis_directions_release(context, &d);
  return status;
}

/* Whether a fitted value is at an end of the candidate's range. */
static bool is_at_bound(const struct um_sensitivity_candidate *c,
                        const struct um_diagnosis_alternative *alternative)
{
  for (size_t k = 0; k < c->ncolumn && !c->is_switch; k++) {
    size_t p = c->parameter[k];
    if (alternative->value[p] <= c->minimum[p] || alternative->value[p] >= c->maximum[p])
      return true;
  }
  return false;
}

/* Chi-square of an alternative's own priors. */
static double own_prior(const struct um_sensitivity_candidate *c,
                        const struct um_diagnosis_alternative *alternative)
{
  double sum = 0.0;
  for (size_t k = 0; k < c->ncolumn && !c->is_switch; k++) {
    size_t p = c->parameter[k];
    const struct um_effect_parameter *of = &c->effect->parameters[p];
    double away = um_effect_transformed(of, alternative->value[p]) -
                  um_effect_transformed(of, c->null_value[p]);
    if (isfinite(of->prior_sigma)) sum += (away / of->prior_sigma) * (away / of->prior_sigma);
  }
  return sum;
}

/* How an alternative relates to the winner of its step. */
static void relate(const struct um_diagnosis_alternative *winner,
                   struct um_diagnosis_alternative *r, const struct um_sensitivity_candidate *c,
                   bool cannot_tie)
{
  double behind = r->bic - winner->bic;
  r->indistinguishable = r->fitted && behind < UM_DIAGNOSIS_EVIDENCE;
  r->not_tried = !r->fitted && !r->refused && !r->score.absorbed && !cannot_tie &&
                 r->chi2_difference < UM_INFERENCE_SEPARABLE &&
                 r->score.statistic > winner->score.statistic - UM_DIAGNOSIS_EVIDENCE;
  if (!r->fitted || r->indistinguishable || !(behind < UM_DIAGNOSIS_NEXT_BEST)) return;
  double own = own_prior(c, r); /* only its own priors count */
  r->excluded_by_prior = own >= UM_DIAGNOSIS_UNUSUAL * UM_DIAGNOSIS_UNUSUAL &&
                         behind - own < UM_DIAGNOSIS_EVIDENCE && !r->same_effect;
  /* the linear model knows no range */
  r->excluded_by_range = !r->excluded_by_prior && !r->same_effect && is_at_bound(c, r) &&
                         r->score.statistic > winner->score.statistic - UM_DIAGNOSIS_EVIDENCE;
}

enum um_status um_diagnosis_rank_groups(struct um_context *context,
                                        const struct um_diagnosis_work *work,
                                        const struct um_diagnosis_state *state,
                                        const double *signal, struct um_diagnosis_step *step)
{
  enum um_status status;
  size_t count = work->candidates->count;
  struct um_diagnosis_directions d = {0};
  double *chi2_difference = NULL;
  UM_CHECK(um_diagnosis_directions_make(context, work, state, &d));
  UM_CHECK(um_core_allocate(context, count, sizeof *chi2_difference, &chi2_difference));
  UM_CHECK(um_inference_chi2_difference(context, work->forward->observations.count, signal,
                                        &d.nuisance, count, d.direction, chi2_difference));
  const struct um_diagnosis_alternative *winner = &step->alternative[0];
  size_t plausible = 0, tied = 0, not_tried = 0;
  for (size_t i = 0; i < step->nalternative; i++) {
    struct um_diagnosis_alternative *r = &step->alternative[i];
    const struct um_sensitivity_candidate *c = &work->candidates->candidate[r->candidate];
    r->chi2_difference = i == 0 ? 0.0 : chi2_difference[r->candidate];
    r->implausible = r->fitted && um_diagnosis_prior_widths(c, r->value) > UM_DIAGNOSIS_IMPLAUSIBLE;
    if (i == 0) continue;
    r->same_effect =
        um_diagnosis_is_same_effect(c, &work->candidates->candidate[winner->candidate]);
    if (!r->same_effect && r->bic - winner->bic < UM_DIAGNOSIS_NEXT_BEST)
      UM_CHECK(um_diagnosis_contains_winner(context, work, state, winner, r, &r->contains_winner));
    r->same_effect = r->same_effect || r->contains_winner;
    relate(winner, r, c, um_diagnosis_cannot_tie(work, state, c, winner));
    if (r->same_effect) r->indistinguishable = r->not_tried = false; /* the effect is known */
    not_tried += r->not_tried;
    tied += r->indistinguishable;
    plausible += r->indistinguishable && !r->implausible;
  }
  step->by_prior = tied > 0 && plausible == 0 && not_tried == 0 && !winner->implausible;
done:
  um_core_free(context, chi2_difference);
  um_diagnosis_directions_release(context, &d);
  return status;
}
