/* Tables of black bodies.
 *
 * B_lambda(T) is nearly exponential in x = 1/T, d ln B/dx = -C2/lambda, so four-point Lagrange
 * interpolation on a grid of step h in x has the relative error (3/128) (h C2/lambda)^4;
 * h C2/lambda_min = 0.02 makes it 3.7e-9. Where lambda T is large B goes like T instead, with the
 * error (9/16) (h/x)^4; h/x <= 0.008 makes it 2.3e-9. Where a band sees next to nothing of the
 * hottest surface, h C2/lambda_min = 0.2 makes it 3.7e-5. Entries are exact means over the bin. */
#include "optics/radiance/spectra_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "optics/radiance/lagrange_impl.h"

#define PLANCK_STEP       0.02 /* h C2 / lambda_min [1] */
#define PLANCK_STEP_FAINT 0.2
#define PLANCK_FAINT      40.0  /* C2 / (lambda T), exp(-40) = 4e-18 of what is emitted at all */
#define PLANCK_RATIO      0.008 /* h / x at the hottest [1] */
#define PLANCK_LIMIT      700.0 /* C2 / (lambda T) beyond which exp underflows [1] */
#define PLANCK_NODES      131072.0

double um_optics_planck_mean(const struct um_optics_spectra *spectra, size_t bin,
                             double temperature)
{
  return um_core_planck_band(spectra->from[bin], spectra->to[bin], temperature) /
         spectra->width[bin];
}

/* Node 1 of the four about a temperature, and their weights; false: not in the table. */
static bool nodes_about(const struct um_optics_planck *table, double temperature, size_t *node,
                        double weight[4])
{
  double place = table->nnode == 0 ? -1.0 : (1.0 / temperature - table->x_from) / table->step;
  if (!(place >= 0.0 && place <= (double)(table->nnode - 1))) return false;
  *node = (size_t)place;
  if (*node < 1) *node = 1;
  if (*node > table->nnode - 3) *node = table->nnode - 3;
  um_optics_lagrange_weights(place - (double)*node, weight);
  return true;
}

void um_optics_spectra_planck(const struct um_optics_spectra *spectra, double temperature,
                              double *row)
{
  for (size_t k = 0; k < spectra->nband; k++) {
    const struct um_optics_planck *table = &spectra->planck[k];
    size_t first = spectra->first[k], n = spectra->first[k + 1] - first, node;
    double w[4];
    if (nodes_about(table, temperature, &node, w)) {
      um_optics_lagrange_rows(w, table->radiance + (node - 1) * n, n, n, row + first);
      continue;
    }
    for (size_t i = 0; i < n; i++)
      row[first + i] = um_optics_planck_mean(spectra, first + i, temperature);
  }
}

enum um_status um_optics_planck_create(struct um_context *context, double low, double high,
                                       struct um_optics_spectra *s)
{
  UM_TRY(um_core_allocate(context, s->nband, sizeof *s->planck, &s->planck));
  for (size_t k = 0; k < s->nband; k++) {
    struct um_optics_planck *table = &s->planck[k];
    size_t first = s->first[k], n = s->first[k + 1] - first;
    double scale = s->from[first] / UM_RADIATION_C2; /* [1/K] per unit of C2/(lambda T) */
    double x_low = 1.0 / high, x_high = fmin(1.0 / low, PLANCK_LIMIT * scale);
    if (!(x_low < PLANCK_LIMIT * scale)) continue;
    bool faint = UM_RADIATION_C2 * x_low > PLANCK_FAINT * s->to[first + n - 1];
    table->step = fmin((faint ? PLANCK_STEP_FAINT : PLANCK_STEP) * scale, PLANCK_RATIO * x_low);
    table->x_from = x_low - table->step;
    double nodes = ceil((x_high - x_low) / table->step) + 4.0;
    if (!(nodes <= PLANCK_NODES)) continue; /* an absurd range: evaluate directly */
    table->nnode = (size_t)nodes;
    UM_TRY(um_core_allocate(context, table->nnode * n, sizeof *table->radiance, &table->radiance));
#pragma omp parallel for schedule(static) num_threads(um_core_context_threads(context))
    for (size_t i = 0; i < table->nnode; i++) {
      double temperature = 1.0 / (table->x_from + (double)i * table->step);
      for (size_t b = 0; b < n; b++)
        table->radiance[i * n + b] = um_optics_planck_mean(s, first + b, temperature);
    }
  }
  return UM_OK;
}

enum um_status um_optics_planck_sum_create(struct um_context *context,
                                           const struct um_optics_spectra *spectra,
                                           struct um_optics_planck_sum *sum)
{
  size_t nnode = 0;
  for (size_t k = 0; k < spectra->nband; k++) nnode += spectra->planck[k].nnode;
  UM_TRY(um_core_allocate(context, nnode, sizeof *sum->weight, &sum->weight));
  UM_TRY(um_core_allocate(context, spectra->nband, sizeof *sum->low, &sum->low));
  UM_TRY(um_core_allocate(context, spectra->nband, sizeof *sum->end, &sum->end));
  UM_TRY(um_core_allocate(context, spectra->nband, sizeof *sum->has_rest, &sum->has_rest));
  return um_core_allocate(context, spectra->nbin, sizeof *sum->rest, &sum->rest);
}

void um_optics_planck_sum_clear(struct um_context *context, struct um_optics_planck_sum *sum)
{
  UM_FREE(context, sum->weight, sum->low, sum->end, sum->has_rest, sum->rest);
}

void um_optics_planck_sum_add(const struct um_optics_spectra *spectra, double temperature,
                              double weight, struct um_optics_planck_sum *sum)
{
  double *nodes = sum->weight;
  for (size_t k = 0; k < spectra->nband; nodes += spectra->planck[k].nnode, k++) {
    size_t node;
    double w[4];
    if (!nodes_about(&spectra->planck[k], temperature, &node, w)) {
      sum->has_rest[k] = true;
      for (size_t b = spectra->first[k]; b < spectra->first[k + 1]; b++)
        sum->rest[b] += weight * um_optics_planck_mean(spectra, b, temperature);
      continue;
    }
    for (size_t i = 0; i < 4; i++) nodes[node - 1 + i] += weight * w[i];
    bool empty = sum->end[k] == 0;
    if (empty || node - 1 < sum->low[k]) sum->low[k] = node - 1;
    if (empty || node + 3 > sum->end[k]) sum->end[k] = node + 3;
  }
}

void um_optics_planck_sum_end(const struct um_optics_spectra *spectra,
                              struct um_optics_planck_sum *sum, double *row)
{
  double *nodes = sum->weight;
  memset(row, 0, spectra->nbin * sizeof *row);
  for (size_t k = 0; k < spectra->nband; nodes += spectra->planck[k].nnode, k++) {
    size_t first = spectra->first[k], n = spectra->first[k + 1] - first;
    double *to = row + first, *rest = sum->rest + first;
    for (size_t i = sum->low[k]; i < sum->end[k]; i++) {
      const double *radiance = spectra->planck[k].radiance + i * n;
      double w = nodes[i];
      if (w == 0.0) continue;
      for (size_t b = 0; b < n; b++) to[b] += w * radiance[b];
      nodes[i] = 0.0;
    }
    for (size_t b = 0; b < n && sum->has_rest[k]; b++) {
      to[b] += rest[b];
      rest[b] = 0.0;
    }
    sum->low[k] = sum->end[k] = 0;
    sum->has_rest[k] = false;
  }
}
