/* The candidates of the highest promise are fitted in earnest. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "diagnosis/diagnose_impl.h"

/* Rivals are fitted in rounds while the best of them leaves a residual that is not noise. */
#define ROUNDS      2
#define GOOD_ENOUGH 1.3 /* reduced chi-square */
#define REACH       0.25 /* of the best score: what straight lines may underrate a bent candidate by */
#define SHAPED_MAX  2    /* candidates with parameters of shape in a round; they cost a scan each */
#define LATER_REACH 0.5 /* the same for rounds after the first */

/* Jacobian of the state's fit and the signatures of candidates, by inner parameters. */
static enum um_status jacobian_with(struct um_context *context,
                                    const struct um_diagnosis_work *work,
                                    const struct um_diagnosis_state *state, const size_t *candidate,
                                    size_t ncandidate, double **out)
{
  size_t n = work->forward->nrow, columns = state->nparameter, at = 0;
  for (size_t i = 0; i < ncandidate; i++)
    columns += um_diagnosis_block_of(work, candidate[i]).nfree;
  UM_TRY(um_core_allocate(context, columns * n, sizeof **out, out));
  for (; at < state->nparameter; at++)
    for (size_t j = 0; j < n; j++)
      (*out)[at * n + j] = state->fit->jacobian[at * n + j] * work->forward->sigma[j];
  for (size_t i = 0; i < ncandidate; i++) {
    const struct um_diagnosis_candidate *c = &work->candidates->candidate[candidate[i]];
    for (size_t k = 0; k < c->ncolumn && !c->is_switch; k++) {
      size_t p = c->parameter[k];
      double slope = um_diagnosis_slope(&c->effect->parameters[p], c->null_value[p]);
      for (size_t j = 0; j < n; j++) (*out)[(at + k) * n + j] = slope * c->signature[k * n + j];
    }
    /* parameters of shape do nothing yet: zeros */
    at += um_diagnosis_block_of(work, candidate[i]).nfree;
  }
  return UM_OK;
}

enum um_status um_diagnosis_with(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state, const size_t *candidate,
                                 size_t ncandidate, double beaten, struct um_diagnosis_state *out)
{
  enum um_status status;
  double *jacobian = NULL;
  bool switched = false;
  UM_CHECK(um_diagnosis_state_copy(context, state, state->nblock, out));
  out->beaten = beaten;
  for (size_t i = 0; i < ncandidate; i++) {
    struct um_diagnosis_block block = um_diagnosis_block_of(work, candidate[i]);
    switched = switched || work->candidates->candidate[candidate[i]].is_switch;
    UM_CHECK(um_diagnosis_state_append(context, out, &block));
  }
  bool shaped = false;
  for (size_t i = 0; i < ncandidate; i++) {
    if (work->candidates->candidate[candidate[i]].nshape == 0) continue;
    shaped = true;
    UM_CHECK(um_diagnosis_start(context, work, state, out, state->nblock + i));
  }
  if (!shaped) UM_CHECK(jacobian_with(context, work, state, candidate, ncandidate, &jacobian));
  /* a switch is on at once: the values of before are not those of the start */
  UM_CHECK(um_diagnosis_state_fit(context, work, out, switched || shaped ? NULL : state->fit->value,
                                  jacobian));
done:
  um_core_free(context, jacobian);
  if (status != UM_OK) um_diagnosis_state_release(context, out);
  return status;
}

/* Fit one rival, unless it is far from a tie with the one that is ahead (NULL: none is); keep its
 * state when it is the best so far. */
static enum um_status try_rival(struct um_context *context, const struct um_diagnosis_work *work,
                                const struct um_diagnosis_state *state,
                                const struct um_diagnosis_rival *ahead,
                                struct um_diagnosis_rival *rival, struct um_diagnosis_state *best)
{
  struct um_diagnosis_state trial = {0};
  double lead = ahead == NULL ? INFINITY : ahead->bic;
  enum um_status status = um_diagnosis_with(context, work, state, &rival->candidate, 1,
                                            lead + UM_DIAGNOSIS_EVIDENCE, &trial);
  if (status == UM_ERR_INPUT || status == UM_ERR_NUMERIC) { /* the effect refuses such values */
    um_core_message_clear(context);
    return UM_OK;
  }
  UM_TRY(status);
  if (work->candidates->candidate[rival->candidate].nshape > 0 && trial.fit->bic < lead)
    status = um_diagnosis_polish(context, work, &trial, trial.nblock - 1);
  rival->fitted = true;
  rival->chi2 = trial.fit->chi2;
  rival->bic = trial.fit->bic;
  memcpy(rival->value, trial.block[trial.nblock - 1].addition.value, sizeof rival->value);
  um_diagnosis_state_sigma(&trial, trial.nblock - 1, rival->sigma);
  if (status == UM_OK)
    status = um_diagnosis_state_held_out(context, work, &trial, &rival->held_out);
  if (status == UM_OK && (best->fit == NULL || rival->bic < best->fit->bic)) {
    um_diagnosis_state_release(context, best);
    *best = trial;
    return UM_OK;
  }
  um_diagnosis_state_release(context, &trial);
  return status;
}

static int compare_fitted(const void *pa, const void *pb)
{
  const struct um_diagnosis_rival *a = pa, *b = pb;
  if (a->fitted != b->fitted) return a->fitted ? -1 : 1;
  if (a->fitted && a->bic != b->bic) return a->bic < b->bic ? -1 : 1;
  return 0;
}

/* qsort is not stable, and rivals that were not fitted keep their order. */
static void sort_fitted(struct um_diagnosis_rival *rival, size_t nfitted)
{
  for (size_t i = 1; i < nfitted; i++)
    for (size_t j = i; j > 0 && compare_fitted(&rival[j], &rival[j - 1]) < 0; j--) {
      struct um_diagnosis_rival other = rival[j];
      rival[j] = rival[j - 1];
      rival[j - 1] = other;
    }
}

/* Whether a rival's score is worth a fit: within reach of the best. */
static bool is_worth(const struct um_diagnosis_rival *rival, const struct um_diagnosis_rival *best,
                     int round)
{
  double reach = (round == 0 ? REACH : LATER_REACH) * best->score.statistic;
  if (rival->score.absorbed || rival->score.p >= 0.5) return false;
  return rival->score.statistic > fmin(reach, best->score.statistic - UM_DIAGNOSIS_SEPARABLE);
}

/* The best of those fitted by BIC; NULL: none is. */
static const struct um_diagnosis_rival *best_fitted(const struct um_diagnosis_step *step)
{
  const struct um_diagnosis_rival *best = NULL;
  for (size_t i = 0; i < step->nrival; i++)
    if (step->rival[i].fitted && (best == NULL || step->rival[i].bic < best->bic))
      best = &step->rival[i];
  return best;
}

/* Whether a rival with parameters of shape would have to fit better than noise does in order to
 * better the one that is ahead, since each of them costs ln n. */
static bool is_hopeless(const struct um_diagnosis_work *work,
                        const struct um_diagnosis_state *state, size_t nshape,
                        const struct um_diagnosis_rival *ahead)
{
  double n = (double)work->forward->nrow;
  if (ahead == NULL) return false;
  return ahead->chi2 - (double)nshape * log(n) < n - (double)(state->nparameter + nshape + 1);
}

/* Rivals from..until that have parameters of shape, or those that have none. */
static enum um_status try_rivals(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state, bool shaped, size_t from,
                                 size_t until, struct um_diagnosis_step *step,
                                 struct um_diagnosis_state *best)
{
  size_t scans = 0;
  for (size_t i = from; i < until; i++) {
    struct um_diagnosis_rival *rival = &step->rival[i];
    size_t nshape = work->candidates->candidate[rival->candidate].nshape;
    const struct um_diagnosis_rival *ahead = best_fitted(step);
    if (rival->fitted || (nshape > 0) != shaped) continue;
    if (shaped && (is_hopeless(work, state, nshape, ahead) || ++scans > SHAPED_MAX)) break;
    UM_TRY(try_rival(context, work, state, ahead, rival, best));
    UM_TRY(um_core_progress_step(context, 1));
  }
  return UM_OK;
}

enum um_status um_diagnosis_fit_rivals(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state,
                                       struct um_diagnosis_step *step,
                                       struct um_diagnosis_state *best)
{
  size_t tried = 0;
  for (int round = 0; round < ROUNDS; round++) {
    size_t until = tried;
    while (until < step->nrival && until < tried + work->rivals &&
           is_worth(&step->rival[until], &step->rival[0], round))
      until++;
    UM_TRY(try_rivals(context, work, state, false, tried, until, step, best));
    UM_TRY(try_rivals(context, work, state, true, tried, until, step, best));
    const struct um_diagnosis_rival *ahead = best_fitted(step);
    bool all = until < tried + work->rivals;
    tried = until;
    if (all || (ahead != NULL && ahead->chi2 < GOOD_ENOUGH * (double)work->forward->nrow)) break;
  }
  sort_fitted(step->rival, tried);
  return UM_OK;
}
