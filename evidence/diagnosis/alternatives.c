/* Non-linear fits of the candidates that the linear model ranks best. */
#include <math.h>
#include <string.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

/* The Jacobian of the state's fit, with the signatures of candidates behind it; by transformed
 * parameters. */
static enum um_status jacobian_with(struct um_context *context,
                                    const struct um_diagnosis_work *work,
                                    const struct um_diagnosis_state *state, const size_t *candidate,
                                    size_t ncandidate, double **out)
{
  size_t n = work->forward->observations.count, columns = state->nparameter, at = 0;
  for (size_t i = 0; i < ncandidate; i++)
    columns += um_diagnosis_block_of(work, candidate[i]).nfree;
  UM_TRY(um_core_allocate(context, columns * n, sizeof **out, out));
  for (; at < state->nparameter; at++)
    for (size_t j = 0; j < n; j++)
      (*out)[at * n + j] = state->fit->jacobian[at * n + j] * work->forward->observations.sigma[j];
  for (size_t i = 0; i < ncandidate; i++) {
    const struct um_sensitivity_candidate *c = &work->candidates->candidate[candidate[i]];
    for (size_t k = 0; k < c->ncolumn && !c->is_switch; k++) {
      size_t p = c->parameter[k];
      double slope = um_effect_transformed_slope(&c->effect->parameters[p], c->null_value[p]);
      for (size_t j = 0; j < n; j++) (*out)[(at + k) * n + j] = slope * c->signature[k * n + j];
    }
    /* parameters unidentified under the null do nothing yet: zeros */
    at += um_diagnosis_block_of(work, candidate[i]).nfree;
  }
  return UM_OK;
}

enum um_status um_diagnosis_with(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state, const size_t *candidate,
                                 size_t ncandidate, double prune_above,
                                 struct um_diagnosis_state *out)
{
  enum um_status status;
  double *jacobian = NULL;
  bool switched = false;
  UM_CHECK(um_diagnosis_state_copy(context, state, state->nblock, out));
  for (size_t i = 0; i < ncandidate; i++) {
    struct um_diagnosis_block block = um_diagnosis_block_of(work, candidate[i]);
    switched = switched || work->candidates->candidate[candidate[i]].is_switch;
    UM_CHECK(um_diagnosis_state_append(context, out, &block));
  }
  bool shaped = false;
  for (size_t i = 0; i < ncandidate; i++) {
    if (work->candidates->candidate[candidate[i]].nunidentified == 0) continue;
    shaped = true;
    UM_CHECK(um_diagnosis_start(context, work, state, out, state->nblock + i));
  }
  if (!shaped) UM_CHECK(jacobian_with(context, work, state, candidate, ncandidate, &jacobian));
  /* a switch is on from the start, so the state's values are not those of the start */
  UM_CHECK(um_diagnosis_state_fit(context, work, out, switched || shaped ? NULL : state->fit->value,
                                  jacobian, prune_above));
done:
  for (size_t i = 0; i < ncandidate; i++)
    if (work->fate[candidate[i]] != UM_FATE_FITTED)
      work->fate[candidate[i]] = status == UM_OK ? UM_FATE_FITTED : UM_FATE_REFUSED;
  um_core_free(context, jacobian);
  if (status != UM_OK) um_diagnosis_state_release(context, out);
  return status;
}

/* Fit one alternative. The fit is pruned where it cannot come near the one ahead (NULL: none is).
 * Its state is kept when it is the best so far. */
static enum um_status try_alternative(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state,
                                      const struct um_diagnosis_alternative *ahead,
                                      struct um_diagnosis_alternative *alternative,
                                      struct um_diagnosis_state *best)
{
  struct um_diagnosis_state trial = {0};
  double lead = ahead == NULL ? INFINITY : ahead->bic;
  enum um_status status = um_diagnosis_with(context, work, state, &alternative->candidate, 1,
                                            lead + UM_DIAGNOSIS_NEXT_BEST, &trial);
  if (status == UM_ERR_REFUSED || status == UM_ERR_NUMERIC) { /* the effect refuses such values */
    um_core_message_clear(context);
    alternative->refused = true;
    return UM_OK;
  }
  UM_TRY(status);
  if (work->candidates->candidate[alternative->candidate].nunidentified > 0 &&
      trial.fit->bic < lead)
    status = um_diagnosis_simplex_refine(context, work, &trial, trial.nblock - 1);
  alternative->fitted = true;
  alternative->converged = trial.fit->converged;
  alternative->chi2 = trial.fit->chi2;
  alternative->bic = trial.fit->bic;
  alternative->chi2_prior = trial.fit->chi2_prior;
  memcpy(alternative->value, trial.block[trial.nblock - 1].addition.value,
         sizeof alternative->value);
  um_diagnosis_state_sigma(&trial, trial.nblock - 1, alternative->sigma);
  if (status == UM_OK)
    status = um_diagnosis_state_held_out(context, work, &trial, &alternative->held_out);
  if (status == UM_OK && (best->fit == NULL || alternative->bic < best->fit->bic)) {
    um_diagnosis_state_release(context, best);
    *best = trial;
    return UM_OK;
  }
  um_diagnosis_state_release(context, &trial);
  return status;
}

static int compare_fitted(const void *pa, const void *pb)
{
  const struct um_diagnosis_alternative *a = pa, *b = pb;
  if (a->fitted != b->fitted) return a->fitted ? -1 : 1;
  if (a->fitted && a->bic != b->bic) return a->bic < b->bic ? -1 : 1;
  return 0;
}

/* Insertion sort: qsort is not stable, and alternatives that were not fitted keep their order. */
static void sort_fitted(struct um_diagnosis_alternative *alternative, size_t n)
{
  for (size_t i = 1; i < n; i++)
    for (size_t j = i; j > 0 && compare_fitted(&alternative[j], &alternative[j - 1]) < 0; j--) {
      struct um_diagnosis_alternative other = alternative[j];
      alternative[j] = alternative[j - 1];
      alternative[j - 1] = other;
    }
}

/* Whether an alternative's score is near enough to the best for a fit. */
static bool is_worth(const struct um_diagnosis_alternative *alternative,
                     const struct um_diagnosis_alternative *best, int round)
{
  double reach =
      (round == 0 ? UM_DIAGNOSIS_REACH : UM_DIAGNOSIS_LATER_REACH) * best->score.statistic;
  if (alternative->score.absorbed || alternative->score.p >= UM_INFERENCE_WRONG_SIDE) return false;
  return alternative->score.statistic > fmin(reach, best->score.statistic - UM_INFERENCE_SEPARABLE);
}

/* The best of those fitted by BIC; NULL: none is. */
static const struct um_diagnosis_alternative *best_fitted(const struct um_diagnosis_step *step)
{
  const struct um_diagnosis_alternative *best = NULL;
  for (size_t i = 0; i < step->nalternative; i++)
    if (step->alternative[i].fitted && (best == NULL || step->alternative[i].bic < best->bic))
      best = &step->alternative[i];
  return best;
}

/* Whether an alternative with parameters unidentified under the null cannot win. Each of them costs
 * ln n in BIC; it cannot win where it would have to fit better than noise does. */
static bool is_hopeless(const struct um_diagnosis_work *work,
                        const struct um_diagnosis_state *state, size_t nunidentified,
                        const struct um_diagnosis_alternative *ahead)
{
  double n = (double)work->forward->observations.count;
  if (ahead == NULL) return false;
  return ahead->chi2 - (double)nunidentified * log(n) <
         n - (double)(state->nparameter + nunidentified + 1);
}

/* Fit alternatives from..until. shaped: those with parameters unidentified under the null; else
 * those without. */
static enum um_status try_alternatives(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state, bool shaped,
                                       size_t from, size_t until, struct um_diagnosis_step *step,
                                       struct um_diagnosis_state *best)
{
  size_t scans = 0;
  for (size_t i = from; i < until; i++) {
    struct um_diagnosis_alternative *alternative = &step->alternative[i];
    size_t nunidentified = work->candidates->candidate[alternative->candidate].nunidentified;
    const struct um_diagnosis_alternative *ahead = best_fitted(step);
    if (alternative->fitted || (nunidentified > 0) != shaped) continue;
    if (shaped &&
        (is_hopeless(work, state, nunidentified, ahead) || ++scans > UM_DIAGNOSIS_UNIDENTIFIED_MAX))
      break;
    UM_TRY(try_alternative(context, work, state, ahead, alternative, best));
    UM_TRY(um_core_progress_step(context, 1));
  }
  return UM_OK;
}

/* Those left whose score comes within the evidence of the best one's, the best score first, up to
 * UM_DIAGNOSIS_TIES: the linear model alone does not say that they fit as well. */
static enum um_status try_ties(struct um_context *context, const struct um_diagnosis_work *work,
                               const struct um_diagnosis_state *state,
                               struct um_diagnosis_step *step, struct um_diagnosis_state *best)
{
  size_t tried = 0;
  um_core_progress_begin(context, "fitting candidates with tied scores", UM_DIAGNOSIS_TIES);
  for (size_t i = 0; i < step->nalternative && tried < UM_DIAGNOSIS_TIES; i++) {
    struct um_diagnosis_alternative *r = &step->alternative[i];
    const struct um_diagnosis_alternative *ahead = best_fitted(step);
    size_t nunidentified = work->candidates->candidate[r->candidate].nunidentified;
    if (ahead == NULL) break;
    if (r->fitted || r->refused || r->score.absorbed || r->score.p >= UM_INFERENCE_WRONG_SIDE ||
        !(r->score.statistic > ahead->score.statistic - UM_DIAGNOSIS_EVIDENCE) ||
        (nunidentified > 0 && is_hopeless(work, state, nunidentified, ahead)))
      continue;
    UM_TRY(try_alternative(context, work, state, ahead, r, best));
    UM_TRY(um_core_progress_step(context, 1));
    tried++;
  }
  um_core_progress_end(context);
  return UM_OK;
}

/* Fit the best by predicted reduction, in rounds, until one leaves hardly more than noise. */
static enum um_status try_rounds(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state,
                                 struct um_diagnosis_step *step, struct um_diagnosis_state *best)
{
  size_t tried = 0;
  for (int round = 0; round < UM_DIAGNOSIS_ROUNDS; round++) {
    size_t until = tried;
    while (until < step->nalternative && until < tried + work->alternatives &&
           is_worth(&step->alternative[until], &step->alternative[0], round))
      until++;
    um_core_progress_begin(context, "fitting candidates", until - tried);
    UM_TRY(try_alternatives(context, work, state, false, tried, until, step, best));
    UM_TRY(try_alternatives(context, work, state, true, tried, until, step, best));
    um_core_progress_end(context);
    const struct um_diagnosis_alternative *ahead = best_fitted(step);
    bool all = until < tried + work->alternatives;
    tried = until;
    if (all || (ahead != NULL &&
                ahead->chi2 < UM_DIAGNOSIS_GOOD_ENOUGH * (double)work->forward->observations.count))
      break;
  }
  return UM_OK;
}

enum um_status um_diagnosis_fit_alternatives(struct um_context *context,
                                             const struct um_diagnosis_work *work,
                                             const struct um_diagnosis_state *state,
                                             struct um_diagnosis_step *step,
                                             struct um_diagnosis_state *best)
{
  UM_TRY(try_rounds(context, work, state, step, best));
  UM_TRY(try_ties(context, work, state, step, best));
  sort_fitted(step->alternative, step->nalternative);
  return UM_OK;
}
