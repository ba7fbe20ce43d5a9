/* Values that a pass may have. Records are files: what they hold is looked at as any input is. */
#include <math.h>
#include <string.h>

#include "forecast/forecast_impl.h"
#include "study/accepts.h"

static bool is_band(const struct um_forecast_band *b, double from, double to, bool has_sign)
{
  bool seen = !isnan(b->brightest), lit = !isnan(b->largest);
  return (!seen || isfinite(b->brightest)) && seen == !isnan(b->brightest_at) &&
         (!seen || (b->brightest_at >= from && b->brightest_at <= to)) &&
         um_study_is_magnitude(b->culmination) && um_study_is_light(b->largest, has_sign) &&
         lit == !isnan(b->largest_at) && (!lit || (b->largest_at >= from && b->largest_at <= to)) &&
         um_study_is_light(b->irradiance_culmination, has_sign) && isfinite(b->intensity) &&
         b->intensity >= 0.0 && !(b->error < 0.0);
}

static bool is_place(const struct um_forecast_place *p)
{
  const double rounding = 1e-9;
  return um_study_is_temperature(p->lowest) && um_study_is_temperature(p->highest) &&
         um_study_is_temperature(p->mean) && p->mean >= p->lowest * (1.0 - rounding) &&
         p->mean <= p->highest * (1.0 + rounding);
}

static bool is_curve(const double *at, const double *curve, size_t nband, bool has_sign)
{
  const size_t n = UM_FORECAST_CURVE;
  for (size_t k = 0; k < n; k++) {
    if (!isfinite(at[k]) || (k > 0 && at[k] < at[k - 1])) return false;
    for (size_t b = 0; b < nband; b++)
      if (!um_study_is_magnitude(curve[2 * b * n + k]) ||
          !um_study_is_light(curve[(2 * b + 1) * n + k], has_sign))
        return false;
  }
  return true;
}

/* Behind the values: what is uncertain. */
static bool are_sigmas(const struct um_forecast_work *work, const double *sigma)
{
  size_t n = um_forecast_values(work->nband, work->nplace), all = um_forecast_record(work) - n;
  for (size_t k = 0; k < all; k++) /* parts of parameters have a sign */
    if (isinf(sigma[k]) || (k < n && sigma[k] < 0.0)) return false;
  return true;
}

bool um_forecast_accepts(void *user, const double *coordinate, const double *value)
{
  const struct um_forecast_work *work = user;
  struct um_forecast_band band;
  struct um_forecast_place place;
  if (!are_sigmas(work, value + um_forecast_values(work->nband, work->nplace))) return false;
  const double delay = *value++, *at = value;
  at += work->nband * sizeof band / sizeof *at + work->nplace * sizeof place / sizeof *at;
  const double from = at[0], to = at[UM_FORECAST_CURVE - 1];
  (void)coordinate;
  if (delay < 0.0 || isinf(delay)) return false;
  if (!is_curve(at, at + UM_FORECAST_CURVE, work->nband, work->light_has_sign)) return false;
  for (size_t b = 0; b < work->nband; b++, value += sizeof band / sizeof *value) {
    memcpy(&band, value, sizeof band);
    if (!is_band(&band, from, to, work->light_has_sign)) return false;
  }
  for (size_t p = 0; p < work->nplace; p++, value += sizeof place / sizeof *value) {
    memcpy(&place, value, sizeof place);
    if (!is_place(&place)) return false;
  }
  return true;
}
