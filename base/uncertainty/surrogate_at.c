/* A surrogate at given places: its basis there times its surpluses. */
#include <math.h>

#include "base/uncertainty/surrogate_impl.h"

#define GRID  (1 << 14) /* places among which Leja's points are sought */
#define BLOCK 256       /* values that stay in the nearest memory while terms are added */

void um_uncertainty_axis_make(struct um_uncertainty_axis *axis)
{
  for (size_t k = 0; k < UM_UNCERTAINTY_LEVELS; k++) {
    double best = -1.0;
    axis->x[k] = 0.5;
    for (size_t i = 0; i <= GRID && k > 0; i++) {
      double x = (double)i / GRID, product = 1.0;
      for (size_t j = 0; j < k; j++) product *= x > axis->x[j] ? x - axis->x[j] : axis->x[j] - x;
      if (product <= best) continue;
      best = product;
      axis->x[k] = x;
    }
    double product = 1.0;
    for (size_t j = 0; j < k; j++) product *= axis->x[k] - axis->x[j];
    axis->scale[k] = 1.0 / product;
  }
}

void um_uncertainty_axis_basis(const struct um_uncertainty_axis *axis, double x, size_t levels,
                               double *h)
{
  double product = 1.0;
  for (size_t k = 0; k < levels; k++) {
    h[k] = product * axis->scale[k];
    product *= x - axis->x[k];
  }
}

void um_uncertainty_surrogate_basis(const struct um_uncertainty_surrogate *surrogate,
                                    const double *place, size_t from, size_t to, double *out)
{
  double h[UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX][UM_UNCERTAINTY_LEVELS];
  for (size_t k = 0; k < surrogate->d; k++)
    um_uncertainty_axis_basis(&surrogate->axis, place[k], surrogate->levels[k], h[k]);
  for (size_t t = from; t < to; t++) {
    double product = 1.0;
    for (size_t k = 0; k < surrogate->d; k++) product *= h[k][surrogate->term[t].degree[k]];
    out[t - from] = product;
  }
}

/* value [n][nvalue], values first .. last - 1 of all points. */
static void add_block(const struct um_uncertainty_surrogate *s, size_t first, size_t last,
                      const double *basis, size_t n, double *value)
{
  for (size_t i = 0; i < n; i++) {
    double *restrict out = value + i * s->nvalue;
    const double *b = basis + i * s->nterm;
    for (size_t k = first; k < last; k++) out[k] = 0.0;
    for (size_t t = 0; t < s->nterm; t++) {
      const double *restrict surplus = s->term[t].surplus;
      double factor = b[t];
      if (factor == 0.0) continue;
      for (size_t k = first; k < last; k++) out[k] += factor * surplus[k];
    }
    for (size_t k = first; k < last; k++)
      if (s->nowhere[k]) out[k] = NAN;
  }
}

enum um_status um_uncertainty_surrogate_at(struct um_context *context,
                                           const struct um_uncertainty_surrogate *surrogate,
                                           const double *place, size_t n, double *value)
{
  size_t d = surrogate->d, nterm = surrogate->nterm;
  double *basis = NULL;
  for (size_t i = 0; i < n * d; i++)
    if (!(place[i] >= 0.0 && place[i] <= 1.0))
      return um_core_fail(context, UM_ERR_INPUT,
                          "a surrogate at %g on axis %zu, which goes from 0 to 1", place[i], i % d);
  UM_TRY(um_core_allocate(context, n, nterm * sizeof *basis, &basis));
  for (size_t i = 0; i < n; i++)
    um_uncertainty_surrogate_basis(surrogate, place + i * d, 0, nterm, basis + i * nterm);
  long nblock = (long)((surrogate->nvalue + BLOCK - 1) / BLOCK);
#pragma omp parallel for schedule(static) num_threads(um_core_context_threads(context))
  for (long b = 0; b < nblock; b++) {
    size_t first = (size_t)b * BLOCK, last = first + BLOCK;
    if (last > surrogate->nvalue) last = surrogate->nvalue;
    add_block(surrogate, first, last, basis, n, value);
  }
  um_core_free(context, basis);
  return UM_OK;
}
