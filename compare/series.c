/* One channel as a series in linear flux, and phase folding. */
#include "compare/series.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

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
  UM_TRY(um_core_allocate(context, n, sizeof *s->track, &s->track));
  return um_core_allocate(context, n, sizeof *s->row, &s->row);
}

enum um_status um_compare_series_create(struct um_context *context,
                                        const struct um_compare_measurements *measurements,
                                        size_t channel, size_t track,
                                        struct um_compare_series **out)
{
  const struct um_compare_measurements *m = measurements;
  enum um_compare_quantity quantity = m->channel[channel].quantity;
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
    um_compare_linear(quantity, row->value, row->sigma, &s->value[k], &s->sigma[k]);
    sigmas = sigmas && s->sigma[k] > 0.0;
  }
  if (!sigmas) {
    um_core_free(context, s->sigma);
    s->sigma = NULL;
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
  um_core_free(context, (*series)->t);
  um_core_free(context, (*series)->value);
  um_core_free(context, (*series)->sigma);
  um_core_free(context, (*series)->row);
  um_core_free(context, (*series)->track);
  um_core_free(context, *series);
  *series = NULL;
}

/* frac((t - epoch) / period), in [0, 1) also where rounding would give 1. */
static double phase_of(double t, double period, double epoch)
{
  double turns = (t - epoch) / period, phase = turns - floor(turns);
  return phase < 1.0 ? phase : 0.0;
}

void um_compare_fold_bins(const struct um_compare_series *series, double period, double epoch,
                          size_t bins, struct um_compare_fold_bin *out)
{
  const struct um_compare_series *s = series;
  for (size_t b = 0; b < bins; b++) {
    double weight = 0.0, sum = 0.0, scatter = 0.0;
    size_t n = 0;
    for (int pass = 0; pass < 2; pass++) { /* the mean, then the scatter about it */
      for (size_t i = 0; i < s->count; i++) {
        size_t at = (size_t)(phase_of(s->t[i], period, epoch) * (double)bins);
        if ((at < bins ? at : bins - 1) != b) continue;
        double w = s->sigma == NULL ? 1.0 : 1.0 / (s->sigma[i] * s->sigma[i]);
        if (pass == 1) {
          scatter += (s->value[i] - sum / weight) * (s->value[i] - sum / weight);
          continue;
        }
        weight += w;
        sum += w * s->value[i];
        n++;
      }
    }
    out[b] = (struct um_compare_fold_bin){n, n > 0 ? sum / weight : NAN, NAN};
    if (s->sigma != NULL && n > 0) out[b].sigma = sqrt(1.0 / weight);
    if (s->sigma == NULL && n > 1) out[b].sigma = sqrt(scatter / (double)(n - 1) / (double)n);
  }
}
