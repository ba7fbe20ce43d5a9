/* What is uncertain anyway: calibration, clocks, properties with a stated width. */
#include "evidence/diagnosis/steps_impl.h"

#include <math.h>
#include <string.h>

#include "evidence/sensitivity/stated.h"

enum um_status um_diagnosis_block_wanted(struct um_context *context,
                                         const struct um_diagnosis_work *work,
                                         const struct um_model_addition *wanted, double sigma,
                                         struct um_diagnosis_block *out)
{
  const struct um_effect *effect = wanted->effect;
  double present[UM_EFFECT_PARAMETERS_MAX];
  if (effect->nparameter == 0 && !effect->on_by_default)
    return um_core_fail(context, UM_ERR_INPUT, "effect '%s' has nothing to fit", effect->name);
  um_sensitivity_forward_null(work->forward, effect, wanted->target, present);
  *out = (struct um_diagnosis_block){
      .addition = *wanted,
      .candidate = UM_COMPARE_NOWHERE,
      .nfree = effect->on_by_default ? 0 : um_effect_fitted(effect)}; /* a switch is on, or not */
  for (size_t p = 0; p < out->nfree; p++) {
    const struct um_effect_parameter *of = &effect->parameters[p];
    double width = isfinite(sigma) ? sigma : of->prior_sigma;
    out->parameter[p] = p;
    double away =
        um_effect_transformed(of, of->default_value) - um_effect_transformed(of, of->null_value);
    out->prior_mean[p] = um_effect_transformed(of, present[p]);
    out->prior_sigma[p] = width;
    out->step[p] = isfinite(width) ? UM_SENSITIVITY_SHARE_OF_PRIOR * width : fabs(away);
    um_sensitivity_stated_range(work->forward, effect, wanted->target, p, present[p],
                                &out->minimum[p], &out->maximum[p]);
    /* a start outside the range that the scenario leaves */
    out->addition.value[p] = fmin(fmax(wanted->value[p], out->minimum[p]), out->maximum[p]);
    if (!(out->step[p] > 0.0)) out->step[p] = 1e-3 * (of->maximum - of->minimum);
  }
  return UM_OK;
}

enum um_status um_diagnosis_nuisance_check(struct um_context *context,
                                           const struct um_diagnosis_nuisance_effect *nuisance)
{
  if (nuisance->per == NULL || strcmp(nuisance->per, "set") == 0 ||
      strcmp(nuisance->per, "all") == 0)
    return UM_OK;
  return um_core_fail(
      context, UM_ERR_INPUT,
      "nuisance '%s' per '%.40s': an effect that is free at each observation fits any "
      "measurement; accepted: per set, per all",
      nuisance->effect->name, nuisance->per);
}

enum um_status um_diagnosis_nuisances(struct um_context *context,
                                      const struct um_diagnosis_work *work,
                                      struct um_diagnosis_state *state)
{
  const struct um_diagnosis_options *options = work->options;
  for (size_t i = 0; i < options->nnuisance; i++) {
    const struct um_diagnosis_nuisance_effect *n = &options->nuisance[i];
    struct um_model_addition use = {.effect = n->effect, .target = n->target};
    struct um_diagnosis_block block;
    UM_TRY(um_diagnosis_nuisance_check(context, n));
    um_sensitivity_forward_null(work->forward, n->effect, n->target, use.value);
    UM_TRY(um_diagnosis_block_wanted(context, work, &use, n->sigma, &block));
    /* free means free: no width of the effect's own */
    for (size_t p = 0; p < block.nfree; p++) block.prior_sigma[p] = n->sigma;
    UM_TRY(um_diagnosis_state_append(context, state, &block));
    state->nnuisance++;
  }
  return UM_OK;
}
