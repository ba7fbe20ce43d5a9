/* One step of forward selection: the residual is tested, the best alternative by evidence is added.
 */

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

enum um_status um_diagnosis_step_fill(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      const struct um_diagnosis_state *state,
                                      const struct um_diagnosis_state *best,
                                      struct um_diagnosis_step *step)
{
  enum um_status status;
  size_t n = work->forward->observations.count;
  double *signal = NULL;
  const struct um_diagnosis_alternative *winner = &step->alternative[0];
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
    signal[j] = (best->fit->value[j] - state->fit->value[j]) / work->forward->observations.sigma[j];
  um_inference_noise_whiten(work->noise, signal);
  UM_CHECK(um_diagnosis_rank_groups(context, work, state, signal, step));
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
  UM_CHECK(um_core_allocate(context, work->candidates->count, sizeof *step->alternative,
                            &step->alternative));
  UM_CHECK(um_diagnosis_rank(context, work, state, step->alternative, &step->nalternative));
  bool significant = false;
  for (size_t i = 0; i < step->nalternative; i++)
    significant |= step->alternative[i].score.p_corrected < work->level;
  if (!significant) goto done;
  UM_CHECK(um_diagnosis_fit_alternatives(context, work, state, step, &best));
  /* against a discrepancy that explains as much, chance is no measure */
  double ask = work->noise == NULL ? 0.0 : UM_DIAGNOSIS_EVIDENCE;
  if (best.fit == NULL || !(best.fit->bic < state->fit->bic - ask)) goto done;
  UM_CHECK(um_diagnosis_step_fill(context, work, state, &best, step));
  um_diagnosis_state_release(context, state);
  *state = best;
  best = (struct um_diagnosis_state){0};
  *added = true;
done:
  um_diagnosis_state_release(context, &best);
  return status;
}
