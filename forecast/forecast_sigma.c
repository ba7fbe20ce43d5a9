/* Error bars of a pass: to first order in what is uncertain,
 *
 *   sigma^2 = sum_p d_p^2,   d_p = (v(p + sigma_p) - v(p - sigma_p)) / 2
 *
 * of every value v that is kept of the pass. Both sides are variants of the pass itself: its
 * geometry serves those that leave it the same, heat starts from that of the pass. Where a
 * parameter ends (a factor at its bound), or a side is refused, the side that exists gives the
 * difference from the pass as it stands.
 *
 * Differences are of the model, not of its sampling: a facet is looked at by the same points in all
 * variants, since these are drawn by index, and their error falls out. Where lines of sight move
 * (attitude, sizes) it does not wholly; what is left is at most the stated Monte-Carlo error. */
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "forecast/forecast_impl.h"

/* Heat that is solved to be differenced: tolerances of a run of its own, and the repeating state so
 * near that a bar of a kelvin is good to a few thousandths. */
static const struct um_variant_heat near = {.start = UM_VARIANT_WARM, .tolerance = {1.0, 1e-3}};

/* The pass, and what is made of it. */
struct work {
  const struct um_forecast_work *of;
  struct um_variant_evaluator *evaluator; /* of the pass */
  struct um_variant base;
  struct um_forecast_tangents tangents;
  double culmination;
  size_t nvalue;
  const double *stands; /* [nvalue] of the pass as it stands */
  double *solved;       /* [nvalue] the same with heat as `near`; has_solved: it is known */
  bool has_solved;
  double *side[2]; /* [nvalue] with a parameter below and above */
  double step[2];  /* [its unit] how far that is; 0: there is no such side */
  bool ran;        /* their heat was solved */
};

static enum um_status observe(struct um_context *context, const struct work *w,
                              const struct um_variant *v, double *value)
{
  struct um_model_result *result = NULL;
  UM_TRY(um_variant_observe(context, w->evaluator, v, &result));
  um_forecast_store(w->of, v, result, w->culmination, value);
  um_model_result_destroy(context, &result);
  return UM_OK;
}

/* The pass as it stands, with heat that is solved as that of its variants. */
static enum um_status solve_base(struct um_context *context, struct work *w)
{
  struct um_variant own = w->base;
  if (w->has_solved) return UM_OK;
  enum um_status status = um_variant_heat_again(context, w->evaluator, &near, &own);
  if (status == UM_OK) status = observe(context, w, &own, w->solved);
  um_variant_close(context, &own);
  w->has_solved = status == UM_OK;
  return status;
}

/* Values with a parameter moved by `step`, signed; tangent: how its heat answers, or NULL. *ran: it
 * was solved. */
static enum um_status look(struct um_context *context, const struct work *w, size_t which,
                           double step, const struct um_forecast_tangent *tangent, double *value,
                           bool *ran)
{
  enum um_status status;
  const struct um_study_binding *binding = &w->of->unknowns.binding[which];
  const double at = binding->nominal + step;
  struct um_variant_heat heat = near;
  struct um_study_changes changes;
  struct um_variant v = {0};
  if (tangent != NULL && tangent->of != NULL)
    heat = (struct um_variant_heat){.start = UM_VARIANT_EXTRAPOLATED,
                                    .sensitivity = tangent->of,
                                    .which = tangent->which,
                                    .step = step};
  UM_CHECK(um_study_changes_make(context, w->base.model, binding, 1, &at, &changes));
  UM_CHECK(um_variant_open(context, w->evaluator, &changes.all, &heat, &v));
  if (v.tables->nobs != w->base.tables->nobs)
    UM_CHECK(um_core_fail(context, UM_ERR_INPUT, "it moves the instants of the pass"));
  *ran = v.heat != w->base.heat && heat.start == UM_VARIANT_WARM;
  UM_CHECK(observe(context, w, &v, value));
done:
  um_variant_close(context, &v);
  um_study_changes_clear(context, &changes);
  return status;
}

/* Both sides of a parameter, as far as they exist. */
static enum um_status look_around(struct um_context *context, struct work *w, size_t which)
{
  enum um_status status = UM_OK;
  bool ran = false;
  w->ran = false;
  for (int side = 0; side < 2; side++) {
    double step = um_forecast_uncertain_step(&w->of->unknowns, which, side);
    w->step[side] = 0.0;
    if (!(step > 0.0)) continue;
    um_core_message_clear(context);
    status = look(context, w, which, side == 0 ? -step : step, &w->tangents.of[which],
                  w->side[side], &ran);
    if (status == UM_OK) w->step[side] = step;
    if (status != UM_OK && !um_forecast_is_of_changes(status)) return status;
    w->ran = w->ran || (status == UM_OK && ran);
  }
  if (w->step[0] > 0.0 || w->step[1] > 0.0) {
    um_core_message_clear(context);
    return w->ran ? solve_base(context, w) : UM_OK;
  }
  um_core_message_prefix(context, "%s", w->of->unknowns.binding[which].name);
  return status;
}

/* What a value does at 1 sigma, signed; *bend: half of what its sides differ by, NaN with one. */
static double difference(const struct work *w, size_t k, double sigma, double *bend)
{
  double slope[2];
  const double *from = w->ran ? w->solved : w->stands;
  for (int side = 0; side < 2; side++) {
    double way = side == 0 ? -w->step[0] : w->step[1];
    slope[side] = w->step[side] > 0.0 ? (w->side[side][k] - from[k]) / way * sigma : (double)NAN;
    if (!isfinite(slope[side])) slope[side] = NAN;
  }
  *bend = 0.5 * fabs(slope[1] - slope[0]);
  if (isnan(slope[0])) return slope[1];
  return isnan(slope[1]) ? slope[0] : 0.5 * (slope[0] + slope[1]);
}

/* Where the value stands that a band or place is told by. */
static size_t told_at(const struct um_forecast_work *work, size_t i)
{
  const size_t one = sizeof(double), band = sizeof(struct um_forecast_band) / one;
  if (i >= work->nband)
    return 1 + work->nband * band +
           (i - work->nband) * sizeof(struct um_forecast_place) / one; /* its mean */
  return 1 + i * band +
         (work->thermal[i] ? offsetof(struct um_forecast_band, largest)
                           : offsetof(struct um_forecast_band, brightest)) /
             one;
}

/* A parameter into variances [nvalue], its parts and bends [told]. */
static void take(const struct work *w, size_t which, double *variance, double *part, double *bend)
{
  double sigma = w->of->unknowns.sigma[which], bent;
  for (size_t k = 0; k < w->nvalue; k++) {
    double d = difference(w, k, sigma, &bent);
    variance[k] += d * d;
  }
  for (size_t i = 0; i < um_forecast_told(w->of); i++)
    part[i] = difference(w, told_at(w->of, i), sigma, &bend[i]);
}

/* Bends [told] of a parameter whose heat was told by a tangent: of a solved pass, in place of one
 * of its sides. */
static enum um_status check(struct um_context *context, struct work *w, size_t which,
                            const double *part, double *bend)
{
  int side = w->step[1] > 0.0 ? 1 : 0;
  double way = side == 0 ? -w->step[0] : w->step[1];
  bool ran;
  UM_TRY(solve_base(context, w));
  UM_TRY(look(context, w, which, way, NULL, w->side[side], &ran));
  for (size_t i = 0; i < um_forecast_told(w->of); i++) {
    size_t k = told_at(w->of, i);
    double moved = w->side[side][k] - w->solved[k];
    bend[i] = fabs(moved / way * w->of->unknowns.sigma[which] - part[i]);
  }
  return UM_OK;
}

/* Times and errors have no sigma. */
static void forget(const struct um_forecast_work *work, double *sigma)
{
  *sigma++ = NAN;
  for (size_t b = 0; b < work->nband; b++) {
    struct um_forecast_band band;
    memcpy(&band, sigma, sizeof band);
    band.brightest_at = band.largest_at = band.error = NAN;
    memcpy(sigma, &band, sizeof band);
    sigma += sizeof band / sizeof *sigma;
  }
  sigma += work->nplace * sizeof(struct um_forecast_place) / sizeof *sigma;
  for (size_t i = 0; i < UM_FORECAST_CURVE; i++) sigma[i] = NAN;
}

/* A parameter after the other. */
static enum um_status take_all(struct um_context *context, struct work *w, bool checked,
                               double *variance, double *part, double *bend)
{
  size_t told = um_forecast_told(w->of);
  for (size_t i = 0; i < w->of->unknowns.n; i++, part += told, bend += told) {
    UM_TRY(um_core_stop_check(context, "error bars"));
    UM_TRY(look_around(context, w, i));
    take(w, i, variance, part, bend);
    if (w->tangents.of[i].of == NULL) continue;
    for (size_t k = 0; k < told; k++) bend[k] = NAN; /* of light alone */
    if (checked) UM_TRY(check(context, w, i, part, bend));
  }
  return UM_OK;
}

enum um_status um_forecast_sigma(struct um_context *context, const struct um_forecast_work *work,
                                 const struct um_model_instants *instants, double culmination,
                                 bool checked, const struct um_variant *variant, double *record)
{
  enum um_status status;
  struct work w = {.of = work,
                   .culmination = culmination,
                   .nvalue = um_forecast_values(work->nband, work->nplace),
                   .stands = record};
  struct um_model_instants same = *instants;
  const struct um_variant_settings settings = {.instants = &same, .bytes = 1};
  const size_t n = work->unknowns.n;
  double *sigma = record + w.nvalue, *part = sigma + w.nvalue,
         *bend = part + n * um_forecast_told(work);
  um_core_quiet_begin(context); /* what is to say of the pass was said */
  UM_CHECK(um_core_allocate(context, 3 * w.nvalue, sizeof *w.solved, &w.solved));
  w.side[0] = w.solved + w.nvalue;
  w.side[1] = w.solved + 2 * w.nvalue;
  same.sampling = variant->tables->sampling;
  memset(sigma, 0, w.nvalue * sizeof *sigma);
  UM_CHECK(um_variant_evaluator_of(context, variant, &settings, &w.evaluator));
  UM_CHECK(um_variant_base(context, w.evaluator, &w.base));
  UM_CHECK(um_forecast_tangents_find(context, &work->unknowns, w.evaluator, &w.base, &w.tangents));
  UM_CHECK(take_all(context, &w, checked, sigma, part, bend));
  for (size_t k = 0; k < w.nvalue; k++) sigma[k] = sqrt(sigma[k]);
  forget(work, sigma);
done:
  um_forecast_tangents_clear(context, &w.tangents);
  um_variant_evaluator_destroy(context, &w.evaluator);
  um_core_free(context, w.solved);
  um_core_quiet_end(context);
  return status;
}
