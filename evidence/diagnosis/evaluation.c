/* Evaluations of a state, one or several at once. */
#include "evidence/diagnosis/state_impl.h"

#include <math.h>
#include <string.h>

void um_diagnosis_additions_at(const struct um_diagnosis_state *state, const double *x,
                               struct um_model_addition *addition)
{
  for (size_t b = 0, k = 0; b < state->nblock; b++) {
    addition[b] = state->block[b].addition;
    for (size_t p = 0; p < state->block[b].nfree; p++, k++) {
      size_t of = state->block[b].parameter[p];
      addition[b].value[of] = um_effect_physical(&addition[b].effect->parameters[of], x[k]);
    }
  }
}

enum um_status um_diagnosis_evaluate(struct um_context *context, void *user, const double *x,
                                     double *value)
{
  struct um_diagnosis_evaluation *e = user;
  um_diagnosis_additions_at(e->state, x, e->addition);
  return um_sensitivity_forward_evaluate(context, e->work->forward, e->addition, e->state->nblock,
                                         value);
}

struct job {
  struct um_diagnosis_evaluation *evaluation;
  const double *x; /* [n][nparameter] */
  double *value;   /* [n][nobservation] */
};

static enum um_status compute(struct um_context *context, void *user, size_t which, double *value)
{
  const struct job *job = user;
  struct um_diagnosis_evaluation *e = job->evaluation;
  enum um_status status =
      um_diagnosis_evaluate(context, e, job->x + which * e->state->nparameter, value);
  if (status != UM_ERR_REFUSED && status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(context);
  value[0] = NAN;
  return UM_OK;
}

static enum um_status done(struct um_context *context, void *user, size_t which,
                           enum um_status status, const double *value)
{
  (void)context;
  const struct job *job = user;
  size_t n = job->evaluation->work->forward->observations.count;
  if (status == UM_OK) memcpy(job->value + which * n, value, n * sizeof *value);
  return status;
}

enum um_status um_diagnosis_evaluate_all(struct um_context *context, void *user, size_t n,
                                         const double *x, double *value)
{
  struct um_diagnosis_evaluation *e = user;
  struct job job = {e, x, value};
  const struct um_workers_each tasks = {.n = n,
                                        .nvalue = e->work->forward->observations.count,
                                        .compute = compute,
                                        .done = done,
                                        .user = &job,
                                        .workers = um_core_context_threads(context)};
  um_core_quiet_begin(context); /* its steps are none of the caller's progress */
  enum um_status status = um_sensitivity_forward_tasks(context, e->work->forward, &tasks);
  um_core_quiet_end(context);
  return status;
}
