/* Names of verdicts and classes, and the memory of a diagnosis. */
#include "evidence/diagnosis/diagnosis_impl.h"

const char *um_diagnosis_verdict_name(enum um_diagnosis_verdict verdict)
{
  static const char *const name[] = {"complete", "found", "not_identifiable", "unexplained"};
  return name[verdict];
}

const char *um_diagnosis_confidence_name(enum um_diagnosis_confidence confidence)
{
  static const char *const name[] = {"certain", "one_of_group", "small", "uncertain"};
  return name[confidence];
}

const struct um_diagnosis_step *um_diagnosis_step_of(const struct um_diagnosis *d,
                                                     const struct um_model_addition *addition)
{
  for (size_t s = 0; s < d->nstep; s++)
    if (!d->step[s].removed && d->step[s].addition.effect == addition->effect &&
        d->step[s].addition.target == addition->target)
      return &d->step[s];
  return NULL;
}

void um_diagnosis_steps_clear(struct um_context *context, struct um_diagnosis *d)
{
  for (size_t s = 0; s < d->nstep; s++) {
    UM_FREE(context, d->step[s].alternative, d->step[s].value);
  }
  d->nstep = 0;
}

void um_diagnosis_end_clear(struct um_context *context, struct um_diagnosis *d)
{
  UM_FREE(context, d->addition, d->addition_sigma, d->nuisance, d->nuisance_sigma, d->value_after);
  d->addition = d->nuisance = NULL;
  d->addition_sigma = d->nuisance_sigma = NULL;
  d->value_after = NULL;
  d->naddition = d->nnuisance = 0;
}

void um_diagnosis_next_clear(struct um_context *context, struct um_diagnosis *d)
{
  for (size_t i = 0; i < d->nnext; i++) {
    UM_FREE(context, d->next_of[i].what, d->next_of[i].of, d->next_of[i].pass);
  }
  um_core_free(context, d->next_of);
  d->next_of = d->next = NULL;
  d->nnext = 0;
}

void um_diagnosis_destroy(struct um_context *context, struct um_diagnosis **diagnosis)
{
  if (diagnosis == NULL || *diagnosis == NULL) return;
  struct um_diagnosis *d = *diagnosis;
  um_diagnosis_steps_clear(context, d);
  um_diagnosis_end_clear(context, d);
  UM_FREE(context, d->summary, d->step, d->value_before, d->ranking);
  um_diagnosis_next_clear(context, d);
  um_missing_heat_residual_release(context, &d->residual);
  UM_FREE(context, d->superseded, d->missed, d->scatter, d->outlier);
  um_missing_heat_unexplained_destroy(context, &d->unexplained);
  um_diagnosis_posterior_destroy(context, &d->posterior);
  UM_FREE(context, d->fitted, d->tie);
  um_missing_heat_unexplained_destroy(context, &d->heat_asked);
  um_core_free(context, d);
  *diagnosis = NULL;
}
