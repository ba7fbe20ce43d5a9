/* Generalised Lomb-Scargle periodogram with trend and red noise, and false-alarm probability of its
 * highest peak (Baluev 2008, MNRAS 385, 1279).
 *
 *   p(f) = (chi0^2 - chi^2(f)) / chi0^2
 *
 * in what the filter of period_noise.c has made white and rid of trends of p terms together; N = n
 * - p + 1 takes the place of the number of observations, so that p = 1 is the floating mean.
 * Probability of one frequency (1 - z)^((N-3)/2); of a band of width F (Davies' bound)
 *
 *   FAP = 1 - (1 - (1-z)^((N-3)/2)) exp(-tau)
 *   tau = gamma(N-1) W (1-z)^((N-4)/2) sqrt((N-1) z / 2),  W = F sqrt(4 pi var t)
 *   gamma(n) = sqrt(2/n) Gamma(n/2) / Gamma((n-1)/2) */
#include "evidence/inversion/period.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/golden.h"
#include "evidence/comparison/statistics_group.h"
#include "evidence/inversion/period_noise_impl.h"

#define FREQUENCIES_MAX  ((size_t)1 << 24)
#define OVERSAMPLING     10.0
#define REFINEMENT_STEPS 60 /* golden section: the bracket shrinks by 3e-13 */
#define OBSERVATIONS_MIN 5
#define FREE_MIN         4    /* observations beside the trends */
#define CURVATURE_STEP   0.02 /* of 1/span */

static enum um_status check_series(struct um_context *context, const struct um_compare_series *s)
{
  bool moves = false, varies = false;
  double largest = 0.0;
  if (s->count < OBSERVATIONS_MIN)
    return um_core_fail(context, UM_ERR_INPUT,
                        "period search: %zu observations; accepted: %d or more", s->count,
                        OBSERVATIONS_MIN);
  for (size_t i = 0; i < s->count; i++) {
    moves = moves || s->t[i] != s->t[0];
    largest = fmax(largest, fabs(s->value[i]));
  }
  for (size_t i = 0; i < s->count; i++)
    varies = varies || fabs(s->value[i] - s->value[0]) > 1e-14 * largest;
  if (!moves)
    return um_core_fail(
        context, UM_ERR_INPUT,
        "period search: all %zu observations at one time; accepted: times that differ", s->count);
  if (!varies)
    return um_core_fail(context, UM_ERR_INPUT,
                        "period search: all %zu values are equal; accepted: values that vary",
                        s->count);
  return UM_OK;
}

static enum um_status check_curve(struct um_context *context, const struct um_compare_curve *c)
{
  if (c->n >= c->nterm + FREE_MIN && c->longest > 0.0) return UM_OK;
  return um_core_fail(
      context, UM_ERR_INPUT,
      "period search: %zu observations in %zu tracks, whose trends take %zu; accepted: %d "
      "observations more than that, and a track that lasts",
      c->n, c->nblock, c->nterm, FREE_MIN);
}

/* Half the inverse of the median step. */
static enum um_status nyquist(struct um_context *context, const struct um_compare_series *s,
                              double *out)
{
  double *step;
  size_t n = 0;
  UM_TRY(um_core_allocate(context, s->count, sizeof *step, &step));
  for (size_t i = 1; i < s->count; i++)
    if (s->t[i] > s->t[i - 1]) step[n++] = s->t[i] - s->t[i - 1];
  *out = 0.5 / um_compare_median(n, step);
  um_core_free(context, step);
  return UM_OK;
}

static enum um_status choose_grid(struct um_context *context, const struct um_compare_series *s,
                                  const struct um_compare_curve *p,
                                  const struct um_compare_period_options *options,
                                  struct um_compare_period_options *grid, size_t *count)
{
  *grid = options == NULL ? (struct um_compare_period_options){0} : *options;
  if (grid->frequency_min == 0.0) grid->frequency_min = 2.0 / p->longest;
  if (grid->frequency_max == 0.0) UM_TRY(nyquist(context, s, &grid->frequency_max));
  if (grid->oversampling == 0.0) grid->oversampling = OVERSAMPLING;
  if (!(grid->frequency_min > 0.0) || !(grid->frequency_max > grid->frequency_min) ||
      !isfinite(grid->frequency_max))
    return um_core_fail(context, UM_ERR_INPUT,
                        "period search: frequencies from %g to %g Hz; accepted: above 0, from "
                        "below to",
                        grid->frequency_min, grid->frequency_max);
  if (!(grid->frequency_min >= (1.0 - 1e-9) * 2.0 / p->longest))
    return um_core_fail(context, UM_ERR_INPUT,
                        "period search: frequencies from %g Hz; accepted: %g Hz or more, two turns "
                        "in the %g s of the longest track",
                        grid->frequency_min, 2.0 / p->longest, p->longest);
  if (!(grid->oversampling >= 1.0) || !isfinite(grid->oversampling))
    return um_core_fail(context, UM_ERR_INPUT,
                        "period search: oversampling %g; accepted: 1 or more", grid->oversampling);
  double steps = (grid->frequency_max - grid->frequency_min) * p->span * grid->oversampling;
  if (!(steps < (double)FREQUENCIES_MAX - 2.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "period search: %.3g frequencies over %g s; accepted: at most %zu (narrow "
                        "the frequencies or take one track)",
                        steps, p->span, FREQUENCIES_MAX);
  *count = (size_t)floor(steps) + 2; /* the last stands at frequency_max */
  return UM_OK;
}

static double power(const struct um_compare_white *w, double frequency)
{
  return um_compare_white_sine(w, frequency).power;
}

/* The peak of the power between two frequencies, by golden section. */
static double refine(const struct um_compare_white *w, double low, double high)
{
  struct um_core_golden g = um_core_golden(low, high);
  double p[2] = {power(w, g.x[0]), power(w, g.x[1])};
  for (int i = 0; i < REFINEMENT_STEPS; i++) {
    int k = um_core_golden_narrow(&g, p[0] >= p[1]);
    p[1 - k] = p[k];
    p[k] = power(w, g.x[k]);
  }
  return 0.5 * (g.from + g.to);
}

static double false_alarm(const struct um_compare_curve *c, double z, double width)
{
  if (z >= 1.0) return 0.0;
  double n = (double)(c->n - c->nterm) + 1.0, log_rest = log1p(-z);
  double single = exp(0.5 * (n - 3.0) * log_rest);
  double log_gamma = 0.5 * log(2.0 / (n - 1.0)) + lgamma(0.5 * (n - 1.0)) - lgamma(0.5 * (n - 2.0));
  double tau = exp(log_gamma + 0.5 * (n - 4.0) * log_rest) * width *
               sqrt(4.0 * UM_PI * c->variance) * sqrt(0.5 * (n - 1.0) * z);
  /* 1 - (1 - single) exp(-tau), without cancellation */
  return fmin(1.0, single * exp(-tau) - expm1(-tau));
}

/* Standard deviation of the frequency: 2 s^2 over the curvature of chi-square. */
static double frequency_sigma(const struct um_compare_white *w, double frequency)
{
  const struct um_compare_curve *c = w->curve;
  double h = CURVATURE_STEP / c->span, middle = power(w, frequency);
  double bend = 2.0 * middle - power(w, frequency - h) - power(w, frequency + h);
  double dof = (double)(c->n - c->nterm) - 3.0;
  if (!(bend > 0.0) || !(dof > 0.0)) return NAN;
  return sqrt(2.0 * (1.0 - middle) / dof / (bend / (h * h)));
}

/* The sine in the noise that is left beside it; white is set for that. */
static void describe(struct um_compare_white *white, double frequency,
                     struct um_compare_period *out)
{
  const struct um_compare_curve *c = white->curve;
  struct um_compare_red beside;
  double minus2, weight = 0.0;
  um_compare_red_fit(white, frequency, &beside, &minus2);
  struct um_compare_sine s = um_compare_white_sine(white, frequency);
  out->period = 1.0 / frequency;
  out->period_sigma = frequency_sigma(white, frequency) / (frequency * frequency);
  out->amplitude = hypot(s.a, s.b);
  out->offset = 0.0;
  for (size_t i = 0; i < c->n; i++) {
    double x = 2.0 * UM_PI * frequency * c->t[i];
    out->offset += (c->y[i] - s.a * cos(x) - s.b * sin(x)) / c->g[i];
    weight += 1.0 / c->g[i];
  }
  out->offset = c->offset + out->offset / weight;
  /* the maximum nearest the origin, moved by whole periods to the first at or after the first
   * observation */
  double peak = atan2(s.b, s.a) / (2.0 * UM_PI * frequency);
  peak += ceil((c->first - peak) / out->period) * out->period;
  out->epoch = c->origin + peak;
}

static enum um_status allocate_period(struct um_context *context, size_t count,
                                      struct um_compare_period **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  (*out)->count = count;
  UM_TRY(um_core_allocate(context, count, sizeof *(*out)->frequency, &(*out)->frequency));
  return um_core_allocate(context, count, sizeof *(*out)->power, &(*out)->power);
}

enum um_status um_compare_period_search(struct um_context *context,
                                        const struct um_compare_series *series,
                                        const struct um_compare_period_options *options,
                                        struct um_compare_period **out)
{
  struct um_compare_curve *curve = NULL;
  struct um_compare_white *white = NULL;
  struct um_compare_period_options grid;
  struct um_compare_period *made = NULL;
  struct um_compare_red red;
  double minus2;
  size_t count, best = 0;
  enum um_status status;
  *out = NULL;
  UM_CHECK(check_series(context, series));
  UM_CHECK(um_compare_curve_create(context, series, &curve));
  UM_CHECK(check_curve(context, curve));
  UM_CHECK(choose_grid(context, series, curve, options, &grid, &count));
  UM_CHECK(allocate_period(context, count, &made));
  UM_CHECK(um_compare_white_create(context, curve, &white));
  um_compare_red_fit(white, 0.0, &red, &minus2);
  double step = 1.0 / (grid.oversampling * curve->span);
#pragma omp parallel for num_threads(um_core_context_threads(context)) schedule(static)
  for (size_t k = 0; k < count; k++) {
    if (um_core_stopped(context)) continue;
    double f = k + 1 < count ? grid.frequency_min + (double)k * step : grid.frequency_max;
    made->frequency[k] = fmin(f, grid.frequency_max);
    made->power[k] = power(white, made->frequency[k]);
  }
  UM_CHECK(um_core_stop_check(context, "periods were searched"));
  for (size_t k = 1; k < count; k++)
    if (made->power[k] > made->power[best]) best = k;
  double low = made->frequency[best > 0 ? best - 1 : 0];
  double high = made->frequency[best + 1 < count ? best + 1 : best];
  /* where the power is flat to rounding, as at half the sampling rate, the grid stands */
  double frequency = refine(white, low, high);
  if (!(power(white, frequency) > made->power[best] + 1e-14)) frequency = made->frequency[best];
  made->best_power = power(white, frequency);
  made->false_alarm = false_alarm(curve, made->best_power, grid.frequency_max - grid.frequency_min);
  made->red = red.red;
  made->red_time = red.red > 0.0 ? red.tau : (double)NAN;
  made->trend_terms = curve->nterm;
  describe(white, frequency, made);
  *out = made;
  made = NULL;
done:
  um_compare_period_destroy(context, &made);
  um_compare_white_destroy(context, &white);
  um_compare_curve_destroy(context, &curve);
  return status;
}

void um_compare_period_destroy(struct um_context *context, struct um_compare_period **period)
{
  if (period == NULL || *period == NULL) return;
  UM_FREE(context, (*period)->frequency, (*period)->power, *period);
  *period = NULL;
}
