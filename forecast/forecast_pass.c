/* One pass: a run of the scenario over the pass, and what an observer wants to know of it. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "forecast/forecast_impl.h"

/* Means of a pass are asked to 0.1 K, its light to 1e-3 of its brightest. Tolerances for 0.2 K with
 * sparse loads leave 0.06 K of ENVISAT's 21 passes, 7e-4 in LWIR and 5e-4 in VIS. A part that turns
 * into the shadow of another is up to 0.2 K off at an instant, as rows of the loads are 3 s apart.
 */
static const struct um_variant_error asked = {1e-3, 1e-3, 0.2};

static enum um_status pin(struct um_context *context, struct um_forecast_work *work,
                          const char *key)
{
  UM_TRY(um_core_reallocate(context, work->npin + 1, sizeof *work->pin, &work->pin));
  UM_TRY(um_core_strdup(context, key, &work->pin[work->npin]));
  work->npin++;
  return UM_OK;
}

static enum um_status pin_law(struct um_context *context, struct um_forecast_work *work,
                              size_t index, const char *law)
{
  char key[64];
  snprintf(key, sizeof key, "attitude.%zu.%s.at_utc", index, law);
  return pin(context, work, key);
}

enum um_status um_forecast_pin(struct um_context *context, const struct um_model *model,
                               struct um_forecast_work *work)
{
  const struct um_scenario *s = model->scenario;
  const struct um_scenario_attitude *law = s->attitude.items;
  if (s->orbit->circular != NULL && isnan(s->orbit->circular->epoch))
    UM_TRY(pin(context, work, "orbit.circular.epoch_utc"));
  for (size_t i = 0; i < s->attitude.count; i++) {
    if (law[i].spin != NULL && isnan(law[i].spin->at_utc))
      UM_TRY(pin_law(context, work, i, "spin"));
    if (law[i].magnetic != NULL && isnan(law[i].magnetic->at_utc))
      UM_TRY(pin_law(context, work, i, "magnetic"));
    if (law[i].tumble != NULL && isnan(law[i].tumble->at_utc))
      UM_TRY(pin_law(context, work, i, "tumble"));
  }
  return UM_OK;
}

static void set(struct um_forecast_changes *changes, const char *key, double number)
{
  changes->key[changes->all.nkey++] = (struct um_document_change){.key = key, .number = number};
}

enum um_status um_forecast_changes(struct um_context *context, const struct um_forecast_work *work,
                                   size_t station, double start, double stop, double step,
                                   struct um_forecast_changes *out)
{
  enum { TIMES = 3, PLACE = 3 };
  *out = (struct um_forecast_changes){.key = NULL};
  UM_TRY(um_core_allocate(context, work->npin + TIMES + PLACE, sizeof *out->key, &out->key));
  out->all.key = out->key;
  for (size_t i = 0; i < work->npin; i++)
    set(out, work->pin[i], work->model->scenario->time->start);
  set(out, "time.start_utc", start);
  set(out, "time.stop_utc", stop);
  if (!isnan(step)) set(out, "time.step_s", step);
  if (work->station == NULL) return UM_OK;
  const struct um_forecast_station *s = &work->station[station];
  set(out, "observer.station.latitude_deg", s->latitude / UM_DEG);
  set(out, "observer.station.longitude_deg", s->longitude / UM_DEG);
  set(out, "observer.station.height_m", s->height);
  return UM_OK;
}

void um_forecast_changes_clear(struct um_context *context, struct um_forecast_changes *changes)
{
  um_core_free(context, changes->key);
  *changes = (struct um_forecast_changes){.key = NULL};
}

/* The observation nearest to a time. */
static size_t nearest(const struct um_model_tables *p, double t)
{
  size_t best = 0;
  for (size_t k = 1; k < p->nobs; k++)
    if (fabs(p->t_obs[k] - t) < fabs(p->t_obs[best] - t)) best = k;
  return best;
}

static double magnitude(const struct um_model_tables *p, const struct um_model_result *r, size_t k,
                        size_t band)
{
  return p->hidden[k] ? NAN : r->magnitude_ab[k * r->nband + band];
}

/* Largest radiant intensity toward the observer, and what is seen when. */
static struct um_forecast_band band_of(const struct um_model_tables *p,
                                       const struct um_model_result *r, size_t band,
                                       double culmination)
{
  size_t at = nearest(p, culmination);
  struct um_forecast_band b = {
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

static struct um_forecast_place place_of(const struct um_model_result *r, size_t place)
{
  const double *mean = r->place[place].mean;
  struct um_forecast_place out = {0.0, INFINITY, -INFINITY};
  for (size_t k = 0; k < r->nobs; k++) {
    out.mean += mean[k] / (double)r->nobs;
    out.lowest = fmin(out.lowest, mean[k]);
    out.highest = fmax(out.highest, mean[k]);
  }
  return out;
}

void um_forecast_store(const struct um_forecast_work *work, const struct um_variant *variant,
                       const struct um_model_result *r, double culmination, double *value)
{
  const struct um_model_tables *p = variant->tables;
  *value++ = variant->model->orbit_delay;
  for (size_t b = 0; b < work->nband; b++) {
    struct um_forecast_band band = band_of(p, r, b, culmination);
    memcpy(value, &band, sizeof band);
    value += sizeof band / sizeof *value;
  }
  for (size_t i = 0; i < work->nplace; i++) {
    struct um_forecast_place place = place_of(r, work->place[i]);
    memcpy(value, &place, sizeof place);
    value += sizeof place / sizeof *value;
  }
  for (size_t i = 0; i < UM_FORECAST_CURVE; i++) {
    size_t k = i * (r->nobs - 1) / (UM_FORECAST_CURVE - 1);
    value[i] = p->t_obs[k];
    for (size_t b = 0; b < work->nband; b++) {
      value[(1 + 2 * b) * UM_FORECAST_CURVE + i] = magnitude(p, r, k, b);
      value[(2 + 2 * b) * UM_FORECAST_CURVE + i] = r->irradiance[k * r->nband + b];
    }
  }
}

enum um_status um_forecast_compute(struct um_context *context, void *user, const double *coordinate,
                                   double *value)
{
  enum um_status status;
  const struct um_forecast_work *work = user;
  const bool periodic = work->model->scenario->thermal->start == UM_START_PERIODIC;
  const struct um_variant_heat heat = {.start = periodic ? UM_VARIANT_WARM : UM_VARIANT_COLD,
                                       .tolerance = um_variant_tolerance_asked(&asked, NULL)};
  const struct um_model_instants own_window = {.sparse = periodic};
  struct um_variant v = {0};
  struct um_model_result *result = NULL;
  struct um_forecast_changes changes;
  UM_CHECK(um_forecast_changes(context, work, (size_t)coordinate[0], coordinate[1], coordinate[2],
                               NAN, &changes));
  UM_CHECK(um_variant_open_over(context, work->evaluator, &own_window, &changes.all, &heat, &v));
  UM_CHECK(um_variant_observe(context, work->evaluator, &v, &result));
  um_forecast_store(work, &v, result, coordinate[3], value);
  if (work->unknowns.n > 0)
    UM_CHECK(um_forecast_sigma(context, work, &own_window, coordinate[3],
                               coordinate[1] == work->checked, &v, value));
done:
  um_model_result_destroy(context, &result);
  um_variant_close(context, &v);
  um_forecast_changes_clear(context, &changes);
  return status;
}
