/* Flexible GMRES about the exchange between surfaces. What is emitted is in A, what comes back in
 * E, and less comes back than goes: 1 - s E A^-1 has its eigenvalues in (0, 1], so that a few
 * products suffice unless a room is closed. */
#include "thermal/solver/exchange_solve_group.h"

#include <math.h>
#include <string.h>

#define DEPTH    30 /* vectors kept between restarts */
#define RESTARTS 10

struct um_thermal_exchange_solver {
  struct um_thermal_system *system; /* borrowed */
  double *v;                        /* [DEPTH + 1][n] orthonormal */
  double *z;                        /* [DEPTH][n] A^-1 v */
  double *b;                        /* [n] right-hand side */
  double h[DEPTH + 1][DEPTH];       /* Hessenberg, turned to a triangle */
  double cosine[DEPTH], sine[DEPTH], g[DEPTH + 1];
};

enum um_status um_thermal_exchange_solver_create(struct um_thermal_system *system,
                                                 struct um_thermal_exchange_solver **out)
{
  enum um_status status;
  struct um_context *context = system->context;
  struct um_thermal_exchange_solver *solver = NULL;
  size_t n = system->nunknown;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *solver, &solver));
  solver->system = system;
  UM_CHECK(um_core_allocate(context, (DEPTH + 1) * n, sizeof(double), &solver->v));
  UM_CHECK(um_core_allocate(context, DEPTH * n, sizeof(double), &solver->z));
  UM_CHECK(um_core_allocate(context, n, sizeof(double), &solver->b));
  *out = solver;
  return UM_OK;
done:
  um_thermal_exchange_solver_destroy(&solver);
  return status;
}

void um_thermal_exchange_solver_destroy(struct um_thermal_exchange_solver **solver)
{
  if (solver == NULL || *solver == NULL) return;
  struct um_context *context = (*solver)->system->context;
  UM_FREE(context, (*solver)->v, (*solver)->z, (*solver)->b, *solver);
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
static void multiply(struct um_thermal_system *system, const double *value, double scale,
                     const double *x, double *y)
{
  memset(y, 0, system->nunknown * sizeof *y);
  for (size_t j = 0; j < system->nunknown; j++)
    for (int64_t e = system->column[j]; e < system->column[j + 1]; e++)
      y[system->row[e]] += value[e] * x[j];
  um_thermal_system_exchange_tangent(system, -scale, x, y);
}

/* Column k of the Hessenberg matrix by the rotations so far and a new one (Givens). */
static void rotate(struct um_thermal_exchange_solver *s, int k)
{
  for (int i = 0; i < k; i++) {
    double above = s->h[i][k], below = s->h[i + 1][k];
    s->h[i][k] = s->cosine[i] * above + s->sine[i] * below;
    s->h[i + 1][k] = s->cosine[i] * below - s->sine[i] * above;
  }
  double length = hypot(s->h[k][k], s->h[k + 1][k]);
  s->cosine[k] = length > 0.0 ? s->h[k][k] / length : 1.0;
  s->sine[k] = length > 0.0 ? s->h[k + 1][k] / length : 0.0;
  s->h[k][k] = length;
  s->g[k + 1] = -s->sine[k] * s->g[k];
  s->g[k] *= s->cosine[k];
}

/* x += Z y with the triangle's y. */
static void take(struct um_thermal_exchange_solver *s, int m, double *x)
{
  size_t n = s->system->nunknown;
  double y[DEPTH];
  for (int i = m - 1; i >= 0; i--) {
    double sum = s->g[i];
    for (int j = i + 1; j < m; j++) sum -= s->h[i][j] * y[j];
    y[i] = s->h[i][i] != 0.0 ? sum / s->h[i][i] : 0.0;
  }
  for (int i = 0; i < m; i++)
    for (size_t k = 0; k < n; k++) x[k] += y[i] * s->z[(size_t)i * n + k];
}

/* One round from the residual in v[0]; x moves on. *left: norm of the residual. */
static enum um_status round_run(struct um_thermal_exchange_solver *s,
                                const struct um_thermal_inner *inner, const double *value,
                                double scale, double wanted, double *x, double *left)
{
  size_t n = s->system->nunknown;
  int m = 0;
  for (size_t k = 0; k < n; k++) s->v[k] /= *left;
  s->g[0] = *left;
  while (m < DEPTH && fabs(s->g[m]) > wanted) {
    double *z = s->z + (size_t)m * n, *next = s->v + (size_t)(m + 1) * n;
    memcpy(z, s->v + (size_t)m * n, n * sizeof *z);
    UM_TRY(inner->solve(inner->self, z));
    multiply(s->system, value, scale, z, next);
    for (int i = 0; i <= m; i++) {
      const double *v = s->v + (size_t)i * n;
      s->h[i][m] = product(v, next, n);
      for (size_t k = 0; k < n; k++) next[k] -= s->h[i][m] * v[k];
    }
    double length = sqrt(product(next, next, n));
    s->h[m + 1][m] = length;
    for (size_t k = 0; k < n && length > 0.0; k++) next[k] /= length;
    rotate(s, m);
    m++;
  }
  *left = fabs(s->g[m]);
  take(s, m, x);
  return UM_OK;
}

enum um_status um_thermal_exchange_solve(struct um_thermal_exchange_solver *solver,
                                         const struct um_thermal_inner *inner, const double *value,
                                         double scale, double tolerance, double *x)
{
  struct um_thermal_system *system = solver->system;
  size_t n = system->nunknown;
  memcpy(solver->b, x, n * sizeof *x);
  memcpy(solver->v, x, n * sizeof *x);
  memset(x, 0, n * sizeof *x);
  double size = sqrt(product(solver->b, solver->b, n)), left = size;
  for (int round = 0; round < RESTARTS && left > tolerance * size; round++) {
    UM_TRY(round_run(solver, inner, value, scale, 0.9 * tolerance * size, x, &left));
    if (left <= tolerance * size) return UM_OK;
    multiply(system, value, scale, x, solver->v);
    for (size_t k = 0; k < n; k++) solver->v[k] = solver->b[k] - solver->v[k];
    left = sqrt(product(solver->v, solver->v, n));
  }
  if (left <= tolerance * size) return UM_OK;
  return um_core_fail(
      system->context, UM_ERR_NUMERIC,
      "heat exchange between surfaces: the linear equations keep a residual of %.3g "
      "of 1; accepted: %.3g",
      left / size, tolerance);
}
