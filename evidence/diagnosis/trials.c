/* Fits of a state with candidates added, each a task: a worker sends back the values of the blocks
 * and the numbers of the fit. */
#include "evidence/diagnosis/trials_impl.h"

#include <stdio.h>
#include <string.h>

#include "evidence/diagnosis/steps_impl.h"

#define NAMED 2 /* trials, in their progress */

/* The Jacobian of the state's fit, with the signatures of the candidates behind it that `with` has;
 * by transformed parameters. */
static enum um_status jacobian_with(struct um_context *context,
                                    const struct um_diagnosis_work *work,
                                    const struct um_diagnosis_state *state,
                                    const struct um_diagnosis_state *with, double **out)
{
  size_t n = work->forward->observations.count, at = 0;
  UM_TRY(um_core_allocate(context, with->nparameter * n, sizeof **out, out));
  for (; at < state->nparameter; at++)
    for (size_t j = 0; j < n; j++)
      (*out)[at * n + j] = state->fit->jacobian[at * n + j] * work->forward->observations.sigma[j];
  for (size_t b = state->nblock; b < with->nblock; b++) {
    const struct um_sensitivity_candidate *c =
        &work->candidates->candidate[with->block[b].candidate];
    for (size_t k = 0; k < c->ncolumn && !c->is_switch; k++) {
      size_t p = c->parameter[k];
      double slope = um_effect_transformed_slope(&c->effect->parameters[p], c->null_value[p]);
      for (size_t j = 0; j < n; j++) (*out)[(at + k) * n + j] = slope * c->signature[k * n + j];
    }
    /* parameters unidentified under the null do nothing yet: zeros */
    at += with->block[b].nfree;
  }
  return UM_OK;
}

/* A copy of the state with candidates added at their null values, without a fit. */
static enum um_status blocks_with(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_diagnosis_state *state, const size_t *candidate,
                                  size_t ncandidate, struct um_diagnosis_state *out)
{
  UM_TRY(um_diagnosis_state_copy(context, state, state->nblock, out));
  for (size_t i = 0; i < ncandidate; i++) {
    struct um_diagnosis_block block = um_diagnosis_block_of(work, candidate[i]);
    UM_TRY(um_diagnosis_state_append(context, out, &block));
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
  bool switched = false, shaped = false, seen;
  UM_CHECK(blocks_with(context, work, state, candidate, ncandidate, out));
  for (size_t i = 0; i < ncandidate; i++) {
    const struct um_sensitivity_candidate *c = &work->candidates->candidate[candidate[i]];
    switched = switched || c->is_switch;
    if (c->nunidentified == 0) continue;
    UM_CHECK(um_diagnosis_cycle_is_seen(context, work, state, out, state->nblock + i, &seen));
    if (!seen) {
      um_diagnosis_hold_on(work, out, state->nblock + i);
      continue;
    }
    shaped = true;
    if (um_diagnosis_is_rough(c))
      UM_CHECK(um_diagnosis_start(context, work, state, out, state->nblock + i));
    else
      UM_CHECK(um_diagnosis_start_along(context, work, state, out, state->nblock + i));
  }
  if (!shaped) UM_CHECK(jacobian_with(context, work, state, out, &jacobian));
  /* a switch is on from the start, so the state's values are not those of the start */
  UM_CHECK(um_diagnosis_state_fit(context, work, out, switched || shaped ? NULL : state->fit->value,
                                  jacobian, prune_above));
done:
  um_core_free(context, jacobian);
  if (status != UM_OK) um_diagnosis_state_release(context, out);
  return status;
}

/* What has a parameter unidentified under the null is refined where it leads. */
static enum um_status refine(struct um_context *context, const struct um_diagnosis_work *work,
                             const struct um_diagnosis_trial *trial,
                             struct um_diagnosis_state *state)
{
  size_t last = trial->candidate[trial->ncandidate - 1];
  const struct um_sensitivity_candidate *c = &work->candidates->candidate[last];
  if (!um_diagnosis_is_rough(c) ||
      um_diagnosis_is_held_on(c, &state->block[state->nblock - 1].addition))
    return UM_OK;
  if (state->fit->bic < trial->lead)
    UM_TRY(um_diagnosis_simplex_refine(context, work, state, state->nblock - 1));
  return um_diagnosis_phase_refine(context, work, state, state->nblock - 1, trial->lead);
}

/* --- to and from a worker -------------------------------------------------------------------- */

struct job {
  const struct um_diagnosis_work *work;
  const struct um_diagnosis_state *state;
  struct um_diagnosis_trial *trial; /* [n] */
};

/* 1 where it is refused, else 0, how many parameters of each block are free, its values, and the
 * fit. */
static size_t room(const struct job *job, const struct um_diagnosis_trial *trial)
{
  size_t nparameter = job->state->nparameter;
  for (size_t i = 0; i < trial->ncandidate; i++) {
    struct um_diagnosis_block block = um_diagnosis_block_of(job->work, trial->candidate[i]);
    const struct um_effect *effect = block.addition.effect;
    nparameter += block.nfree + (um_diagnosis_phase_of(effect) < effect->nparameter);
  }
  return 1 + (job->state->nblock + trial->ncandidate) * (1 + UM_EFFECT_PARAMETERS_MAX) +
         um_inference_fit_packed(job->work->forward->observations.count, nparameter);
}

static enum um_status compute(struct um_context *context, void *user, size_t which, double *value)
{
  const struct job *job = user;
  const struct um_diagnosis_trial *trial = &job->trial[which];
  struct um_diagnosis_state state = {0};
  enum um_status status = um_diagnosis_with(context, job->work, job->state, trial->candidate,
                                            trial->ncandidate, trial->prune_above, &state);
  bool refused = status == UM_ERR_REFUSED || status == UM_ERR_NUMERIC;
  if (status == UM_OK) status = refine(context, job->work, trial, &state);
  *value++ = refused;
  for (size_t b = 0; status == UM_OK && b < state.nblock; b++, value += UM_EFFECT_PARAMETERS_MAX) {
    *value++ = (double)state.block[b].nfree;
    memcpy(value, state.block[b].addition.value, sizeof state.block[b].addition.value);
  }
  if (status == UM_OK) um_inference_fit_pack(state.fit, value);
  um_diagnosis_state_release(context, &state);
  if (!refused) return status;
  um_core_message_clear(context);
  return UM_OK;
}

static void tell_fate(const struct um_diagnosis_work *work, const struct um_diagnosis_trial *trial)
{
  for (size_t i = 0; i < trial->ncandidate; i++)
    if (work->fate[trial->candidate[i]] != UM_FATE_FITTED)
      work->fate[trial->candidate[i]] = trial->refused ? UM_FATE_REFUSED : UM_FATE_FITTED;
}

static enum um_status done(struct um_context *context, void *user, size_t which,
                           enum um_status status, const double *value)
{
  const struct job *job = user;
  struct um_diagnosis_trial *trial = &job->trial[which];
  struct um_diagnosis_state *state = &trial->state;
  UM_TRY(status);
  trial->refused = *value++ != 0.0;
  if (trial->refused) return UM_OK;
  UM_TRY(blocks_with(context, job->work, job->state, trial->candidate, trial->ncandidate, state));
  for (size_t b = 0; b < state->nblock; b++, value += UM_EFFECT_PARAMETERS_MAX) {
    double nfree = *value++;
    if (nfree < (double)state->block[b].nfree) um_diagnosis_hold_on(job->work, state, b);
    if (nfree > (double)state->block[b].nfree) um_diagnosis_phase_free(state, b);
    memcpy(state->block[b].addition.value, value, sizeof state->block[b].addition.value);
  }
  return um_inference_fit_unpack(context, value, job->work->forward->observations.count,
                                 state->nparameter, &state->fit);
}

/* "fitting emittance:cells with albedo_level, zero_point:vis and 3 more": what is tried. */
static void say_tried(const struct job *job, size_t n, char *out, size_t size)
{
  const struct um_sensitivity_candidate *all = job->work->candidates->candidate;
  size_t at = (size_t)snprintf(out, size, "fitting");
  for (size_t i = 0; i < n && i < NAMED; i++)
    for (size_t k = 0; k < job->trial[i].ncandidate && at < size; k++) {
      const char *before = k > 0 ? " with" : ",";
      at += (size_t)snprintf(out + at, size - at, "%s %.30s", i + k > 0 ? before : "",
                             all[job->trial[i].candidate[k]].name);
    }
  if (n > NAMED && at < size) snprintf(out + at, size - at, " and %zu more", n - NAMED);
}

enum um_status um_diagnosis_trials_fit(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state,
                                       struct um_diagnosis_trial *trial, size_t n)
{
  char what[200];
  struct job job = {work, state, trial};
  struct um_workers_each tasks = {.n = n,
                                  .compute = compute,
                                  .done = done,
                                  .user = &job,
                                  .workers = um_core_context_threads(context)};
  for (size_t i = 0; i < n; i++)
    if (tasks.nvalue < room(&job, &trial[i])) tasks.nvalue = room(&job, &trial[i]);
  if (n == 0) return UM_OK;
  say_tried(&job, n, what, sizeof what);
  um_core_progress_begin(context, what, n);
  enum um_status status = um_sensitivity_forward_tasks(context, work->forward, &tasks);
  um_core_progress_end(context);
  for (size_t i = 0; i < n && status == UM_OK; i++) tell_fate(work, &trial[i]);
  return status;
}

void um_diagnosis_trials_release(struct um_context *context, struct um_diagnosis_trial *trial,
                                 size_t n)
{
  for (size_t i = 0; trial != NULL && i < n; i++)
    um_diagnosis_state_release(context, &trial[i].state);
}
