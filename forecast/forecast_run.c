/* The runs of a forecast, and their values given to its passes. */
#include <math.h>
#include <string.h>

#include "forecast/forecast_impl.h"

/* From AB, which is on record, to the systems of the bands. */
static void take_system(const struct um_forecast *f, struct um_forecast_band *band, double *curve)
{
  const size_t n = UM_FORECAST_CURVE;
  for (size_t b = 0; b < f->nband; b++) {
    if (isnan(f->vega_ab[b])) continue;
    band[b].brightest -= f->vega_ab[b];
    band[b].culmination -= f->vega_ab[b];
    for (size_t k = 0; k < n; k++) curve[2 * b * n + k] -= f->vega_ab[b];
  }
}

/* Bands and places out of a record, where they stand in typed arrays; what is behind them. */
static double *take_arrays(const struct um_forecast *f, double *value,
                           struct um_forecast_band *band, struct um_forecast_place *place)
{
  memcpy(band, value, f->nband * sizeof *band);
  value += f->nband * sizeof *band / sizeof *value;
  memcpy(place, value, f->nplace * sizeof *place);
  return value + f->nplace * sizeof *place / sizeof *value;
}

/* Of what is uncertain, behind the values of a pass. */
static void take_sigmas(struct um_forecast_held *h, size_t i, double *record)
{
  struct um_forecast *f = &h->forecast;
  struct um_forecast_pass *pass = &f->pass[i];
  size_t nvalue = um_forecast_values(f->nband, f->nplace);
  struct um_forecast_band *band = h->band_sigma + i * f->nband;
  struct um_forecast_place *place = h->places_sigma + i * f->nplace;
  pass->curve_sigma = take_arrays(f, record + 1, band, place) + UM_FORECAST_CURVE;
  pass->band_sigma = band;
  pass->place_sigma = place;
  pass->part = record + nvalue;
  pass->bend = pass->part + f->nuncertain * (f->nband + f->nplace);
}

/* Give every pass its part of the values. */
static void take_values(struct um_forecast_held *h, size_t nrecord)
{
  struct um_forecast *f = &h->forecast;
  size_t nvalue = um_forecast_values(f->nband, f->nplace);
  for (size_t i = 0; i < f->npass; i++) {
    double *value = f->value + i * nrecord;
    struct um_forecast_pass *pass = &f->pass[i];
    struct um_forecast_band *band = h->band + i * f->nband;
    struct um_forecast_place *place = h->places + i * f->nplace;
    pass->delay = *value;
    if (f->nuncertain > 0) take_sigmas(h, i, value + nvalue);
    value = take_arrays(f, value + 1, band, place);
    pass->band = band;
    pass->place = place;
    pass->curve_at = value;
    pass->curve = value + UM_FORECAST_CURVE;
    take_system(f, band, value + UM_FORECAST_CURVE);
  }
}

enum um_status um_forecast_run(struct um_context *context, struct um_forecast *forecast,
                               struct um_batch *batch)
{
  enum um_status status;
  struct um_forecast_held *h = (struct um_forecast_held *)(void *)forecast; /* its first member */
  struct um_forecast *f = forecast;
  size_t nvalue = um_forecast_record(&h->work), sigmas = f->nuncertain > 0 ? f->npass : 0;
  char **reason = NULL;
  struct um_variant base;
  UM_CHECK(um_core_allocate(context, f->npass, UM_FORECAST_COORDINATES * sizeof(double),
                            &h->coordinate));
  UM_CHECK(um_core_allocate(context, f->npass, nvalue * sizeof(double), &f->value));
  UM_CHECK(um_core_allocate(context, f->npass * f->nband, sizeof *h->band, &h->band));
  UM_CHECK(um_core_allocate(context, f->npass * f->nplace, sizeof *h->places, &h->places));
  UM_CHECK(um_core_allocate(context, sigmas * f->nband, sizeof *h->band_sigma, &h->band_sigma));
  UM_CHECK(
      um_core_allocate(context, sigmas * f->nplace, sizeof *h->places_sigma, &h->places_sigma));
  UM_CHECK(um_core_allocate(context, f->npass, sizeof *reason, &reason));
  for (size_t i = 0; i < f->npass; i++) {
    const struct um_forecast_pass *p = &f->pass[i];
    const double at[] = {(double)p->station, p->start, p->stop, p->pass.culmination};
    memcpy(h->coordinate + i * UM_FORECAST_COORDINATES, at, sizeof at);
  }
  if (f->npass > 0 && h->model->scenario->thermal->start == UM_START_PERIODIC)
    UM_CHECK(um_variant_base(context, h->work.evaluator, &base)); /* before workers need it */
  UM_CHECK(um_batch_run(context, batch, h->coordinate, f->npass, f->value, reason));
  for (size_t i = 0; i < f->npass; i++) f->pass[i].reason = reason[i];
  um_batch_tell_lost(context, batch, h->coordinate, f->npass, "passes.csv: row", 1);
  take_values(h, nvalue);
  um_forecast_tell_bends(context, f);
done:
  um_core_free(context, reason);
  return status;
}
