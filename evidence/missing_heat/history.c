/* A history of heat that keeps its edges. Heat changes at few of the edges of the bins, by steps
 * delta_e that are normal with one size s:
 *
 *   heat of bin b = sum of delta_e over the changes e <= b.
 *
 * No change is preferred: every number of changes is as likely, and every set of as many; s is flat
 * in its logarithm. So nothing is set by hand; what another change has to bring follows from the
 * data (MacKay 1992, Neural Computation 4:415). With the steps taken out the posterior of a set E
 * is
 *
 *   ln p = v'M^-1 v / 2 - ln det(s^2 M) / 2 - ln C(nbin, k),   M = G + 1 / s^2,
 *
 * G the products of what steps at E do, v those with the residual. It is sampled by changes that
 * are born, die and move (Green 1995, Biometrika 82:711). The band are quantiles of what was drawn.
 */
#include "evidence/missing_heat/history_impl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/order.h"
#include "base/core/sampling.h"
#include "evidence/missing_heat/policy.h"

#define NEAR 3 /* bins that a change moves by at most, at one time in two */

struct changes {
  size_t k, at[UM_MISSING_HEAT_CHANGES];
  double size; /* ln s */
  double log;  /* of the posterior, less what moves take into account themselves */
};

struct chain {
  size_t n;
  const double *gram, *with; /* [n][n], [n] of steps */
  double smallest, largest;  /* of ln s */
  uint64_t key, drawn;
  struct changes now;
  double factor[UM_MISSING_HEAT_CHANGES][UM_MISSING_HEAT_CHANGES]; /* M = F F' */
  double half[UM_MISSING_HEAT_CHANGES];                            /* F^-1 v */
};

static double draw(struct chain *c)
{
  return um_core_hash_uniform(um_core_hash(c->key, c->drawn++));
}

static size_t draw_below(struct chain *c, size_t n)
{
  size_t i = (size_t)(draw(c) * (double)n);
  return i < n ? i : n - 1;
}

static double draw_normal(struct chain *c) /* Box & Muller 1958 */
{
  double radius = sqrt(-2.0 * log(1.0 - draw(c)));
  return radius * cos(2.0 * UM_PI * draw(c));
}

/* F, F^-1 v and log of a set. */
static void weigh(struct chain *c, struct changes *s)
{
  double stiff = exp(-2.0 * s->size);
  s->log = -(double)s->k * s->size;
  for (size_t i = 0; i < s->k; i++) {
    double with = c->with[s->at[i]];
    for (size_t j = 0; j <= i; j++) {
      double sum = c->gram[s->at[i] * c->n + s->at[j]] + (i == j ? stiff : 0.0);
      for (size_t l = 0; l < j; l++) sum -= c->factor[i][l] * c->factor[j][l];
      if (i == j)
        c->factor[i][i] = sqrt(fmax(sum, 1e-6 * stiff)); /* rounding must not make it negative */
      else
        c->factor[i][j] = sum / c->factor[j][j];
    }
    for (size_t l = 0; l < i; l++) with -= c->factor[i][l] * c->half[l];
    c->half[i] = with / c->factor[i][i];
    s->log += 0.5 * c->half[i] * c->half[i] - log(c->factor[i][i]);
  }
}

static bool has(const struct changes *s, size_t edge)
{
  for (size_t i = 0; i < s->k; i++)
    if (s->at[i] == edge) return true;
  return false;
}

/* Another set; false: there is none. Births and deaths are as likely as the number of sets asks. */
static bool propose(struct chain *c, struct changes *next)
{
  double kind = draw(c);
  *next = c->now;
  if (kind < 0.25) { /* birth */
    size_t edge = draw_below(c, c->n);
    if (next->k == UM_MISSING_HEAT_CHANGES || next->k == c->n) return false;
    while (has(next, edge)) edge = draw_below(c, c->n);
    next->at[next->k++] = edge;
    return true;
  }
  if (kind < 0.5) { /* death */
    if (next->k == 0) return false;
    size_t i = draw_below(c, next->k);
    next->at[i] = next->at[--next->k];
    return true;
  }
  if (kind < 0.9) { /* move */
    if (next->k == 0) return false;
    size_t i = draw_below(c, next->k);
    size_t to =
        draw(c) < 0.5 ? draw_below(c, c->n) : next->at[i] + draw_below(c, 2 * NEAR + 1) - NEAR;
    if (to >= c->n || has(next, to)) return false; /* below 0 has wrapped */
    next->at[i] = to;
    return true;
  }
  next->size += 1.5 * (2.0 * draw(c) - 1.0);
  return next->size > c->smallest && next->size < c->largest;
}

static void move(struct chain *c)
{
  struct changes next;
  bool possible = propose(c, &next);
  double level = log(draw(c));
  if (!possible) return;
  weigh(c, &next);
  if (level < next.log - c->now.log) c->now = next;
}

/* One history of those that the set may have. */
static void take(struct chain *c, double *heat)
{
  double step[UM_MISSING_HEAT_CHANGES];
  weigh(c, &c->now);
  for (size_t i = c->now.k; i-- > 0;) { /* F' step = F^-1 v + z */
    double sum = c->half[i] + draw_normal(c);
    for (size_t j = i + 1; j < c->now.k; j++) sum -= c->factor[j][i] * step[j];
    step[i] = sum / c->factor[i][i];
  }
  for (size_t b = 0; b < c->n; b++) {
    heat[b] = 0.0;
    for (size_t i = 0; i < c->now.k; i++)
      if (c->now.at[i] <= b) heat[b] += step[i];
  }
}

static void sample(struct chain *c, double *heat)
{
  for (int k = 0; k < UM_MISSING_HEAT_FORGET; k++) move(c);
  for (size_t d = 0; d < UM_MISSING_HEAT_DRAWS; d++) {
    for (int k = 0; k < UM_MISSING_HEAT_BETWEEN; k++) move(c);
    take(c, heat + d * c->n);
  }
}

/* Products of steps: of heat from a bin on. */
static void sum_up(const struct um_missing_heat_bins *bins, double scale, double *gram,
                   double *with)
{
  size_t n = bins->nbin;
  for (size_t i = n; i-- > 0;) {
    with[i] = bins->with[i] / scale + (i + 1 < n ? with[i + 1] : 0.0);
    for (size_t j = n; j-- > 0;)
      gram[i * n + j] = bins->gram[i * n + j] / scale + (i + 1 < n ? gram[(i + 1) * n + j] : 0.0) +
                        (j + 1 < n ? gram[i * n + j + 1] : 0.0) -
                        (i + 1 < n && j + 1 < n ? gram[(i + 1) * n + j + 1] : 0.0);
  }
}

static void summarise(size_t n, size_t count, const double *heat, double *sorted,
                      const struct um_missing_heat_band *out)
{
  size_t off = (size_t)(0.5 * (1.0 - UM_MISSING_HEAT_BAND) * (double)count);
  for (size_t b = 0; b < n; b++) {
    double mean = 0.0, square = 0.0;
    for (size_t d = 0; d < count; d++) {
      sorted[d] = heat[d * n + b];
      mean += sorted[d] / (double)count;
    }
    for (size_t d = 0; d < count; d++) square += (sorted[d] - mean) * (sorted[d] - mean);
    qsort(sorted, count, sizeof *sorted, um_core_order_double);
    out->heat[b] = 0.5 * (sorted[(count - 1) / 2] + sorted[count / 2]);
    out->sigma[b] = sqrt(square / (double)(count - 1));
    out->low[b] = sorted[off];
    out->high[b] = sorted[count - 1 - off];
  }
}

enum um_status um_missing_heat_history(struct um_context *context,
                                       const struct um_missing_heat_bins *bins, double scale,
                                       const struct um_missing_heat_band *out)
{
  enum um_status status;
  size_t n = bins->nbin, count = (size_t)UM_MISSING_HEAT_CHAINS * UM_MISSING_HEAT_DRAWS;
  double *gram = NULL, *with = NULL, *heat = NULL, *sorted = NULL, most = 0.0;
  struct chain *chain = NULL;
  UM_CHECK(um_core_allocate(context, n * n, sizeof *gram, &gram));
  UM_CHECK(um_core_allocate(context, n, sizeof *with, &with));
  UM_CHECK(um_core_allocate(context, count * n, sizeof *heat, &heat));
  UM_CHECK(um_core_allocate(context, count, sizeof *sorted, &sorted));
  UM_CHECK(um_core_allocate(context, 1, sizeof *chain, &chain));
  sum_up(bins, scale, gram, with);
  for (size_t i = 0; i < n; i++) most = fmax(most, gram[i * n + i]);
  double seen = most > 0.0 ? -0.5 * log(most) : 0.0; /* ln of a power of one sigma */
  for (size_t k = 0; k < UM_MISSING_HEAT_CHAINS; k++) {
    *chain = (struct chain){.n = n, .gram = gram, .with = with, .key = 977 + k};
    chain->smallest = seen;
    chain->largest = seen + UM_MISSING_HEAT_SIZES;
    chain->now.size = seen + 0.25 * (double)(k + 1) * UM_MISSING_HEAT_SIZES * 0.9;
    sample(chain, heat + k * UM_MISSING_HEAT_DRAWS * n);
  }
  summarise(n, count, heat, sorted, out);
done:
  UM_FREE(context, gram, with, heat, sorted, chain);
  return status;
}
