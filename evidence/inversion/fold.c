/* Folding beside trends.
 *
 * y = trend + profile(phase) is an additive model: trend and profile are fitted in turn, each to
 * what the other leaves (backfitting; Hastie and Tibshirani 1986, Statist. Sci. 1, 297), beginning
 * with the sine that was found as the profile. A turn takes out what one share of the other still
 * holds: the square of their correlation, small where the track has more turns than its trend has
 * terms. Where points are fewer than bins the first trend stays. */
#include "evidence/inversion/fold.h"

#include <math.h>

#include "base/core/constants.h"
#include "evidence/inversion/period_noise_impl.h"

#define TURNS 10

struct fold {
  const struct um_compare_series *series;
  const struct um_compare_period *period;
  struct um_compare_curve *curve; /* its variances are the inverse weights */
  struct um_compare_white *white;
  struct um_compare_series beside; /* what the trends leave, in the order of the curve */
  double *profile, *trend, *left;  /* [n] */
};

static enum um_status allocate(struct um_context *context, struct fold *f)
{
  size_t n = f->series->count;
  UM_TRY(um_core_allocate(context, n, sizeof *f->profile, &f->profile));
  UM_TRY(um_core_allocate(context, n, sizeof *f->trend, &f->trend));
  UM_TRY(um_core_allocate(context, n, sizeof *f->left, &f->left));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &f->beside.t));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &f->beside.value));
  UM_TRY(um_core_allocate(context, n, sizeof(double), &f->beside.weight));
  f->beside.count = n;
  if (f->series->sigma == NULL) return UM_OK;
  return um_core_allocate(context, n, sizeof(double), &f->beside.sigma);
}

static enum um_status prepare(struct um_context *context, struct fold *f)
{
  const struct um_compare_series *s = f->series;
  const struct um_compare_period *p = f->period;
  const struct um_compare_red white = {0.0, 1.0};
  struct um_compare_series even = *s;
  even.sigma = f->left; /* until it is needed */
  for (size_t i = 0; i < s->count; i++) f->left[i] = sqrt(1.0 / um_compare_series_weight(s, i));
  UM_TRY(um_compare_curve_create(context, &even, &f->curve));
  UM_TRY(um_compare_white_create(context, f->curve, &f->white));
  um_compare_white_set(f->white, &white);
  for (size_t i = 0; i < s->count; i++) {
    size_t k = f->curve->row[i];
    f->beside.t[i] = s->t[k];
    f->beside.weight[i] = um_compare_series_weight(s, k);
    if (s->sigma != NULL) f->beside.sigma[i] = s->sigma[k];
    f->profile[i] = p->amplitude * cos(2.0 * UM_PI * (s->t[k] - p->epoch) / p->period);
  }
  return UM_OK;
}

/* The trends of what the profile leaves, taken out of the light about their mean. */
static void take_trend(struct fold *f)
{
  const struct um_compare_curve *c = f->curve;
  double mean = 0.0, weight = 0.0;
  for (size_t i = 0; i < c->n; i++) f->left[i] = f->white->scale[i] * (c->y[i] - f->profile[i]);
  um_compare_white_take_trend(f->white, f->left);
  for (size_t i = 0; i < c->n; i++) {
    f->trend[i] = c->y[i] - f->profile[i] - f->left[i] / f->white->scale[i];
    mean += f->trend[i] / c->g[i];
    weight += 1.0 / c->g[i];
  }
  mean /= weight;
  for (size_t i = 0; i < c->n; i++) f->beside.value[i] = c->offset + c->y[i] - (f->trend[i] - mean);
}

/* The profile is that of the bins, about its own mean over the observations. */
static void take_profile(struct fold *f, size_t bins, const struct um_compare_fold_bin *bin)
{
  const struct um_compare_curve *c = f->curve;
  const struct um_compare_period *p = f->period;
  double mean = 0.0, weight = 0.0;
  for (size_t i = 0; i < c->n; i++) {
    f->profile[i] = bin[um_compare_fold_bin_of(f->beside.t[i], p->period, p->epoch, bins)].mean;
    mean += f->profile[i] / c->g[i];
    weight += 1.0 / c->g[i];
  }
  for (size_t i = 0; i < c->n; i++) f->profile[i] -= mean / weight;
}

enum um_status um_compare_fold(struct um_context *context, const struct um_compare_series *series,
                               const struct um_compare_period *period, size_t bins,
                               struct um_compare_fold_bin *out)
{
  enum um_status status;
  struct fold f = {.series = series, .period = period};
  UM_CHECK(allocate(context, &f));
  UM_CHECK(prepare(context, &f));
  for (int turn = 0; turn < TURNS; turn++) {
    if (turn > 0) take_profile(&f, bins, out);
    take_trend(&f);
    um_compare_fold_bins(&f.beside, period->period, period->epoch, bins, out);
  }
done:
  um_compare_curve_destroy(context, &f.curve);
  um_compare_white_destroy(context, &f.white);
  UM_FREE(context, f.profile, f.trend, f.left, f.beside.t, f.beside.value, f.beside.sigma,
          f.beside.weight);
  return status;
}
