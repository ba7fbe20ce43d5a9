/* What a unit of corrected light does to each observation. Corrections act on what comes of the
 * light at the end, as a user's effect does:
 *
 *   a factor f on the light of a material of share w    dV = f w V,
 *   an intensity I of the satellite                     dV = c I / R^2,
 *   an irradiance E                                     dV = c E,
 *
 * c from irradiance to what is measured: 1, R^2 of an intensity, and of magnitudes and counts
 * the median of V R^2 / I over the channel. */
#include "evidence/missing_light/observations_impl.h"

#include <math.h>

#include "base/core/sort.h"
#include "base/inference/algebra.h"
#include "model/run/effect_view.h"

#define THERMAL 2.5e-6 /* [m] shorter light is reflected, longer is emitted */

static bool is_light(const struct um_sensitivity_forward *f, size_t j)
{
  enum um_compare_quantity q = f->measurements->channel[f->observations.channel[j]].quantity;
  return q != UM_QUANTITY_TEMPERATURE && !um_compare_is_grey_body(q);
}

/* Number of a band among those that are measured; it joins them where it is new. */
static size_t band_number(struct um_missing_light_observations *o,
                          const struct um_optics_band *band)
{
  for (size_t b = 0; b < o->nband; b++)
    if (strcmp(o->band[b], band->name) == 0) return b;
  o->band[o->nband] = band->name;
  o->thermal[o->nband] = band->from > THERMAL;
  return o->nband++;
}

static int ascending(const void *a, const void *b)
{
  const double *x = a, *y = b;
  return (*x > *y) - (*x < *y);
}

/* From irradiance to the values of a channel: the median over its observations; NAN: nothing shone.
 * scratch: [nobservation]. */
static enum um_status median_of(struct um_context *context, const struct um_sensitivity_forward *f,
                                const struct um_missing_light_observations *o, size_t channel,
                                const double *value, double *scratch, double *out)
{
  size_t n = 0, band = um_compare_band(f->plan, f->model, channel);
  for (size_t j = 0; j < o->nobservation; j++) {
    if (f->observations.channel[j] != channel) continue;
    size_t k = f->plan->observation[f->observations.row[j]];
    const struct um_model_tables *tables = o->run.variant.tables;
    double range = tables->sample[k * tables->nsub + tables->nsub / 2].range;
    double light = um_model_result_intensity(o->run.result, k, band, -1) / (range * range);
    if (light > 0.0 && isfinite(value[j])) scratch[n++] = value[j] / light;
  }
  UM_TRY(um_core_sort(context, scratch, n, sizeof *scratch, ascending));
  *out = n > 0 ? scratch[n / 2] : (double)NAN;
  return UM_OK;
}

static double from_irradiance(enum um_compare_quantity quantity, double range, double median)
{
  if (quantity == UM_QUANTITY_BAND_IRRADIANCE) return 1.0;
  if (quantity == UM_QUANTITY_RADIANT_INTENSITY) return range * range;
  return isnan(median) ? 0.0 : median;
}

static void fill_one(struct um_missing_light_observations *o,
                     const struct um_sensitivity_forward *f, size_t j, size_t channel,
                     double median, const double *value)
{
  size_t k = f->plan->observation[f->observations.row[j]], n = o->nobservation;
  size_t band = um_compare_band(f->plan, f->model, channel);
  const struct um_effect_view view =
      um_model_effect_view(o->run.variant.tables, o->run.result, o->material, k, band);
  double sigma = f->observations.sigma[j];
  double c = from_irradiance(f->measurements->channel[channel].quantity, view.range, median);
  o->of[j] = band_number(o, &f->model->band[band]);
  for (size_t m = 0; m < o->nmaterial; m++)
    o->unit[m * n + j] = um_effect_share(&view, o->material[m]) * value[j] / sigma;
  o->unit[o->nmaterial * n + j] = value[j] / sigma;
  o->unit[(o->nmaterial + 1) * n + j] = c / (view.range * view.range) / sigma;
  o->unit[(o->nmaterial + 2) * n + j] = c / sigma;
  for (size_t i = 0; i < UM_COORDINATES; i++)
    o->coordinate[i * n + j] = um_effect_coordinate_at((enum um_effect_coordinate)i,
                                                       o->run.variant.tables->t_obs[k], &view);
}

static enum um_status fill(struct um_context *context, const struct um_sensitivity_forward *f,
                           const double *value, struct um_missing_light_observations *o)
{
  enum um_status status = UM_OK;
  size_t n = o->nobservation;
  double *scratch = NULL, *median = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *scratch, &scratch));
  UM_CHECK(um_core_allocate(context, f->measurements->nchannel, sizeof *median, &median));
  for (size_t c = 0; c < f->measurements->nchannel; c++) median[c] = INFINITY; /* not yet */
  for (size_t j = 0; j < n; j++) {
    size_t channel = f->observations.channel[j];
    o->of[j] = SIZE_MAX;
    for (size_t i = 0; i < UM_COORDINATES; i++) o->coordinate[i * n + j] = NAN;
    if (!is_light(f, j)) continue;
    if (isinf(median[channel]))
      UM_CHECK(median_of(context, f, o, channel, value, scratch, &median[channel]));
    fill_one(o, f, j, channel, median[channel], value);
  }
done:
  UM_FREE(context, scratch, median);
  return status;
}

static enum um_status project(struct um_context *context, const struct um_sensitivity_forward *f,
                              const double *value, const double *nuisance, size_t nnuisance,
                              struct um_missing_light_observations *o)
{
  enum um_status status;
  double *whole = NULL, *width = NULL;
  UM_CHECK(um_core_allocate(context, o->nobservation, sizeof *whole, &whole));
  UM_CHECK(um_core_allocate(context, nnuisance, sizeof *width, &width));
  for (size_t i = 0; i < nnuisance; i++) width[i] = INFINITY;
  for (size_t j = 0; j < o->nobservation; j++)
    whole[j] = (f->observations.measured[j] - value[j]) / f->observations.sigma[j];
  const struct um_inference_nuisance free = {nnuisance, nuisance, width};
  UM_CHECK(um_inference_projection_create(context, o->nobservation, &free, &o->projection));
  o->nleft = o->projection.nleft;
  UM_CHECK(um_core_allocate(context, o->nleft, sizeof *o->residual, &o->residual));
  um_inference_projection_apply(&o->projection, whole, o->residual);
  o->square = um_inference_dot(o->nleft, o->residual, o->residual);
done:
  UM_FREE(context, whole, width);
  return status;
}

enum um_status um_missing_light_observations_create(struct um_context *context,
                                                    struct um_sensitivity_forward *forward,
                                                    const struct um_model_addition *addition,
                                                    size_t naddition, const double *value,
                                                    const double *nuisance, size_t nnuisance,
                                                    struct um_missing_light_observations *out)
{
  struct um_missing_light_observations *o = out;
  size_t n = forward->observations.count;
  bool light = false;
  *o = (struct um_missing_light_observations){.nobservation = n};
  UM_TRY(project(context, forward, value, nuisance, nnuisance, o));
  for (size_t j = 0; j < n; j++) light = light || is_light(forward, j);
  if (!light) return UM_OK;
  UM_TRY(um_sensitivity_forward_run(context, forward, addition, naddition, NULL, &o->run));
  forward->evaluations++;
  UM_TRY(um_model_material_names(context, forward->model, &o->material));
  o->nmaterial = o->run.result->nmaterial;
  UM_TRY(um_core_allocate(context, n, sizeof *o->of, &o->of));
  UM_TRY(um_core_allocate(context, forward->model->nband, sizeof *o->band, (void *)&o->band));
  UM_TRY(um_core_allocate(context, forward->model->nband, sizeof *o->thermal, &o->thermal));
  UM_TRY(um_core_allocate(context, (o->nmaterial + 3) * n, sizeof *o->unit, &o->unit));
  UM_TRY(um_core_allocate(context, UM_COORDINATES * n, sizeof *o->coordinate, &o->coordinate));
  return fill(context, forward, value, o);
}

void um_missing_light_observations_release(struct um_context *context,
                                           struct um_missing_light_observations *o)
{
  um_sensitivity_forward_run_release(context, &o->run);
  um_inference_projection_destroy(context, &o->projection);
  UM_FREE(context, o->residual, (void *)o->band, o->thermal, o->of, (void *)o->material, o->unit,
          o->coordinate);
}

size_t um_missing_light_unit(const struct um_missing_light_observations *o,
                             enum um_missing_light_kind kind, size_t material)
{
  if (kind == UM_LIGHT_FACTOR) return material < o->nmaterial ? material : o->nmaterial;
  return o->nmaterial + (kind == UM_LIGHT_INTENSITY ? 1 : 2);
}
