/* The Earth's shadow behind measurements, its edges at their own times. */
#include "evidence/comparison/shade.h"

#include <math.h>

#include "base/core/constants.h"
#include "model/build/timeline.h"
#include "orbit/time.h"

#define LONGEST   259200.0 /* [s] beyond it single shadows are not to be seen */
#define STEP      60.0     /* [s] at most between instants at which the shadow is looked up */
#define LEAST     200      /* instants */
#define TOLERANCE 1e-3     /* of an edge [s] */

struct shadow {
  struct um_context *context;
  const struct um_model *model;
  double *t, *sunlit;
  size_t count, capacity;
};

static enum um_status look(const struct shadow *s, double t, double *sunlit)
{
  struct um_environment_sample sample;
  enum um_status status = um_model_sample_at(s->context, s->model, t, &sample);
  *sunlit = sample.sunlit_fraction;
  if (status != UM_ERR_INPUT) return status;
  um_core_message_clear(s->context); /* an orbit that ends with the measurements */
  *sunlit = 1.0;
  return UM_OK;
}

static enum um_status add(struct shadow *s, double t, double sunlit)
{
  if (s->count == s->capacity) {
    s->capacity = s->capacity > 0 ? 2 * s->capacity : 512;
    UM_TRY(um_core_reallocate(s->context, s->capacity, sizeof *s->t, &s->t));
    UM_TRY(um_core_reallocate(s->context, s->capacity, sizeof *s->sunlit, &s->sunlit));
  }
  s->t[s->count] = t;
  s->sunlit[s->count++] = sunlit;
  return UM_OK;
}

/* 0: umbra, 1: penumbra, 2: sunlight, as um_plot_shade sees them. */
static int kind_of(double sunlit)
{
  return sunlit <= UM_UMBRA_MOST ? 0 : sunlit < UM_SUNLIGHT_LEAST ? 1 : 2;
}

/* Instants on either side of the edges between the last one that stands and (t, sunlit). */
static enum um_status edges(struct shadow *s, double t, double sunlit)
{
  while (kind_of(s->sunlit[s->count - 1]) != kind_of(sunlit)) {
    double low = s->t[s->count - 1], high = t, after = sunlit, before = s->sunlit[s->count - 1];
    int first = kind_of(before);
    while (high - low > TOLERANCE) {
      double middle = 0.5 * (low + high), value;
      UM_TRY(look(s, middle, &value));
      if (kind_of(value) == first) {
        low = middle;
        before = value;
      } else {
        high = middle;
        after = value;
      }
    }
    UM_TRY(add(s, low, before));
    UM_TRY(add(s, high, after));
  }
  return UM_OK;
}

static enum um_status follow(struct shadow *s, double first, double last)
{
  size_t n = (size_t)fmax(LEAST, ceil((last - first) / STEP));
  for (size_t i = 0; i <= n; i++) {
    double t = first + (last - first) * (double)i / (double)n, sunlit;
    UM_TRY(look(s, t, &sunlit));
    if (i > 0) UM_TRY(edges(s, t, sunlit));
    UM_TRY(add(s, t, sunlit));
  }
  return UM_OK;
}

/* Nothing where an axis has no shadows to be seen. */
static enum um_status follow_axis(struct shadow *s, double first, double last)
{
  if (s->model->points || !(last > first) || !(last - first < LONGEST)) return UM_OK;
  return follow(s, first, last);
}

enum um_status um_compare_plot_shade(struct um_context *context, const struct um_model *model,
                                     const struct um_plot_time *time, struct um_plot *plot)
{
  struct shadow s = {.context = context, .model = model};
  enum um_status status = follow_axis(&s, time->first, time->last);
  if (status == UM_OK) um_plot_shade(plot, time, s.count, s.t, s.sunlit);
  UM_FREE(context, s.t, s.sunlit);
  return status;
}

enum um_status um_compare_page_shade(struct um_page_writer *w, const struct um_model *model,
                                     double first, double last)
{
  struct shadow s = {.context = w->context, .model = model};
  enum um_status status = follow_axis(&s, first, last);
  for (size_t k = 0; k < s.count; k++) s.t[k] = um_orbit_time_unix(s.t[k]);
  if (status == UM_OK) status = um_page_writer_shade(w, s.count, s.t, s.sunlit);
  UM_FREE(w->context, s.t, s.sunlit);
  return status;
}
