/* Which terms of a growing surrogate come next. */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/uncertainty/surrogate_growth_impl.h"

#define BULK 0.5 /* terms of at least this share of the largest one are taken along with it */

static size_t find(const struct um_uncertainty_surrogate *s, const unsigned char *degree)
{
  for (size_t t = 0; t < s->nterm; t++)
    if (memcmp(s->term[t].degree, degree, s->d) == 0) return t;
  return SIZE_MAX;
}

/* Whether all terms of one degree less are there and passed, and this one is not there. */
static bool admissible(const struct um_uncertainty_surrogate *s, unsigned char *degree)
{
  if (find(s, degree) != SIZE_MAX) return false;
  for (size_t k = 0; k < s->d; k++) {
    if (degree[k] == 0) continue;
    degree[k]--;
    size_t below = find(s, degree);
    degree[k]++;
    if (below == SIZE_MAX || !s->term[below].passed) return false;
  }
  return true;
}

/* All terms that the passing of term t admits, behind those in list [*n][d]. */
static enum um_status pass(struct um_context *context, struct um_uncertainty_surrogate *s, size_t t,
                           unsigned char **list, size_t *n)
{
  unsigned char next[UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX];
  s->term[t].passed = true;
  UM_TRY(um_core_reallocate(context, (*n + s->d) * s->d, 1, list));
  for (size_t k = 0; k < s->d; k++) {
    memcpy(next, s->term[t].degree, s->d);
    if (++next[k] >= UM_UNCERTAINTY_LEVELS || !admissible(s, next)) continue;
    bool listed = false;
    for (size_t i = 0; i < *n; i++) listed = listed || memcmp(*list + i * s->d, next, s->d) == 0;
    if (!listed) memcpy(*list + (*n)++ * s->d, next, s->d);
  }
  return UM_OK;
}

static size_t order(const struct um_uncertainty_surrogate *s, size_t t)
{
  size_t sum = 0;
  for (size_t k = 0; k < s->d; k++) sum += s->term[t].degree[k];
  return sum;
}

/* How much of what is left of the worst value at the held-out points, r [nheld], a term beyond term
 * t may explain: max (h'r)^2 / h'h with the new term's basis function h there. They choose where
 * to look, not what is found. */
static double beyond(const struct um_uncertainty_growth *g, size_t t, const double *r)
{
  struct um_uncertainty_surrogate *s = g->s;
  unsigned char degree[UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX];
  double most = -1.0, h[UM_UNCERTAINTY_LEVELS];
  memcpy(degree, s->term[t].degree, s->d);
  s->term[t].passed = true;
  for (size_t k = 0; k < s->d; k++) {
    if (++degree[k] < UM_UNCERTAINTY_LEVELS && admissible(s, degree)) {
      double product = 0.0, square = 0.0;
      for (size_t i = 0; i < s->nheld; i++) {
        double basis = 1.0;
        for (size_t a = 0; a < s->d; a++) {
          um_uncertainty_axis_basis(&s->axis, g->held[i * s->d + a], (size_t)degree[a] + 1, h);
          basis *= h[degree[a]];
        }
        product += basis * r[i * s->nvalue];
        square += basis * basis;
      }
      if (square > 0.0) most = fmax(most, product * product / square);
    }
    degree[k]--;
  }
  s->term[t].passed = false;
  return most;
}

/* What is left at the held-out points of the value that is worst there, every nvalue-th. */
static const double *worst_left(const struct um_uncertainty_growth *g)
{
  size_t worst = 0;
  for (size_t i = 1; i < g->s->ngroup; i++)
    if (g->s->error[i].share > g->s->error[worst].share) worst = i;
  return g->left + g->request->group[worst].first + g->s->error[worst].value;
}

/* The next terms. Beyond those that are larger than what is asked: the largest and what is of its
 * kind. Where none is, but held-out points disagree, since terms vanish by symmetry or are small by
 * chance: beyond the one that explains most of that, and every third time the one of lowest order,
 * in case the first have all vanished. */
enum um_status um_uncertainty_growth_choose(struct um_context *context,
                                            struct um_uncertainty_growth *g, unsigned char **list,
                                            size_t *n)
{
  struct um_uncertainty_surrogate *s = g->s;
  double largest = -1.0, most = -1.0;
  size_t lowest = SIZE_MAX, at = 0, nterm = s->nterm;
  *n = 0;
  for (size_t t = 0; t < nterm; t++) {
    if (s->term[t].passed) continue;
    largest = fmax(largest, s->term[t].size);
    if (lowest == SIZE_MAX || order(s, t) < order(s, lowest)) lowest = t;
  }
  if (lowest == SIZE_MAX) return UM_OK;
  if (largest > 1.0) {
    for (size_t t = 0; t < nterm; t++)
      if (!s->term[t].passed && s->term[t].size >= fmax(1.0, BULK * largest))
        UM_TRY(pass(context, s, t, list, n));
    return UM_OK;
  }
  for (size_t t = 0; t < nterm; t++) {
    double explained = s->term[t].passed ? -2.0 : beyond(g, t, worst_left(g));
    if (explained <= most) continue;
    most = explained;
    at = t;
  }
  return pass(context, s, ++g->searches % 3 == 0 || most < 0.0 ? lowest : at, list, n);
}
