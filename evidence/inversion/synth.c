/* Measurements made from a model. */
#include "evidence/inversion/synth.h"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <math.h>

#include "base/core/sampling.h"
#include "evidence/comparison/places_group.h"
#include "evidence/comparison/residual.h"
#include "evidence/measurements/set_group.h"
#include "model/build/bands.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "model/run/grey_body.h"

/* A channel in the making. */
struct source {
  enum um_compare_quantity quantity;
  size_t index;   /* band, sensor or place */
  size_t channel; /* of the set */
  double sigma;   /* of a temperature [K]; floor of an irradiance [W/m^2] or count rate [1/s] */
  gsl_rng *random;
};

/* A generator of its own for the channel; the twister takes 32 bits, and 0 would be its default. */
static enum um_status seed_source(struct um_context *context, uint64_t seed, const char *name,
                                  struct source *s)
{
  uint64_t key = um_core_hash(seed, (uint64_t)s->quantity);
  for (; *name != '\0'; name++) key = um_core_hash(key, (unsigned char)*name);
  s->random = gsl_rng_alloc(gsl_rng_mt19937);
  if (s->random == NULL) return um_core_fail(context, UM_ERR_MEMORY, "out of memory");
  gsl_rng_set(s->random, (unsigned long)(key & 0xffffffffu) | 1u);
  return UM_OK;
}

/* Largest value of column i of a table [nobs][n] where it is seen; 0 when it is never. */
static double peak(const double *table, size_t nobs, size_t n, size_t i)
{
  double largest = 0.0;
  for (size_t k = 0; k < nobs; k++)
    if (table[k * n + i] > largest) largest = table[k * n + i]; /* NaN where hidden */
  return largest;
}

static enum um_status make_sources(struct um_context *context, const struct um_model *model,
                                   const struct um_model_result *result,
                                   const struct um_compare_synth *o, struct um_compare_set *set,
                                   struct source *source, size_t *count)
{
  for (size_t b = 0; model->has_observer && b < model->nband; b++) {
    struct source *s = &source[(*count)++];
    double most = peak(result->irradiance, result->nobs, result->nband, b);
    *s = (struct source){
        .quantity = UM_QUANTITY_BAND_IRRADIANCE, .index = b, .sigma = o->floor * most};
    UM_TRY(um_compare_set_channel(context, set, s->quantity, model->band[b].name, &s->channel));
    UM_TRY(seed_source(context, o->seed, model->band[b].name, s));
  }
  for (size_t i = 0; model->has_observer && i < model->nsensor; i++) {
    struct source *s = &source[(*count)++];
    double most = peak(result->count_rate, result->nobs, result->nsensor, i);
    *s = (struct source){.quantity = UM_QUANTITY_COUNT_RATE, .index = i, .sigma = o->floor * most};
    UM_TRY(um_compare_set_channel(context, set, s->quantity, model->sensor[i].name, &s->channel));
    UM_TRY(seed_source(context, o->seed, model->sensor[i].name, s));
  }
  for (int q = 0; o->grey_body && q < 2; q++) {
    struct source *s = &source[(*count)++];
    *s = (struct source){.quantity = q == 0 ? UM_QUANTITY_CHARACTERISTIC_TEMPERATURE
                                            : UM_QUANTITY_INFRARED_CROSS_SECTION};
    UM_TRY(um_compare_set_channel(context, set, s->quantity, UM_COMPARE_THERMAL, &s->channel));
    UM_TRY(seed_source(context, o->seed, UM_COMPARE_THERMAL, s));
  }
  for (size_t p = 0; p < o->nplace; p++) {
    struct source *s = &source[(*count)++];
    *s = (struct source){.quantity = UM_QUANTITY_TEMPERATURE, .sigma = o->temperature_sigma};
    UM_TRY(um_compare_place_find(context, model, o->place[p], &s->index));
    for (size_t i = 0; i + 1 < *count; i++)
      if (source[i].quantity == s->quantity && source[i].index == s->index)
        return um_core_fail(context, UM_ERR_INPUT, "place '%s' is named twice", o->place[p]);
    const char *name = result->place[s->index].name;
    UM_TRY(um_compare_set_channel(context, set, s->quantity, name, &s->channel));
    UM_TRY(seed_source(context, o->seed, name, s));
  }
  return UM_OK;
}

/* Temperature or area of all thermal bands together, and what the bands' noise makes of it. */
static enum um_status grey_body(struct um_context *context, const struct um_model *model,
                                const struct um_model_tables *tables,
                                const struct um_model_result *r, const struct um_compare_synth *o,
                                const struct source *s, size_t k, double *truth, double *sigma)
{
  double *noise, temperature, area;
  bool first = s->quantity == UM_QUANTITY_CHARACTERISTIC_TEMPERATURE;
  const struct um_instrument_grey_body *one = &r->grey_body[k].one;
  *truth = *sigma = NAN;
  if (tables->hidden[k] || one->n == 0) return UM_OK;
  double range = tables->sample[k * tables->nsub + tables->nsub / 2].range;
  UM_TRY(um_core_allocate(context, r->nband, sizeof *noise, &noise));
  for (size_t b = 0; b < r->nband; b++)
    noise[b] = hypot(o->relative * r->measured_intensity[k * r->nband + b],
                     o->floor * peak(r->irradiance, r->nobs, r->nband, b) * range * range);
  enum um_status status =
      um_model_grey_body_error(context, model, tables, r, k, noise, &temperature, &area);
  um_core_free(context, noise);
  *truth = first ? one->temperature[0] : one->area[0];
  *sigma = first ? temperature : area;
  return status;
}

/* What a source says at observation k, NaN: nothing, and its noise. */
static enum um_status look(struct um_context *context, const struct um_model *model,
                           const struct um_model_tables *tables, const struct um_model_result *r,
                           const struct um_compare_synth *o, const struct source *s, size_t k,
                           double *truth, double *sigma)
{
  switch (s->quantity) {
  case UM_QUANTITY_TEMPERATURE:
    *truth = r->place[s->index].mean[k];
    *sigma = s->sigma;
    return UM_OK;
  case UM_QUANTITY_CHARACTERISTIC_TEMPERATURE:
  case UM_QUANTITY_INFRARED_CROSS_SECTION:
    return grey_body(context, model, tables, r, o, s, k, truth, sigma);
  case UM_QUANTITY_COUNT_RATE:
    *truth = r->count_rate[k * r->nsensor + s->index];
    break;
  default:
    *truth = r->irradiance[k * r->nband + s->index];
  }
  *sigma = hypot(o->relative * *truth, s->sigma);
  return UM_OK;
}

/* The row of a source at observation k, unless the observer cannot see the satellite there. */
static enum um_status add_row(struct um_context *context, const struct um_model *model,
                              const struct um_model_tables *tables, const struct um_model_result *r,
                              const struct um_compare_synth *o, const struct source *s, size_t k,
                              struct um_compare_set *set)
{
  double truth, sigma, exposure = model->scenario->time->exposure_s;
  UM_TRY(look(context, model, tables, r, o, s, k, &truth, &sigma));
  if (isnan(truth)) return UM_OK;
  if (!(sigma > 0.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "noise of %s '%s' of %g %s is %g; accepted: a floor above 0",
                        um_compare_quantity_name(s->quantity), set->channels.text[s->channel],
                        truth, um_compare_quantity_unit(s->quantity), sigma);
  struct um_compare_measurement row = {.t_tai = tables->t_obs[k],
                                       .channel = s->channel,
                                       .value = truth + gsl_ran_gaussian_ziggurat(s->random, sigma),
                                       .sigma = sigma,
                                       .exposure = exposure > 0.0 ? exposure : (double)NAN,
                                       .satellite_height = NAN,
                                       .azimuth = NAN,
                                       .elevation = NAN,
                                       .line = 2 + (int)set->made->count,
                                       .station = SIZE_MAX};
  UM_TRY(um_compare_set_track(context, set, "", &row.track));
  return um_compare_set_add(context, set, &row);
}

enum um_status um_compare_synth_check(struct um_context *context, const struct um_model *model,
                                      const struct um_compare_synth *options)
{
  const struct um_compare_synth *o = options;
  size_t place;
  if (!(o->relative >= 0.0 && o->floor >= 0.0 && o->relative + o->floor > 0.0) ||
      !isfinite(o->relative + o->floor))
    return um_core_fail(context, UM_ERR_INPUT,
                        "noise %g,%g; accepted: relative and floor 0 or more, not both 0",
                        o->relative, o->floor);
  if (o->nplace > 0 && !(o->temperature_sigma > 0.0 && isfinite(o->temperature_sigma)))
    return um_core_fail(context, UM_ERR_INPUT, "noise of temperatures %g K; accepted: above 0 K",
                        o->temperature_sigma);
  for (size_t p = 0; p < o->nplace; p++)
    UM_TRY(um_compare_place_find(context, model, o->place[p], &place));
  if (o->grey_body && (!model->has_observer || um_model_thermal_bands(model) < 3))
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: --grey-body wants an observer and light in three bands of %g to %g um "
                        "or more, the scenario has %zu such bands",
                        model->scenario->at.file, UM_INSTRUMENT_THERMAL_FROM * 1e6,
                        UM_INSTRUMENT_THERMAL_TO * 1e6, um_model_thermal_bands(model));
  if (model->has_observer || o->nplace > 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: the scenario has no observer; accepted: places whose temperatures are "
                      "measured",
                      model->scenario->at.file);
}

enum um_status um_compare_synth_share(struct um_context *context, void *user,
                                      const struct um_model_tables *tables,
                                      const struct um_model_result *result,
                                      const struct um_compare_twice *twice, double variance,
                                      double *share)
{
  const struct um_compare_synth *o = user;
  (void)context;
  *share = NAN;
  for (size_t b = 0; tables->view != NULL && b < result->nband; b++) {
    double floor = o->floor * peak(result->irradiance, result->nobs, result->nband, b), sum = 0.0;
    size_t count = 0;
    for (size_t k = 0; k < result->nobs; k++) {
      size_t at = k * result->nband + b;
      double sigma = hypot(o->relative * result->irradiance[at], floor);
      double own = twice == NULL
                       ? result->irradiance_error[at]
                       : fabs(twice->finer->irradiance[at] - twice->coarse->irradiance[at]);
      if (!(sigma > 0.0)) continue; /* below the horizon, or refused later */
      sum += um_compare_residual_share(sigma, sqrt(variance) * own);
      count++;
    }
    if (count > 0) *share = fmax(*share, sum / (double)count);
  }
  return UM_OK;
}

enum um_status um_compare_synth_create(struct um_context *context, const struct um_model *model,
                                       const struct um_model_tables *tables,
                                       const struct um_model_result *result,
                                       const struct um_compare_synth *options, const char *path,
                                       struct um_compare_measurements **out)
{
  struct um_compare_set set = {0};
  struct source *source = NULL;
  size_t count = 0;
  enum um_status status;
  *out = NULL;
  UM_TRY(um_compare_synth_check(context, model, options));
  UM_TRY(um_core_allocate(context, model->nband + model->nsensor + options->nplace + 2,
                          sizeof *source, &source));
  UM_CHECK(um_compare_set_begin(context, path, "time_utc", &set));
  UM_CHECK(make_sources(context, model, result, options, &set, source, &count));
  for (size_t k = 0; k < tables->nobs; k++)
    for (size_t i = 0; i < count; i++)
      UM_CHECK(add_row(context, model, tables, result, options, &source[i], k, &set));
  if (set.made->count == 0) {
    status = um_core_fail(
        context, UM_ERR_INPUT,
        "%s: the satellite is never seen, it is below the horizon or behind the Earth; "
        "accepted: another time, "
        "or places whose temperatures are measured",
        model->scenario->at.file);
    goto done;
  }
  UM_CHECK(um_compare_set_finish(context, &set, out));
done:
  for (size_t i = 0; i < count; i++)
    if (source[i].random != NULL) gsl_rng_free(source[i].random);
  um_core_free(context, source);
  um_compare_set_abandon(context, &set);
  return status;
}

enum um_status um_compare_synth_run(struct um_context *context, const char *scenario,
                                    const struct um_model_options *changes,
                                    const struct um_compare_synth *options, const char *path,
                                    struct um_compare_measurements **out)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_model_tables *tables = NULL;
  struct um_model_result *result = NULL;
  struct um_compare_synth looked_at = *options;
  *out = NULL;
  UM_CHECK(um_model_create(context, scenario, changes, &model));
  UM_CHECK(um_compare_synth_check(context, model, options));
  UM_CHECK(um_model_precompute(context, model, &tables));
  UM_CHECK(um_compare_refine(context, model, tables, UM_COMPARE_MODEL_SHARE, um_compare_synth_share,
                             &looked_at, &result, NULL));
  UM_CHECK(um_compare_synth_create(context, model, tables, result, options, path, out));
done:
  um_model_result_destroy(context, &result);
  um_model_tables_destroy(context, &tables);
  um_model_destroy(context, &model);
  return status;
}
