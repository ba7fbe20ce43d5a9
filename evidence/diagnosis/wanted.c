/* Effects that a person chose, fitted as a diagnosis fits those that it finds. They are added one
 * after another, each at its null value. Chi-square of several effects has more than one minimum;
 * so this ends in the one that a diagnosis ends in. Where it is the end of a range, each effect is
 * taken out and added again. The order on the command line does not matter. */
#include "evidence/diagnosis/steps_impl.h"

#include <math.h>

#include "evidence/diagnosis/policy.h"
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

/* A copy of the state with an effect added at its null value, fitted together. */
static enum um_status with_one(struct um_context *context, const struct um_diagnosis_work *work,
                               const struct um_model_addition *wanted,
                               const struct um_diagnosis_state *state, size_t which,
                               struct um_diagnosis_state *out)
{
  UM_TRY(um_diagnosis_with(context, work, state, &which, 1, INFINITY, out));
  if (um_diagnosis_is_rough(&work->candidates->candidate[which]))
    UM_TRY(um_diagnosis_simplex_refine(context, work, out, out->nblock - 1));
  out->block[out->nblock - 1].addition.target = wanted[which].target; /* outlives the candidate */
  return UM_OK;
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
  UM_CHECK(with_one(context, work, wanted, state, ranking[0].candidate, &trial));
  um_diagnosis_state_release(context, state);
  *state = trial;
  trial = (struct um_diagnosis_state){0};
done:
  um_diagnosis_state_release(context, &trial);
  return status;
}

/* ---- other minima ---- */

/* Whether a fit may have ended where it need not: at the end of a range, or on its way. */
static bool is_stuck(const struct um_diagnosis_state *state)
{
  bool stuck = !state->fit->converged;
  for (size_t k = 0; k < state->nparameter; k++) stuck = stuck || state->fit->at_bound[k];
  return stuck;
}

/* The block of an effect; nblock: it is none of them. */
static size_t block_with(const struct um_diagnosis_state *state,
                         const struct um_model_addition *wanted)
{
  size_t b = state->nnuisance;
  while (b < state->nblock && (state->block[b].addition.effect != wanted->effect ||
                               state->block[b].addition.target != wanted->target))
    b++;
  return b;
}

/* The state without an effect, fitted, and then with it again. A refusal is no better. */
static enum um_status once_more(struct um_context *context, const struct um_diagnosis_work *work,
                                const struct um_model_addition *wanted,
                                const struct um_diagnosis_state *state, size_t which,
                                struct um_diagnosis_state *out)
{
  enum um_status status;
  struct um_diagnosis_state without = {0};
  UM_CHECK(um_diagnosis_state_copy(context, state, block_with(state, &wanted[which]), &without));
  UM_CHECK(um_diagnosis_state_fit(context, work, &without, NULL, NULL, INFINITY));
  UM_CHECK(with_one(context, work, wanted, &without, which, out));
done:
  um_diagnosis_state_release(context, &without);
  if (status != UM_ERR_REFUSED && status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(context);
  um_diagnosis_state_release(context, out);
  return UM_OK;
}

/* Where the fit is stuck: each effect is taken out and added again to what the others make of it,
 * as the search does; the best of that, until none is better. */
static enum um_status leave(struct um_context *context, const struct um_diagnosis_work *work,
                            const struct um_model_addition *wanted, size_t nwanted,
                            struct um_diagnosis_state *state)
{
  enum um_status status = UM_OK;
  struct um_diagnosis_state trial = {0}, best = {0};
  bool better = nwanted > 1;
  for (int pass = 0; pass < UM_DIAGNOSIS_PASSES && better && is_stuck(state); pass++) {
    better = false;
    for (size_t i = 0; i < nwanted; i++) {
      const struct um_sensitivity_candidate *c = &work->candidates->candidate[i];
      if (c->is_switch || c->insensitive) continue;
      UM_CHECK(once_more(context, work, wanted, state, i, &trial));
      double least = best.fit == NULL ? state->fit->bic - UM_DIAGNOSIS_SETTLED : best.fit->bic;
      if (trial.fit != NULL && trial.fit->bic < least) {
        um_diagnosis_state_release(context, &best);
        best = trial;
        trial = (struct um_diagnosis_state){0};
      }
      um_diagnosis_state_release(context, &trial);
    }
    if (best.fit == NULL) break;
    um_diagnosis_state_release(context, state);
    *state = best;
    best = (struct um_diagnosis_state){0};
    better = true;
  }
done:
  um_diagnosis_state_release(context, &trial);
  um_diagnosis_state_release(context, &best);
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
  UM_CHECK(leave(context, work, wanted, nwanted, state));
done:
  um_core_progress_end(context);
  um_core_free(context, ranking);
  return status;
}
