/* Flexible GMRES about the exchange between surfaces. What is emitted is in A, what comes back in
 * E, and less comes back than goes: 1 - s E A^-1 has its eigenvalues in (0, 1], so that a few
 * products suffice unless a room is closed. Right-hand sides go side by side, each with a basis of
 * its own: what a product reads of E and A serves all. */
#include "thermal/solver/exchange_solve_group.h"

#include <math.h>
#include <string.h>

#include "base/core/wide.h"

#define LOT      UM_THERMAL_LOT
#define DEPTH    30 /* vectors kept between restarts */
#define RESTARTS 10
#define ROUNDING 1e-12 /* of a right side: no residual falls below it */

/* One right-hand side. */
struct column {
  double *x;                  /* [n] the solution so far; of the caller */
  double *b;                  /* [n] */
  double *v;                  /* [DEPTH + 1][n] orthonormal */
  double *z;                  /* [DEPTH][n] A^-1 v */
  double size, left;          /* norms of b, of the residual */
  bool runs;                  /* in this round */
  int m;                      /* products in this round */
  double h[DEPTH + 1][DEPTH]; /* Hessenberg, turned to a triangle */
  double cosine[DEPTH], sine[DEPTH], g[DEPTH + 1];
};
struct um_thermal_exchange_solver {
  struct um_thermal_system *system; /* borrowed */
  size_t lot;
  struct column *column;          /* [lot] */
  double *vectors;                /* of all columns */
  double *work, *product;         /* [lot][n] */
  double (*in)[LOT], (*out)[LOT]; /* [n] a lot, column by column; lot 1: none */
};

/* What solves a lot at a time. */
struct equations {
  const struct um_thermal_inner *inner;
  const double *value;
  double scale, tolerance;
};

enum um_status um_thermal_exchange_solver_create(struct um_thermal_system *system, size_t lot,
                                                 struct um_thermal_exchange_solver **out)
{
  enum um_status status;
  struct um_context *context = system->context;
  struct um_thermal_exchange_solver *solver = NULL;
  size_t n = system->nunknown, own = (2 * DEPTH + 2) * n;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *solver, &solver));
  solver->system = system;
  solver->lot = lot;
  UM_CHECK(um_core_allocate(context, lot, sizeof *solver->column, &solver->column));
  UM_CHECK(um_core_allocate(context, lot, own * sizeof(double), &solver->vectors));
  UM_CHECK(um_core_allocate(context, lot, n * sizeof(double), &solver->work));
  UM_CHECK(um_core_allocate(context, lot, n * sizeof(double), &solver->product));
  for (size_t k = 0; k < lot; k++) {
    solver->column[k].b = solver->vectors + k * own;
    solver->column[k].v = solver->column[k].b + n;
    solver->column[k].z = solver->column[k].v + (DEPTH + 1) * n;
  }
  if (lot > 1) {
    UM_CHECK(um_core_allocate(context, n, sizeof *solver->in, &solver->in));
    UM_CHECK(um_core_allocate(context, n, sizeof *solver->out, &solver->out));
    UM_CHECK(um_thermal_system_exchange_reserve_lot(system));
  }
  *out = solver;
  return UM_OK;
done:
  um_thermal_exchange_solver_destroy(&solver);
  return status;
}

void um_thermal_exchange_solver_destroy(struct um_thermal_exchange_solver **solver)
{
  if (solver == NULL || *solver == NULL) return;
  struct um_thermal_exchange_solver *s = *solver;
  UM_FREE(s->system->context, s->column, s->vectors, s->work, s->product, s->in, s->out, s);
  *solver = NULL;
}

static double product(const double *a, const double *b, size_t n)
{
  double sum[4] = {0.0, 0.0, 0.0, 0.0};
  size_t k = 0;
  for (; k + 4 <= n; k += 4)
    for (size_t s = 0; s < 4; s++) sum[s] += a[k + s] * b[k + s];
  for (; k < n; k++) sum[0] += a[k] * b[k];
  return sum[0] + sum[1] + sum[2] + sum[3];
}

/* y = (A - s E) x. */
static void multiply_one(struct um_thermal_system *system, const double *value, double scale,
                         const double *x, double *y)
{
  memset(y, 0, system->nunknown * sizeof *y);
  for (size_t j = 0; j < system->nunknown; j++)
    for (int64_t e = system->column[j]; e < system->column[j + 1]; e++)
      y[system->row[e]] += value[e] * x[j];
  um_thermal_system_exchange_tangent(system, -scale, x, y);
}

/* y += A x of a lot. */
UM_WIDE_VECTORS static void multiply_sparse(const struct um_thermal_system *system,
                                            const double *value, const double (*x)[LOT],
                                            double (*y)[LOT])
{
  for (size_t j = 0; j < system->nunknown; j++)
    for (int64_t e = system->column[j]; e < system->column[j + 1]; e++) {
      double a = value[e], *to = y[system->row[e]];
      for (size_t k = 0; k < LOT; k++) to[k] += a * x[j][k];
    }
}

/* s->product = (A - s E) s->work, of `count` columns. */
static void multiply(struct um_thermal_exchange_solver *s, const struct equations *of, size_t count)
{
  size_t n = s->system->nunknown;
  if (count == 1 || s->lot == 1) {
    for (size_t k = 0; k < count; k++)
      multiply_one(s->system, of->value, of->scale, s->work + k * n, s->product + k * n);
    return;
  }
  memset(s->in, 0, n * sizeof *s->in);
  memset(s->out, 0, n * sizeof *s->out);
  for (size_t k = 0; k < count; k++)
    for (size_t i = 0; i < n; i++) s->in[i][k] = s->work[k * n + i];
  multiply_sparse(s->system, of->value, (const double(*)[LOT])s->in, s->out);
  um_thermal_system_exchange_tangent_lot(s->system, -of->scale, (const double(*)[LOT])s->in,
                                         s->out);
  for (size_t k = 0; k < count; k++)
    for (size_t i = 0; i < n; i++) s->product[k * n + i] = s->out[i][k];
}

/* Column k of the Hessenberg matrix by the rotations so far and a new one (Givens). */
static void rotate(struct column *c, int k)
{
  for (int i = 0; i < k; i++) {
    double above = c->h[i][k], below = c->h[i + 1][k];
    c->h[i][k] = c->cosine[i] * above + c->sine[i] * below;
    c->h[i + 1][k] = c->cosine[i] * below - c->sine[i] * above;
  }
  double length = hypot(c->h[k][k], c->h[k + 1][k]);
  c->cosine[k] = length > 0.0 ? c->h[k][k] / length : 1.0;
  c->sine[k] = length > 0.0 ? c->h[k + 1][k] / length : 0.0;
  c->h[k][k] = length;
  c->g[k + 1] = -c->sine[k] * c->g[k];
  c->g[k] *= c->cosine[k];
}

/* The next vector of the basis from the product that was made of the last. */
static void extend(struct column *c, const double *made, size_t n)
{
  int m = c->m;
  double *next = c->v + (size_t)(m + 1) * n;
  memcpy(next, made, n * sizeof *next);
  for (int i = 0; i <= m; i++) {
    const double *v = c->v + (size_t)i * n;
    c->h[i][m] = product(v, next, n);
    for (size_t k = 0; k < n; k++) next[k] -= c->h[i][m] * v[k];
  }
  double length = sqrt(product(next, next, n));
  c->h[m + 1][m] = length;
  for (size_t k = 0; k < n && length > 0.0; k++) next[k] /= length;
  rotate(c, m);
  c->m++;
}

/* x += Z y with the triangle's y. */
static void take(struct column *c, size_t n)
{
  double y[DEPTH];
  for (int i = c->m - 1; i >= 0; i--) {
    double sum = c->g[i];
    for (int j = i + 1; j < c->m; j++) sum -= c->h[i][j] * y[j];
    y[i] = c->h[i][i] != 0.0 ? sum / c->h[i][i] : 0.0;
  }
  for (int i = 0; i < c->m; i++)
    for (size_t k = 0; k < n; k++) c->x[k] += y[i] * c->z[(size_t)i * n + k];
}

static bool is_there(const struct column *c, const struct equations *of)
{
  return c->left <= of->tolerance * c->size;
}

/* Columns that run and want another product, their last vectors into s->work; how many. */
static size_t gather(struct um_thermal_exchange_solver *s, const struct equations *of, size_t count,
                     struct column **which)
{
  size_t n = s->system->nunknown, found = 0;
  for (size_t k = 0; k < count; k++) {
    struct column *c = &s->column[k];
    if (!c->runs || c->m == DEPTH || !(fabs(c->g[c->m]) > 0.9 * of->tolerance * c->size)) continue;
    memcpy(s->work + found * n, c->v + (size_t)c->m * n, n * sizeof(double));
    which[found++] = c;
  }
  return found;
}

/* One round of all columns from the residuals in their v[0]; their x move on. */
static enum um_status round_run(struct um_thermal_exchange_solver *s, const struct equations *of,
                                size_t count)
{
  size_t n = s->system->nunknown, nrun;
  struct column *run[LOT];
  for (size_t k = 0; k < count; k++) {
    struct column *c = &s->column[k];
    c->m = 0;
    c->runs = !is_there(c, of);
    for (size_t i = 0; i < n && c->runs; i++) c->v[i] /= c->left;
    c->g[0] = c->left;
  }
  while ((nrun = gather(s, of, count, run)) > 0) {
    UM_TRY(of->inner->solve(of->inner->self, nrun, s->work));
    for (size_t k = 0; k < nrun; k++)
      memcpy(run[k]->z + (size_t)run[k]->m * n, s->work + k * n, n * sizeof(double));
    multiply(s, of, nrun);
    for (size_t k = 0; k < nrun; k++) extend(run[k], s->product + k * n, n);
  }
  for (size_t k = 0; k < count; k++) {
    struct column *c = &s->column[k];
    if (!c->runs) continue;
    c->left = fabs(c->g[c->m]);
    take(c, n);
  }
  return UM_OK;
}

/* Residuals of columns that are not there yet, anew; are there any? */
static bool look_again(struct um_thermal_exchange_solver *s, const struct equations *of,
                       size_t count)
{
  size_t n = s->system->nunknown, nrun = 0;
  struct column *run[LOT];
  for (size_t k = 0; k < count; k++) {
    struct column *c = &s->column[k];
    if (is_there(c, of)) continue;
    memcpy(s->work + nrun * n, c->x, n * sizeof(double));
    run[nrun++] = c;
  }
  if (nrun == 0) return false;
  multiply(s, of, nrun);
  for (size_t k = 0; k < nrun; k++) {
    struct column *c = run[k];
    for (size_t i = 0; i < n; i++) c->v[i] = c->b[i] - s->product[k * n + i];
    c->left = sqrt(product(c->v, c->v, n));
  }
  return true;
}

/* Columns with the guess [count][n] (NULL: 0) for a solution, and what residual that leaves. */
static void begin(struct um_thermal_exchange_solver *s, const struct equations *of,
                  const double *guess, size_t count, double *x)
{
  size_t n = s->system->nunknown;
  for (size_t k = 0; k < count; k++) {
    struct column *c = &s->column[k];
    c->x = x + k * n;
    memcpy(c->b, c->x, n * sizeof *x);
    memcpy(c->v, c->x, n * sizeof *x);
    memset(c->x, 0, n * sizeof *x);
    c->size = c->left = sqrt(product(c->b, c->b, n));
  }
  if (guess == NULL) return;
  memcpy(s->work, guess, count * n * sizeof *guess);
  multiply(s, of, count);
  for (size_t k = 0; k < count; k++) {
    struct column *c = &s->column[k];
    memcpy(c->x, guess + k * n, n * sizeof *x);
    for (size_t i = 0; i < n; i++) c->v[i] = c->b[i] - s->product[k * n + i];
    c->left = sqrt(product(c->v, c->v, n));
    c->size = fmax(c->left, ROUNDING / of->tolerance * c->size);
  }
}

static enum um_status solve_lot(struct um_thermal_exchange_solver *s, const struct equations *of,
                                const double *guess, size_t count, double *x)
{
  begin(s, of, guess, count, x);
  for (int round = 0; round < RESTARTS; round++) {
    UM_TRY(round_run(s, of, count));
    if (!look_again(s, of, count)) return UM_OK;
  }
  const struct column *worst = NULL;
  for (size_t k = 0; k < count; k++) {
    const struct column *c = &s->column[k];
    if (is_there(c, of)) continue;
    if (worst == NULL || c->left * worst->size > worst->left * c->size) worst = c;
  }
  if (worst == NULL) return UM_OK;
  return um_core_fail(
      s->system->context, UM_ERR_NUMERIC,
      "heat exchange between surfaces: the linear equations keep a residual of %.3g "
      "of 1; accepted: %.3g",
      worst->left / worst->size, of->tolerance);
}

enum um_status um_thermal_exchange_solve(struct um_thermal_exchange_solver *solver,
                                         const struct um_thermal_inner *inner, const double *value,
                                         double scale, double tolerance, const double *guess,
                                         size_t count, double *x)
{
  const struct equations of = {inner, value, scale, tolerance};
  for (size_t first = 0; first < count; first += solver->lot) {
    size_t left = count - first, own = left < solver->lot ? left : solver->lot;
    size_t at = first * solver->system->nunknown;
    UM_TRY(solve_lot(solver, &of, guess != NULL ? guess + at : NULL, own, x + at));
  }
  return UM_OK;
}
