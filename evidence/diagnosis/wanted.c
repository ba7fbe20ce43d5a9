/* Effects that a person chose, fitted as a diagnosis fits those that it finds. They are added one
 * after another, each at its null value. Chi-square of several effects has more than one minimum;
 * so this ends in the one that a diagnosis ends in. The order on the command line does not matter.
 */
#include "evidence/diagnosis/steps_impl.h"

#include <math.h>

#include "evidence/diagnosis/trials_impl.h"

static bool is_started(const struct um_model_addition *wanted)
{
  for (size_t p = 0; p < wanted->effect->nparameter; p++)
    if (!isnan(wanted->value[p])) return true;
  return false;
}

/* With the effect's defaults where no start is said. */
static enum um_status block_of(struct um_context *context, const struct um_diagnosis_work *work,
                               const struct um_model_addition *wanted,
                               struct um_diagnosis_block *out)
{
  struct um_model_addition whole = *wanted;
  for (size_t p = 0; p < wanted->effect->nparameter; p++)
    if (isnan(whole.value[p])) whole.value[p] = wanted->effect->parameters[p].default_value;
  return um_diagnosis_block_wanted(context, work, &whole, INFINITY, out);
}

/* Add the effects with a start value, switches, and effects that move no observation. */
static enum um_status add_as_said(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_model_addition *wanted, size_t nwanted,
                                  struct um_diagnosis_state *state)
{
  double nfree = um_diagnosis_free_parameters(state);
  size_t before = state->nblock;
  for (size_t i = 0; i < nwanted; i++) {
    const struct um_sensitivity_candidate *c = &work->candidates->candidate[i];
    struct um_diagnosis_block block;
    UM_TRY(block_of(context, work, &wanted[i], &block));
    for (size_t p = 0; p < block.nfree; p++) nfree += isinf(block.prior_sigma[p]);
    if (!is_started(&wanted[i]) && !c->is_switch && !c->insensitive) continue;
    UM_TRY(um_diagnosis_state_append(context, state, &block));
  }
  UM_TRY(um_diagnosis_check_free(context, work, nfree));
  if (state->nblock == before) return UM_OK;
  return um_diagnosis_state_fit(context, work, state, NULL, NULL, INFINITY);
}

/* Add the effect that explains most of the residual. */
static enum um_status add_best(struct um_context *context, const struct um_diagnosis_work *work,
                               const struct um_model_addition *wanted,
                               struct um_diagnosis_alternative *ranking,
                               struct um_diagnosis_state *state, bool *added)
{
  enum um_status status;
  size_t n;
  struct um_diagnosis_state trial = {0};
  UM_CHECK(um_diagnosis_rank(context, work, state, ranking, &n));
  *added = n > 0;
  if (n == 0) goto done;
  size_t best = ranking[0].candidate;
  UM_CHECK(um_diagnosis_with(context, work, state, &best, 1, INFINITY, &trial));
  if (um_diagnosis_is_rough(&work->candidates->candidate[best]))
    UM_CHECK(um_diagnosis_simplex_refine(context, work, &trial, trial.nblock - 1));
  trial.block[trial.nblock - 1].addition.target = wanted[best].target; /* outlives the candidate */
  um_diagnosis_state_release(context, state);
  *state = trial;
  trial = (struct um_diagnosis_state){0};
done:
  um_diagnosis_state_release(context, &trial);
  return status;
}

enum um_status um_diagnosis_add_wanted(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_model_addition *wanted, size_t nwanted,
                                       struct um_diagnosis_state *state)
{
  enum um_status status;
  struct um_diagnosis_alternative *ranking = NULL;
  um_core_progress_begin(context, "fitting", nwanted);
  UM_CHECK(um_core_allocate(context, nwanted, sizeof *ranking, &ranking));
  UM_CHECK(add_as_said(context, work, wanted, nwanted, state));
  for (bool added = true; added;) {
    UM_CHECK(add_best(context, work, wanted, ranking, state, &added));
    if (added) UM_CHECK(um_core_progress_step(context, 1));
  }
done:
  um_core_progress_end(context);
  um_core_free(context, ranking);
  return status;
}
