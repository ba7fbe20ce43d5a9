/* Candidates and nuisances as whitened directions, for the linear statistics. */
#include "evidence/diagnosis/steps_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/suggestions.h"

void um_diagnosis_directions_release(struct um_context *context, struct um_diagnosis_directions *d)
{
  UM_FREE(context, d->direction, d->column, d->bound, d->nuisance_sigma, d->nuisance_column);
}

/* Unit of a direction [transformed]: the step of its difference, so that a
 * length says what a step does, whatever the unit of the parameter. */
double um_diagnosis_unit(const struct um_sensitivity_candidate *c, size_t k)
{
  if (c->is_switch || c->step[k] == 0.0) return 1.0;
  size_t p = c->parameter[k];
  return fabs(c->step[k]) /
         um_effect_transformed_slope(&c->effect->parameters[p], c->null_value[p]);
}

/* A switch has one column: 0 is off and 1 is on. Others in units of their step. */
static void bounds_of(const struct um_sensitivity_candidate *c, double *low, double *high,
                      double *prior, double *slope)
{
  for (size_t k = 0; k < c->ncolumn; k++) {
    low[k] = 0.0;
    high[k] = prior[k] = INFINITY;
    slope[k] = 1.0;
    if (c->is_switch) continue;
    const struct um_effect_parameter *of = &c->effect->parameters[c->parameter[k]];
    double null_value = c->null_value[c->parameter[k]];
    double unit = um_diagnosis_unit(c, k);
    low[k] = (um_effect_transformed(of, c->minimum[c->parameter[k]]) -
              um_effect_transformed(of, null_value)) /
             unit;
    high[k] = (um_effect_transformed(of, c->maximum[c->parameter[k]]) -
               um_effect_transformed(of, null_value)) /
              unit;
    prior[k] = of->prior_sigma / unit;
    slope[k] = um_effect_transformed_slope(of, null_value) * unit;
  }
}

enum um_status um_diagnosis_directions_make(struct um_context *context,
                                            const struct um_diagnosis_work *work,
                                            const struct um_diagnosis_state *state,
                                            struct um_diagnosis_directions *d)
{
  const struct um_sensitivity_candidates *all = work->candidates;
  size_t n = work->forward->observations.count, columns = 0, at = 0;
  for (size_t i = 0; i < all->count; i++) columns += all->candidate[i].ncolumn;
  UM_TRY(um_core_allocate(context, all->count, sizeof *d->direction, &d->direction));
  UM_TRY(um_core_allocate(context, columns * n, sizeof *d->column, &d->column));
  UM_TRY(um_core_allocate(context, 3 * columns, sizeof *d->bound, &d->bound));
  UM_TRY(um_core_allocate(context, state->nparameter, sizeof(double), &d->nuisance_sigma));
  for (size_t i = 0; i < all->count; i++) {
    const struct um_sensitivity_candidate *c = &all->candidate[i];
    double *low = d->bound + at, *high = low + columns, *prior = high + columns;
    double slope[UM_EFFECT_PARAMETERS_MAX];
    bounds_of(c, low, high, prior, slope);
    for (size_t k = 0; k < c->ncolumn; k++) {
      double *column = d->column + (at + k) * n;
      for (size_t j = 0; j < n && !c->insensitive; j++)
        column[j] = slope[k] * c->signature[k * n + j] / work->forward->observations.sigma[j];
      um_inference_noise_whiten(work->noise, column);
    }
    d->direction[i] = (struct um_inference_direction){c->ncolumn, d->column + at * n, low, high,
                                                      prior,      c->trials};
    at += c->ncolumn;
  }
  for (size_t b = 0, k = 0; b < state->nblock; b++)
    for (size_t p = 0; p < state->block[b].nfree; p++)
      d->nuisance_sigma[k++] = state->block[b].prior_sigma[p];
  UM_TRY(um_core_allocate(context, state->nparameter * n, sizeof(double), &d->nuisance_column));
  for (size_t k = 0; k < state->nparameter; k++) {
    memcpy(d->nuisance_column + k * n, state->fit->jacobian + k * n, n * sizeof(double));
    um_inference_noise_whiten(work->noise, d->nuisance_column + k * n);
  }
  d->nuisance =
      (struct um_inference_nuisance){state->nparameter, d->nuisance_column, d->nuisance_sigma};
  return UM_OK;
}

/* Residual with the parameters at the means of their priors. */
void um_diagnosis_residual_at_means(const struct um_diagnosis_work *work,
                                    const struct um_diagnosis_state *state, size_t n, double *out)
{
  const struct um_inference_fit *fit = state->fit;
  memcpy(out, fit->residual, n * sizeof *out);
  for (size_t b = 0, k = 0; b < state->nblock; b++)
    for (size_t p = 0; p < state->block[b].nfree; p++, k++) {
      double away = fit->x[k] - state->block[b].prior_mean[p];
      if (isinf(state->block[b].prior_sigma[p])) continue;
      for (size_t j = 0; j < n; j++) out[j] += fit->jacobian[k * n + j] * away;
    }
  um_inference_noise_whiten(work->noise, out);
}

bool um_diagnosis_is_same_effect(const struct um_sensitivity_candidate *a,
                                 const struct um_sensitivity_candidate *b)
{
  return a->effect == b->effect && um_core_words_same(a->target, b->target);
}

/* An effect on a target that is fitted already. */
bool um_diagnosis_is_taken(const struct um_diagnosis_state *state,
                           const struct um_sensitivity_candidate *c)
{
  for (size_t b = 0; b < state->nblock; b++)
    if (strcmp(state->block[b].addition.effect->name, c->effect->name) == 0 &&
        um_core_words_same(state->block[b].addition.target, c->target))
      return true;
  return false;
}
