/* Per observation of a channel the expected chi-square between two explanations is
 *
 *   (M1 - M2)^2 / (sigma^2 + sigma_model^2),
 *
 * as a diagnosis would weigh it: sigma is the measurement's own, that of observations of the
 * channel which were measured, else a usual one; sigma_model is the sampling error of the model at
 * the times that are planned (not that of those measured), 0 of temperatures. */
#include "evidence/diagnosis/apart_impl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/order.h"
#include "evidence/diagnosis/policy.h"

static bool is_of(const struct um_sensitivity_forward *f, size_t j, bool temperature,
                  const char *of)
{
  const struct um_compare_channel *c = &f->measurements->channel[f->observations.channel[j]];
  return (c->quantity == UM_QUANTITY_TEMPERATURE) == temperature && strcmp(c->of, of) == 0;
}

double um_diagnosis_sigma_of(const struct um_sensitivity_forward *f, bool temperature,
                             const char *of)
{
  double sum = 0.0, count = 0.0;
  for (size_t j = 0; j < f->observations.count; j++) {
    if (!is_of(f, j, temperature, of)) continue;
    double sigma = f->observations.stated_sigma[j];
    sum += temperature ? sigma : sigma / fmax(fabs(f->observations.measured[j]), sigma);
    count += 1.0;
  }
  if (count > 0.0) return sum / count;
  return temperature ? UM_DIAGNOSIS_USUAL_TEMPERATURE : UM_DIAGNOSIS_USUAL_RELATIVE;
}

enum um_status um_diagnosis_cadence_of(struct um_context *context,
                                       const struct um_sensitivity_forward *f, bool temperature,
                                       const char *of, double *out)
{
  const struct um_compare_measurements *m = f->measurements;
  size_t n = 0, before = UM_COMPARE_NOWHERE;
  double *gap = NULL;
  UM_TRY(um_core_allocate(context, f->observations.count, sizeof *gap, &gap));
  for (size_t j = 0; j < f->observations.count; j++) {
    if (!is_of(f, j, temperature, of)) continue;
    const struct um_compare_measurement *row = &m->row[f->observations.row[j]];
    const struct um_compare_measurement *last =
        before == UM_COMPARE_NOWHERE ? NULL : &m->row[f->observations.row[before]];
    if (last != NULL && last->channel == row->channel && last->track == row->track)
      gap[n++] = row->t_tai - last->t_tai;
    before = j;
  }
  qsort(gap, n, sizeof *gap, um_core_order_double);
  *out = n > 0 && gap[n / 2] > 0.0 ? gap[n / 2] : f->model->scenario->time->step_s;
  um_core_free(context, gap);
  return UM_OK;
}

struct um_diagnosis_band_noise
um_diagnosis_noise_of_band(const struct um_sensitivity_forward *forward,
                           const struct um_model_result *result, size_t band, const char *name)
{
  double peak = 0.0;
  for (size_t k = 0; k < result->nobs; k++)
    if (result->irradiance[k * result->nband + band] > peak)
      peak = result->irradiance[k * result->nband + band];
  return (struct um_diagnosis_band_noise){um_diagnosis_sigma_of(forward, false, name),
                                          UM_DIAGNOSIS_FAINT * peak};
}

double um_diagnosis_apart(const struct um_diagnosis_band_noise *noise,
                          const struct um_model_result *a, const struct um_model_result *b,
                          size_t band, size_t k, double *sigma)
{
  double ea = a->irradiance[k * a->nband + band], eb = b->irradiance[k * b->nband + band];
  double own = a->irradiance_error[k * a->nband + band];
  *sigma = hypot(noise->relative * ea, noise->floor);
  if (!(noise->floor > 0.0)) return NAN;
  return (ea - eb) * (ea - eb) / (*sigma * *sigma + own * own);
}
