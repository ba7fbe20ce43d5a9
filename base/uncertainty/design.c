/* Designs of points in the unit cube. */
#include "base/uncertainty/design.h"

#include <gsl/gsl_qrng.h>
#include <math.h>
#include <string.h>

#include "base/core/sampling.h"

static enum um_status reserve(struct um_context *context, size_t d, size_t n, double **u)
{
  *u = NULL;
  if (d == 0 || d > UM_UNCERTAINTY_DIMENSIONS_MAX)
    return um_core_fail(context, UM_ERR_INPUT,
                        "a design of %zu parameters, at least 1 and at most %d", d,
                        UM_UNCERTAINTY_DIMENSIONS_MAX);
  if (n == 0) return um_core_fail(context, UM_ERR_INPUT, "a design without points");
  if (n > UM_UNCERTAINTY_NUMBERS_MAX / d)
    return um_core_fail(context, UM_ERR_INPUT,
                        "a design of %zu points of %zu parameters; at most %zu points are possible",
                        n, d, UM_UNCERTAINTY_NUMBERS_MAX / d);
  return um_core_allocate(context, n * d, sizeof **u, u);
}

double um_uncertainty_level(size_t i, size_t count, bool ends)
{
  if (count == 1) return 0.5;
  return ends ? (double)i / (double)(count - 1) : ((double)i + 0.5) / (double)count;
}

enum um_status um_uncertainty_grid(struct um_context *context, size_t d, const size_t *count,
                                   const bool *ends, double **u, size_t *n)
{
  *n = d > 0 ? 1 : 0;
  for (size_t k = 0; k < d; k++) {
    if (count[k] != 0 && *n > UM_UNCERTAINTY_NUMBERS_MAX / count[k]) {
      *u = NULL;
      return um_core_fail(context, UM_ERR_INPUT, "the levels of the grid make more points than %d",
                          UM_UNCERTAINTY_NUMBERS_MAX);
    }
    *n *= count[k];
  }
  UM_TRY(reserve(context, d, *n, u));
  for (size_t i = 0; i < *n; i++) {
    size_t rest = i;
    for (size_t k = d; k-- > 0; rest /= count[k])
      (*u)[i * d + k] = um_uncertainty_level(rest % count[k], count[k], ends[k]);
  }
  return UM_OK;
}

enum um_status um_uncertainty_paired(struct um_context *context, size_t d, size_t n, double **u)
{
  UM_TRY(reserve(context, d, n, u));
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < d; k++) (*u)[i * d + k] = um_uncertainty_level(i, n, false);
  return UM_OK;
}

/* Random number i of stream k. */
static double draw(uint64_t seed, uint64_t k, uint64_t i)
{
  return um_core_hash_uniform(um_core_hash(um_core_hash(seed, k), i));
}

/* One of 0 .. count - 1 from a number in [0, 1). */
static size_t pick(double r, size_t count)
{
  size_t i = (size_t)(r * (double)count);
  return i < count ? i : count - 1;
}

enum um_status um_uncertainty_latin_hypercube(struct um_context *context, size_t d, size_t n,
                                              uint64_t seed, double **u)
{
  UM_TRY(reserve(context, d, n, u));
  for (size_t k = 0; k < d; k++) {
    double *x = *u + k; /* every d-th: the share of each point, shuffled (Fisher & Yates) */
    for (size_t i = 0; i < n; i++) x[i * d] = (double)i;
    for (size_t i = n; i-- > 1;) {
      size_t j = pick(draw(seed, 2 * k, i), i + 1);
      double share = x[i * d];
      x[i * d] = x[j * d];
      x[j * d] = share;
    }
    for (size_t i = 0; i < n; i++) x[i * d] = (x[i * d] + draw(seed, 2 * k + 1, i)) / (double)n;
  }
  return UM_OK;
}

/* Points first .. first + n - 1 of a sequence of GSL's, whose own first is its point 1, as u
 * [n][d], shifted by a vector of the seed. */
static enum um_status sequence(struct um_context *context, const gsl_qrng_type *type, size_t d,
                               size_t first, size_t n, const uint64_t *seed, double *u)
{
  gsl_qrng *q = gsl_qrng_alloc(type, (unsigned)d);
  double scratch[2 * UM_UNCERTAINTY_DIMENSIONS_MAX];
  if (q == NULL) return um_core_fail(context, UM_ERR_MEMORY, "out of memory for a sequence");
  for (size_t i = 1; i < first; i++) gsl_qrng_get(q, scratch);
  for (size_t i = 0; i < n; i++) {
    if (first + i == 0)
      memset(u, 0, d * sizeof *u);
    else
      gsl_qrng_get(q, u + i * d);
    for (size_t k = 0; k < d && seed != NULL; k++) {
      double x = u[i * d + k] + draw(*seed, k, 0);
      u[i * d + k] = x - floor(x);
    }
  }
  gsl_qrng_free(q);
  return UM_OK;
}

static enum um_status filled(struct um_context *context, enum um_status status, double **u)
{
  if (status == UM_OK) return UM_OK;
  um_core_free(context, *u);
  *u = NULL;
  return status;
}

enum um_status um_uncertainty_sobol_sequence(struct um_context *context, size_t d, size_t n,
                                             uint64_t seed, double **u)
{
  UM_TRY(reserve(context, d, n, u));
  return filled(context, sequence(context, gsl_qrng_sobol, d, 0, n, seed ? &seed : NULL, *u), u);
}

enum um_status um_uncertainty_halton(struct um_context *context, size_t d, size_t first, size_t n,
                                     double **u)
{
  UM_TRY(reserve(context, d, n, u));
  return filled(context, sequence(context, gsl_qrng_halton, d, first, n, NULL, *u), u);
}

enum um_status um_uncertainty_one_at_a_time(struct um_context *context, size_t d, size_t count,
                                            const double *centre, double **u, size_t *n)
{
  *n = 1;
  *u = NULL;
  for (size_t k = 0; k < d; k++)
    if (!(centre[k] >= 0.0 && centre[k] <= 1.0))
      return um_core_fail(context, UM_ERR_INPUT,
                          "the centre of a design is %g on axis %zu, at least 0 and at most 1",
                          centre[k], k);
  if (count > UM_UNCERTAINTY_NUMBERS_MAX / 100)
    return um_core_fail(context, UM_ERR_INPUT, "%zu levels of a parameter, at most %d", count,
                        UM_UNCERTAINTY_NUMBERS_MAX / 100);
  UM_TRY(reserve(context, d, 1 + d * count, u));
  memcpy(*u, centre, d * sizeof **u);
  for (size_t k = 0; k < d; k++)
    for (size_t i = 0; i < count; i++) {
      double level = um_uncertainty_level(i, count, true);
      if (level == centre[k]) continue;
      memcpy(*u + *n * d, centre, d * sizeof **u);
      (*u)[*n * d + k] = level;
      ++*n;
    }
  return UM_OK;
}

enum um_status um_uncertainty_saltelli(struct um_context *context, size_t d, size_t n,
                                       uint64_t seed, double **u)
{
  enum um_status status;
  double *ab = NULL;
  *u = NULL;
  if (n > UM_UNCERTAINTY_NUMBERS_MAX)
    return um_core_fail(context, UM_ERR_INPUT, "%zu points of a design, at most %d", n,
                        UM_UNCERTAINTY_NUMBERS_MAX);
  UM_TRY(reserve(context, d, n * (d + 2), u));
  UM_CHECK(um_core_allocate(context, n, 2 * d * sizeof *ab, &ab));
  UM_CHECK(sequence(context, gsl_qrng_sobol, 2 * d, 0, n, &seed, ab));
  for (size_t j = 0; j < n; j++) {
    const double *a = ab + j * 2 * d, *b = a + d;
    double *row = *u + j * (d + 2) * d;
    memcpy(row, a, d * sizeof *row);
    memcpy(row + d, b, d * sizeof *row);
    for (size_t i = 0; i < d; i++) {
      memcpy(row + (2 + i) * d, a, d * sizeof *row);
      row[(2 + i) * d + i] = b[i];
    }
  }
done:
  um_core_free(context, ab);
  return filled(context, status, u);
}

enum um_status um_uncertainty_morris_trajectories(struct um_context *context, size_t d, size_t n,
                                                  size_t levels, uint64_t seed, double **u)
{
  *u = NULL;
  if (levels < 2 || levels % 2 != 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%zu levels of Morris's design, which wants an even number of 2 or more",
                        levels);
  if (n > UM_UNCERTAINTY_NUMBERS_MAX)
    return um_core_fail(context, UM_ERR_INPUT, "%zu trajectories, at most %d", n,
                        UM_UNCERTAINTY_NUMBERS_MAX);
  UM_TRY(reserve(context, d, n * (d + 1), u));
  size_t half = levels / 2; /* a step, in spacings of the grid */
  double spacing = 1.0 / (double)(levels - 1);
  for (size_t t = 0; t < n; t++) {
    size_t order[UM_UNCERTAINTY_DIMENSIONS_MAX];
    double *row = *u + t * (d + 1) * d;
    bool up[UM_UNCERTAINTY_DIMENSIONS_MAX];
    for (size_t k = 0; k < d; k++) {
      order[k] = k;
      /* below the middle a step up stays inside, above it a step down */
      size_t level = pick(draw(seed, 3 * t, k), levels);
      up[k] = level < half;
      row[k] = (double)level * spacing;
    }
    for (size_t k = d; k-- > 1;) {
      size_t j = pick(draw(seed, 3 * t + 1, k), k + 1), axis = order[k];
      order[k] = order[j];
      order[j] = axis;
    }
    for (size_t k = 0; k < d; k++) {
      double *next = row + (k + 1) * d;
      size_t axis = order[k];
      memcpy(next, next - d, d * sizeof *next);
      next[axis] += up[axis] ? (double)half * spacing : -(double)half * spacing;
      next[axis] = fmin(fmax(next[axis], 0.0), 1.0); /* rounding */
    }
  }
  return UM_OK;
}
