/* Explanations that are one. A thermostat that stays on through all rows is constant power there:
 * whatever constant power explains, such a heater does, and by n alone its two temperatures would
 * put it within the evidence or not. So where the winner of a step is a heater that never switches,
 * and switching explains no more by BIC, the heater is the winner by another name. That it is the
 * same is known by what it does, with the winner's number for its power and out of reach of the
 * temperature at which it would switch off. */
#include <math.h>
#include <string.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

/* Observations [n] with a candidate at these values beside the blocks of the state. */
static enum um_status values_with(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_diagnosis_state *state, size_t candidate,
                                  const double *at, double *value)
{
  const struct um_sensitivity_candidate *c = &work->candidates->candidate[candidate];
  struct um_model_addition *all = NULL;
  UM_TRY(um_core_allocate(context, state->nblock + 1, sizeof *all, &all));
  um_diagnosis_state_additions(state, all);
  all[state->nblock] =
      (struct um_model_addition){.effect = c->effect, .target = c->target, .off = c->off};
  memcpy(all[state->nblock].value, at, c->effect->nparameter * sizeof *at);
  enum um_status status =
      um_sensitivity_forward_evaluate(context, work->forward, all, state->nblock + 1, value);
  um_core_free(context, all);
  return status;
}

/* Whether the only number of `plain` is of the same name and unit as the first of `shaped`. */
static bool is_same_amplitude(const struct um_sensitivity_candidate *plain,
                              const struct um_sensitivity_candidate *shaped)
{
  if (plain->ncolumn != 1 || plain->nunidentified > 0 || !um_diagnosis_is_rough(shaped))
    return false;
  const struct um_effect_parameter *a = &plain->effect->parameters[plain->parameter[0]],
                                   *b = &shaped->effect->parameters[shaped->parameter[0]];
  return strcmp(a->name, b->name) == 0 && strcmp(a->unit, b->unit) == 0;
}

/* Values of the shaped candidate that is on all the time, with the winner's amplitude. */
static void put_always_on(const struct um_sensitivity_candidate *shaped,
                          const struct um_diagnosis_alternative *r, double amplitude, double *at)
{
  memcpy(at, r->value, sizeof r->value);
  at[shaped->parameter[0]] = shaped->null_value[shaped->parameter[0]] + amplitude;
  um_diagnosis_always_on(shaped, at);
}

enum um_status um_diagnosis_contains_winner(struct um_context *context,
                                            const struct um_diagnosis_work *work,
                                            const struct um_diagnosis_state *state,
                                            const struct um_diagnosis_alternative *winner,
                                            const struct um_diagnosis_alternative *r, bool *out)
{
  enum um_status status;
  const struct um_sensitivity_candidate *plain = &work->candidates->candidate[winner->candidate],
                                        *shaped = &work->candidates->candidate[r->candidate];
  size_t n = work->forward->observations.count;
  double *with = NULL, *other = NULL, at[UM_EFFECT_PARAMETERS_MAX], square = 0.0;
  *out = false;
  if (!r->fitted || r->bic < winner->bic || !is_same_amplitude(plain, shaped)) return UM_OK;
  put_always_on(shaped, r,
                winner->value[plain->parameter[0]] - plain->null_value[plain->parameter[0]], at);
  UM_CHECK(um_core_allocate(context, n, sizeof *with, &with));
  UM_CHECK(um_core_allocate(context, n, sizeof *other, &other));
  UM_CHECK(values_with(context, work, state, r->candidate, at, with));
  UM_CHECK(values_with(context, work, state, winner->candidate, winner->value, other));
  for (size_t j = 0; j < n; j++)
    square += pow((with[j] - other[j]) / work->forward->observations.sigma[j], 2);
  *out = square < UM_DIAGNOSIS_SETTLED;
done:
  UM_FREE(context, other, with);
  if (status != UM_ERR_REFUSED && status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(context);
  return UM_OK;
}
