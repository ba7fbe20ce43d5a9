/* All orders of diffuse reflection between patches,
 *
 *   B = S (1 - r A^-1 S)^-1,   B x = S (x + R y),   M y = R S x,   M = 1 - R S R,
 *   R = sqrt(r / A).
 *
 * M is symmetric and positive definite where light finds a way out of every room or into one of its
 * walls, and its eigenvalues lie within rho of 1, rho the largest share of what leaves a patch that
 * comes back once. Conjugate gradients (Hestenes and Stiefel 1952) read the few entries of S a
 * dozen times where rho is small; where it is near 1, or patches see most of the others, M has
 * Cholesky factors (triangle.c). */
#include "thermal/exchange/reflections_impl.h"

#include <math.h>
#include <string.h>

#include "base/core/wide.h"
#include "thermal/exchange/triangle_impl.h"

#define WHITEST    (1.0 - 1e-9) /* largest reflectance: a white room has no balance */
#define RETURNING  0.98         /* rho up to which M is iterated with [1] */
#define RESIDUAL   1e-11        /* of M y = R S x, of its right-hand side [1] */
#define ITERATIONS 1000         /* M y = R S x takes 150 where rho is largest */
#define EACH       2.5          /* what an entry of S costs of one of the factors, read in order */
#define TOGETHER   UM_THERMAL_TOGETHER

struct um_thermal_reflections {
  const struct um_geometry_view_factors *factors; /* borrowed */
  double *root;                                   /* [n] R [1/m] */
  double *l; /* the triangle of M's factors; NULL: M is iterated with */
};

enum um_status um_thermal_reflections_fail(struct um_context *context)
{
  return um_core_fail(context, UM_ERR_NUMERIC,
                      "light between surfaces finds no end: a room without a way out whose walls "
                      "absorb nothing; accepted: walls that absorb");
}

/* M as factors. */
static enum um_status factorise(struct um_context *context, struct um_thermal_reflections *r)
{
  const struct um_geometry_view_factors *f = r->factors;
  size_t n = f->npatch;
  bool definite;
  UM_TRY(um_core_allocate(context, n * (n + 1) / 2, sizeof *r->l, &r->l));
  for (size_t p = 0; p < n; p++) {
    double *row = um_thermal_triangle_row(r->l, p);
    row[p] = 1.0;
    for (size_t e = f->begin[p]; e < f->begin[p + 1] && f->other[e] <= p; e++)
      row[f->other[e]] -= r->root[p] * f->area[e] * r->root[f->other[e]];
  }
  UM_TRY(um_thermal_triangle_factorise(context, n, r->l, &definite));
  return definite ? UM_OK : um_thermal_reflections_fail(context);
}

/* Whether factors are worth it, for as many columns as there are patches: n^3 / 6 for them and n^2
 * a column, or as many times all entries of S as the error, (rho / (1 + sqrt(1 - rho^2)))^k of
 * which is left (Saad 2003, eq. 6.128), wants. */
static bool is_dense(const struct um_geometry_view_factors *factors, double rho)
{
  double n = (double)factors->npatch;
  double rounds = 2.0 + log(RESIDUAL) / log(fmax(rho, 1e-3) / (1.0 + sqrt(1.0 - rho * rho)));
  return EACH * rounds * (double)factors->begin[factors->npatch] > 7.0 / 6.0 * n * n;
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
  if (!(rho <= RETURNING) || is_dense(factors, rho)) UM_CHECK(factorise(context, r));
  *out = r;
  r = NULL;
done:
  um_thermal_reflections_destroy(context, &r);
  return status;
}

void um_thermal_reflections_destroy(struct um_context *context, struct um_thermal_reflections **r)
{
  if (*r == NULL) return;
  UM_FREE(context, (*r)->root, (*r)->l, *r);
  *r = NULL;
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

/* The same where few patches send: S is symmetric, and theirs are the rows that are read. */
UM_WIDE_VECTORS static void multiply_few(const struct um_geometry_view_factors *f, const double *x,
                                         double *out)
{
  memset(out, 0, f->npatch * TOGETHER * sizeof *out);
  for (size_t q = 0; q < f->npatch; q++) {
    const double *of = x + q * TOGETHER;
    bool any = false;
    for (size_t k = 0; k < TOGETHER; k++) any = any || of[k] != 0.0;
    for (size_t e = f->begin[q]; any && e < f->begin[q + 1]; e++) {
      double *to = out + (size_t)f->other[e] * TOGETHER;
      for (size_t k = 0; k < TOGETHER; k++) to[k] += f->area[e] * of[k];
    }
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
  return (r->l != NULL ? 2u : 5u) * TOGETHER * r->factors->npatch;
}

bool um_thermal_reflections_apply(const struct um_thermal_reflections *r, const double *x,
                                  double *scratch, double *out)
{
  size_t n = r->factors->npatch, size = n * TOGETHER;
  double *scaled = scratch, *rest = scaled + size, *along = rest + size, *turned = along + size,
         *y = turned + size;
  multiply_few(r->factors, x, out);
  scale(r, out, rest);
  if (r->l != NULL) {
    um_thermal_triangle_solve(r->l, n, rest);
    y = rest;
  } else if (!iterate(r, rest, along, turned, scaled, y)) {
    return false;
  }
  scale(r, y, scaled);
  for (size_t i = 0; i < size; i++) scaled[i] += x[i];
  multiply(r->factors, scaled, out);
  return true;
}
