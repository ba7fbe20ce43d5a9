/* One pass: a run of the scenario over the pass, and what an observer wants to know of it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/constants.h"
#include "model/build.h"
#include "model/precompute.h"
#include "model/run.h"
#include "orbit/time.h"
#include "study/forecast_impl.h"

static enum um_status pin(struct um_context *context, struct um_study_forecast_work *work,
                          const char *before, size_t index, const char *law, double start)
{
  char utc[32], number[24] = "";
  um_orbit_time_format(start, utc);
  if (law != NULL) snprintf(number, sizeof number, "%zu", index);
  UM_TRY(um_core_reallocate(context, work->npin + 1, sizeof *work->pin, &work->pin));
  work->pin[work->npin] = NULL;
  UM_TRY(um_core_asprintf(context, &work->pin[work->npin], "%s%s%s=%s", before, number,
                          law == NULL ? "" : law, utc));
  work->npin++;
  return UM_OK;
}

enum um_status um_study_forecast_pin(struct um_context *context, const struct um_model *model,
                                     struct um_study_forecast_work *work)
{
  const struct um_scenario *s = model->scenario;
  const struct um_scenario_attitude *law = s->attitude.items;
  if (s->orbit->circular != NULL && isnan(s->orbit->circular->epoch))
    UM_TRY(pin(context, work, "orbit.circular.epoch_utc", 0, NULL, s->time->start));
  for (size_t i = 0; i < s->attitude.count; i++) {
    if (law[i].spin != NULL && isnan(law[i].spin->at_utc))
      UM_TRY(pin(context, work, "attitude.", i, ".spin.at_utc", s->time->start));
    if (law[i].magnetic != NULL && isnan(law[i].magnetic->at_utc))
      UM_TRY(pin(context, work, "attitude.", i, ".magnetic.at_utc", s->time->start));
    if (law[i].tumble != NULL && isnan(law[i].tumble->at_utc))
      UM_TRY(pin(context, work, "attitude.", i, ".tumble.at_utc", s->time->start));
  }
  return UM_OK;
}

enum um_status um_study_forecast_changes(struct um_context *context,
                                         const struct um_study_forecast_work *work, size_t station,
                                         double start, double stop, double step,
                                         struct um_study_forecast_changes *out)
{
  char from[32], to[32];
  const struct um_model_options *asked = work->ask->options;
  size_t at = 0, own = 2;
  out->options = *asked;
  UM_TRY(um_core_allocate(context,
                          asked->noverride + work->npin + sizeof out->own / sizeof *out->own,
                          sizeof *out->text, &out->text));
  um_orbit_time_format(start, from);
  um_orbit_time_format(stop, to);
  snprintf(out->own[0], sizeof out->own[0], "time.start_utc=%s", from);
  snprintf(out->own[1], sizeof out->own[1], "time.stop_utc=%s", to);
  if (!isnan(step)) snprintf(out->own[own++], sizeof *out->own, "time.step_s=%.17g", step);
  if (work->station != NULL) {
    const struct um_study_station *s = &work->station[station];
    snprintf(out->own[own++], sizeof *out->own, "observer.station.latitude_deg=%.17g",
             s->latitude / UM_DEG);
    snprintf(out->own[own++], sizeof *out->own, "observer.station.longitude_deg=%.17g",
             s->longitude / UM_DEG);
    snprintf(out->own[own++], sizeof *out->own, "observer.station.height_m=%.17g", s->height);
  }
  for (size_t i = 0; i < asked->noverride; i++) out->text[at++] = asked->overrides[i];
  for (size_t i = 0; i < work->npin; i++) out->text[at++] = work->pin[i];
  for (size_t i = 0; i < own; i++) out->text[at++] = out->own[i];
  out->options.overrides = out->text;
  out->options.noverride = at;
  return UM_OK;
}

/* The observation nearest to a time. */
static size_t nearest(const struct um_model_precomputed *p, double t)
{
  size_t best = 0;
  for (size_t k = 1; k < p->nobs; k++)
    if (fabs(p->t_obs[k] - t) < fabs(p->t_obs[best] - t)) best = k;
  return best;
}

static double magnitude(const struct um_model_precomputed *p, const struct um_model_result *r,
                        size_t k, size_t band)
{
  return p->hidden[k] ? NAN : r->magnitude_ab[k * r->nband + band];
}

/* Largest radiant intensity toward the observer, and what is seen when. */
static struct um_study_forecast_band band_of(const struct um_model_precomputed *p,
                                             const struct um_model_result *r, size_t band,
                                             double culmination)
{
  size_t at = nearest(p, culmination);
  struct um_study_forecast_band b = {
      NAN, NAN, magnitude(p, r, at, band), NAN, NAN, r->irradiance[at * r->nband + band], 0.0, NAN};
  for (size_t k = 0; k < r->nobs; k++) {
    double m = magnitude(p, r, k, band), e = r->irradiance[k * r->nband + band];
    b.intensity = fmax(b.intensity, um_model_result_intensity(r, k, band, -1));
    if (isfinite(m) && !(b.brightest <= m)) {
      b.brightest = m;
      b.brightest_at = p->t_obs[k];
      /* m = -2.5 lg f: the flux's standard error, in magnitudes */
      b.error = UM_POGSON * r->magnitude_error[k * r->nband + band] / pow(10.0, -0.4 * m);
    }
    if (isfinite(e) && !(b.largest >= e)) {
      b.largest = e;
      b.largest_at = p->t_obs[k];
    }
  }
  return b;
}

static struct um_study_forecast_place place_of(const struct um_model_result *r, size_t place)
{
  const double *mean = r->place[place].mean;
  struct um_study_forecast_place out = {0.0, INFINITY, -INFINITY};
  for (size_t k = 0; k < r->nobs; k++) {
    out.mean += mean[k] / (double)r->nobs;
    out.lowest = fmin(out.lowest, mean[k]);
    out.highest = fmax(out.highest, mean[k]);
  }
  return out;
}

/* In the order of um_study_forecast_values. */
static void store(const struct um_study_forecast_work *work, const struct um_model_precomputed *p,
                  const struct um_model_result *r, double delay, double culmination, double *value)
{
  *value++ = delay;
  for (size_t b = 0; b < work->nband; b++) {
    struct um_study_forecast_band band = band_of(p, r, b, culmination);
    memcpy(value, &band, sizeof band);
    value += sizeof band / sizeof *value;
  }
  for (size_t i = 0; i < work->nplace; i++) {
    struct um_study_forecast_place place = place_of(r, work->place[i]);
    memcpy(value, &place, sizeof place);
    value += sizeof place / sizeof *value;
  }
  for (size_t i = 0; i < UM_STUDY_FORECAST_CURVE; i++) {
    size_t k = i * (r->nobs - 1) / (UM_STUDY_FORECAST_CURVE - 1);
    value[i] = p->t_obs[k];
    for (size_t b = 0; b < work->nband; b++) {
      value[(1 + 2 * b) * UM_STUDY_FORECAST_CURVE + i] = magnitude(p, r, k, b);
      value[(2 + 2 * b) * UM_STUDY_FORECAST_CURVE + i] = r->irradiance[k * r->nband + b];
    }
  }
}

enum um_status um_study_forecast_compute(struct um_context *context, void *user,
                                         const double *coordinate, double *value)
{
  enum um_status status;
  const struct um_study_forecast_work *work = user;
  struct um_model *model = NULL;
  struct um_model_precomputed *precomputed = NULL;
  struct um_model_result *result = NULL;
  struct um_study_forecast_changes changes = {.text = NULL};
  UM_CHECK(um_study_forecast_changes(context, work, (size_t)coordinate[0], coordinate[1],
                                     coordinate[2], NAN, &changes));
  UM_CHECK(um_model_create(context, work->ask->path, &changes.options, &model));
  UM_CHECK(um_model_precompute(context, model, &precomputed));
  UM_CHECK(um_model_run(context, model, precomputed, &result));
  store(work, precomputed, result, model->orbit_delay, coordinate[3], value);
done:
  um_model_result_destroy(context, &result);
  um_model_precomputed_destroy(context, &precomputed);
  um_model_destroy(context, &model);
  um_core_free(context, (void *)changes.text);
  return status;
}
