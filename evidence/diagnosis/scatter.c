/* What is left, in the words of a user: how much more than their sigma observations scatter, how
 * large the model's own error is and along what it goes, which rows were set aside. */
#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/steps_impl.h"

/* Of one channel. discrepancy: [nobservation] over sigma. */
static void fill(const struct um_diagnosis_work *work, const struct um_inference_noise *noise,
                 const struct um_diagnosis *d, const double *discrepancy,
                 struct um_diagnosis_scatter *out)
{
  const struct um_sensitivity_observations *o = &work->forward->observations;
  double n = 0.0, sigmas = 0.0, unit = 0.0, level = 0.0, before = 0.0;
  for (size_t j = 0; j < o->count; j++) {
    if (o->channel[j] != out->channel) continue;
    double off = (o->measured[j] - d->value_before[j]) / o->sigma[j];
    n += 1.0;
    sigmas += discrepancy[j] * discrepancy[j];
    unit += discrepancy[j] * discrepancy[j] * o->sigma[j] * o->sigma[j];
    level += o->measured[j] * o->measured[j];
    before += off * off;
  }
  const struct um_inference_noise_channel *of = &noise->channel[out->channel];
  out->scale = of->scale;
  if (!(of->ratio > 0.0) || n == 0.0) return;
  out->along = noise->family->kind[of->kind]->name;
  out->sigmas = sqrt(sigmas / n);
  out->rms = sqrt(unit / n);
  out->share = sqrt(unit / level);
  out->of_before = sqrt(sigmas / before);
}

static bool is_large(const struct um_diagnosis *d, const struct um_diagnosis_scatter *s)
{
  if (s->scale > UM_DIAGNOSIS_LARGE_SCALE) return true;
  bool heat = d->forward->measurements->channel[s->channel].quantity == UM_QUANTITY_TEMPERATURE;
  return s->sigmas > UM_DIAGNOSIS_LARGE_SIGMAS && s->of_before > UM_DIAGNOSIS_LARGE_SHARE &&
         (heat ? s->rms > UM_DIAGNOSIS_LARGE_TEMPERATURE : s->share > UM_DIAGNOSIS_LARGE_LIGHT);
}

static bool is_aside(const struct um_diagnosis *d, size_t row)
{
  for (size_t i = 0; i < d->noutlier; i++)
    if (d->outlier[i] == row) return true;
  return false;
}

/* Whether rows of a channel that were set aside are no accidents: they are too many, or more of
 * them follow one another than by chance. A run of k begins at one of n rows by n (share)^k; two
 * together may be one accident (base/inference/noise.h). */
static bool are_outliers_many(const struct um_diagnosis *d, size_t channel)
{
  const struct um_compare_measurements *m = d->forward->measurements;
  size_t n = 0, run = 0, longest = 0;
  for (size_t r = 0; r < m->count; r++) {
    if (m->row[r].channel != channel) continue;
    bool aside = is_aside(d, r);
    n += aside;
    run = aside ? run + 1 : 0;
    if (run > longest) longest = run;
  }
  double count = (double)m->channel[channel].count, share = (double)n / count;
  return share > UM_DIAGNOSIS_LARGE_OUTLIERS ||
         (longest > 2 && count * pow(share, (double)longest) < UM_DIAGNOSIS_NOT_NOISE);
}

bool um_diagnosis_discrepancy_is_large(const struct um_diagnosis *d)
{
  for (size_t c = 0; d->noutlier > 0 && c < d->forward->measurements->nchannel; c++)
    if (are_outliers_many(d, c)) return true;
  for (size_t i = 0; i < d->nscatter; i++)
    if (is_large(d, &d->scatter[i])) return true;
  return false;
}

enum um_status um_diagnosis_scatter_describe(struct um_context *context,
                                             const struct um_diagnosis_work *work,
                                             const struct um_diagnosis_state *state,
                                             struct um_diagnosis *d)
{
  enum um_status status;
  struct um_inference_noise own = {0};
  double *discrepancy = NULL;
  if (work->noise == NULL) return UM_OK;
  const struct um_inference_noise_family *f = work->noise->family;
  UM_CHECK(um_inference_noise_estimate(context, f, state->fit->residual, work->noise, &own));
  UM_CHECK(um_core_allocate(context, f->nobservation, sizeof *discrepancy, &discrepancy));
  UM_CHECK(um_core_allocate(context, f->nchannel, sizeof *d->scatter, &d->scatter));
  UM_CHECK(um_core_allocate(context, own.noutlier, sizeof *d->outlier, &d->outlier));
  um_inference_noise_discrepancy(&own, state->fit->residual, discrepancy);
  for (size_t c = 0; c < f->nchannel; c++) {
    struct um_diagnosis_scatter *to = &d->scatter[d->nscatter];
    *to = (struct um_diagnosis_scatter){.channel = c};
    fill(work, &own, d, discrepancy, to);
    d->nscatter += to->scale >= UM_DIAGNOSIS_SCATTERS || to->along != NULL;
  }
  for (size_t j = 0; j < f->nobservation; j++)
    if (own.factor[j] > 1.0) d->outlier[d->noutlier++] = work->forward->observations.row[j];
done:
  um_core_free(context, discrepancy);
  um_inference_noise_release(context, &own);
  return status;
}
