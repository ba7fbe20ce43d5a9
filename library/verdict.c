/* The verdict of a diagnosis or fit, as structure. */
#include <math.h>

#include "library/diagnosis_impl.h"

#define SAME(ours, theirs)                                                                         \
  _Static_assert((int)UMBRA_##ours == (int)UM_##theirs, "a number of its own: " #ours)
SAME(COMPLETE, VERDICT_COMPLETE);
SAME(FOUND, VERDICT_FOUND);
SAME(NOT_IDENTIFIABLE, VERDICT_NOT_IDENTIFIABLE);
SAME(UNEXPLAINED, VERDICT_UNEXPLAINED);
SAME(CERTAIN, CONFIDENCE_CERTAIN);
SAME(ONE_OF_GROUP, CONFIDENCE_ONE_OF_GROUP);
SAME(SMALL, CONFIDENCE_SMALL);
SAME(UNCERTAIN, CONFIDENCE_UNCERTAIN);

static enum um_status estimates(struct um_context *context, struct um_core_arena *memory,
                                const struct um_effect *effect, const double *value,
                                const double *sigma, const struct umbra_estimate **out)
{
  struct umbra_estimate *list;
  UM_TRY(um_core_arena_allocate(context, memory, effect->nparameter, sizeof *list, &list));
  for (size_t p = 0; p < effect->nparameter; p++) {
    const struct um_effect_parameter *of = &effect->parameters[p];
    list[p] = (struct umbra_estimate){of->name, of->unit, value[p], sigma[p], of->null_value};
  }
  *out = list;
  return UM_OK;
}

/* [0] of a step's alternatives is what was found itself. */
static enum um_status alternatives(struct um_context *context, struct um_library_diagnosis *work,
                                   const struct um_diagnosis_step *step, struct umbra_finding *to)
{
  struct umbra_alternative *list;
  size_t n = step->nalternative > 0 ? step->nalternative - 1 : 0;
  UM_TRY(um_core_arena_allocate(context, &work->memory, n, sizeof *list, &list));
  for (size_t i = 0; i < n; i++) {
    const struct um_diagnosis_alternative *from = &step->alternative[i + 1];
    const struct um_sensitivity_candidate *candidate =
        &work->diagnosis->candidates->candidate[from->candidate];
    list[i] = (struct umbra_alternative){
        .effect = candidate->effect->name,
        .target = candidate->target,
        .off = candidate->off,
        .fitted = from->fitted,
        .tied = from->indistinguishable,
        .implausible = from->implausible,
        .delta_bic = from->fitted ? from->bic - step->alternative[0].bic : (double)NAN};
    if (!from->fitted) continue;
    list[i].nestimate = candidate->effect->nparameter;
    UM_TRY(estimates(context, &work->memory, candidate->effect, from->value, from->sigma,
                     &list[i].estimate));
  }
  to->alternative = list;
  to->nalternative = n;
  return UM_OK;
}

/* step NULL: it was chosen. */
static enum um_status finding(struct um_context *context, struct um_library_diagnosis *work,
                              const struct um_model_addition *addition, const double *sigma,
                              const struct um_diagnosis_step *step, struct umbra_finding *to)
{
  *to = (struct umbra_finding){.effect = addition->effect->name,
                               .target = addition->target,
                               .off = addition->off,
                               .confidence = UMBRA_CHOSEN,
                               .p_value = NAN,
                               .delta_bic = NAN,
                               .nestimate = addition->effect->nparameter};
  UM_TRY(
      estimates(context, &work->memory, addition->effect, addition->value, sigma, &to->estimate));
  if (step == NULL) return UM_OK;
  to->confidence = (enum umbra_confidence)step->confidence;
  to->p_value = step->p_value;
  to->delta_bic = step->delta_bic;
  return alternatives(context, work, step, to);
}

/* Without candidates it is a fit, of what the caller said. */
static enum um_status list_findings(struct um_context *context, struct um_library_diagnosis *work,
                                    const struct umbra_finding **out)
{
  const struct um_diagnosis *d = work->diagnosis;
  struct umbra_finding *list;
  UM_TRY(um_core_arena_allocate(context, &work->memory, d->naddition, sizeof *list, &list));
  for (size_t i = 0; i < d->naddition; i++)
    UM_TRY(finding(context, work, &d->addition[i], d->addition_sigma[i],
                   work->candidates == NULL ? NULL : um_diagnosis_step_of(d, &d->addition[i]),
                   &list[i]));
  *out = list;
  return UM_OK;
}

static enum um_status list_nuisances(struct um_context *context, struct um_library_diagnosis *work,
                                     const struct umbra_finding **out)
{
  const struct um_diagnosis *d = work->diagnosis;
  struct umbra_finding *list;
  UM_TRY(um_core_arena_allocate(context, &work->memory, d->nnuisance, sizeof *list, &list));
  for (size_t i = 0; i < d->nnuisance; i++)
    UM_TRY(finding(context, work, &d->nuisance[i], d->nuisance_sigma[i], NULL, &list[i]));
  *out = list;
  return UM_OK;
}

/* Of a diagnosis: probabilities of what is missing, and of which half is wrong. */
static enum um_status list_probabilities(struct um_context *context,
                                         struct um_library_diagnosis *work,
                                         struct umbra_verdict *to)
{
  const struct um_diagnosis *d = work->diagnosis;
  struct umbra_half *half;
  if (work->candidates == NULL) return UM_OK;
  UM_TRY(um_core_arena_allocate(context, &work->memory, UM_HALVES, sizeof *half, &half));
  for (size_t h = 0; h < UM_HALVES; h++)
    half[h] = (struct umbra_half){um_effects_half_name((enum um_effects_half)h), d->half[h]};
  to->half = half;
  to->nhalf = UM_HALVES;
  to->probability_nothing = d->probability.nothing;
  to->probability_one = d->probability.one;
  to->probability_several = d->probability.several;
  to->probability_none = d->probability.none;
  return UM_OK;
}

enum um_status um_library_verdict(struct um_context *context, struct um_library_diagnosis *work)
{
  const struct um_diagnosis *d = work->diagnosis;
  work->verdict = (struct umbra_verdict){.kind = (enum umbra_verdict_kind)d->verdict,
                                         .sentence = d->summary,
                                         .chi2_before = d->chi2,
                                         .dof_before = d->dof,
                                         .chi2_after = d->chi2_after,
                                         .dof_after = d->dof_after,
                                         .nfinding = d->naddition,
                                         .nnuisance = d->nnuisance,
                                         .probability_nothing = NAN,
                                         .probability_one = NAN,
                                         .probability_several = NAN,
                                         .probability_none = NAN,
                                         .next = d->next == NULL ? NULL : d->next->what};
  UM_TRY(list_probabilities(context, work, &work->verdict));
  UM_TRY(list_findings(context, work, &work->verdict.finding));
  return list_nuisances(context, work, &work->verdict.nuisance);
}
