/* Values that a point may have. Records are files: what they hold is looked at as any input is. */
#include <math.h>
#include <string.h>

#include "study/forecast_impl.h"
#include "study/study_impl.h"

/* Effects that change readings may take more away than there is; those that are on by default do
 * not. */
static bool changes_readings(const struct um_effect *effect)
{
  return effect != NULL && effect->hooks.observation != NULL && !effect->on_by_default;
}

bool um_study_light_has_sign(const struct um_model *model)
{
  for (size_t i = 0; i < model->neffect; i++)
    if (!model->effect[i].off && changes_readings(model->effect[i].effect)) return true;
  return false;
}

/* Light [W/m^2], or nothing that is seen. */
static bool is_light(double value, bool has_sign)
{
  return isnan(value) || (isfinite(value) && (has_sign || value >= 0.0));
}

static bool is_temperature(double value) { return isfinite(value) && value > 0.0; }

/* No light is an infinite magnitude; an infinite light is none. */
static bool is_magnitude(double value) { return !(value == -(double)INFINITY); }

/* --- a study --------------------------------------------------------------------------------- */

bool um_study_accepts(void *user, const double *parameter, const double *value)
{
  const struct um_study *study = user;
  bool has_sign = um_study_light_has_sign(study->model), same_sight = true;
  (void)parameter;
  for (size_t i = 0; i < study->nway; i++) {
    has_sign = has_sign || changes_readings(study->way[i].effect);
    same_sight = same_sight && !study->moves_geometry[i];
  }
  for (size_t i = 0; i < study->nvalue; i++) {
    switch (study->output[i / study->ntime].kind) {
    case UM_STUDY_TEMPERATURE:
      if (!is_temperature(value[i])) return false;
      break;
    case UM_STUDY_IRRADIANCE:
      if (!is_light(value[i], has_sign)) return false;
      if (same_sight && isnan(value[i]) != isnan(study->nominal[i])) return false;
      break;
    case UM_STUDY_MAGNITUDE:
      if (isinf(value[i])) return false;
      break;
    }
  }
  return true;
}

/* --- a forecast ------------------------------------------------------------------------------ */

static bool is_band(const struct um_study_forecast_band *b, double from, double to, bool has_sign)
{
  bool seen = !isnan(b->brightest), lit = !isnan(b->largest);
  return (!seen || isfinite(b->brightest)) && seen == !isnan(b->brightest_at) &&
         (!seen || (b->brightest_at >= from && b->brightest_at <= to)) &&
         is_magnitude(b->culmination) && is_light(b->largest, has_sign) &&
         lit == !isnan(b->largest_at) && (!lit || (b->largest_at >= from && b->largest_at <= to)) &&
         is_light(b->irradiance_culmination, has_sign) && isfinite(b->intensity) &&
         b->intensity >= 0.0 && !(b->error < 0.0);
}

static bool is_place(const struct um_study_forecast_place *p)
{
  const double rounding = 1e-9;
  return is_temperature(p->lowest) && is_temperature(p->highest) && is_temperature(p->mean) &&
         p->mean >= p->lowest * (1.0 - rounding) && p->mean <= p->highest * (1.0 + rounding);
}

static bool is_curve(const double *at, const double *curve, size_t nband, bool has_sign)
{
  const size_t n = UM_STUDY_FORECAST_CURVE;
  for (size_t k = 0; k < n; k++) {
    if (!isfinite(at[k]) || (k > 0 && at[k] < at[k - 1])) return false;
    for (size_t b = 0; b < nband; b++)
      if (!is_magnitude(curve[2 * b * n + k]) || !is_light(curve[(2 * b + 1) * n + k], has_sign))
        return false;
  }
  return true;
}

bool um_study_forecast_accepts(void *user, const double *coordinate, const double *value)
{
  const struct um_study_forecast_work *work = user;
  struct um_study_forecast_band band;
  struct um_study_forecast_place place;
  const double delay = *value++, *at = value;
  at += work->nband * sizeof band / sizeof *at + work->nplace * sizeof place / sizeof *at;
  const double from = at[0], to = at[UM_STUDY_FORECAST_CURVE - 1];
  (void)coordinate;
  if (delay < 0.0 || isinf(delay)) return false;
  if (!is_curve(at, at + UM_STUDY_FORECAST_CURVE, work->nband, work->light_has_sign)) return false;
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
