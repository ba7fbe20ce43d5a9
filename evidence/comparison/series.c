/* One channel as a series in linear flux, and phase folding. */
#include "evidence/comparison/series.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "evidence/comparison/residual.h"

/* A row's place in time; equal times keep the order of the file. */
struct instant {
  double t; /* t_tai [s] */
  size_t row;
};

static int compare_instants(const void *a, const void *b)
{
  const struct instant *x = a, *y = b;
  if (x->t != y->t) return x->t < y->t ? -1 : 1;
  return x->row < y->row ? -1 : x->row > y->row;
}

static enum um_status allocate_series(struct um_context *context, size_t n,
                                      struct um_compare_series *s)
{
  s->count = n;
  UM_TRY(um_core_allocate(context, n, sizeof *s->t, &s->t));
  UM_TRY(um_core_allocate(context, n, sizeof *s->value, &s->value));
  UM_TRY(um_core_allocate(context, n, sizeof *s->sigma, &s->sigma));
  UM_TRY(um_core_allocate(context, n, sizeof *s->weight, &s->weight));
  UM_TRY(um_core_allocate(context, n, sizeof *s->track, &s->track));
  return um_core_allocate(context, n, sizeof *s->row, &s->row);
}

/* The power of the values by which the sigmas follow them: least squares of ln sigma against ln F.
 */
static double power_of(const struct um_compare_series *s)
{
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, n = (double)s->count;
  for (size_t i = 0; i < s->count; i++) {
    if (!(s->value[i] > 0.0)) return 0.0;
    x += log(s->value[i]) / n;
    y += log(s->sigma[i]) / n;
  }
  for (size_t i = 0; i < s->count; i++) {
    double d = log(s->value[i]) - x;
    xx += d * d;
    xy += d * (log(s->sigma[i]) - y);
  }
  return xx > 0.0 ? fmin(fmax(xy / xx, 0.0), 1.0) : 0.0;
}

static void set_weights(struct um_compare_series *s)
{
  double power = power_of(s);
  for (size_t i = 0; i < s->count; i++) {
    double free = power > 0.0 ? pow(s->value[i], power) / s->sigma[i] : 1.0 / s->sigma[i];
    s->weight[i] = free * free;
  }
}

enum um_status um_compare_series_create(struct um_context *context,
                                        const struct um_compare_measurements *measurements,
                                        size_t channel, size_t track,
                                        struct um_compare_series **out)
{
  const struct um_compare_measurements *m = measurements;
  struct um_compare_series *s = NULL;
  struct instant *instant = NULL;
  size_t n = 0;
  bool sigmas = true;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, m->channel[channel].count, sizeof *instant, &instant));
  for (size_t i = 0; i < m->count; i++) {
    const struct um_compare_measurement *row = &m->row[i];
    if (row->channel != channel || row->flag != 0) continue;
    if (track == SIZE_MAX || row->track == track) instant[n++] = (struct instant){row->t_tai, i};
  }
  if (n > 0) qsort(instant, n, sizeof *instant, compare_instants);
  UM_CHECK(um_core_allocate(context, 1, sizeof *s, &s));
  UM_CHECK(allocate_series(context, n, s));
  for (size_t k = 0; k < n; k++) {
    const struct um_compare_measurement *row = &m->row[instant[k].row];
    s->t[k] = row->t_tai;
    s->row[k] = instant[k].row;
    s->track[k] = row->track;
    struct um_compare_linear linear = um_compare_measured(m, instant[k].row, row->sigma);
    s->value[k] = linear.value;
    s->sigma[k] = linear.sigma;
    sigmas = sigmas && s->sigma[k] > 0.0;
  }
  if (sigmas) {
    set_weights(s);
  } else {
    UM_FREE(context, s->sigma, s->weight);
    s->sigma = s->weight = NULL;
  }
  *out = s;
  s = NULL;
done:
  um_compare_series_destroy(context, &s);
  um_core_free(context, instant);
  return status;
}

void um_compare_series_destroy(struct um_context *context, struct um_compare_series **series)
{
  if (series == NULL || *series == NULL) return;
  UM_FREE(context, (*series)->t, (*series)->value, (*series)->sigma, (*series)->weight,
          (*series)->row, (*series)->track, *series);
  *series = NULL;
}

double um_compare_series_weight(const struct um_compare_series *s, size_t i)
{
  if (s->weight != NULL) return s->weight[i];
  return s->sigma == NULL ? 1.0 : 1.0 / (s->sigma[i] * s->sigma[i]);
}

/* frac((t - epoch) / period), in [0, 1) also where rounding would give 1. */
static double phase_of(double t, double period, double epoch)
{
  double turns = (t - epoch) / period, phase = turns - floor(turns);
  return phase < 1.0 ? phase : 0.0;
}

size_t um_compare_fold_bin_of(double t, double period, double epoch, size_t bins)
{
  size_t at = (size_t)(phase_of(t, period, epoch) * (double)bins);
  return at < bins ? at : bins - 1;
}

void um_compare_fold_bins(const struct um_compare_series *series, double period, double epoch,
                          size_t bins, struct um_compare_fold_bin *out)
{
  const struct um_compare_series *s = series;
  for (size_t b = 0; b < bins; b++) {
    double weight = 0.0, sum = 0.0, scatter = 0.0, variance = 0.0;
    size_t n = 0;
    for (int pass = 0; pass < 2; pass++) { /* the mean, then the scatter about it */
      for (size_t i = 0; i < s->count; i++) {
        if (um_compare_fold_bin_of(s->t[i], period, epoch, bins) != b) continue;
        double w = um_compare_series_weight(s, i);
        if (pass == 1) {
          scatter += (s->value[i] - sum / weight) * (s->value[i] - sum / weight);
          continue;
        }
        weight += w;
        sum += w * s->value[i];
        if (s->sigma != NULL) variance += w * s->sigma[i] * w * s->sigma[i];
        n++;
      }
    }
    out[b] = (struct um_compare_fold_bin){n, n > 0 ? sum / weight : NAN, NAN};
    if (s->sigma != NULL && n > 0) out[b].sigma = sqrt(variance) / weight;
    if (s->sigma == NULL && n > 1) out[b].sigma = sqrt(scatter / (double)(n - 1) / (double)n);
  }
}
