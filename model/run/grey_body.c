/* Temperature and infrared cross-section of every observation of a run, as an infrared observer
 * concludes them (optics/instrument/grey_body.h): from the whole light of the thermal bands, what
 * they reflect counted as heat. */
#include "model/run/grey_body.h"

#include <math.h>
#include <string.h>

#include "model/build/bands.h"
#include "model/run/counts.h"

#define SHARE 0.01 /* error of a band that nothing is stated of, of its light */

/* Light of the thermal bands of one observation. */
struct spectrum {
  size_t nband;
  size_t *band;                      /* [nband] of the model */
  struct um_instrument_bins *bins;   /* [nband] */
  double *intensity, *sigma, *error; /* [nband] [W/sr] */
};

/* The scenario's entry of a quantity for a band, one that names it before one that names none. */
static const struct um_scenario_noise *entry(const struct um_model *model, int quantity, size_t b)
{
  const struct um_scenario_noise *found = NULL;
  const struct um_scenario_measurements *m = model->scenario->measurements;
  for (size_t i = 0; m != NULL && i < m->noise.count; i++) {
    const struct um_scenario_noise *n = (const struct um_scenario_noise *)m->noise.items + i;
    if (n->quantity != quantity) continue;
    if (n->of != NULL && strcmp(n->of, model->band[b].name) == 0) return n;
    if (n->of == NULL) found = n;
  }
  return found;
}

/* Stated error of a band's intensity [W/sr]; a floor of irradiance by the square of the range. */
static double stated(const struct um_model *model, size_t b, double intensity, double range)
{
  const struct um_scenario_noise *n = entry(model, UM_SCENARIO_RADIANT_INTENSITY, b);
  double scale = 1.0, sigma = 0.0;
  if (n == NULL) {
    n = entry(model, UM_SCENARIO_BAND_IRRADIANCE, b);
    scale = range * range;
  }
  if (n != NULL) sigma = hypot(n->relative * intensity, n->floor * scale);
  return sigma > 0.0 ? sigma : SHARE * fabs(intensity);
}

static enum um_status make_spectrum(struct um_context *context, const struct um_model *model,
                                    const struct um_model_result *r, struct spectrum *s)
{
  size_t n = um_model_thermal_bands(model);
  UM_TRY(um_core_allocate(context, n, sizeof *s->band, &s->band));
  UM_TRY(um_core_allocate(context, n, sizeof *s->bins, &s->bins));
  UM_TRY(um_core_allocate(context, 3 * n, sizeof *s->intensity, &s->intensity));
  s->sigma = s->intensity + n;
  s->error = s->sigma + n;
  for (size_t b = 0; b < model->nband; b++) {
    if (!um_model_band_is_thermal(&model->band[b])) continue;
    s->band[s->nband] = b;
    s->bins[s->nband++] = um_model_bins(r, b, NULL);
  }
  return UM_OK;
}

static void release(struct um_context *context, struct spectrum *s)
{
  UM_FREE(context, s->band, s->bins, s->intensity);
}

/* Intensities and their weights at observation k. */
static void take(const struct um_model *model, const struct um_model_tables *tables,
                 const struct um_model_result *r, size_t k, const struct spectrum *s)
{
  double range = tables->sample[k * tables->nsub + tables->nsub / 2].range;
  for (size_t i = 0; i < s->nband; i++) {
    size_t at = k * r->nband + s->band[i];
    s->intensity[i] = r->measured_intensity[at];
    s->error[i] = r->standard_error[at];
    s->sigma[i] = hypot(stated(model, s->band[i], s->intensity[i], range), s->error[i]);
  }
}

static enum um_status conclude(struct um_context *context, const struct um_model *model,
                               const struct um_model_tables *tables,
                               const struct um_model_result *r, size_t k, const struct spectrum *s,
                               struct um_model_grey_body *out)
{
  take(model, tables, r, k, s);
  out->temperature_error = out->area_error = NAN;
  UM_TRY(um_instrument_grey_body_try(context, s->bins, s->intensity, s->sigma, s->nband, 1,
                                     &out->one));
  if (out->one.n == 0) return UM_OK;
  um_instrument_grey_body_error(&out->one, s->bins, s->sigma, s->error, s->nband,
                                &out->temperature_error, &out->area_error);
  return um_instrument_grey_body_try(context, s->bins, s->intensity, s->sigma, s->nband, 2,
                                     &out->two);
}

enum um_status um_model_run_grey_bodies(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables,
                                        struct um_model_result *result)
{
  enum um_status status;
  struct spectrum s = {0};
  if (um_model_thermal_bands(model) < 3) return UM_OK;
  UM_CHECK(make_spectrum(context, model, result, &s));
  UM_CHECK(um_core_allocate(context, result->nobs, sizeof *result->grey_body, &result->grey_body));
  for (size_t k = 0; k < result->nobs; k++) {
    UM_CHECK(um_core_stop_check(context, "temperatures were concluded from the light"));
    UM_CHECK(conclude(context, model, tables, result, k, &s, &result->grey_body[k]));
  }
done:
  release(context, &s);
  return status;
}

enum um_status um_model_grey_body_error(struct um_context *context, const struct um_model *model,
                                        const struct um_model_tables *tables,
                                        const struct um_model_result *result, size_t k,
                                        const double *error, double *temperature, double *area)
{
  struct spectrum s = {0};
  *temperature = *area = NAN;
  if (result->grey_body == NULL || result->grey_body[k].one.n == 0) return UM_OK;
  enum um_status status = make_spectrum(context, model, result, &s);
  if (status == UM_OK) {
    take(model, tables, result, k, &s);
    for (size_t i = 0; i < s.nband; i++) s.error[i] = error[s.band[i]];
    um_instrument_grey_body_error(&result->grey_body[k].one, s.bins, s.sigma, s.error, s.nband,
                                  temperature, area);
  }
  release(context, &s);
  return status;
}
