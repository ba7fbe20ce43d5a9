/* Non-linear fits of the candidates that the linear model ranks best. */
#include <math.h>
#include <string.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"
#include "evidence/diagnosis/trials_impl.h"

#define AT_ONCE 16 /* alternatives, at most */

/* Where a fit began is half of where it ends, of a rough one: the best values are kept. */
static void remember(const struct um_diagnosis_work *work, size_t candidate,
                     const struct um_diagnosis_state *state)
{
  struct um_diagnosis_shape *shape = &work->shape[candidate];
  if (!um_diagnosis_is_rough(&work->candidates->candidate[candidate]) ||
      (shape->chi2 > 0.0 && shape->chi2 <= state->fit->chi2))
    return;
  shape->chi2 = state->fit->chi2;
  memcpy(shape->value, state->block[state->nblock - 1].addition.value, sizeof shape->value);
}

/* What was found of an alternative; its state is kept where it is the best so far. */
static enum um_status note(struct um_context *context, const struct um_diagnosis_work *work,
                           struct um_diagnosis_trial *trial,
                           struct um_diagnosis_alternative *alternative,
                           struct um_diagnosis_state *best)
{
  const struct um_inference_fit *fit = trial->state.fit;
  alternative->refused = trial->refused;
  if (trial->refused) return UM_OK;
  remember(work, alternative->candidate, &trial->state);
  alternative->fitted = true;
  alternative->converged = fit->converged;
  alternative->chi2 = fit->chi2;
  alternative->bic = fit->bic;
  alternative->chi2_prior = fit->chi2_prior;
  memcpy(alternative->value, trial->state.block[trial->state.nblock - 1].addition.value,
         sizeof alternative->value);
  um_diagnosis_state_sigma(&trial->state, trial->state.nblock - 1, alternative->sigma);
  UM_TRY(um_diagnosis_state_held_out(context, work, &trial->state, &alternative->held_out));
  if (best->fit != NULL && !(alternative->bic < best->fit->bic)) return UM_OK;
  um_diagnosis_state_release(context, best);
  *best = trial->state;
  trial->state = (struct um_diagnosis_state){0};
  return UM_OK;
}

/* Fit alternatives [n] at once. Fits are pruned where they cannot come within `near` [BIC] of the
 * one ahead of all, as it is now (NULL: none is): that does not depend on which of them ends
 * first. */
static enum um_status try_at_once(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_diagnosis_state *state,
                                  const struct um_diagnosis_alternative *ahead, double near,
                                  struct um_diagnosis_alternative *const *alternative, size_t n,
                                  struct um_diagnosis_state *best)
{
  enum um_status status;
  struct um_diagnosis_trial *trial = NULL;
  double lead = ahead == NULL ? INFINITY : ahead->bic;
  UM_CHECK(um_core_allocate(context, n, sizeof *trial, &trial));
  for (size_t i = 0; i < n; i++)
    trial[i] = (struct um_diagnosis_trial){.candidate = {alternative[i]->candidate},
                                           .ncandidate = 1,
                                           .prune_above = lead + near,
                                           .lead = lead};
  UM_CHECK(um_diagnosis_trials_fit(context, work, state, trial, n));
  for (size_t i = 0; i < n; i++) UM_CHECK(note(context, work, &trial[i], alternative[i], best));
done:
  um_diagnosis_trials_release(context, trial, n);
  um_core_free(context, trial);
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

/* Whether an alternative with k parameters unidentified under the null cannot come within `slack`
 * of the BIC ahead. Each of them costs ln n. It fits no better than noise does, or where the one
 * ahead does already, by one of chi-square for each of them. */
static bool is_hopeless(const struct um_diagnosis_work *work,
                        const struct um_diagnosis_state *state, size_t nunidentified,
                        const struct um_diagnosis_alternative *ahead, double slack)
{
  double n = (double)work->forward->observations.count, k = (double)nunidentified;
  double parameters = (double)state->nparameter + k + 1.0;
  if (ahead == NULL) return false;
  /* what one leaves may be a discrepancy: then it is BIC that noise alone cannot come below */
  if (work->noise != NULL)
    return ahead->bic + slack <
           fmin(n + parameters * (log(n) - 1.0), ahead->bic + k * (log(n) - 1.0));
  return ahead->chi2 + slack - k * log(n) < fmin(n - parameters, ahead->chi2 - k);
}

bool um_diagnosis_cannot_tie(const struct um_diagnosis_work *work,
                             const struct um_diagnosis_state *state,
                             const struct um_sensitivity_candidate *c,
                             const struct um_diagnosis_alternative *winner)
{
  return c->nunidentified > 0 &&
         is_hopeless(work, state, c->nunidentified, winner, UM_DIAGNOSIS_EVIDENCE);
}

/* Fit alternatives from..until. shaped: those that are rough (um_diagnosis_is_rough); else the
 * others. Where none is ahead yet, the first one is fitted alone: the others are held
 * against it. */
static enum um_status try_alternatives(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state, bool shaped,
                                       size_t from, size_t until, struct um_diagnosis_step *step,
                                       struct um_diagnosis_state *best)
{
  struct um_diagnosis_alternative *at_once[AT_ONCE];
  const struct um_diagnosis_alternative *ahead = best_fitted(step);
  size_t n = 0, scans = 0;
  for (size_t i = from; i < until; i++) {
    struct um_diagnosis_alternative *alternative = &step->alternative[i];
    const struct um_sensitivity_candidate *c = &work->candidates->candidate[alternative->candidate];
    if (alternative->fitted || um_diagnosis_is_rough(c) != shaped) continue;
    if (shaped && (is_hopeless(work, state, c->nunidentified, ahead, 0.0) ||
                   ++scans > UM_DIAGNOSIS_UNIDENTIFIED_MAX))
      break;
    at_once[n++] = alternative;
    if (ahead != NULL && n < AT_ONCE) continue;
    UM_TRY(try_at_once(context, work, state, ahead, UM_DIAGNOSIS_NEXT_BEST, at_once, n, best));
    n = 0;
    ahead = best_fitted(step);
  }
  return try_at_once(context, work, state, ahead, UM_DIAGNOSIS_NEXT_BEST, at_once, n, best);
}

/* Whether an alternative may fit as well as the one ahead. The score of one whose shape is not
 * known is that of the shape it begins with, and no more than the least it explains. */
static bool may_tie(const struct um_diagnosis_work *work, const struct um_diagnosis_state *state,
                    const struct um_diagnosis_alternative *r,
                    const struct um_diagnosis_alternative *ahead)
{
  const struct um_sensitivity_candidate *c = &work->candidates->candidate[r->candidate];
  double best = ahead->score.statistic;
  if (r->fitted || r->refused || r->score.absorbed || r->score.p >= UM_INFERENCE_WRONG_SIDE)
    return false;
  if (c->nunidentified == 0) return r->score.statistic > best - UM_DIAGNOSIS_EVIDENCE;
  return r->score.statistic > fmin(UM_DIAGNOSIS_SHAPE_REACH * best, best - UM_DIAGNOSIS_EVIDENCE) &&
         !um_diagnosis_cannot_tie(work, state, c, ahead);
}

/* Those left that may fit as well, the best score first, up to UM_DIAGNOSIS_TIES: the linear model
 * alone does not say that they do. One that is found not to tie need not be fitted to its end. */
static enum um_status try_ties(struct um_context *context, const struct um_diagnosis_work *work,
                               const struct um_diagnosis_state *state,
                               struct um_diagnosis_step *step, struct um_diagnosis_state *best)
{
  struct um_diagnosis_alternative *tied[UM_DIAGNOSIS_TIES];
  const struct um_diagnosis_alternative *ahead = best_fitted(step);
  size_t n = 0;
  for (size_t i = 0; ahead != NULL && i < step->nalternative && n < UM_DIAGNOSIS_TIES; i++) {
    struct um_diagnosis_alternative *r = &step->alternative[i];
    if (!may_tie(work, state, r, ahead)) continue;
    tied[n++] = r;
  }
  return try_at_once(context, work, state, ahead, UM_DIAGNOSIS_EVIDENCE, tied, n, best);
}

/* Those that an earlier search named. */
static enum um_status try_named(struct um_context *context, const struct um_diagnosis_work *work,
                                const struct um_diagnosis_state *state,
                                struct um_diagnosis_step *step, struct um_diagnosis_state *best)
{
  struct um_diagnosis_alternative *named[AT_ONCE];
  size_t n = 0;
  for (size_t i = 0; i < step->nalternative && n < AT_ONCE; i++) {
    struct um_diagnosis_alternative *r = &step->alternative[i];
    if (work->shape[r->candidate].named && !r->fitted && !r->refused) named[n++] = r;
  }
  return try_at_once(context, work, state, best_fitted(step), UM_DIAGNOSIS_NEXT_BEST, named, n,
                     best);
}

/* Alternatives [from, until): those without unidentified parameters first. */
static enum um_status try_round(struct um_context *context, const struct um_diagnosis_work *work,
                                const struct um_diagnosis_state *state, size_t from, size_t until,
                                struct um_diagnosis_step *step, struct um_diagnosis_state *best)
{
  UM_TRY(try_alternatives(context, work, state, false, from, until, step, best));
  return try_alternatives(context, work, state, true, from, until, step, best);
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
    if (until > tried) UM_TRY(try_round(context, work, state, tried, until, step, best));
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
  UM_TRY(try_named(context, work, state, step, best));
  UM_TRY(try_ties(context, work, state, step, best));
  sort_fitted(step->alternative, step->nalternative);
  return UM_OK;
}
