/* Generalised Lomb-Scargle periodogram (Zechmeister & Kuerster 2009, A&A 496, 577) and false-alarm
 * probability of its highest peak (Baluev 2008, MNRAS 385, 1279).
 *
 *   p(f) = (chi0^2 - chi^2(f)) / chi0^2
 *        = (SS YC^2 + CC YS^2 - 2 CS YC YS) / (YY D),  D = CC SS - CS^2           (ZK 5, 6)
 *
 * with sums over rows weighted by w_i ~ 1/sigma_i^2, sum w = 1, about their weighted means.
 * Probability of one frequency (1 - z)^((N-3)/2) (ZK 24); of a band of width F (Davies' bound)
 *
 *   FAP = 1 - (1 - (1-z)^((N-3)/2)) exp(-tau)
 *   tau = gamma(N-1) W (1-z)^((N-4)/2) sqrt((N-1) z / 2),  W = F sqrt(4 pi var t)
 *   gamma(n) = sqrt(2/n) Gamma(n/2) / Gamma((n-1)/2) */
#include <math.h>
#include <string.h>

#include "compare/series.h"
#include "compare/statistics_impl.h"
#include "core/constants.h"

#define FREQUENCIES_MAX  ((size_t)1 << 24)
#define OVERSAMPLING     10.0
#define REFINEMENT_STEPS 60 /* golden section: the bracket shrinks by 3e-13 */
#define DEGENERATE       1e-10
#define ROWS_MIN         5

/* A series about its means, with normalised weights. */
struct problem {
  size_t n;
  double *t, *y, *w;             /* [n]: t - origin [s]; y - offset; weights of sum 1 */
  double origin, offset, weight; /* mean time, mean value, sum of 1/sigma^2 */
  double yy, span, variance;     /* weighted mean of y^2; time spanned [s]; variance of t [s^2] */
};

/* a cos + b sin, about the value c at its mean. */
struct sine {
  double power, a, b, c;
};

static struct sine evaluate(const struct problem *p, double frequency)
{
  double c = 0.0, s = 0.0, yc = 0.0, ys = 0.0, cc = 0.0, cs = 0.0;
  for (size_t i = 0; i < p->n; i++) {
    double x = 2.0 * UM_PI * frequency * p->t[i], w = p->w[i];
    double cosine = cos(x), sine = sin(x);
    c += w * cosine;
    s += w * sine;
    yc += w * p->y[i] * cosine;
    ys += w * p->y[i] * sine;
    cc += w * cosine * cosine;
    cs += w * cosine * sine;
  }
  /* ZK 7-15; the mean of y is zero */
  double ss = 1.0 - cc - s * s;
  cc -= c * c;
  cs -= c * s;
  double d = cc * ss - cs * cs, sum = cc + ss;
  struct sine out = {0};
  if (d > DEGENERATE * sum * sum) {
    out.power = (ss * yc * yc + cc * ys * ys - 2.0 * cs * yc * ys) / (p->yy * d);
    out.a = (yc * ss - ys * cs) / d;
    out.b = (ys * cc - yc * cs) / d;
  } else if (sum > DEGENERATE) { /* as at half the sampling rate: only one phase is seen */
    if (cc >= ss)
      out.a = yc / cc;
    else
      out.b = ys / ss;
    out.power = (out.a * yc + out.b * ys) / p->yy;
  }
  out.power = fmin(1.0, fmax(0.0, out.power));
  out.c = p->offset - out.a * c - out.b * s;
  return out;
}

static void problem_free(struct um_context *context, struct problem *p)
{
  um_core_free(context, p->t);
  um_core_free(context, p->y);
  um_core_free(context, p->w);
}

/* Weights of sum 1, times and values about their weighted means, and their second moments. */
static void normalise(struct problem *p)
{
  double first = p->t[0], mean = 0.0;
  p->span = p->t[p->n - 1] - first;
  for (size_t i = 0; i < p->n; i++) p->weight += p->w[i];
  for (size_t i = 0; i < p->n; i++) {
    p->w[i] /= p->weight;
    mean += p->w[i] * (p->t[i] - first);
    p->offset += p->w[i] * p->y[i];
  }
  p->origin = first + mean;
  for (size_t i = 0; i < p->n; i++) {
    p->t[i] -= p->origin;
    p->y[i] -= p->offset;
    p->variance += p->w[i] * p->t[i] * p->t[i];
    p->yy += p->w[i] * p->y[i] * p->y[i];
  }
}

static enum um_status problem_set(struct um_context *context, const struct um_compare_series *s,
                                  struct problem *p)
{
  p->n = s->count;
  if (p->n < ROWS_MIN)
    return um_core_fail(context, UM_ERR_INPUT, "period search: %zu rows; accepted: %d or more",
                        p->n, ROWS_MIN);
  UM_TRY(um_core_allocate(context, p->n, sizeof *p->t, &p->t));
  UM_TRY(um_core_allocate(context, p->n, sizeof *p->y, &p->y));
  UM_TRY(um_core_allocate(context, p->n, sizeof *p->w, &p->w));
  double largest = 0.0;
  for (size_t i = 0; i < p->n; i++) {
    p->t[i] = s->t[i];
    p->y[i] = s->value[i];
    p->w[i] = s->sigma == NULL ? 1.0 : 1.0 / (s->sigma[i] * s->sigma[i]);
    largest = fmax(largest, fabs(p->y[i]));
  }
  normalise(p);
  if (!(p->span > 0.0))
    return um_core_fail(context, UM_ERR_INPUT,
                        "period search: all %zu rows at one time; accepted: times that differ",
                        p->n);
  if (!(sqrt(p->yy) > 1e-14 * largest))
    return um_core_fail(context, UM_ERR_INPUT,
                        "period search: all %zu values are equal; accepted: values that vary",
                        p->n);
  return UM_OK;
}

/* Half the inverse of the median step. */
static enum um_status nyquist(struct um_context *context, const struct problem *p, double *out)
{
  double *step;
  size_t n = 0;
  UM_TRY(um_core_allocate(context, p->n, sizeof *step, &step));
  for (size_t i = 1; i < p->n; i++)
    if (p->t[i] > p->t[i - 1]) step[n++] = p->t[i] - p->t[i - 1];
  *out = 0.5 / um_compare_median(n, step);
  um_core_free(context, step);
  return UM_OK;
}

static enum um_status choose_grid(struct um_context *context, const struct problem *p,
                                  const struct um_compare_period_options *options,
                                  struct um_compare_period_options *grid, size_t *count)
{
  *grid = options == NULL ? (struct um_compare_period_options){0} : *options;
  if (grid->frequency_min == 0.0) grid->frequency_min = 1.0 / p->span;
  if (grid->frequency_max == 0.0) UM_TRY(nyquist(context, p, &grid->frequency_max));
  if (grid->oversampling == 0.0) grid->oversampling = OVERSAMPLING;
  if (!(grid->frequency_min > 0.0) || !(grid->frequency_max > grid->frequency_min) ||
      !isfinite(grid->frequency_max))
    return um_core_fail(context, UM_ERR_INPUT,
                        "period search: frequencies from %g to %g Hz; accepted: above 0, from "
                        "below to",
                        grid->frequency_min, grid->frequency_max);
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

/* The peak of the power between two frequencies, by golden section. */
static double refine(const struct problem *p, double low, double high)
{
  const double golden = 0.61803398874989484820;
  double x1 = high - golden * (high - low), x2 = low + golden * (high - low);
  double p1 = evaluate(p, x1).power, p2 = evaluate(p, x2).power;
  for (int i = 0; i < REFINEMENT_STEPS; i++) {
    if (p1 >= p2) {
      high = x2;
      x2 = x1;
      p2 = p1;
      x1 = high - golden * (high - low);
      p1 = evaluate(p, x1).power;
    } else {
      low = x1;
      x1 = x2;
      p1 = p2;
      x2 = low + golden * (high - low);
      p2 = evaluate(p, x2).power;
    }
  }
  return 0.5 * (low + high);
}

static double false_alarm(const struct problem *p, double z, double width)
{
  if (z >= 1.0) return 0.0;
  double n = (double)p->n, log_rest = log1p(-z);
  double single = exp(0.5 * (n - 3.0) * log_rest);
  double log_gamma = 0.5 * log(2.0 / (n - 1.0)) + lgamma(0.5 * (n - 1.0)) - lgamma(0.5 * (n - 2.0));
  double tau = exp(log_gamma + 0.5 * (n - 4.0) * log_rest) * width *
               sqrt(4.0 * UM_PI * p->variance) * sqrt(0.5 * (n - 1.0) * z);
  /* 1 - (1 - single) exp(-tau), without cancellation */
  return fmin(1.0, single * exp(-tau) - expm1(-tau));
}

static void describe(const struct problem *p, double frequency, double width,
                     struct um_compare_period *out)
{
  struct sine s = evaluate(p, frequency);
  double n = (double)p->n;
  out->period = 1.0 / frequency;
  out->best_power = s.power;
  out->amplitude = hypot(s.a, s.b);
  out->offset = s.c;
  out->false_alarm = false_alarm(p, s.power, width);
  /* Fisher: var f = 2 s^2 / (N A^2 (2 pi)^2 var t), s^2 the residuals' variance; for even steps
   * Montgomery & O'Donoghue 1999, DSSN 13, 28 */
  double residual = (1.0 - s.power) * p->yy * n / (n - 4.0);
  double f_sigma = sqrt(2.0 * residual / n / p->variance) / (2.0 * UM_PI * out->amplitude);
  out->period_sigma = f_sigma / (frequency * frequency);
  /* the maximum nearest the origin, moved by whole periods to the first at or after the first row
   */
  double peak = atan2(s.b, s.a) / (2.0 * UM_PI * frequency);
  peak += ceil((p->t[0] - peak) / out->period) * out->period;
  out->epoch = p->origin + peak;
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
  struct problem p = {0};
  struct um_compare_period_options grid;
  struct um_compare_period *made = NULL;
  size_t count, best = 0;
  enum um_status status;
  *out = NULL;
  UM_CHECK(problem_set(context, series, &p));
  UM_CHECK(choose_grid(context, &p, options, &grid, &count));
  UM_CHECK(allocate_period(context, count, &made));
  double step = 1.0 / (grid.oversampling * p.span);
#pragma omp parallel for num_threads(um_core_context_threads(context)) schedule(static)
  for (size_t k = 0; k < count; k++) {
    double f = k + 1 < count ? grid.frequency_min + (double)k * step : grid.frequency_max;
    made->frequency[k] = fmin(f, grid.frequency_max);
    made->power[k] = evaluate(&p, made->frequency[k]).power;
  }
  for (size_t k = 1; k < count; k++)
    if (made->power[k] > made->power[best]) best = k;
  double low = made->frequency[best > 0 ? best - 1 : 0];
  double high = made->frequency[best + 1 < count ? best + 1 : best];
  /* where the power is flat to rounding, as at half the sampling rate, the grid stands */
  double frequency = refine(&p, low, high);
  if (!(evaluate(&p, frequency).power > made->power[best] + 1e-14))
    frequency = made->frequency[best];
  describe(&p, frequency, grid.frequency_max - grid.frequency_min, made);
  *out = made;
  made = NULL;
done:
  um_compare_period_destroy(context, &made);
  problem_free(context, &p);
  return status;
}

void um_compare_period_destroy(struct um_context *context, struct um_compare_period **period)
{
  if (period == NULL || *period == NULL) return;
  um_core_free(context, (*period)->frequency);
  um_core_free(context, (*period)->power);
  um_core_free(context, *period);
  *period = NULL;
}
