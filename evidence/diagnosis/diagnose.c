/* The method, step by step. Fit the nuisances. Test, fit and add effects one after another, until
 * nothing significant is left. Remove what is no longer needed. Where the end is not noise of the
 * stated sigma, estimate what it is and search anew: an effect must beat what a discrepancy of the
 * model explains. Say what is found and what cannot be known. */
#include "evidence/diagnosis/diagnose.h"

#include <math.h>
#include <string.h>

#include "evidence/diagnosis/coming_impl.h"
#include "evidence/diagnosis/diagnosis_impl.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

static void nothing(double values[UM_EFFECT_PARAMETERS_MAX])
{
  for (size_t p = 0; p < UM_EFFECT_PARAMETERS_MAX; p++) values[p] = NAN;
}

enum um_status um_diagnosis_baseline(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     struct um_diagnosis_state *state, struct um_diagnosis *d)
{
  size_t n = work->forward->observations.count;
  UM_TRY(um_diagnosis_nuisances(context, work, state));
  UM_TRY(um_diagnosis_check_free(context, work, um_diagnosis_free_parameters(state)));
  UM_TRY(um_diagnosis_state_fit(
      context, work, state, state->nnuisance == 0 ? work->candidates->base : NULL, NULL, INFINITY));
  UM_TRY(um_core_allocate(context, n, sizeof *d->value_before, &d->value_before));
  memcpy(d->value_before, state->fit->value, n * sizeof *d->value_before);
  d->chi2 = state->fit->chi2;
  d->dof = (double)n - um_diagnosis_free_parameters(state);
  d->chi2_reduced = d->chi2 / d->dof;
  return um_diagnosis_state_whiteness(context, work, state, &d->baseline_whiteness);
}

static enum um_status keep_ranking(struct um_context *context, const struct um_diagnosis_work *work,
                                   const struct um_diagnosis_state *state, struct um_diagnosis *d)
{
  UM_TRY(um_core_allocate(context, work->candidates->count, sizeof *d->ranking, &d->ranking));
  return um_diagnosis_rank(context, work, state, d->ranking, &d->nranking);
}

static enum um_status go_forward(struct um_context *context, const struct um_diagnosis_work *work,
                                 struct um_diagnosis_state *state, struct um_diagnosis *d)
{
  size_t n = work->forward->observations.count;
  UM_TRY(um_core_allocate(context, work->steps_max, sizeof *d->step, &d->step));
  for (bool added = true; added && d->nstep < work->steps_max;) {
    struct um_diagnosis_step *step = &d->step[d->nstep];
    nothing(step->sigma);
    enum um_status status = um_diagnosis_select(context, work, state, step, &added);
    if (status != UM_OK || !added) {
      um_core_free(context, step->alternative);
      step->alternative = NULL;
      UM_TRY(status);
      break;
    }
    d->nstep++;
    UM_TRY(um_core_allocate(context, n, sizeof *step->value, &step->value));
    memcpy(step->value, state->fit->value, n * sizeof *step->value);
    /* fits that pairs cost are not pruned beside a discrepancy; those of a white search stand */
    if (work->noise == NULL && state->nblock - state->nnuisance > 1)
      UM_TRY(um_diagnosis_pair_swap(context, work, state));
    UM_TRY(um_diagnosis_backward(context, work, state, d));
  }
  UM_TRY(um_diagnosis_superseded_take(context, d));
  UM_TRY(um_diagnosis_leave_one_out(context, work, state, d));
  um_diagnosis_superseded_keep(state, d);
  return UM_OK;
}

enum um_status um_diagnosis_keep_end(struct um_context *context,
                                     const struct um_diagnosis_work *work,
                                     const struct um_diagnosis_state *state, struct um_diagnosis *d)
{
  size_t n = work->forward->observations.count, added = state->nblock - state->nnuisance;
  um_diagnosis_end_clear(context, d);
  UM_TRY(um_core_allocate(context, added, sizeof *d->addition, &d->addition));
  UM_TRY(um_core_allocate(context, added, sizeof *d->addition_sigma, &d->addition_sigma));
  UM_TRY(um_core_allocate(context, state->nnuisance, sizeof *d->nuisance, &d->nuisance));
  UM_TRY(
      um_core_allocate(context, state->nnuisance, sizeof *d->nuisance_sigma, &d->nuisance_sigma));
  for (size_t b = 0; b < state->nblock; b++) {
    bool nuisance = b < state->nnuisance;
    size_t i = nuisance ? d->nnuisance++ : d->naddition++;
    *(nuisance ? &d->nuisance[i] : &d->addition[i]) = state->block[b].addition;
    um_diagnosis_state_sigma(state, b, nuisance ? d->nuisance_sigma[i] : d->addition_sigma[i]);
    for (size_t s = 0; s < d->nstep && !nuisance; s++) { /* values as fitted together */
      if (d->step[s].removed || d->step[s].candidate != state->block[b].candidate) continue;
      d->step[s].addition = d->addition[i];
      memcpy(d->step[s].sigma, d->addition_sigma[i], sizeof d->step[s].sigma);
    }
  }
  UM_TRY(um_core_allocate(context, n, sizeof *d->value_after, &d->value_after));
  memcpy(d->value_after, state->fit->value, n * sizeof *d->value_after);
  d->chi2_after = state->fit->chi2;
  d->bic_after = state->fit->bic;
  d->dof_after = (double)n - (double)state->nparameter;
  d->chi2_reduced_after = d->chi2_after / d->dof_after;
  return um_diagnosis_state_whiteness(context, work, state, &d->final_whiteness);
}

/* --- what follows ----------------------------------------------------------------------------- */

/* Describe the residual of the baseline, where the verdict abstains. */
static enum um_status look_at_residual(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *bare,
                                       struct um_diagnosis *d)
{
  struct um_model_addition *addition = NULL;
  if (d->verdict == UM_VERDICT_COMPLETE || d->verdict == UM_VERDICT_FOUND) return UM_OK;
  UM_TRY(um_core_allocate(context, bare->nblock, sizeof *addition, &addition));
  um_diagnosis_state_additions(bare, addition);
  enum um_status status =
      um_missing_heat_residual_of(context, work->forward, addition, bare->nblock,
                                  um_diagnosis_free_parameters(bare), &d->residual);
  um_core_free(context, addition);
  return status;
}

/* The search, with the noise of the work. bare: the scenario with its nuisances. */
static enum um_status search(struct um_context *context, const struct um_diagnosis_work *work,
                             struct um_diagnosis_state *state, struct um_diagnosis_state *bare,
                             struct um_diagnosis *d)
{
  UM_TRY(um_diagnosis_baseline(context, work, state, d));
  UM_TRY(um_diagnosis_state_copy(context, state, state->nblock, bare));
  UM_TRY(um_diagnosis_state_fit(context, work, bare, state->fit->value, NULL, INFINITY));
  UM_TRY(keep_ranking(context, work, state, d));
  UM_TRY(go_forward(context, work, state, d));
  return um_diagnosis_keep_end(context, work, state, d);
}

/* Whether two searches ended with the same effects. */
static bool ends_alike(const struct um_diagnosis *a, const struct um_diagnosis *b)
{
  if (a->naddition != b->naddition) return false;
  for (size_t i = 0; i < a->naddition; i++) {
    bool there = false;
    for (size_t j = 0; j < b->naddition && !there; j++)
      there = a->addition[i].effect == b->addition[j].effect &&
              a->addition[i].target == b->addition[j].target;
    if (!there) return false;
  }
  return true;
}

/* What the search ended with, or added and replaced, is tried by the searches that follow, where
 * its shape is not known by its score: with it at its best may be left what no other leaves. */
static void carry(const struct um_diagnosis_work *work, const struct um_diagnosis *d)
{
  for (size_t i = 0; i < work->candidates->count; i++) {
    const struct um_sensitivity_candidate *c = &work->candidates->candidate[i];
    for (size_t k = 0; k < d->naddition + d->nsuperseded && um_diagnosis_is_rough(c); k++) {
      const struct um_model_addition *a =
          k < d->naddition ? &d->addition[k] : &d->superseded[k - d->naddition].addition;
      if (a->effect == c->effect && a->target == c->target) work->shape[i].named = true;
    }
  }
}

/* The search anew, with the noise that a residual has. *same: it ends alike. */
static enum um_status search_anew(struct um_context *context, struct um_diagnosis_work *work,
                                  const double *residual, struct um_diagnosis_state *state,
                                  struct um_diagnosis_state *bare, struct um_diagnosis **d,
                                  bool *same)
{
  enum um_status status;
  struct um_diagnosis *next = NULL;
  UM_TRY(um_diagnosis_noise_take(context, work, residual, same));
  if (*same) return UM_OK;
  um_diagnosis_state_release(context, state);
  um_diagnosis_state_release(context, bare);
  UM_CHECK(um_core_allocate(context, 1, sizeof *next, &next));
  next->forward = work->forward;
  next->candidates = (*d)->candidates;
  next->level = work->level;
  next->weighed = true;
  carry(work, *d);
  memset(work->fate, 0, work->candidates->count * sizeof *work->fate);
  UM_CHECK(search(context, work, state, bare, next));
  next->baseline_whiteness = (*d)->baseline_whiteness; /* of sigma as it is stated */
  *same = ends_alike(*d, next);
  um_diagnosis_destroy(context, d);
  *d = next;
  next = NULL;
done:
  um_diagnosis_destroy(context, &next);
  return status;
}

/* Whether a search through white noise stands whatever a discrepancy explains: it leaves noise, and
 * has added nothing, or one effect that is not small. A discrepancy would explain a mere level, as
 * a zero point, as well. */
static bool stands(const struct um_diagnosis *d)
{
  if (!um_diagnosis_is_noise(&d->final_whiteness)) return false;
  if (d->naddition == 0) return true;
  const struct um_diagnosis_step *step = um_diagnosis_step_of(d, &d->addition[0]);
  return d->naddition == 1 && step != NULL && -step->delta_bic >= UM_DIAGNOSIS_SMALL;
}

/* Where what is left is not noise of the stated sigma, or a discrepancy explains as much as the
 * last of the effects that were added: searches by what it is. */
static enum um_status search_with_noise(struct um_context *context, struct um_diagnosis_work *work,
                                        struct um_diagnosis_state *state,
                                        struct um_diagnosis_state *bare, struct um_diagnosis **d)
{
  enum um_status status = UM_OK;
  bool white = um_diagnosis_is_noise(&(*d)->final_whiteness), whole = true, same = false;
  double *residual = NULL;
  if (stands(*d)) return UM_OK;
  UM_CHECK(um_diagnosis_discrepancy_create(context, work->forward, &work->discrepancy));
  UM_CHECK(
      um_core_allocate(context, work->forward->observations.count, sizeof *residual, &residual));
  UM_CHECK(um_diagnosis_depth_find(context, work, state, *d, residual, &whole));
  if (white && whole) goto done;
  for (int round = 0; round < UM_DIAGNOSIS_NOISE_ROUNDS && !same; round++) {
    const double *left = round == 0 ? residual : state->fit->residual;
    UM_CHECK(search_anew(context, work, left, state, bare, d, &same));
  }
done:
  um_core_free(context, residual);
  return status;
}

/* What the search means, and what follows from it. */
static enum um_status conclude(struct um_context *context, const struct um_diagnosis_work *work,
                               struct um_diagnosis_state *state,
                               const struct um_diagnosis_state *bare, struct um_diagnosis *d)
{
  UM_TRY(um_diagnosis_scatter_describe(context, work, state, d));
  UM_TRY(um_diagnosis_sceptic_ask(context, work, state, d));
  d->verdict = um_diagnosis_judge(state, d);
  if (d->verdict == UM_VERDICT_UNEXPLAINED || d->weighed)
    UM_TRY(um_diagnosis_weigh_heat(context, work, state, bare, d));
  UM_TRY(um_diagnosis_weigh_light(context, work, state, bare, d));
  UM_TRY(um_diagnosis_look_as_asked(context, work, bare, d));
  um_diagnosis_halves_assign(bare, d);
  um_diagnosis_confidence_assign(d);
  um_diagnosis_probabilities_assign(bare, d);
  UM_TRY(look_at_residual(context, work, bare, d));
  if (!work->options->no_next) UM_TRY(um_diagnosis_next_find(context, work, state, d));
  UM_TRY(um_diagnosis_missed_find(context, work, d));
  return um_diagnosis_summary_write(context, d, &d->summary);
}

enum um_status um_diagnosis_begin(struct um_context *context,
                                  struct um_sensitivity_forward *forward,
                                  const struct um_sensitivity_candidates *candidates,
                                  const struct um_diagnosis_options *options,
                                  struct um_diagnosis_work *work, struct um_diagnosis **d)
{
  if (options->passes > 0) UM_TRY(um_diagnosis_coming_check(context, forward));
  UM_TRY(um_core_allocate(context, 1, sizeof **d, d));
  *work = (struct um_diagnosis_work){
      .forward = forward,
      .candidates = candidates,
      .options = options,
      .level = options->level > 0.0 ? options->level : UM_MISSING_HEAT_LEVEL,
      .steps_max = options->steps_max > 0 ? options->steps_max : UM_DIAGNOSIS_STEPS_MAX,
      .alternatives = options->alternatives > 0 ? options->alternatives : UM_DIAGNOSIS_ALTERNATIVES,
  };
  (*d)->forward = forward;
  (*d)->level = work->level;
  UM_TRY(um_core_allocate(context, candidates->count, sizeof *work->fate, &work->fate));
  UM_TRY(um_core_allocate(context, candidates->count, sizeof *work->shape, &work->shape));
  UM_TRY(um_core_allocate(context, forward->observations.count, sizeof *work->fold, &work->fold));
  work->nfold = UM_DIAGNOSIS_FOLDS;
  um_diagnosis_time_blocks(&forward->observations, work->nfold, work->fold);
  return UM_OK;
}

void um_diagnosis_end(struct um_context *context, struct um_diagnosis_work *work)
{
  UM_FREE(context, work->fate, work->fold, work->shape);
  um_inference_noise_release(context, &work->estimated);
  um_diagnosis_discrepancy_release(context, &work->discrepancy);
  *work = (struct um_diagnosis_work){0};
}

enum um_status um_diagnosis_create(struct um_context *context,
                                   struct um_sensitivity_forward *forward,
                                   struct um_sensitivity_candidates *candidates,
                                   const struct um_diagnosis_options *options,
                                   struct um_diagnosis **out)
{
  enum um_status status;
  struct um_diagnosis_work work = {0};
  struct um_diagnosis_state state = {0}, bare = {0};
  struct um_diagnosis *d = NULL;
  *out = NULL;
  UM_CHECK(um_diagnosis_begin(context, forward, candidates, options, &work, &d));
  d->candidates = candidates;
  UM_CHECK(search(context, &work, &state, &bare, d));
  UM_CHECK(search_with_noise(context, &work, &state, &bare, &d));
  UM_CHECK(conclude(context, &work, &state, &bare, d));
  *out = d;
  d = NULL;
done:
  um_diagnosis_end(context, &work);
  um_diagnosis_state_release(context, &state);
  um_diagnosis_state_release(context, &bare);
  um_diagnosis_destroy(context, &d);
  return status;
}
