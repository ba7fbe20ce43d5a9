/* The steps of a response run: sources, edges and jumps of the loads end them, and between these
 * they are equal and at most as long as is asked for. */
#include <math.h>
#include <stdlib.h>

#include "base/core/order.h"
#include "base/core/sort.h"
#include "thermal/tangent/response_impl.h"

#define SHARE_OF_TIME 0.25 /* of the shortest source: the default step */

/* Times at which a step ends, not sorted, from 0; times NULL: only counts. */
static size_t ends_list(const struct um_thermal_response_run *r, const double *times, size_t ntime,
                        double *end)
{
  const struct um_irradiation_loads *loads = r->system->loads;
  size_t count = 0;
#define END(t)                                                                                     \
  do {                                                                                             \
    if (end != NULL) end[count] = (t)-r->from;                                                     \
    count++;                                                                                       \
  } while (0)
  END(r->from);
  END(times[ntime - 1]);
  for (size_t k = UM_THERMAL_INSIDE; k < ntime; k += UM_THERMAL_INSIDE) END(times[k]);
  for (size_t k = 0; k < r->nsource; k++) {
    END(r->source[k].t_from);
    END(r->source[k].t_to);
  }
  for (size_t k = 0; loads != NULL && k < loads->nedge; k++) END(loads->edge[k]);
  for (size_t k = 1; loads != NULL && k < loads->ntime; k++)
    if (loads->t[k] <= loads->t[k - 1]) END(loads->t[k]);
#undef END
  return count;
}

static double step_limit(const struct um_thermal_response_run *r,
                         const struct um_thermal_response_options *how)
{
  if (how != NULL && how->longest_step > 0.0) return how->longest_step;
  double shortest = INFINITY;
  for (size_t k = 0; k < r->nsource; k++)
    if (r->source[k].t_to > r->source[k].t_from)
      shortest = fmin(shortest, r->source[k].t_to - r->source[k].t_from);
  return SHARE_OF_TIME * shortest;
}

enum um_status um_thermal_response_grid(struct um_thermal_response_run *r, const double *times,
                                        size_t ntime, const struct um_thermal_response_options *how)
{
  enum um_status status;
  double *end = NULL, last = times[ntime - 1] - r->from, limit = step_limit(r, how);
  size_t count = ends_list(r, times, ntime, NULL), kept = 0;
  UM_CHECK(um_core_allocate(r->context, count, sizeof *end, &end));
  ends_list(r, times, ntime, end);
  UM_CHECK(um_core_sort(r->context, end, count, sizeof *end, um_core_order_double));
  for (size_t k = 0; k < count; k++)
    if (end[k] >= 0.0 && end[k] <= last &&
        (kept == 0 || end[k] > end[kept - 1] + UM_THERMAL_ONE_TIME))
      end[kept++] = end[k];
  for (size_t k = 1; k < kept; k++)
    r->nstep += (size_t)fmax(1.0, ceil((end[k] - end[k - 1]) / limit - 1e-9));
  UM_CHECK(um_core_allocate(r->context, r->nstep + 1, sizeof(double), &r->grid));
  size_t at = 0;
  for (size_t k = 1; k < kept; k++) {
    size_t n = (size_t)fmax(1.0, ceil((end[k] - end[k - 1]) / limit - 1e-9));
    for (size_t i = 0; i < n; i++)
      r->grid[at++] = end[k - 1] + (end[k] - end[k - 1]) * (double)i / (double)n;
  }
  r->grid[at] = end[kept - 1];
done:
  um_core_free(r->context, end);
  return status;
}

void um_thermal_response_times(const struct um_thermal_response_run *r, const double *times,
                               size_t ntime, double *all, size_t *middle, size_t *place)
{
  size_t at = 0, next = 0;
  for (size_t k = 0; k < r->nstep; k++) {
    double t = r->from + 0.5 * (r->grid[k] + r->grid[k + 1]);
    for (; next < ntime && times[next] <= t; next++) {
      place[next] = at;
      all[at++] = times[next];
    }
    middle[k] = at;
    all[at++] = t;
  }
  for (; next < ntime; next++) {
    place[next] = at;
    all[at++] = times[next];
  }
}
