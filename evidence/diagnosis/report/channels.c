/* Observations and metrics of a diagnosis by channel. */
#include "evidence/diagnosis/report/channels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "evidence/comparison/metrics.h"

const struct um_compare_channel *um_diagnosis_report_channel(const struct um_diagnosis *diagnosis,
                                                             size_t c)
{
  return &diagnosis->forward->measurements->channel[c];
}

struct timed {
  double t; /* [s] */
  size_t row;
};

static int by_time(const void *a, const void *b)
{
  const struct timed *x = a, *y = b;
  if (x->t != y->t) return x->t < y->t ? -1 : 1;
  return x->row < y->row ? -1 : x->row > y->row;
}

enum um_status um_diagnosis_report_channel_rows(struct um_context *context,
                                                const struct um_diagnosis *diagnosis, size_t c,
                                                size_t **out, size_t *count)
{
  const struct um_sensitivity_forward *f = diagnosis->forward;
  struct timed *timed = NULL;
  *out = NULL;
  *count = 0;
  UM_TRY(um_core_allocate(context, f->observations.count, sizeof *timed, &timed));
  for (size_t i = 0; i < f->observations.count; i++)
    if (f->observations.channel[i] == c)
      timed[(*count)++] = (struct timed){f->observations.t[i], i};
  qsort(timed, *count, sizeof *timed, by_time);
  enum um_status status = um_core_allocate(context, *count, sizeof **out, out);
  for (size_t i = 0; status == UM_OK && i < *count; i++) (*out)[i] = timed[i].row;
  um_core_free(context, timed);
  return status;
}

enum um_status um_diagnosis_report_channel_metrics(struct um_context *context,
                                                   const struct um_diagnosis *diagnosis, size_t c,
                                                   const double *value, double dof,
                                                   struct um_compare_metrics *out)
{
  const struct um_sensitivity_forward *f = diagnosis->forward;
  enum um_compare_quantity quantity = um_diagnosis_report_channel(diagnosis, c)->quantity;
  enum um_status status;
  size_t *row = NULL, n;
  struct um_compare_residual *residual = NULL;
  UM_CHECK(um_diagnosis_report_channel_rows(context, diagnosis, c, &row, &n));
  UM_CHECK(um_core_allocate(context, n, sizeof *residual, &residual));
  for (size_t i = 0; i < n; i++)
    residual[i] = (struct um_compare_residual){f->observations.measured[row[i]], value[row[i]],
                                               f->observations.stated_sigma[row[i]],
                                               f->observations.model_sigma[row[i]]};
  /* without figures in magnitudes */
  if (um_compare_is_magnitude(quantity)) quantity = UM_QUANTITY_RADIANT_INTENSITY;
  double fitted = ((double)f->observations.count - dof) * (double)n / (double)f->observations.count;
  UM_CHECK(um_compare_metrics_compute(context, quantity, n, residual, NULL, 0, fmax(fitted, 0.0),
                                      NULL, out));
done:
  UM_FREE(context, row, residual);
  return status;
}

double um_diagnosis_report_in_unit(enum um_compare_quantity quantity, double linear)
{
  if (!um_compare_is_magnitude(quantity)) return linear;
  return linear > 0.0 ? -2.5 * log10(linear) : (double)NAN;
}

const struct um_sensitivity_candidate *
um_diagnosis_report_candidate_of(const struct um_diagnosis *diagnosis,
                                 const struct um_diagnosis_alternative *alternative)
{
  return &diagnosis->candidates->candidate[alternative->candidate];
}

void um_diagnosis_report_estimate(const struct um_sensitivity_candidate *candidate,
                                  const struct um_inference_score *score, size_t k, double *value,
                                  double *sigma)
{
  size_t p = candidate->parameter[k];
  const struct um_effect_parameter *parameter = &candidate->effect->parameters[p];
  double transformed =
      um_effect_transformed(parameter, candidate->null_value[p]) + score->estimate[k];
  *value = um_effect_physical(parameter, transformed);
  *sigma = score->sigma[k] * um_effect_transformed_slope(parameter, *value);
}

const double *um_diagnosis_report_step_values(const struct um_diagnosis *diagnosis,
                                              const struct um_diagnosis_step *step)
{
  if (step->value != NULL) return step->value;
  bool last = step == &diagnosis->step[diagnosis->nstep - 1];
  return last && !step->removed ? diagnosis->value_after : NULL;
}
