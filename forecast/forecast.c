/* Passes of stations over days, and their runs. */
#include "forecast/forecast.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/digest.h"
#include "base/core/file_snapshot.h"
#include "base/core/sort.h"
#include "forecast/forecast_impl.h"
#include "model/build/bands.h"
#include "model/build/build.h"
#include "study/accepts.h"
#include "study/identity.h"

#define DAY 86400.0

const char *um_forecast_sky(double sun_elevation)
{
  static const struct {
    double above; /* [deg] */
    const char *word;
  } skies[] = {{-0.833, "day"}, {-6.0, "civil"}, {-12.0, "nautical"}, {-18.0, "astronomical"}};
  for (size_t i = 0; i < sizeof skies / sizeof *skies; i++)
    if (sun_elevation > skies[i].above * UM_DEG) return skies[i].word;
  return "night";
}

const char *um_forecast_system(const struct um_forecast *forecast, size_t band)
{
  return isnan(forecast->vega_ab[band]) ? "AB" : "Vega";
}

static int by_rise(const void *a, const void *b)
{
  const struct um_forecast_pass *p = a, *q = b;
  return (p->pass.rise > q->pass.rise) - (p->pass.rise < q->pass.rise);
}

/* Bands, and the places that are told of: parts and interiors. */
static enum um_status name_outputs(struct um_context *context, struct um_forecast_held *h,
                                   const struct um_model *model)
{
  struct um_forecast *f = &h->forecast;
  const struct um_thermal_body *body = model->body;
  UM_TRY(um_core_allocate(context, model->nband, sizeof *f->band, &f->band));
  UM_TRY(um_core_allocate(context, model->nband, sizeof *f->thermal, &f->thermal));
  UM_TRY(um_core_allocate(context, model->nband, sizeof *f->vega_ab, &f->vega_ab));
  for (; f->nband < model->nband; f->nband++) {
    bool vega = um_model_band_is_vega(model, f->nband);
    f->vega_ab[f->nband] = vega ? model->vega_ab[f->nband] : (double)NAN;
    f->thermal[f->nband] = um_model_band_is_thermal(&model->band[f->nband]);
    UM_TRY(um_core_strdup(context, model->band[f->nband].name, &f->band[f->nband]));
  }
  size_t n = body == NULL ? 0 : body->nplace;
  UM_TRY(um_core_allocate(context, n, sizeof *f->place, &f->place));
  UM_TRY(um_core_allocate(context, n, sizeof *h->place, &h->place));
  for (size_t i = 0; i < n; i++) {
    if (body->place[i].kind != UM_PLACE_PART && body->place[i].kind != UM_PLACE_INTERIOR) continue;
    UM_TRY(um_core_strdup(context, body->place[i].name, &f->place[f->nplace]));
    h->place[f->nplace++] = i;
  }
  return UM_OK;
}

static enum um_status name_stations(struct um_context *context, struct um_forecast_held *h,
                                    const struct um_model *model)
{
  struct um_forecast *f = &h->forecast;
  size_t n = h->ask.nstation;
  UM_TRY(um_core_allocate(context, n > 0 ? n : 1, sizeof *f->station, &f->station));
  UM_TRY(um_forecast_check_orbit(context, model));
  const char *name = model->scenario->observer->station->name;
  struct um_forecast_station own = {name == NULL ? "station" : name, model->observer.latitude,
                                    model->observer.longitude, model->observer.height};
  for (size_t i = 0; i < (n > 0 ? n : 1); i++) {
    char *copy;
    const struct um_forecast_station *from = n > 0 ? &h->ask.station[i] : &own;
    UM_TRY(um_core_strdup(context, from->name, &copy));
    f->station[f->nstation] = *from;
    f->station[f->nstation++].name = copy;
  }
  h->work.station = n > 0 ? f->station : NULL;
  return UM_OK;
}

static enum um_status read_uncertain(struct um_context *context, struct um_forecast_held *h)
{
  struct um_forecast *f = &h->forecast;
  struct um_forecast_unknowns *u = &h->work.unknowns;
  UM_TRY(um_forecast_uncertain_read(context, &h->work, h->ask.uncertain, h->ask.nuncertain, u));
  UM_TRY(um_core_allocate(context, u->n, sizeof *f->uncertain, &f->uncertain));
  for (; f->nuncertain < u->n; f->nuncertain++) {
    const struct um_study_binding *b = &u->binding[f->nuncertain];
    f->uncertain[f->nuncertain] =
        (struct um_forecast_uncertain){b->name, b->unit, b->nominal, u->sigma[f->nuncertain]};
  }
  return UM_OK;
}

/* The scenario with all that it is made of, the stations and what is uncertain: a pass of these has
 * its values. */
static enum um_status identify(struct um_context *context, struct um_forecast_held *h,
                               const struct um_model *model)
{
  uint64_t stations = UM_CORE_DIGEST_BEGIN;
  UM_TRY(um_study_identity_create(context, h->ask.version, model, h->ask.options, &h->identity));
  for (size_t i = 0; i < h->forecast.nstation; i++) {
    const struct um_forecast_station *s = &h->forecast.station[i];
    const double place[3] = {s->latitude, s->longitude, s->height};
    stations = um_core_digest(stations, place, sizeof place);
  }
  UM_TRY(um_study_identity_add(context, h->identity, "the stations", stations));
  return um_study_identity_add(context, h->identity, "the uncertain parameters",
                               um_forecast_uncertain_digest(&h->work.unknowns));
}

enum um_status um_forecast_open(struct um_context *context, const struct um_forecast *forecast,
                                const struct um_batch_task *task, struct um_batch **out)
{
  const struct um_forecast_held *h =
      (const struct um_forecast_held *)(const void *)forecast; /* its first member */
  return um_study_identity_open(context, h->identity, task, out);
}

/* Days around the scenario, so that its own pass is seen whole. */
static void take_days(struct um_forecast_held *h, const struct um_scenario_time *time)
{
  struct um_forecast *f = &h->forecast;
  double half = fmax(0.5 * DAY, 0.5 * (time->stop - time->start));
  bool around = isnan(h->ask.days);
  f->from = isnan(h->ask.from) ? time->start : h->ask.from;
  if (around) f->from = 0.5 * (time->start + time->stop) - half;
  f->to = f->from + (around ? 2.0 * half : h->ask.days * DAY);
}

/* Days, stations and what begins with the scenario; bands and runs are not looked at. */
static enum um_status prepare_times(struct um_context *context, struct um_forecast_held *h)
{
  struct um_forecast *f = &h->forecast;
  const struct um_model *model = h->work.model = h->model;
  take_days(h, model->scenario->time);
  UM_TRY(um_core_strdup(context, model->scenario->name, &f->name));
  UM_TRY(name_stations(context, h, model));
  f->minimum_elevation = isnan(h->ask.minimum_elevation)
                             ? model->scenario->observer->minimum_elevation_deg * UM_DEG
                             : h->ask.minimum_elevation;
  return um_forecast_pin(context, model, &h->work);
}

static enum um_status find_all(struct um_context *context, struct um_forecast_held *h)
{
  struct um_forecast *f = &h->forecast;
  for (size_t s = 0; s < f->nstation; s++) UM_TRY(um_forecast_find(context, &h->work, f, s));
  return um_core_sort(context, f->pass, f->npass, sizeof *f->pass, by_rise);
}

static enum um_status prepare(struct um_context *context, struct um_forecast_held *h)
{
  struct um_forecast *f = &h->forecast;
  const struct um_variant_error asked = {1e-3, 1e-3, 0.1}; /* of the heat that others start from */
  const struct um_variant_settings settings = {.instants = &h->instant,
                                               .base = um_variant_tolerance_asked(&asked, NULL)};
  UM_TRY(um_core_snapshot_begin(context)); /* every pass is of the same bytes */
  h->holds_files = true;
  UM_TRY(um_model_create(context, h->ask.path, h->ask.options, &h->model));
  UM_TRY(prepare_times(context, h));
  const struct um_model *model = h->model;
  UM_TRY(name_outputs(context, h, model));
  UM_TRY(read_uncertain(context, h));
  h->work.thermal = f->thermal;
  h->work.light_has_sign = um_study_light_has_sign(model);
  h->instant = (struct um_model_instants){.time = &f->from, .count = 1, .sparse = true};
  UM_TRY(um_variant_evaluator_create(context, model, &settings, &h->work.evaluator));
  return identify(context, h, model);
}

enum um_status um_forecast_create(struct um_context *context, const struct um_forecast_ask *ask,
                                  struct um_batch_task *task, struct um_forecast **out)
{
  enum um_status status;
  struct um_forecast_held *h;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *h, &h));
  struct um_forecast *f = &h->forecast;
  h->ask = *ask;
  UM_CHECK(prepare(context, h));
  UM_CHECK(find_all(context, h));
  h->work.checked = f->npass > 0 ? f->pass[0].start : (double)NAN;
  h->work.nband = f->nband;
  h->work.nplace = f->nplace;
  h->work.place = h->place;
  task->work.ncoordinate = UM_FORECAST_COORDINATES;
  task->work.nvalue = um_forecast_record(&h->work);
  task->work.compute = um_forecast_compute;
  task->accepts = um_forecast_accepts;
  task->work.user = &h->work;
  *out = f;
  h = NULL;
done:
  if (h != NULL) {
    f = &h->forecast;
    um_forecast_destroy(context, &f);
  }
  return status;
}

enum um_status um_forecast_times(struct um_context *context, const struct um_forecast_ask *ask,
                                 struct um_forecast **out)
{
  enum um_status status;
  struct um_forecast_held *h;
  struct um_forecast *f;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *h, &h));
  h->ask = *ask;
  h->work.times = &h->ask;
  UM_CHECK(um_core_snapshot_begin(context)); /* every station is of the same bytes */
  h->holds_files = true;
  UM_CHECK(um_model_create_orbit(context, ask->path, ask->options, &h->model));
  UM_CHECK(prepare_times(context, h));
  UM_CHECK(find_all(context, h));
  *out = &h->forecast;
  h = NULL;
done:
  f = h == NULL ? NULL : &h->forecast;
  um_forecast_destroy(context, &f);
  return status;
}

void um_forecast_destroy(struct um_context *context, struct um_forecast **forecast)
{
  if (forecast == NULL || *forecast == NULL) return;
  struct um_forecast_held *h = (struct um_forecast_held *)(void *)*forecast;
  struct um_forecast *f = *forecast;
  for (size_t i = 0; i < f->npass; i++) UM_FREE(context, f->pass[i].reason, f->pass[i].event);
  for (size_t i = 0; i < f->nband; i++) um_core_free(context, f->band[i]);
  for (size_t i = 0; i < f->nplace; i++) um_core_free(context, f->place[i]);
  for (size_t i = 0; i < f->nstation; i++) um_core_free(context, (void *)f->station[i].name);
  for (size_t i = 0; i < h->work.npin; i++) um_core_free(context, h->work.pin[i]);
  um_variant_evaluator_destroy(context, &h->work.evaluator);
  um_model_destroy(context, &h->model);
  um_study_identity_destroy(context, &h->identity);
  um_forecast_uncertain_clear(context, &h->work.unknowns);
  if (h->holds_files) um_core_snapshot_end(context);
  void *const block[] = {h->work.pin,   f->pass,    f->band,   f->thermal,    f->vega_ab,
                         f->place,      f->station, f->value,  f->name,       h->place,
                         h->coordinate, h->band,    h->places, h->band_sigma, h->places_sigma,
                         f->uncertain,  h};
  for (size_t i = 0; i < sizeof block / sizeof *block; i++) um_core_free(context, block[i]);
  *forecast = NULL;
}
