/* One step of forward selection: the candidates of the highest promise are fitted, the best by
 * evidence is added. Later, what is no longer needed is taken out again. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "diagnosis/diagnose_impl.h"

/* Rivals are fitted in rounds while the best of them leaves a residual that is not noise. */
#define ROUNDS      3
#define GOOD_ENOUGH 1.3 /* reduced chi-square */
#define REACH       0.25 /* of the best score: what straight lines may underrate a bent candidate by */
#define CLEAR       6.0 /* sigmas from null that need no second look */
#define LATER_REACH 0.5 /* the same for rounds after the first */

/* Jacobian of the state's fit and the signature of the candidate, by inner parameters. */
static enum um_status jacobian_with(struct um_context *context,
                                    const struct um_diagnosis_work *work,
                                    const struct um_diagnosis_state *state, size_t candidate,
                                    double **out)
{
  const struct um_diagnosis_candidate *c = &work->candidates->candidate[candidate];
  size_t n = work->forward->nrow, nnew = c->is_switch ? 0 : c->ncolumn;
  /* parameters of shape do nothing yet: zeros */
  UM_TRY(um_core_allocate(context, (state->nparameter + nnew + c->nshape) * n, sizeof **out, out));
  for (size_t k = 0; k < state->nparameter; k++)
    for (size_t j = 0; j < n; j++)
      (*out)[k * n + j] = state->fit->jacobian[k * n + j] * work->forward->sigma[j];
  for (size_t k = 0; k < nnew; k++) {
    size_t p = c->parameter[k];
    double slope = um_diagnosis_slope(&c->effect->parameters[p], c->null_value[p]);
    for (size_t j = 0; j < n; j++)
      (*out)[(state->nparameter + k) * n + j] = slope * c->signature[k * n + j];
  }
  return UM_OK;
}

/* The state with the candidate added and fitted. */
static enum um_status with_candidate(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     const struct um_diagnosis_state *state, size_t candidate,
                                     struct um_diagnosis_state *out)
{
  enum um_status status;
  double *jacobian = NULL;
  struct um_diagnosis_block block = um_diagnosis_block_of(work, candidate);
  bool is_switch = work->candidates->candidate[candidate].is_switch;
  UM_CHECK(um_diagnosis_state_copy(context, state, state->nblock, out));
  UM_CHECK(um_diagnosis_state_append(context, out, &block));
  UM_CHECK(jacobian_with(context, work, state, candidate, &jacobian));
  /* a switch is on at once: the values of before are not those of the start */
  UM_CHECK(
      um_diagnosis_state_fit(context, work, out, is_switch ? NULL : state->fit->value, jacobian));
done:
  um_core_free(context, jacobian);
  if (status != UM_OK) um_diagnosis_state_release(context, out);
  return status;
}

/* Fit one rival; keep its state when it is the best so far. */
static enum um_status try_rival(struct um_context *context, const struct um_diagnosis_work *work,
                                const struct um_diagnosis_state *state,
                                struct um_diagnosis_rival *rival, struct um_diagnosis_state *best)
{
  struct um_diagnosis_state trial = {0};
  enum um_status status = with_candidate(context, work, state, rival->candidate, &trial);
  if (status == UM_ERR_INPUT || status == UM_ERR_NUMERIC) { /* the effect refuses such values */
    um_core_message_clear(context);
    return UM_OK;
  }
  UM_TRY(status);
  rival->fitted = true;
  rival->chi2 = trial.fit->chi2;
  rival->bic = trial.fit->bic;
  memcpy(rival->value, trial.block[trial.nblock - 1].addition.value, sizeof rival->value);
  um_diagnosis_state_sigma(&trial, trial.nblock - 1, rival->sigma);
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

static enum um_status fit_rivals(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state,
                                 struct um_diagnosis_step *step, struct um_diagnosis_state *best)
{
  size_t tried = 0;
  double rows = (double)work->forward->nrow;
  for (int round = 0; round < ROUNDS; round++) {
    size_t until = tried + work->rivals;
    for (; tried < step->nrival && tried < until; tried++) {
      if (!is_worth(&step->rival[tried], &step->rival[0], round)) break;
      UM_TRY(try_rival(context, work, state, &step->rival[tried], best));
    }
    if (tried < until || (best->fit != NULL && best->fit->chi2 < GOOD_ENOUGH * rows)) break;
  }
  sort_fitted(step->rival, tried);
  return UM_OK;
}

static enum um_status take_winner(struct um_context *context, const struct um_diagnosis_work *work,
                                  struct um_diagnosis_state *state, struct um_diagnosis_state *best,
                                  struct um_diagnosis_step *step)
{
  enum um_status status;
  size_t n = work->forward->nrow;
  double *signal = NULL;
  const struct um_diagnosis_rival *winner = &step->rival[0];
  step->candidate = winner->candidate;
  step->p_value = winner->score.p_corrected;
  step->delta_bic = best->fit->bic - state->fit->bic;
  step->held_out = winner->held_out;
  step->chi2 = best->fit->chi2;
  step->dof = (double)n - (double)best->nparameter;
  step->chi2_reduced = step->chi2 / step->dof;
  step->addition = best->block[best->nblock - 1].addition;
  um_diagnosis_state_sigma(best, best->nblock - 1, step->sigma);
  UM_CHECK(um_diagnosis_state_held_out(context, work, state, &step->held_out_before));
  UM_CHECK(um_core_allocate(context, n, sizeof *signal, &signal));
  for (size_t j = 0; j < n; j++)
    signal[j] = (best->fit->value[j] - state->fit->value[j]) / work->forward->sigma[j];
  UM_CHECK(um_diagnosis_rank_groups(context, work, state, signal, step));
  um_diagnosis_state_release(context, state);
  *state = *best;
  *best = (struct um_diagnosis_state){0};
done:
  um_core_free(context, signal);
  return status;
}

enum um_status um_diagnosis_select(struct um_context *context, const struct um_diagnosis_work *work,
                                   struct um_diagnosis_state *state, struct um_diagnosis_step *step,
                                   bool *added)
{
  enum um_status status;
  struct um_diagnosis_state best = {0};
  *added = false;
  UM_CHECK(um_core_allocate(context, work->candidates->count, sizeof *step->rival, &step->rival));
  UM_CHECK(um_diagnosis_rank(context, work, state, step->rival, &step->nrival));
  bool significant = false;
  for (size_t i = 0; i < step->nrival; i++)
    significant |= step->rival[i].score.p_corrected < work->level;
  if (!significant) goto done;
  UM_CHECK(fit_rivals(context, work, state, step, &best));
  if (best.fit == NULL || !(best.fit->bic < state->fit->bic)) goto done;
  UM_CHECK(take_winner(context, work, state, &best, step));
  *added = true;
done:
  um_diagnosis_state_release(context, &best);
  return status;
}

/* --- backward --------------------------------------------------------------------------------- */

/* A free parameter of the block stands many sigmas from where it does nothing: it is needed. */
static bool is_clear(const struct um_diagnosis_state *state, size_t b)
{
  size_t k = 0;
  for (size_t i = 0; i < b; i++) k += state->block[i].nfree;
  for (size_t p = 0; p < state->block[b].nfree; p++)
    if (fabs(state->fit->x[k + p] - state->block[b].prior_mean[p]) >
        CLEAR * state->fit->sigma[k + p])
      return true;
  return false;
}

static enum um_status jacobian_without(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state, size_t omit,
                                       double **out)
{
  size_t n = work->forward->nrow, kept = 0;
  UM_TRY(um_core_allocate(context, state->nparameter * n, sizeof **out, out));
  for (size_t b = 0, k = 0; b < state->nblock; b++)
    for (size_t p = 0; p < state->block[b].nfree; p++, k++) {
      if (b == omit) continue;
      for (size_t j = 0; j < n; j++)
        (*out)[kept * n + j] = state->fit->jacobian[k * n + j] * work->forward->sigma[j];
      kept++;
    }
  return UM_OK;
}

static enum um_status try_without(struct um_context *context, const struct um_diagnosis_work *work,
                                  struct um_diagnosis_state *state, size_t b, bool *removed)
{
  enum um_status status;
  struct um_diagnosis_state trial = {0};
  double *jacobian = NULL;
  *removed = false;
  UM_CHECK(um_diagnosis_state_copy(context, state, b, &trial));
  UM_CHECK(jacobian_without(context, work, state, b, &jacobian));
  UM_CHECK(um_diagnosis_state_fit(context, work, &trial, NULL, jacobian));
  if (trial.fit->bic <= state->fit->bic) {
    um_diagnosis_state_release(context, state);
    *state = trial;
    trial = (struct um_diagnosis_state){0};
    *removed = true;
  }
done:
  um_core_free(context, jacobian);
  um_diagnosis_state_release(context, &trial);
  return status;
}

enum um_status um_diagnosis_backward(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     struct um_diagnosis_state *state, struct um_diagnosis *d)
{
  for (size_t b = state->nnuisance; b + 1 < state->nblock;) {
    bool removed = false;
    size_t candidate = state->block[b].candidate;
    if (!is_clear(state, b)) UM_TRY(try_without(context, work, state, b, &removed));
    if (!removed) b++;
    for (size_t s = 0; s < d->nstep && removed; s++)
      if (d->step[s].candidate == candidate) d->step[s].removed = true;
  }
  return UM_OK;
}
