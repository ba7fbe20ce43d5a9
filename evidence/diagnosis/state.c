/* Fits several effects together, as one vector of parameters. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"

void um_diagnosis_time_blocks(const struct um_sensitivity_observations *o, size_t nblock,
                              size_t *block)
{
  double first = INFINITY, last = -INFINITY;
  for (size_t j = 0; j < o->count; j++) {
    first = fmin(first, o->t[j]);
    last = fmax(last, o->t[j]);
  }
  for (size_t j = 0; j < o->count; j++) {
    block[j] = last > first ? (size_t)((double)nblock * (o->t[j] - first) / (last - first)) : 0;
    if (block[j] == nblock) block[j]--;
  }
}

bool um_diagnosis_is_rough(const struct um_sensitivity_candidate *candidate)
{
  for (size_t k = 0; k < candidate->nunidentified; k++)
    if (candidate->trials == 0 ||
        !candidate->effect->parameters[candidate->unidentified[k]].is_rate)
      return true;
  return false;
}

struct um_diagnosis_block um_diagnosis_block_of(const struct um_diagnosis_work *work,
                                                size_t candidate)
{
  const struct um_sensitivity_candidate *c = &work->candidates->candidate[candidate];
  struct um_diagnosis_block block = {
      .addition = {.effect = c->effect, .target = c->target, .off = c->off},
      .candidate = candidate,
      .nfree = c->is_switch ? 0 : c->ncolumn + c->nunidentified};
  for (size_t p = 0; p < c->effect->nparameter; p++) block.addition.value[p] = c->null_value[p];
  for (size_t k = 0; k < block.nfree; k++) {
    size_t p = k < c->ncolumn ? c->parameter[k] : c->unidentified[k - c->ncolumn];
    const struct um_effect_parameter *of = &c->effect->parameters[p];
    double null_value = c->null_value[p];
    block.parameter[k] = p;
    block.minimum[k] = c->minimum[p];
    block.maximum[k] = c->maximum[p];
    block.prior_mean[k] = um_effect_transformed(of, null_value);
    block.prior_sigma[k] = of->prior_sigma;
    block.step[k] = k < c->ncolumn ? fabs(c->step[k]) / um_effect_transformed_slope(of, null_value)
                                   : UM_DIAGNOSIS_UNIDENTIFIED_STEP * of->prior_sigma;
  }
  return block;
}

enum um_status um_diagnosis_state_append(struct um_context *context,
                                         struct um_diagnosis_state *state,
                                         const struct um_diagnosis_block *block)
{
  UM_TRY(
      um_core_reallocate(context, state->nblock + 1, sizeof *state->block, (void **)&state->block));
  state->block[state->nblock++] = *block;
  state->nparameter += block->nfree;
  return UM_OK;
}

enum um_status um_diagnosis_state_copy(struct um_context *context,
                                       const struct um_diagnosis_state *state, size_t omit,
                                       struct um_diagnosis_state *out)
{
  *out = (struct um_diagnosis_state){.nnuisance = state->nnuisance};
  for (size_t b = 0; b < state->nblock; b++) {
    if (b == omit) continue;
    enum um_status status = um_diagnosis_state_append(context, out, &state->block[b]);
    if (status == UM_OK) continue;
    um_diagnosis_state_release(context, out);
    return status;
  }
  return UM_OK;
}

void um_diagnosis_state_release(struct um_context *context, struct um_diagnosis_state *state)
{
  um_inference_fit_destroy(context, &state->fit);
  um_core_free(context, state->block);
  *state = (struct um_diagnosis_state){0};
}

/* --- fit -------------------------------------------------------------------------------------- */

void um_diagnosis_state_parameters(const struct um_diagnosis_state *state,
                                   struct um_inference_fit_parameter *out)
{
  for (size_t b = 0, k = 0; b < state->nblock; b++) {
    const struct um_diagnosis_block *block = &state->block[b];
    for (size_t p = 0; p < block->nfree; p++, k++) {
      const struct um_effect_parameter *of =
          &block->addition.effect->parameters[block->parameter[p]];
      double value = block->addition.value[block->parameter[p]];
      out[k] = (struct um_inference_fit_parameter){
          .start = um_effect_transformed(of, value),
          .minimum = um_effect_transformed(of, block->minimum[p]),
          .maximum = um_effect_transformed(of, block->maximum[p]),
          .prior_mean = block->prior_mean[p],
          .prior_sigma = block->prior_sigma[p],
          .step = block->step[p]};
    }
  }
}

/* A thermostat's chi-square is non-smooth below some scale: more iterations only follow the
 * discontinuities. */
static size_t iterations(const struct um_diagnosis_work *work,
                         const struct um_diagnosis_state *state)
{
  for (size_t b = 0; b < state->nblock; b++)
    if (state->block[b].candidate != UM_COMPARE_NOWHERE &&
        um_diagnosis_is_rough(&work->candidates->candidate[state->block[b].candidate]))
      return UM_DIAGNOSIS_NON_SMOOTH_STEPS;
  return 0;
}

/* What BIC asks for numbers that are not free because nothing tells of them, and for the odds of
 * what is turned off. */
static double of_held(const struct um_diagnosis_work *work, const struct um_diagnosis_state *state)
{
  double sum = 0.0, each = log((double)work->forward->observations.count);
  for (size_t b = 0; b < state->nblock; b++)
    sum += (double)state->block[b].nheld * each +
           (state->block[b].addition.off ? UM_DIAGNOSIS_OFF : 0.0);
  return sum;
}

/* Has it a heater that is on all the time (always_on.c)? It moves all along its signature: that was
 * looked at with ten times the power. */
static bool is_held(const struct um_diagnosis_state *state)
{
  bool held = false;
  for (size_t b = 0; b < state->nblock; b++) held = held || state->block[b].nheld > 0;
  return held;
}

/* The chi-square of observations and priors that makes this BIC. */
static double chi2_of_bic(const struct um_diagnosis_work *work,
                          const struct um_diagnosis_state *state, double bic)
{
  return bic - (double)state->nparameter * log((double)work->forward->observations.count) -
         of_held(work, state);
}

enum um_status um_diagnosis_noise_take(struct um_context *context, struct um_diagnosis_work *work,
                                       const double *residual, bool *white)
{
  struct um_inference_noise next = {0};
  UM_TRY(um_inference_noise_estimate(context, &work->discrepancy.family, residual, NULL, &next));
  *white = um_inference_noise_is_white(&next);
  struct um_inference_noise *rest = *white ? &next : &work->estimated;
  um_inference_noise_release(context, rest);
  if (*white) return UM_OK;
  work->estimated = next;
  work->noise = &work->estimated;
  return UM_OK;
}

enum um_status um_diagnosis_noise_bic(struct um_context *context,
                                      const struct um_inference_noise_family *family,
                                      const struct um_inference_noise *outliers,
                                      const struct um_inference_fit *fit, double *out)
{
  struct um_inference_noise own = {0};
  UM_TRY(um_inference_noise_estimate(context, family, fit->residual, outliers, &own));
  *out = own.worth + fit->chi2_prior + (double)fit->nparameter * log((double)fit->nobservation);
  um_inference_noise_release(context, &own);
  return UM_OK;
}

/* BIC with the noise that the fit's own residual has the largest likelihood with: what another
 * explanation leaves may be discrepancy, too, and is paid for as such. Chi-square is that of white
 * noise again. */
static enum um_status judge_by_own_noise(struct um_context *context,
                                         const struct um_diagnosis_work *work,
                                         struct um_inference_fit *fit)
{
  fit->chi2 = um_inference_dot(fit->nobservation, fit->residual, fit->residual);
  return um_diagnosis_noise_bic(context, work->noise->family, work->noise, fit, &fit->bic);
}

enum um_status um_diagnosis_state_fit(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      struct um_diagnosis_state *state, const double *value,
                                      const double *jacobian, double prune_above)
{
  enum um_status status;
  struct um_diagnosis_evaluation e = {work, state, NULL};
  struct um_inference_fit_parameter *parameter = NULL;
  struct um_inference_fit *fit = NULL;
  UM_CHECK(um_core_allocate(context, state->nblock, sizeof *e.addition, &e.addition));
  UM_CHECK(um_core_allocate(context, state->nparameter, sizeof *parameter, &parameter));
  um_diagnosis_state_parameters(state, parameter);
  struct um_inference_fit_problem problem = {.nobservation = work->forward->observations.count,
                                             .nparameter = state->nparameter,
                                             .measured = work->forward->observations.measured,
                                             .sigma = work->forward->observations.sigma,
                                             .parameter = parameter,
                                             .evaluate = um_diagnosis_evaluate,
                                             .evaluate_all = um_diagnosis_evaluate_all,
                                             .user = &e,
                                             .jacobian = jacobian,
                                             .value = value,
                                             .iterations_max = iterations(work, state),
                                             .noise = work->noise,
                                             .prunes = work->noise == NULL && isfinite(prune_above),
                                             .sure = is_held(state),
                                             .prune_above = chi2_of_bic(work, state, prune_above)};
  UM_CHECK(um_inference_fit_create(context, &problem, &fit));
  if (work->noise != NULL) UM_CHECK(judge_by_own_noise(context, work, fit));
  fit->bic += of_held(work, state);
  um_diagnosis_additions_at(state, fit->x, e.addition);
  for (size_t b = 0; b < state->nblock; b++) state->block[b].addition = e.addition[b];
  um_inference_fit_destroy(context, &state->fit);
  state->fit = fit;
  fit = NULL;
done:
  um_inference_fit_destroy(context, &fit);
  UM_FREE(context, parameter, e.addition);
  return status;
}

void um_diagnosis_state_additions(const struct um_diagnosis_state *state,
                                  struct um_model_addition *out)
{
  for (size_t b = 0; b < state->nblock; b++) out[b] = state->block[b].addition;
}

void um_diagnosis_state_sigma(const struct um_diagnosis_state *state, size_t block, double *sigma)
{
  size_t k = 0;
  for (size_t b = 0; b < block; b++) k += state->block[b].nfree;
  for (size_t p = 0; p < UM_EFFECT_PARAMETERS_MAX; p++) sigma[p] = NAN;
  for (size_t p = 0; p < state->block[block].nfree; p++) {
    const struct um_model_addition *a = &state->block[block].addition;
    size_t of = state->block[block].parameter[p];
    sigma[of] = state->fit->sigma[k + p] *
                um_effect_transformed_slope(&a->effect->parameters[of], a->value[of]);
  }
}

enum um_status um_diagnosis_state_held_out(struct um_context *context,
                                           const struct um_diagnosis_work *work,
                                           const struct um_diagnosis_state *state, double *out)
{
  enum um_status status;
  struct um_inference_fit_parameter *parameter = NULL;
  UM_TRY(um_core_allocate(context, state->nparameter, sizeof *parameter, &parameter));
  um_diagnosis_state_parameters(state, parameter);
  struct um_inference_fit_problem problem = {.nobservation = work->forward->observations.count,
                                             .nparameter = state->nparameter,
                                             .measured = work->forward->observations.measured,
                                             .sigma = work->forward->observations.sigma,
                                             .parameter = parameter};
  status = um_inference_fit_held_out(context, &problem, state->fit, work->fold, work->nfold, out);
  um_core_free(context, parameter);
  return status;
}

/* --- residual --------------------------------------------------------------------------------- */

double um_diagnosis_free_parameters(const struct um_diagnosis_state *state)
{
  double n = 0.0;
  for (size_t b = 0; b < state->nblock; b++)
    for (size_t p = 0; p < state->block[b].nfree; p++) n += isinf(state->block[b].prior_sigma[p]);
  return n;
}

enum um_status um_diagnosis_check_free(struct um_context *context,
                                       const struct um_diagnosis_work *work, double nfree)
{
  if (nfree < (double)work->forward->observations.count) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: %zu observations and %.0f free parameters; accepted: more observations "
                      "than parameters",
                      work->forward->measurements->path, work->forward->observations.count, nfree);
}

/* The residual, over its own noise where there is one. */
static enum um_status standardised(struct um_context *context, const struct um_diagnosis_work *work,
                                   const struct um_diagnosis_state *state, double *out)
{
  const struct um_inference_fit *fit = state->fit;
  struct um_inference_noise own = {0};
  memcpy(out, fit->residual, fit->nobservation * sizeof *out);
  if (work->noise == NULL) return UM_OK;
  UM_TRY(
      um_inference_noise_estimate(context, work->noise->family, fit->residual, work->noise, &own));
  um_inference_noise_whiten(&own, out);
  um_inference_noise_release(context, &own);
  return UM_OK;
}

/* Observations of each channel in order of time, as the whiteness test wants them. */
enum um_status um_diagnosis_state_whiteness(struct um_context *context,
                                            const struct um_diagnosis_work *work,
                                            const struct um_diagnosis_state *state,
                                            struct um_inference_whiteness *out)
{
  enum um_status status;
  const struct um_sensitivity_forward *f = work->forward;
  size_t *order = NULL, *channel = NULL;
  double *sorted = NULL, *residual = NULL;
  UM_CHECK(um_core_allocate(context, f->observations.count, sizeof *residual, &residual));
  UM_CHECK(standardised(context, work, state, residual));
  UM_CHECK(um_core_allocate(context, f->observations.count, sizeof *order, &order));
  UM_CHECK(um_core_allocate(context, f->observations.count, sizeof *channel, &channel));
  UM_CHECK(um_core_allocate(context, f->observations.count, sizeof *sorted, &sorted));
  /* observations are in order of time within a track; insertion is quick where they nearly are */
  for (size_t j = 0; j < f->observations.count; j++) {
    size_t at = j;
    for (; at > 0 && f->observations.t[order[at - 1]] > f->observations.t[j]; at--)
      order[at] = order[at - 1];
    order[at] = j;
  }
  for (size_t j = 0; j < f->observations.count; j++) {
    sorted[j] = residual[order[j]];
    channel[j] = f->observations.channel[order[j]];
  }
  UM_CHECK(um_inference_whiteness_test(context, f->observations.count, sorted, channel,
                                       f->measurements->nchannel,
                                       um_diagnosis_free_parameters(state), out));
done:
  UM_FREE(context, sorted, residual, channel, order);
  return status;
}

static enum um_status jacobian_without(struct um_context *context,
                                       const struct um_diagnosis_work *work,
                                       const struct um_diagnosis_state *state, size_t omit,
                                       double **out)
{
  size_t n = work->forward->observations.count, kept = 0;
  UM_TRY(um_core_allocate(context, state->nparameter * n, sizeof **out, out));
  for (size_t b = 0, k = 0; b < state->nblock; b++)
    for (size_t p = 0; p < state->block[b].nfree; p++, k++) {
      if (b == omit) continue;
      for (size_t j = 0; j < n; j++)
        (*out)[kept * n + j] =
            state->fit->jacobian[k * n + j] * work->forward->observations.sigma[j];
      kept++;
    }
  return UM_OK;
}

enum um_status um_diagnosis_without(struct um_context *context,
                                    const struct um_diagnosis_work *work,
                                    const struct um_diagnosis_state *state, size_t b,
                                    struct um_diagnosis_state *out)
{
  enum um_status status;
  char what[80];
  double *jacobian = NULL;
  snprintf(what, sizeof what, "fitting without %.60s",
           work->candidates->candidate[state->block[b].candidate].name);
  um_core_progress_begin(context, what, 0);
  UM_CHECK(um_diagnosis_state_copy(context, state, b, out));
  UM_CHECK(jacobian_without(context, work, state, b, &jacobian));
  UM_CHECK(um_diagnosis_state_fit(context, work, out, NULL, jacobian, INFINITY));
done:
  um_core_progress_end(context);
  um_core_free(context, jacobian);
  if (status != UM_OK) um_diagnosis_state_release(context, out);
  return status;
}
