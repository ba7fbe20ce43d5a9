/* All orders of diffuse reflection between patches,
 *
 *   B = S (1 - r A^-1 S)^-1 = S + S R M^-1 R S,   M = 1 - R S R,   R = sqrt(r / A).
 *
 * M is symmetric and positive definite where light finds a way out of every room or into one of its
 * walls. Its eigenvalues lie within rho of 1, rho the largest share of what leaves a patch that
 * comes back once: where that is not near 1, B x = S (x + R y), M y = R S x, by conjugate gradients
 * (Hestenes and Stiefel 1952), which read the few entries of S a dozen times. A room that hardly
 * absorbs, and a few patches, have B itself, by Cholesky factors: with L L^T = M and Y = L^-1 R S,
 * B = S + Y^T Y. */
#include "thermal/exchange/reflections_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/wide.h"

#define WHITEST    (1.0 - 1e-9) /* largest reflectance: a white room has no balance */
#define COLUMNS    64           /* solved at a time */
#define FEW        64           /* patches: B itself is no larger than what else is kept of them */
#define RETURNING  0.98         /* rho up to which M is iterated with [1] */
#define RESIDUAL   1e-11        /* of M y = R S x, of its right-hand side [1] */
#define ITERATIONS 1000         /* M y = R S x takes 100 where rho is largest */
#define TOGETHER   UM_THERMAL_TOGETHER

struct um_thermal_reflections {
  const struct um_geometry_view_factors *factors; /* borrowed */
  double *root;                                   /* [n] R [1/m] */
  double *b;                                      /* [n][n] [m^2]; NULL: M is iterated with */
};

enum um_status um_thermal_reflections_fail(struct um_context *context)
{
  return um_core_fail(context, UM_ERR_NUMERIC,
                      "light between surfaces finds no end: a room without a way out whose walls "
                      "absorb nothing; accepted: walls that absorb");
}

/* L in place of the lower triangle of m; false: not positive definite. */
static bool cholesky(double *m, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    double *row = m + i * n;
    for (size_t j = 0; j <= i; j++) {
      const double *other = m + j * n;
      double sum = row[j];
      for (size_t k = 0; k < j; k++) sum -= row[k] * other[k];
      if (j < i)
        row[j] = sum / other[j];
      else if (sum > 0.0)
        row[j] = sqrt(sum);
      else
        return false;
    }
  }
  return true;
}

/* y <- L^-1 y for columns [from, to). */
static void forward(const double *l, double *y, size_t n, size_t from, size_t to)
{
  for (size_t i = 0; i < n; i++) {
    double *row = y + i * n;
    for (size_t k = 0; k < i; k++) {
      double factor = l[i * n + k];
      const double *other = y + k * n;
      for (size_t q = from; factor != 0.0 && q < to; q++) row[q] -= factor * other[q];
    }
    for (size_t q = from; q < to; q++) row[q] /= l[i * n + i];
  }
}

/* m = 1 - R S R, y = R S, b = S. */
static void fill(const struct um_thermal_reflections *r, double *m, double *y)
{
  const struct um_geometry_view_factors *f = r->factors;
  size_t n = f->npatch;
  for (size_t p = 0; p < n; p++) {
    m[p * n + p] = 1.0;
    for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++) {
      size_t q = f->other[e];
      m[p * n + q] -= r->root[p] * f->area[e] * r->root[q];
      y[p * n + q] = r->root[p] * f->area[e];
      r->b[p * n + q] = f->area[e];
    }
  }
}

/* B itself. */
static enum um_status make_all(struct um_context *context, struct um_thermal_reflections *r)
{
  enum um_status status;
  size_t n = r->factors->npatch;
  double *m = NULL, *y = NULL;
  UM_CHECK(um_core_allocate(context, n * n, sizeof *r->b, &r->b));
  UM_CHECK(um_core_allocate(context, n * n, sizeof *m, &m));
  UM_CHECK(um_core_allocate(context, n * n, sizeof *y, &y));
  fill(r, m, y);
  if (!cholesky(m, n)) {
    status = um_thermal_reflections_fail(context);
    goto done;
  }
  UM_CHECK(um_core_stop_check(context, "reflections were added up"));
  long blocks = (long)((n + COLUMNS - 1) / COLUMNS), rows = (long)n;
#pragma omp parallel for schedule(dynamic, 1) num_threads(um_core_context_threads(context))
  for (long k = 0; k < blocks; k++) {
    size_t from = (size_t)k * COLUMNS, to = from + COLUMNS;
    forward(m, y, n, from, to < n ? to : n);
  }
#pragma omp parallel for schedule(dynamic, 8) num_threads(um_core_context_threads(context))
  for (long p = 0; p < rows; p++) {
    double *row = r->b + (size_t)p * n;
    for (size_t k = 0; k < n; k++) {
      double factor = y[k * n + (size_t)p];
      const double *other = y + k * n;
      for (size_t q = 0; factor != 0.0 && q < n; q++) row[q] += factor * other[q];
    }
  }
done:
  UM_FREE(context, m, y);
  return status;
}

enum um_status um_thermal_reflections_create(struct um_context *context,
                                             const struct um_geometry_view_factors *factors,
                                             const double *area, const double *reflectance,
                                             struct um_thermal_reflections **out)
{
  enum um_status status;
  struct um_thermal_reflections *r = NULL;
  size_t n = factors->npatch;
  double rho = 0.0; /* row sums of r A^-1 S */
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *r, &r));
  r->factors = factors;
  UM_CHECK(um_core_allocate(context, n, sizeof *r->root, &r->root));
  for (size_t p = 0; p < n; p++) {
    double reflected = fmin(fmax(reflectance[p], 0.0), WHITEST), seen = 0.0;
    r->root[p] = sqrt(reflected / area[p]);
    for (size_t e = factors->begin[p]; e < factors->begin[p + 1]; e++) seen += factors->area[e];
    rho = fmax(rho, reflected / area[p] * seen);
  }
  if (n <= FEW || !(rho <= RETURNING)) UM_CHECK(make_all(context, r));
  *out = r;
  r = NULL;
done:
  um_thermal_reflections_destroy(context, &r);
  return status;
}

void um_thermal_reflections_destroy(struct um_context *context, struct um_thermal_reflections **r)
{
  if (*r == NULL) return;
  UM_FREE(context, (*r)->root, (*r)->b, *r);
  *r = NULL;
}

/* out[TOGETHER]: of b[q] times x[q], q through lit[nlit]. */
UM_WIDE_VECTORS static void gather(const double *b, const uint32_t *lit, size_t nlit,
                                   const double *x, double *out)
{
  double sum[TOGETHER] = {0.0};
  for (size_t j = 0; j < nlit; j++) {
    double share = b[lit[j]];
    const double *of = x + (size_t)lit[j] * TOGETHER;
    for (size_t k = 0; k < TOGETHER; k++) sum[k] += share * of[k];
  }
  memcpy(out, sum, sizeof sum);
}

/* out = S x. */
UM_WIDE_VECTORS static void multiply(const struct um_geometry_view_factors *f, const double *x,
                                     double *out)
{
  for (size_t p = 0; p < f->npatch; p++) {
    double sum[TOGETHER] = {0.0};
    for (size_t e = f->begin[p]; e < f->begin[p + 1]; e++) {
      double area = f->area[e];
      const double *of = x + (size_t)f->other[e] * TOGETHER;
      for (size_t k = 0; k < TOGETHER; k++) sum[k] += area * of[k];
    }
    memcpy(out + p * TOGETHER, sum, sizeof sum);
  }
}

/* out = R x. */
static void scale(const struct um_thermal_reflections *r, const double *x, double *out)
{
  for (size_t p = 0; p < r->factors->npatch; p++)
    for (size_t k = 0; k < TOGETHER; k++) out[p * TOGETHER + k] = r->root[p] * x[p * TOGETHER + k];
}

/* sum[TOGETHER] of the columns' products. */
UM_WIDE_VECTORS static void products(const double *a, const double *b, size_t n, double *out)
{
  double sum[TOGETHER] = {0.0};
  for (size_t p = 0; p < n; p++)
    for (size_t k = 0; k < TOGETHER; k++) sum[k] += a[p * TOGETHER + k] * b[p * TOGETHER + k];
  memcpy(out, sum, sizeof sum);
}

/* y = M^-1 rest, which is used up; along, turned, scaled: scratch, all [n][TOGETHER]. */
static bool iterate(const struct um_thermal_reflections *r, double *rest, double *along,
                    double *turned, double *scaled, double *y)
{
  size_t n = r->factors->npatch;
  double left[TOGETHER], wanted[TOGETHER], curve[TOGETHER], step[TOGETHER], keep[TOGETHER];
  products(rest, rest, n, left);
  for (size_t k = 0; k < TOGETHER; k++) wanted[k] = RESIDUAL * RESIDUAL * left[k];
  memset(y, 0, n * TOGETHER * sizeof *y);
  memcpy(along, rest, n * TOGETHER * sizeof *along);
  for (int round = 0; round < ITERATIONS; round++) {
    bool done = true;
    for (size_t k = 0; k < TOGETHER; k++) done = done && left[k] <= wanted[k];
    if (done) return true;
    scale(r, along, scaled);
    multiply(r->factors, scaled, turned);
    scale(r, turned, scaled);
    for (size_t i = 0; i < n * TOGETHER; i++) turned[i] = along[i] - scaled[i];
    products(along, turned, n, curve);
    for (size_t k = 0; k < TOGETHER; k++) {
      if (left[k] > wanted[k] && !(curve[k] > 0.0)) return false;
      step[k] = left[k] > wanted[k] ? left[k] / curve[k] : 0.0;
      keep[k] = left[k];
    }
    for (size_t p = 0; p < n; p++)
      for (size_t k = 0; k < TOGETHER; k++) {
        y[p * TOGETHER + k] += step[k] * along[p * TOGETHER + k];
        rest[p * TOGETHER + k] -= step[k] * turned[p * TOGETHER + k];
      }
    products(rest, rest, n, left);
    for (size_t k = 0; k < TOGETHER; k++) keep[k] = keep[k] > 0.0 ? left[k] / keep[k] : 0.0;
    for (size_t p = 0; p < n; p++)
      for (size_t k = 0; k < TOGETHER; k++)
        along[p * TOGETHER + k] = rest[p * TOGETHER + k] + keep[k] * along[p * TOGETHER + k];
  }
  return false;
}

size_t um_thermal_reflections_scratch(const struct um_thermal_reflections *r)
{
  return (r->b != NULL ? 1 : 5 * TOGETHER) * r->factors->npatch;
}

bool um_thermal_reflections_apply(const struct um_thermal_reflections *r, const double *x,
                                  double *scratch, double *out)
{
  size_t n = r->factors->npatch, nlit = 0;
  if (r->b != NULL) {
    uint32_t *lit = (uint32_t *)scratch;
    for (size_t p = 0; p < n; p++) {
      bool any = false;
      for (size_t k = 0; k < TOGETHER; k++) any = any || x[p * TOGETHER + k] != 0.0;
      if (any) lit[nlit++] = (uint32_t)p;
    }
    for (size_t p = 0; p < n; p++) gather(r->b + p * n, lit, nlit, x, out + p * TOGETHER);
    return true;
  }
  size_t size = n * TOGETHER;
  double *rest = scratch, *along = rest + size, *turned = along + size, *scaled = turned + size,
         *y = scaled + size;
  multiply(r->factors, x, out);
  scale(r, out, rest);
  if (!iterate(r, rest, along, turned, scaled, y)) return false;
  scale(r, y, scaled);
  for (size_t i = 0; i < size; i++) scaled[i] += x[i];
  multiply(r->factors, scaled, out);
  return true;
}
