/* A thermostat whose cycle cannot be seen. Held by a strong heater its place moves within the band;
 * where even that leaves no trace beside the signature of constant power, as inside a wrapped body,
 * the temperatures at which it switches say nothing. It is fitted as what it is, constant power: on
 * all the time, its power the only number that is free. BIC counts the others all the same:
 * constant power is the simpler one. */
#include <math.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

#define STRONG 10.0 /* power that shows the cycle [of what the linear model wants] */

/* Whether it switches by the temperature of its place. */
static bool is_thermostat(const struct um_sensitivity_candidate *c)
{
  for (size_t s = 0; s < c->nunidentified; s++)
    if (c->effect->parameters[c->unidentified[s]].is_temperature) return true;
  return false;
}

void um_diagnosis_always_on(const struct um_sensitivity_candidate *c, double *value)
{
  size_t phase = um_diagnosis_phase_of(c->effect);
  for (size_t s = 0; s < c->nunidentified; s++)
    if (c->effect->parameters[c->unidentified[s]].is_temperature)
      value[c->unidentified[s]] = c->maximum[c->unidentified[s]];
  if (phase < c->effect->nparameter) value[phase] = c->null_value[phase];
}

void um_diagnosis_hold_on(const struct um_diagnosis_work *work, struct um_diagnosis_state *state,
                          size_t b)
{
  struct um_diagnosis_block *block = &state->block[b];
  const struct um_sensitivity_candidate *c = &work->candidates->candidate[block->candidate];
  um_diagnosis_always_on(c, block->addition.value);
  state->nparameter -= block->nfree - c->ncolumn;
  block->nheld = block->nfree - c->ncolumn;
  block->nfree = c->ncolumn;
}

bool um_diagnosis_is_held_on(const struct um_sensitivity_candidate *c,
                             const struct um_model_addition *addition)
{
  bool held = is_thermostat(c);
  for (size_t s = 0; s < c->nunidentified; s++) {
    size_t p = c->unidentified[s];
    if (c->effect->parameters[p].is_temperature) held = held && addition->value[p] >= c->maximum[p];
  }
  return held;
}

/* What the heater changes, along the signature of constant power and beside it, as chi-square. */
static void split(const struct um_diagnosis_work *work, const struct um_diagnosis_state *before,
                  const double *signature, const double *value, double *along, double *beside)
{
  double dot = 0.0, square = 0.0, all = 0.0;
  for (size_t j = 0; j < work->forward->observations.count; j++) {
    double sigma = work->forward->observations.sigma[j];
    double moved = (value[j] - before->fit->value[j]) / sigma, by = signature[j] / sigma;
    dot += moved * by;
    square += by * by;
    all += moved * moved;
  }
  *along = square > 0.0 ? dot * dot / square : 0.0;
  *beside = all - *along;
}

enum um_status um_diagnosis_cycle_is_seen(struct um_context *context,
                                          const struct um_diagnosis_work *work,
                                          const struct um_diagnosis_state *before,
                                          const struct um_diagnosis_state *state, size_t b,
                                          bool *out)
{
  enum um_status status;
  const struct um_sensitivity_candidate *c =
      &work->candidates->candidate[state->block[b].candidate];
  size_t p = c->parameter[0];
  double amplitude = um_diagnosis_linear_amplitude(work, before, c), along, beside;
  struct um_model_addition *all = NULL;
  double *value = NULL;
  *out = true;
  if (!is_thermostat(c)) return UM_OK; /* other shapes do not hide behind an amplitude */
  UM_CHECK(um_core_allocate(context, state->nblock, sizeof *all, &all));
  UM_CHECK(um_core_allocate(context, work->forward->observations.count, sizeof *value, &value));
  um_diagnosis_state_additions(state, all);
  all[b].value[p] = fmin(fmax(c->null_value[p] + STRONG * amplitude, c->minimum[p]), c->maximum[p]);
  UM_CHECK(um_sensitivity_forward_evaluate(context, work->forward, all, state->nblock, value));
  split(work, before, c->signature, value, &along, &beside);
  *out = !(beside < UM_DIAGNOSIS_SETTLED && along > UM_DIAGNOSIS_SETTLED);
done:
  UM_FREE(context, value, all);
  if (status != UM_ERR_REFUSED && status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(context);
  return UM_OK;
}
