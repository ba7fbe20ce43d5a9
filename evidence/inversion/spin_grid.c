/* A grid of spins, looked up. For an axis, what the map says of every observation at every turn of
 * the body is one ring of numbers; a law picks from it along phase + rate t. */
#include <math.h>
#include <omp.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "evidence/inversion/spin_impl.h"

#define MAP_ERROR 0.3 /* of what is looked up, and of what is measured [1] */
#define BLOCK     8   /* axes per thread between two looks at the stop */

/* The grid and the room of its threads. */
struct grid {
  const struct um_compare_spin_data *data;
  size_t naxis, nrate, nturn;
  double rate_least, rate_step;      /* [rad/s] */
  float *ring;                       /* [nthread][count][nturn] */
  double *looked_up;                 /* [nthread][nband] */
  double *least;                     /* [nthread][nturn] misfit of the best rate at each phase */
  size_t *at;                        /* [nthread][nturn] that rate */
  struct um_compare_spin_law *found; /* [naxis][2][nturn]; misfit NaN: none */
};

/* Evenly over the sphere: a spiral whose turns are as far apart as its points. */
static struct um_vec3 axis_at(size_t i, size_t n)
{
  double z = 1.0 - (2.0 * (double)i + 1.0) / (double)n, across = sqrt(1.0 - z * z);
  double angle = (double)i * UM_PI * (3.0 - sqrt(5.0));
  return um_vec3(across * cos(angle), across * sin(angle), z);
}

static void fill_ring(const struct grid *g, struct um_vec3 axis, double *looked_up, float *ring)
{
  const struct um_compare_spin_data *d = g->data;
  struct um_quat base = um_core_quat_between(d->axis_body, axis);
  for (size_t k = 0; k < g->nturn; k++) {
    double turn = 2.0 * UM_PI * (double)k / (double)g->nturn;
    struct um_quat q = um_quat_then(base, um_quat_from_axis(d->axis_body, turn));
    for (size_t i = 0; i < d->count; i++)
      ring[i * g->nturn + k] = (float)um_compare_spin_look_up(d, &d->row[i], q, looked_up);
  }
}

/* Mean of (a - b)^2 / (sigma^2 + f^2 (a^2 + b^2)), at most 1/f^2 each. */
static double misfit(const struct grid *g, const float *ring, double rate, double phase)
{
  const struct um_compare_spin_data *d = g->data;
  double sum = 0.0;
  for (size_t i = 0; i < d->count; i++) {
    const struct um_compare_spin_row *row = &d->row[i];
    double turn = (phase + rate * row->t) / (2.0 * UM_PI);
    turn = (turn - floor(turn)) * (double)g->nturn;
    size_t low = (size_t)turn;
    double share = turn - (double)low;
    low = low < g->nturn ? low : 0;
    const float *own = ring + i * g->nturn;
    double a = (1.0 - share) * (double)own[low] + share * (double)own[(low + 1) % g->nturn];
    double b = row->value, difference = a - b;
    if (isnan(a)) continue;
    sum += difference * difference /
           (row->sigma * row->sigma + MAP_ERROR * MAP_ERROR * (a * a + b * b));
  }
  return sum / (double)d->count;
}

/* Both senses of one axis: every phase that is better than its neighbours. */
static void search_axis(const struct grid *g, size_t axis, size_t thread)
{
  float *ring = g->ring + thread * g->data->count * g->nturn;
  double *least = g->least + thread * g->nturn;
  size_t *at = g->at + thread * g->nturn, n = g->nturn;
  struct um_vec3 e = axis_at(axis, g->naxis);
  fill_ring(g, e, g->looked_up + thread * g->data->map->nband, ring);
  for (int sense = 0; sense < 2; sense++) {
    struct um_compare_spin_law *found = g->found + (axis * 2 + (size_t)sense) * n;
    for (size_t k = 0; k < n; k++) {
      least[k] = INFINITY;
      for (size_t r = 0; r < g->nrate; r++) {
        double rate = g->rate_least + (double)r * g->rate_step;
        double own = misfit(g, ring, sense ? -rate : rate, 2.0 * UM_PI * (double)k / (double)n);
        if (own < least[k]) {
          least[k] = own;
          at[k] = r;
        }
      }
    }
    for (size_t k = 0; k < n; k++) {
      double rate = g->rate_least + (double)at[k] * g->rate_step;
      bool best = least[k] < least[(k + 1) % n] && least[k] <= least[(k + n - 1) % n];
      found[k] =
          (struct um_compare_spin_law){e, sense ? -rate : rate, 2.0 * UM_PI * (double)k / (double)n,
                                       best ? least[k] : (double)NAN};
    }
  }
}

static enum um_status search_all(struct um_context *context, const struct grid *g)
{
  enum um_status status = UM_OK;
  size_t nthread = (size_t)um_core_context_threads(context), block = BLOCK * nthread;
  um_core_progress_begin(context, "looking up attitudes", g->naxis);
  for (size_t from = 0; from < g->naxis && status == UM_OK; from += block) {
    size_t end = from + block < g->naxis ? from + block : g->naxis;
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(context))
    for (size_t i = from; i < end; i++)
      if (!um_core_stopped(context)) search_axis(g, i, (size_t)omp_get_thread_num());
    status = um_core_progress_step(context, end - from);
    if (status == UM_OK) status = um_core_stop_check(context, "attitudes were looked up");
  }
  um_core_progress_end(context);
  return status;
}

static int compare_laws(const void *a, const void *b)
{
  double x = ((const struct um_compare_spin_law *)a)->misfit;
  double y = ((const struct um_compare_spin_law *)b)->misfit;
  return (x > y) - (x < y);
}

/* The best that are apart by more than the grid's steps. */
static enum um_status choose(struct um_context *context, const struct grid *g,
                             struct um_compare_spin_law **out, size_t *count)
{
  const struct um_compare_spin_search *s = g->data->search;
  size_t n = 0, all = g->naxis * 2 * g->nturn;
  double near = 1.5 * (s->axis_step + s->turn_step);
  for (size_t i = 0; i < all; i++)
    if (!isnan(g->found[i].misfit)) g->found[n++] = g->found[i];
  qsort(g->found, n, sizeof *g->found, compare_laws);
  UM_TRY(um_core_allocate(context, s->keep, sizeof **out, out));
  for (size_t i = 0; i < n && *count < s->keep; i++) {
    bool apart = true;
    for (size_t k = 0; k < *count && apart; k++)
      apart = um_compare_spin_distance(g->data, &g->found[i], &(*out)[k]) > near;
    if (apart) (*out)[(*count)++] = g->found[i];
    if (i % 64 == 0) UM_TRY(um_core_stop_check(context, "attitudes were chosen"));
  }
  return UM_OK;
}

enum um_status um_compare_spin_grid(struct um_context *context,
                                    const struct um_compare_spin_data *data,
                                    struct um_compare_spin_law **out, size_t *count, size_t *nlaw)
{
  enum um_status status;
  const struct um_compare_spin_search *s = data->search;
  struct grid g = {.data = data, .rate_least = 2.0 * UM_PI / s->period_most};
  size_t nthread = (size_t)um_core_context_threads(context);
  double range = 2.0 * UM_PI / s->period_least - g.rate_least;
  *out = NULL;
  *count = 0;
  g.naxis = (size_t)ceil(4.0 * UM_PI / (s->axis_step * s->axis_step));
  g.nturn = (size_t)ceil(2.0 * UM_PI / s->turn_step - 1e-9);
  /* the phase holds in the middle: one step moves the ends by one step of turn */
  g.nrate = 1 + (size_t)ceil(range * 0.5 * data->span / s->turn_step);
  g.rate_step = g.nrate > 1 ? range / (double)(g.nrate - 1) : 0.0;
  *nlaw = g.naxis * 2 * g.nrate * g.nturn;
  UM_CHECK(um_core_allocate(context, nthread * data->count * g.nturn, sizeof *g.ring, &g.ring));
  UM_CHECK(
      um_core_allocate(context, nthread * data->map->nband, sizeof *g.looked_up, &g.looked_up));
  UM_CHECK(um_core_allocate(context, nthread * g.nturn, sizeof *g.least, &g.least));
  UM_CHECK(um_core_allocate(context, nthread * g.nturn, sizeof *g.at, &g.at));
  UM_CHECK(um_core_allocate(context, g.naxis * 2 * g.nturn, sizeof *g.found, &g.found));
  UM_CHECK(search_all(context, &g));
  UM_CHECK(choose(context, &g, out, count));
done:
  UM_FREE(context, g.ring, g.looked_up, g.least, g.at, g.found);
  if (status != UM_OK) {
    um_core_free(context, *out);
    *out = NULL;
  }
  return status;
}
