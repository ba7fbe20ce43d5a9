/* Where the fit of an effect with parameters of shape begins. A thermostat that cycles makes
 * chi-square jagged, and a weak heater that is always on is a minimum of its own: so its power is
 * scanned upward from the straight line's, which is that of the always-on heater, and its
 * temperature around the one that its place has. */
#include <math.h>
#include <string.h>

#include "diagnosis/diagnose_impl.h"

static const double powers[] = {1.0, 1.5, 2.5, 4.0}; /* of the straight line's */
static const double temperatures[] = {0.0, -0.5};    /* from the candidate's [K] */

/* The amplitude that the residual of the state asks for in a straight line. */
static double straight(const struct um_diagnosis_work *work, const struct um_diagnosis_state *state,
                       const struct um_diagnosis_candidate *c)
{
  double dot = 0.0, square = 0.0;
  for (size_t j = 0; j < work->forward->nrow; j++) {
    double s = c->signature[j] / work->forward->sigma[j];
    dot += s * state->fit->residual[j];
    square += s * s;
  }
  return square > 0.0 ? dot / square : 0.0;
}

static double clamp(const struct um_effect_parameter *p, double value)
{
  return fmin(fmax(value, p->minimum), p->maximum);
}

static enum um_status chi2_at(struct um_context *context, const struct um_diagnosis_work *work,
                              const struct um_diagnosis_state *state,
                              struct um_diagnosis_addition *all, double *value, double *out)
{
  const struct um_diagnosis_forward *f = work->forward;
  um_diagnosis_state_additions(state, all);
  enum um_status status =
      um_diagnosis_forward_evaluate(context, work->forward, all, state->nblock, value);
  *out = 0.0;
  if (status == UM_ERR_INPUT || status == UM_ERR_NUMERIC) { /* no place to begin */
    um_core_message_clear(context);
    *out = INFINITY;
    return UM_OK;
  }
  for (size_t j = 0; j < f->nrow && status == UM_OK; j++)
    *out += pow((f->measured[j] - value[j]) / f->sigma[j], 2);
  return status;
}

enum um_status um_diagnosis_start(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_diagnosis_state *before,
                                  struct um_diagnosis_state *state, size_t b)
{
  enum um_status status;
  const struct um_diagnosis_candidate *c = &work->candidates->candidate[state->block[b].candidate];
  const struct um_effect_parameter *parameters = c->effect->parameters;
  double *best = state->block[b].addition.value, found[UM_EFFECT_PARAMETERS_MAX];
  double amplitude = straight(work, before, c), lowest = INFINITY, chi2;
  struct um_diagnosis_addition *all = NULL;
  double *value = NULL;
  UM_CHECK(um_core_allocate(context, state->nblock, sizeof *all, &all));
  UM_CHECK(um_core_allocate(context, work->forward->nrow, sizeof *value, &value));
  memcpy(found, best, sizeof found);
  for (size_t i = 0; i < sizeof powers / sizeof powers[0]; i++)
    for (size_t k = 0; k < sizeof temperatures / sizeof temperatures[0]; k++) {
      size_t p = c->parameter[0];
      best[p] = clamp(&parameters[p], c->null_value[p] + powers[i] * amplitude);
      for (size_t s = 0; s < c->nshape; s++)
        if (parameters[c->shape[s]].is_temperature)
          best[c->shape[s]] =
              clamp(&parameters[c->shape[s]], c->null_value[c->shape[s]] + temperatures[k]);
      UM_CHECK(chi2_at(context, work, state, all, value, &chi2));
      if (!(chi2 < lowest)) continue;
      lowest = chi2;
      memcpy(found, best, sizeof found);
    }
  memcpy(best, found, sizeof found);
done:
  um_core_free(context, value);
  um_core_free(context, all);
  return status;
}
