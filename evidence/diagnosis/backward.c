/* Removes effects that are no longer worth their parameters by BIC. */
#include <math.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

/* A parameter of the block is many sigmas from where it does nothing: the effect is needed. */
static bool is_clear(const struct um_diagnosis_state *state, size_t b)
{
  size_t k = 0;
  for (size_t i = 0; i < b; i++) k += state->block[i].nfree;
  for (size_t p = 0; p < state->block[b].nfree; p++)
    if (fabs(state->fit->x[k + p] - state->block[b].prior_mean[p]) >
        UM_DIAGNOSIS_CLEAR * state->fit->sigma[k + p])
      return true;
  return false;
}

static enum um_status try_without(struct um_context *context, const struct um_diagnosis_work *work,
                                  struct um_diagnosis_state *state, size_t b, bool *removed)
{
  struct um_diagnosis_state trial = {0};
  *removed = false;
  UM_TRY(um_diagnosis_without(context, work, state, b, &trial));
  double ask = work->noise == NULL ? 0.0 : UM_DIAGNOSIS_EVIDENCE;
  if (trial.fit->bic <= state->fit->bic + ask) {
    um_diagnosis_state_release(context, state);
    *state = trial;
    trial = (struct um_diagnosis_state){0};
    *removed = true;
  }
  um_diagnosis_state_release(context, &trial);
  return UM_OK;
}

enum um_status um_diagnosis_backward(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     struct um_diagnosis_state *state, struct um_diagnosis *d)
{
  for (size_t b = state->nnuisance; b + 1 < state->nblock;) {
    bool removed = false;
    size_t candidate = state->block[b].candidate;
    if (work->noise != NULL || !is_clear(state, b))
      UM_TRY(try_without(context, work, state, b, &removed));
    if (!removed) b++;
    for (size_t s = 0; s < d->nstep && removed; s++)
      if (d->step[s].candidate == candidate) d->step[s].removed = true;
  }
  return UM_OK;
}
