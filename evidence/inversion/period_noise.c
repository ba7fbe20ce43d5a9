/* Trend and red noise of light curves.
 *
 * y = trend + sine + e. The trend is a polynomial in time for every track: a constant below 8
 * observations, and a degree more each time there are half as many again (12, 18, 27, ...), up to
 * the seventh at 90. It takes what range, phase angle, airmass and one broad glint do over a pass.
 * e is white noise of the stated shape and unknown size beside an Ornstein-Uhlenbeck process: what
 * trend, sine and shadow leave is correlated between neighbours, and white noise would call it a
 * period. A Kalman filter makes e white in n steps for given red and tau (Kelly et al. 2009, ApJ
 * 698, 895, appendix, with measurement errors); everything linear goes through the same filter. Red
 * and tau are those of largest restricted likelihood (Harville 1977, JASA 72, 320)
 *
 *   -2 ln L = (n - p) ln chi2 + ln det V + ln det(X' V^-1 X)
 *
 * on a grid, factors of two in tau from the mean step to the longest track, of four in red. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "evidence/inversion/period_noise_impl.h"

#define RED_FIRST  0.0625 /* of the white variance */
#define RED_FACTOR 4.0
#define RED_STEPS  11
#define TAU_FACTOR 2.0
#define DEGENERATE 1e-10
#define NOTHING    1e-26 /* of the variance: rounding */

/* --- curve ----------------------------------------------------------------------------------- */

struct sorted {
  size_t track, row;
  double t;
};

static int compare_sorted(const void *a, const void *b)
{
  const struct sorted *x = a, *y = b;
  if (x->track != y->track) return x->track < y->track ? -1 : 1;
  if (x->t != y->t) return x->t < y->t ? -1 : 1;
  return x->row < y->row ? -1 : x->row > y->row;
}

/* Blocks of the sorted observations, and how many terms their trends have. */
static void find_blocks(const struct sorted *row, struct um_compare_curve *c)
{
  for (size_t i = 0, end; i < c->n; i = end) {
    for (end = i + 1; end < c->n && row[end].track == row[i].track;) end++;
    struct um_compare_block *b = &c->block[c->nblock++];
    *b = (struct um_compare_block){.first = i, .count = end - i, .nterm = 1};
    for (size_t need = 8; b->nterm < UM_COMPARE_TREND_MAX && b->count >= need; need += need / 2)
      b->nterm++;
    c->nterm += b->nterm;
    c->longest = fmax(c->longest, row[end - 1].t - row[i].t);
  }
}

/* Times and values about their weighted means; weights of mean 1. */
static void normalise(struct um_compare_curve *c)
{
  double sum = 0.0, t0 = c->t[0], mean = 0.0, low = INFINITY, high = -INFINITY;
  for (size_t i = 0; i < c->n; i++) sum += 1.0 / c->g[i];
  for (size_t i = 0; i < c->n; i++) {
    double w = 1.0 / c->g[i] / sum;
    mean += w * (c->t[i] - t0);
    c->offset += w * c->y[i];
  }
  c->origin = t0 + mean;
  for (size_t i = 0; i < c->n; i++) {
    double w = 1.0 / c->g[i] / sum;
    c->t[i] -= c->origin;
    c->y[i] -= c->offset;
    c->variance += w * c->t[i] * c->t[i];
    c->yy += w * c->y[i] * c->y[i];
    low = fmin(low, c->t[i]);
    high = fmax(high, c->t[i]);
  }
  for (size_t i = 0; i < c->n; i++) c->g[i] *= sum / (double)c->n;
  c->first = low;
  c->span = high - low;
}

enum um_status um_compare_curve_create(struct um_context *context,
                                       const struct um_compare_series *s,
                                       struct um_compare_curve **out)
{
  struct um_compare_curve *c = NULL;
  struct sorted *row = NULL;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *c, &c));
  UM_CHECK(um_core_allocate(context, s->count, sizeof *row, &row));
  UM_CHECK(um_core_allocate(context, s->count, sizeof *c->block, &c->block));
  UM_CHECK(um_core_allocate(context, s->count, sizeof *c->t, &c->t));
  UM_CHECK(um_core_allocate(context, s->count, sizeof *c->y, &c->y));
  UM_CHECK(um_core_allocate(context, s->count, sizeof *c->g, &c->g));
  UM_CHECK(um_core_allocate(context, s->count, sizeof *c->row, &c->row));
  c->n = s->count;
  for (size_t i = 0; i < c->n; i++)
    row[i] = (struct sorted){s->track == NULL ? 0 : s->track[i], i, s->t[i]};
  qsort(row, c->n, sizeof *row, compare_sorted);
  find_blocks(row, c);
  for (size_t i = 0; i < c->n; i++) {
    size_t k = row[i].row;
    c->t[i] = s->t[k];
    c->y[i] = s->value[k];
    c->g[i] = s->sigma == NULL ? 1.0 : s->sigma[k] * s->sigma[k];
    c->row[i] = k;
  }
  normalise(c);
  *out = c;
  c = NULL;
done:
  um_core_free(context, row);
  um_compare_curve_destroy(context, &c);
  return status;
}

void um_compare_curve_destroy(struct um_context *context, struct um_compare_curve **curve)
{
  if (curve == NULL || *curve == NULL) return;
  UM_FREE(context, (*curve)->block, (*curve)->t, (*curve)->y, (*curve)->g, (*curve)->row, *curve);
  *curve = NULL;
}

/* --- whitening ------------------------------------------------------------------------------- */

/* Powers of time, which no noise changes: once for all noises that are tried. */
static void set_powers(struct um_compare_white *w)
{
  const struct um_compare_curve *c = w->curve;
  for (size_t k = 0; k < c->nblock; k++) {
    const struct um_compare_block *b = &c->block[k];
    double from = c->t[b->first], to = c->t[b->first + b->count - 1];
    double middle = 0.5 * (from + to), half = to > from ? 0.5 * (to - from) : 1.0;
    for (size_t i = b->first; i < b->first + b->count; i++)
      for (size_t j = 0; j < b->nterm; j++)
        w->power[i * UM_COMPARE_TREND_MAX + j] = pow((c->t[i] - middle) / half, (double)j);
  }
}

enum um_status um_compare_white_create(struct um_context *context,
                                       const struct um_compare_curve *curve,
                                       struct um_compare_white **out)
{
  struct um_compare_white *w = NULL;
  enum um_status status;
  size_t n = curve->n;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *w, &w));
  w->curve = curve;
  UM_CHECK(um_core_allocate(context, n, sizeof *w->phi, &w->phi));
  UM_CHECK(um_core_allocate(context, n, sizeof *w->gain, &w->gain));
  UM_CHECK(um_core_allocate(context, n, sizeof *w->scale, &w->scale));
  UM_CHECK(um_core_allocate(context, n * UM_COMPARE_TREND_MAX, sizeof *w->power, &w->power));
  UM_CHECK(um_core_allocate(context, n * UM_COMPARE_TREND_MAX, sizeof *w->trend, &w->trend));
  UM_CHECK(um_core_allocate(context, n, sizeof *w->y, &w->y));
  set_powers(w);
  *out = w;
  w = NULL;
done:
  um_compare_white_destroy(context, &w);
  return status;
}

void um_compare_white_destroy(struct um_context *context, struct um_compare_white **white)
{
  if (white == NULL || *white == NULL) return;
  UM_FREE(context, (*white)->phi, (*white)->gain, (*white)->scale, (*white)->power, (*white)->trend,
          (*white)->y, *white);
  *white = NULL;
}

/* Factors of the filter, which depend on times and noise alone. */
static void set_filter(struct um_compare_white *w, const struct um_compare_red *noise)
{
  const struct um_compare_curve *c = w->curve;
  w->log_det = 0.0;
  for (size_t k = 0; k < c->nblock; k++) {
    double p = noise->red;
    for (size_t j = 0; j < c->block[k].count; j++) {
      size_t i = c->block[k].first + j;
      w->phi[i] = j == 0 || !(noise->red > 0.0) ? 0.0 : exp(-(c->t[i] - c->t[i - 1]) / noise->tau);
      if (j > 0) p = w->phi[i] * w->phi[i] * p + noise->red * (1.0 - w->phi[i] * w->phi[i]);
      double s = p + c->g[i];
      w->gain[i] = p / s;
      w->scale[i] = 1.0 / sqrt(s);
      w->log_det += log(s);
      p *= c->g[i] / s;
    }
  }
}

/* The trend of a block: powers of time through the filter, orthonormal (Gram-Schmidt, twice). */
static void set_trend(struct um_compare_white *w, const struct um_compare_block *b)
{
  for (size_t k = 0; k < b->nterm; k++) {
    double state = 0.0;
    for (size_t i = b->first; i < b->first + b->count; i++) {
      state *= w->phi[i];
      double e = w->power[i * UM_COMPARE_TREND_MAX + k] - state;
      state += w->gain[i] * e;
      w->trend[i * UM_COMPARE_TREND_MAX + k] = w->scale[i] * e;
    }
    double norm = 0.0, whole = 0.0;
    for (int pass = 0; pass < 2; pass++) {
      for (size_t q = 0; q < k; q++) {
        double dot = 0.0;
        for (size_t i = b->first; i < b->first + b->count; i++)
          dot += w->trend[i * UM_COMPARE_TREND_MAX + q] * w->trend[i * UM_COMPARE_TREND_MAX + k];
        for (size_t i = b->first; i < b->first + b->count; i++)
          w->trend[i * UM_COMPARE_TREND_MAX + k] -= dot * w->trend[i * UM_COMPARE_TREND_MAX + q];
        if (pass == 0) whole += dot * dot;
      }
    }
    for (size_t i = b->first; i < b->first + b->count; i++)
      norm += w->trend[i * UM_COMPARE_TREND_MAX + k] * w->trend[i * UM_COMPARE_TREND_MAX + k];
    bool real = norm > DEGENERATE * (norm + whole); /* not where times repeat too often */
    for (size_t i = b->first; i < b->first + b->count; i++)
      w->trend[i * UM_COMPARE_TREND_MAX + k] *= real ? 1.0 / sqrt(norm) : 0.0;
    if (real) w->log_det += log(norm);
  }
}

/* How much of each trend a block's column, already whitened in x, holds; taken out of it. */
static void take_trend(const struct um_compare_white *w, const struct um_compare_block *b,
                       double *x, size_t stride)
{
  for (size_t k = 0; k < b->nterm; k++) {
    double dot = 0.0;
    for (size_t j = 0; j < b->count; j++)
      dot += w->trend[(b->first + j) * UM_COMPARE_TREND_MAX + k] * x[j * stride];
    for (size_t j = 0; j < b->count; j++)
      x[j * stride] -= dot * w->trend[(b->first + j) * UM_COMPARE_TREND_MAX + k];
  }
}

void um_compare_white_set(struct um_compare_white *w, const struct um_compare_red *noise)
{
  const struct um_compare_curve *c = w->curve;
  set_filter(w, noise);
  w->chi2 = 0.0;
  for (size_t k = 0; k < c->nblock; k++) {
    const struct um_compare_block *b = &c->block[k];
    double state = 0.0;
    set_trend(w, b);
    for (size_t i = b->first; i < b->first + b->count; i++) {
      state *= w->phi[i];
      double e = c->y[i] - state;
      state += w->gain[i] * e;
      w->y[i] = w->scale[i] * e;
    }
    for (int pass = 0; pass < 2; pass++) take_trend(w, b, w->y + b->first, 1);
    for (size_t i = b->first; i < b->first + b->count; i++) w->chi2 += w->y[i] * w->y[i];
  }
}

void um_compare_white_take_trend(const struct um_compare_white *w, double *x)
{
  for (size_t k = 0; k < w->curve->nblock; k++) {
    const struct um_compare_block *b = &w->curve->block[k];
    for (int pass = 0; pass < 2; pass++) take_trend(w, b, x + b->first, 1);
  }
}

/* --- a sine ---------------------------------------------------------------------------------- */

/* Products of the whitened sine and cosine without trend, and y. Sums over a block need its
 * products with the trend alone: <c - Q Q'c, s - Q Q's> = <c, s> - (Q'c)(Q's). */
struct products {
  double cc, ss, cs, yc, ys, norm; /* norm: <c, c> + <s, s> before the trend is out */
};

static void add_block(const struct um_compare_white *w, const struct um_compare_block *b,
                      double omega, struct products *out)
{
  const struct um_compare_curve *curve = w->curve;
  double qc[UM_COMPARE_TREND_MAX] = {0}, qs[UM_COMPARE_TREND_MAX] = {0}, mc = 0.0, ms = 0.0;
  for (size_t i = b->first; i < b->first + b->count; i++) {
    double x = omega * curve->t[i];
    mc *= w->phi[i];
    ms *= w->phi[i];
    double ec = cos(x) - mc, es = sin(x) - ms;
    mc += w->gain[i] * ec;
    ms += w->gain[i] * es;
    double c = w->scale[i] * ec, s = w->scale[i] * es;
    out->cc += c * c;
    out->ss += s * s;
    out->cs += c * s;
    out->yc += w->y[i] * c;
    out->ys += w->y[i] * s;
    const double *q = w->trend + i * UM_COMPARE_TREND_MAX;
    for (size_t k = 0; k < b->nterm; k++) {
      qc[k] += q[k] * c;
      qs[k] += q[k] * s;
    }
  }
  for (size_t k = 0; k < b->nterm; k++) {
    out->norm += qc[k] * qc[k] + qs[k] * qs[k];
    out->cc -= qc[k] * qc[k];
    out->ss -= qs[k] * qs[k];
    out->cs -= qc[k] * qs[k];
  }
}

static struct products products_of(const struct um_compare_white *w, double frequency)
{
  struct products p = {0};
  for (size_t k = 0; k < w->curve->nblock; k++)
    add_block(w, &w->curve->block[k], 2.0 * UM_PI * frequency, &p);
  p.norm += p.cc + p.ss;
  return p;
}

static struct um_compare_sine solve(const struct um_compare_white *w, const struct products *p)
{
  struct um_compare_sine out = {0};
  double d = p->cc * p->ss - p->cs * p->cs, sum = p->cc + p->ss;
  if (!(w->chi2 > 0.0) || !(sum > DEGENERATE * p->norm)) return out;
  if (d > DEGENERATE * sum * sum) {
    out.a = (p->yc * p->ss - p->ys * p->cs) / d;
    out.b = (p->ys * p->cc - p->yc * p->cs) / d;
  } else if (p->cc >= p->ss) { /* as at half the sampling rate: only one phase is seen */
    out.a = p->yc / p->cc;
  } else {
    out.b = p->ys / p->ss;
  }
  out.power = fmin(1.0, fmax(0.0, (out.a * p->yc + out.b * p->ys) / w->chi2));
  return out;
}

struct um_compare_sine um_compare_white_sine(const struct um_compare_white *white, double frequency)
{
  struct products p = products_of(white, frequency);
  return solve(white, &p);
}

/* --- the noise ------------------------------------------------------------------------------- */

static double minus2_of(const struct um_compare_white *w, double frequency)
{
  const struct um_compare_curve *c = w->curve;
  double dof = (double)(c->n - c->nterm), chi2 = w->chi2, log_det = w->log_det;
  if (frequency > 0.0) {
    struct products p = products_of(w, frequency);
    chi2 *= 1.0 - solve(w, &p).power;
    log_det += log(fmax(p.cc * p.ss - p.cs * p.cs, DEGENERATE * p.norm * p.norm));
    dof -= 2.0;
  }
  double floor = NOTHING * c->yy * (double)c->n; /* in units of the white noise: at most this */
  return dof * log(fmax(chi2, floor)) + log_det;
}

void um_compare_red_fit(struct um_compare_white *white, double frequency,
                        struct um_compare_red *noise, double *minus2)
{
  const struct um_compare_curve *c = white->curve;
  struct um_compare_red best = {0.0, 1.0}, now;
  um_compare_white_set(white, &best);
  double least = minus2_of(white, frequency);
  double step = c->span / (double)c->n;
  for (now.tau = step; now.tau <= c->longest; now.tau *= TAU_FACTOR) {
    now.red = RED_FIRST;
    for (int k = 0; k < RED_STEPS; k++, now.red *= RED_FACTOR) {
      um_compare_white_set(white, &now);
      double value = minus2_of(white, frequency);
      if (!(value < least)) continue;
      least = value;
      best = now;
    }
  }
  um_compare_white_set(white, &best);
  *noise = best;
  *minus2 = least;
}
