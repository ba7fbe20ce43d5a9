/* Each of several effects is judged beside the others: the fit without it, and the alternatives
 * that could replace it. */
#include <math.h>
#include <string.h>

#include "evidence/diagnosis/diagnosis_impl.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

bool um_diagnosis_put_first(struct um_diagnosis_step *step, size_t candidate)
{
  size_t at = 0;
  while (at < step->nalternative && step->alternative[at].candidate != candidate) at++;
  if (at == step->nalternative) return false;
  struct um_diagnosis_alternative own = step->alternative[at];
  memmove(step->alternative + 1, step->alternative, at * sizeof own);
  step->alternative[0] = own;
  return true;
}

/* Put the effect first among the alternatives of its step, with the fit that it has already. */
static void put_own(const struct um_diagnosis_state *state, size_t b, double held_out,
                    struct um_diagnosis_step *step)
{
  if (!um_diagnosis_put_first(step, state->block[b].candidate)) return;
  struct um_diagnosis_alternative *own = &step->alternative[0];
  own->fitted = true;
  own->chi2 = state->fit->chi2;
  own->bic = state->fit->bic;
  own->chi2_prior = state->fit->chi2_prior;
  own->held_out = held_out;
  memcpy(own->value, state->block[b].addition.value, sizeof own->value);
  um_diagnosis_state_sigma(state, b, own->sigma);
}

/* The state with the block moved to the end, where um_diagnosis_step_fill expects it. */
static enum um_status with_last(struct um_context *context, const struct um_diagnosis_work *work,
                                const struct um_diagnosis_state *without,
                                const struct um_diagnosis_state *state, size_t b,
                                struct um_diagnosis_state *out)
{
  UM_TRY(um_diagnosis_state_copy(context, without, without->nblock, out));
  enum um_status status = um_diagnosis_state_append(context, out, &state->block[b]);
  for (size_t i = 0, k = 0; i < state->nblock && status == UM_OK; i++)
    if (i != b) out->block[k++] = state->block[i];
  if (status == UM_OK)
    status = um_diagnosis_state_fit(context, work, out, state->fit->value, NULL, INFINITY);
  if (status != UM_OK) um_diagnosis_state_release(context, out);
  return status;
}

/* Judge one effect. *replaced: a better alternative has replaced it in the state. */
static enum um_status judge(struct um_context *context, const struct um_diagnosis_work *work,
                            struct um_diagnosis_state *state, size_t b, bool last_pass,
                            struct um_diagnosis_step *step, double *chi2_without, bool *replaced)
{
  enum um_status status;
  struct um_diagnosis_state without = {0}, best = {0}, own = {0};
  double held_out = NAN;
  UM_CHECK(um_diagnosis_without(context, work, state, b, &without));
  *chi2_without = without.fit->chi2;
  UM_CHECK(um_core_allocate(context, work->candidates->count, sizeof *step->alternative,
                            &step->alternative));
  UM_CHECK(um_diagnosis_rank(context, work, &without, step->alternative, &step->nalternative));
  UM_CHECK(um_diagnosis_state_held_out(context, work, state, &held_out));
  put_own(state, b, held_out, step);
  UM_CHECK(um_diagnosis_fit_alternatives(context, work, &without, step, &best));
  if (!last_pass && best.fit != NULL && best.fit->bic < state->fit->bic - UM_DIAGNOSIS_BETTER) {
    um_diagnosis_state_release(context, state);
    *state = best;
    best = (struct um_diagnosis_state){0};
    *replaced = true;
    goto done;
  }
  /* what does only a little better stays an alternative, and the effect leads */
  um_diagnosis_put_first(step, state->block[b].candidate);
  UM_CHECK(with_last(context, work, &without, state, b, &own));
  UM_CHECK(um_diagnosis_step_fill(context, work, &without, &own, step));
done:
  um_diagnosis_state_release(context, &own);
  um_diagnosis_state_release(context, &best);
  um_diagnosis_state_release(context, &without);
  return status;
}

/* Sort steps by the chi-square without their effect, falling. */
static void sort_steps(struct um_diagnosis *d, double *cost)
{
  for (size_t i = 1; i < d->nstep; i++)
    for (size_t j = i; j > 0 && cost[j] > cost[j - 1]; j--) {
      struct um_diagnosis_step step = d->step[j];
      double c = cost[j];
      d->step[j] = d->step[j - 1];
      d->step[j - 1] = step;
      cost[j] = cost[j - 1];
      cost[j - 1] = c;
    }
}

/* Model values and chi-square of each step, as the effects are added in that order. */
static enum um_status fill_series(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_diagnosis_state *state, struct um_diagnosis *d)
{
  enum um_status status = UM_OK;
  size_t n = work->forward->observations.count;
  struct um_diagnosis_state now = {0};
  for (size_t s = 0; s < d->nstep; s++) {
    struct um_diagnosis_step *step = &d->step[s];
    const struct um_inference_fit *fit = state->fit;
    if (s + 1 < d->nstep) {
      um_diagnosis_state_release(context, &now);
      now.nnuisance = state->nnuisance;
      for (size_t b = 0; b < state->nblock; b++) {
        bool in = b < state->nnuisance;
        for (size_t i = 0; i <= s; i++)
          in = in || d->step[i].candidate == state->block[b].candidate;
        if (in) UM_CHECK(um_diagnosis_state_append(context, &now, &state->block[b]));
      }
      UM_CHECK(um_diagnosis_state_fit(context, work, &now, NULL, NULL, INFINITY));
      fit = now.fit;
    }
    step->chi2 = fit->chi2;
    step->dof = (double)n - (double)fit->nparameter;
    step->chi2_reduced = step->chi2 / step->dof;
    UM_CHECK(um_core_allocate(context, n, sizeof *step->value, &step->value));
    memcpy(step->value, fit->value, n * sizeof *step->value);
  }
done:
  um_diagnosis_state_release(context, &now);
  return status;
}

static enum um_status judge_all(struct um_context *context, const struct um_diagnosis_work *work,
                                struct um_diagnosis_state *state, bool last_pass,
                                struct um_diagnosis *d, double *cost, bool *replaced)
{
  um_diagnosis_steps_clear(context, d);
  for (size_t b = state->nnuisance; b < state->nblock && !*replaced; b++) {
    struct um_diagnosis_step *step = &d->step[d->nstep++];
    *step = (struct um_diagnosis_step){0};
    UM_TRY(judge(context, work, state, b, last_pass, step, &cost[d->nstep - 1], replaced));
  }
  return UM_OK;
}

/* Whether every effect has its step. A pair that replaced others has none yet, and one of the pair
 * may be left alone. */
static bool is_told(const struct um_diagnosis_state *state, const struct um_diagnosis *d)
{
  size_t kept = 0, known = 0;
  for (size_t s = 0; s < d->nstep; s++) {
    if (d->step[s].removed) continue;
    kept++;
    for (size_t b = state->nnuisance; b < state->nblock; b++)
      known += d->step[s].candidate == state->block[b].candidate;
  }
  return kept == known && known == state->nblock - state->nnuisance;
}

enum um_status um_diagnosis_leave_one_out(struct um_context *context,
                                          const struct um_diagnosis_work *work,
                                          struct um_diagnosis_state *state, struct um_diagnosis *d)
{
  double *cost = NULL;
  size_t effects = state->nblock - state->nnuisance;
  if (effects == 0 || (effects == 1 && is_told(state, d))) return UM_OK;
  UM_TRY(um_core_allocate(context, effects, sizeof *cost, &cost));
  enum um_status status = UM_OK;
  for (int pass = 0; pass < UM_DIAGNOSIS_PASSES; pass++) {
    bool replaced = false;
    status = judge_all(context, work, state, pass + 1 == UM_DIAGNOSIS_PASSES, d, cost, &replaced);
    if (status != UM_OK || !replaced) break;
  }
  if (status == UM_OK) {
    sort_steps(d, cost);
    status = fill_series(context, work, state, d);
  }
  um_core_free(context, cost);
  return status;
}
