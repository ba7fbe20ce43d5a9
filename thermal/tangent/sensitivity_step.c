/* Steps of dS_k/dt = J(t) S_k + b_k(t) for many columns with one factorisation a stage: the known
 * first stage, singly diagonally implicit method of order 3 with four stages that is L-stable and
 * stiffly accurate, ESDIRK3(2)4L[2]SA (Kennedy and Carpenter 2003, Appl. Numer. Math. 44:139),
 *
 *   (1 - g h J_i) S_i = S + h sum_{j<i} a_ij F_j + g h b_i,   F_j = J_j S_j + b_j,
 *
 * J_i and b_i at the stage's own instant: what forgets within a step is where it belongs at its
 * end. The difference to the embedded method of order 2, damped by A^-1, is the error of a step.
 * Its root mean square over the nodes is held to `tolerance` of that of the column's answer, the
 * largest so far: a facet of foil that the Sun grazes follows kinks of its load that no mean over a
 * part feels, and to follow them takes ten times the steps. Steps end at rows of the loads.
 * Iterated solutions begin with the rate of the stage before (decision 0017).
 *
 * b_k = (f_k - f) / h_k, f_k the balance of variant k at the base's unknowns; the temperatures that
 * follow from these (arithmetic nodes) are the variant's own. b_k of a pulse: sensitivity_pulse.c.
 */
#include <math.h>
#include <string.h>

#include "base/core/interpolation.h"
#include "thermal/tangent/sensitivity_impl.h"

#define STAGES       4
#define POLE         (1767732205903.0 / 4055673282236.0)
#define SAFETY       0.8
#define FASTEST      2.5   /* growth of a step */
#define SLOWEST      0.2   /* and its shrinking */
#define LINEAR_SHARE 1e-2  /* of what the rate of the stage before leaves, not solved [1] */
#define ERROR_SHARE  1e-2  /* of the error of a step, likewise */
#define SHORTEST     1e-7  /* [s] */
#define ROUNDING     3e-10 /* [K] over a parameter's step: answers below are not looked at */
#define LONGEST      32.0  /* steps of the base that one may pass */
#define PASSED       1e-3  /* of a step: a row that is nearer is behind it */

static const double weight[STAGES][STAGES] = {
    {0.0, 0.0, 0.0, 0.0},
    {POLE, POLE, 0.0, 0.0},
    {2746238789719.0 / 10658868560708.0, -640167445237.0 / 6845629431997.0, POLE, 0.0},
    {1471266399579.0 / 7840856788654.0, -4482444167858.0 / 7529755066697.0,
     11266239266428.0 / 11593286722821.0, POLE}};
static const double instant[STAGES] = {0.0, 2.0 * POLE, 0.6, 1.0};
static const double embedded[STAGES] = {
    2756255671327.0 / 12835298489170.0, -10771552573575.0 / 22201958757719.0,
    9247589265047.0 / 10645013368117.0, 2193209047091.0 / 5459859503100.0};

static enum um_status balance_lost(const struct um_thermal_sensitivity_run *r)
{
  return um_core_fail(r->context, UM_ERR_NUMERIC,
                      "heat sensitivities: an arithmetic node finds no balance %.3f s after the "
                      "start",
                      r->t);
}

/* State, rate and Jacobian of the base at t. */
static enum um_status linearize(struct um_thermal_sensitivity_run *r, double t)
{
  um_thermal_base_at(&r->base, t, r->y);
  if (!um_thermal_system_state_set(r->system, t, r->y)) return balance_lost(r);
  um_thermal_system_rate(r->system, r->rate);
  if (!um_thermal_system_jacobian(r->system, r->jacobian)) return balance_lost(r);
  if (r->exchange != NULL) um_thermal_system_exchange_hold(r->system, false);
  return UM_OK;
}

/* b of a column where linearize() was, into r->moved. */
static enum um_status force(struct um_thermal_sensitivity_run *r, size_t column, double t)
{
  if (!r->forced) {
    memset(r->moved, 0, r->n * sizeof *r->moved);
    return UM_OK;
  }
  if (column >= r->nvariant) {
    um_thermal_pulses_force(r, column, r->moved);
    return UM_OK;
  }
  struct um_thermal_system *variant = r->variant[column];
  if (!um_thermal_system_state_set(variant, t, r->y)) return balance_lost(r);
  um_thermal_system_rate(variant, r->moved);
  double inverse = 1.0 / r->width[column];
  for (size_t i = 0; i < r->n; i++) r->moved[i] = (r->moved[i] - r->rate[i]) * inverse;
  return UM_OK;
}

static enum um_status factor(struct um_thermal_sensitivity_run *r)
{
  const struct um_thermal_system *system = r->system;
  char fault[256];
  for (size_t k = 0; k < system->nnonzero; k++) r->matrix[k] = -POLE * r->h * r->jacobian[k];
  for (size_t k = 0; k < r->n; k++) r->matrix[system->diagonal[k]] += 1.0;
  enum um_status status = um_thermal_linear_factor(r->linear, r->matrix);
  if (status != UM_ERR_NUMERIC) return status;
  return um_core_fail(r->context, UM_ERR_NUMERIC, "heat sensitivities %.3f s after the start: %s",
                      r->t, um_thermal_linear_fault(r->linear, fault, sizeof fault));
}

/* J is joined by E, the derivative of what surfaces exchange, which is full: (A - scale E) x = b is
 * iterated with A's factors (exchange_solve.c), E x is a product (system_exchange.c). */
static enum um_status inner_solve(void *self, size_t count, double *x)
{
  struct um_thermal_sensitivity_run *r = self;
  return um_thermal_linear_solve(r->linear, count, r->share, x);
}

/* x <- x - A g, of the active columns. */
static void subtract_product(const struct um_thermal_sensitivity_run *r, const double *g, double *x)
{
  const struct um_thermal_system *system = r->system;
  for (size_t at = 0; at < r->nactive * r->n; at += r->n)
    for (size_t k = 0; k < r->n; k++)
      for (int64_t e = system->column[k]; e < system->column[k + 1]; e++)
        x[at + (size_t)system->row[e]] -= r->matrix[e] * g[at + k];
}

/* Without E: the guess and what solves its residual, since A may be iterated with, too. */
static enum um_status solve_alone(struct um_thermal_sensitivity_run *r, double share,
                                  const double *guess, double *x)
{
  if (guess != NULL) subtract_product(r, guess, x);
  UM_TRY(um_thermal_linear_solve(r->linear, r->nactive, share, x));
  for (size_t k = 0; guess != NULL && k < r->nactive * r->n; k++) x[k] += guess[k];
  return UM_OK;
}

enum um_status um_thermal_sensitivity_solve(struct um_thermal_sensitivity_run *r, double scale,
                                            double share, const double *guess, double *x)
{
  if (r->exchange == NULL) return solve_alone(r, share, guess, x);
  const struct um_thermal_inner inner = {inner_solve, r};
  r->share = share;
  return um_thermal_exchange_solve(r->exchange, &inner, r->matrix, scale, share, guess, r->nactive,
                                   x);
}

static enum um_status solve(struct um_thermal_sensitivity_run *r, const double *guess, double *x)
{
  enum um_status status = um_thermal_sensitivity_solve(r, POLE * r->h, LINEAR_SHARE, guess, x);
  if (status != UM_ERR_NUMERIC || um_core_message(r->context)[0] != '\0') return status;
  return um_core_fail(r->context, UM_ERR_NUMERIC,
                      "heat sensitivities %.3f s after the start: no solution", r->t);
}

/* stage[0] = J S + b at the begin of a stretch. */
static enum um_status first_rate(struct um_thermal_sensitivity_run *r)
{
  const struct um_thermal_system *system = r->system;
  UM_TRY(linearize(r, r->t));
  for (size_t c = 0; c < r->nactive; c++) {
    double *out = r->stage[0] + c * r->n;
    const double *s = r->s + c * r->n;
    UM_TRY(force(r, c, r->t));
    memcpy(out, r->moved, r->n * sizeof *out);
    for (size_t k = 0; k < r->n; k++)
      for (int64_t e = system->column[k]; e < system->column[k + 1]; e++)
        out[system->row[e]] += r->jacobian[e] * s[k];
    if (r->exchange != NULL) um_thermal_system_exchange_tangent(r->system, 1.0, s, out);
  }
  return UM_OK;
}

enum um_status um_thermal_sensitivity_edge(struct um_thermal_sensitivity_run *r)
{
  um_thermal_pulses_enter(r);
  r->continued = false;
  r->opening = true;
  if (r->pulses.h > 0.0) r->h = r->pulses.h;
  return first_rate(r);
}

enum um_status um_thermal_sensitivity_begin(struct um_thermal_sensitivity_run *r)
{
  double end = um_thermal_integrator_stop(r->base.integrator);
  for (size_t c = 0; c <= r->nvariant; c++) {
    struct um_thermal_system *system = c < r->nvariant ? r->variant[c] : r->system;
    um_thermal_system_window(system, r->t, end);
    for (size_t k = 0; k < system->nthermostat; k++) system->thermostat[k].on = r->base.heating[k];
  }
  r->continued = false;
  return first_rate(r);
}

/* Stage i of all columns: the state into r->next, its rate into stage[i]. */
static enum um_status stage_make(struct um_thermal_sensitivity_run *r, int i)
{
  double t = r->t + instant[i] * r->h, gh = POLE * r->h;
  UM_TRY(linearize(r, t));
  UM_TRY(factor(r));
  for (size_t c = 0; c < r->nactive; c++) {
    size_t at = c * r->n;
    double *known = r->known + at, *next = r->next + at, *guess = r->error + at;
    const double *before = r->stage[i - 1] + at;
    memcpy(known, r->s + at, r->n * sizeof *known);
    for (int j = 0; j < i; j++) {
      double w = r->h * weight[i][j];
      const double *f = r->stage[j] + at;
      for (size_t k = 0; k < r->n; k++) known[k] += w * f[k];
    }
    UM_TRY(force(r, c, t));
    for (size_t k = 0; k < r->n; k++) next[k] = known[k] + gh * r->moved[k];
    for (size_t k = 0; k < r->n; k++) guess[k] = known[k] + gh * before[k];
  }
  UM_TRY(solve(r, r->error, r->next));
  for (size_t k = 0; k < r->nactive * r->n; k++) r->stage[i][k] = (r->next[k] - r->known[k]) / gh;
  return UM_OK;
}

double um_thermal_sensitivity_size(const struct um_thermal_sensitivity_run *r, const double *x,
                                   size_t column)
{
  const double *own = x + column * r->n;
  double sum = 0.0;
  for (size_t k = 0; k < r->n; k++) sum += own[k] * own[k];
  return sqrt(sum / (double)(r->n > 0 ? r->n : 1));
}

/* Largest error of a column over what is allowed [1]. */
static enum um_status error_find(struct um_thermal_sensitivity_run *r, double *out)
{
  memset(r->error, 0, r->nactive * r->n * sizeof *r->error);
  for (int j = 0; j < STAGES; j++) {
    double w = r->h * (weight[STAGES - 1][j] - embedded[j]);
    for (size_t k = 0; k < r->nactive * r->n; k++) r->error[k] += w * r->stage[j][k];
  }
  UM_TRY(um_thermal_linear_solve(r->linear, r->nactive, ERROR_SHARE, r->error));
  *out = 0.0;
  for (size_t c = 0; c < r->nactive; c++) {
    double size = fmax(r->largest[c], fmax(um_thermal_sensitivity_size(r, r->next, c),
                                           ROUNDING / fabs(r->width[c])));
    double error = um_thermal_sensitivity_size(r, r->error, c);
    if (error > 0.0) *out = fmax(*out, error / (r->tolerance * size));
  }
  return UM_OK;
}

static void swap(double **a, double **b)
{
  double *kept = *a;
  *a = *b;
  *b = kept;
}

/* |T|^3 and the slopes of mean thermostats at the end of the step, for the orbit's mean: how well
 * it is met decides how fast the periodic state is found, not which. */
static void mean_add(struct um_thermal_sensitivity_run *r, double h)
{
  const struct um_thermal_system *system = r->system;
  if (r->mean_cube == NULL) return;
  for (size_t i = 0; i < system->n; i++) r->mean_cube[i] += h * system->cube[i];
  for (size_t k = 0; k < system->nthermostat; k++)
    r->mean_slope[k] += h * system->thermostat[k].slope;
}

/* The step is good. */
static void take(struct um_thermal_sensitivity_run *r)
{
  swap(&r->s, &r->next);
  for (size_t c = 0; c < r->nactive; c++)
    r->largest[c] = fmax(r->largest[c], um_thermal_sensitivity_size(r, r->s, c));
  r->t += r->h;
  r->steps++;
}

/* Loads bend at the rows of their table, and answers with them: a step that a row is within ends at
 * the last such row, and what is left up to the next is not made a sliver. */
static double step_to_row(const struct um_thermal_sensitivity_run *r, double h)
{
  const struct um_thermal_system *system = r->system;
  size_t n = system->loads != NULL ? system->loads->ntime : 0;
  if (n < 2) return h;
  size_t k = um_core_interval_find(system->grid, n, r->t + h);
  if (system->grid[k + 1] <= r->t + h) k++; /* the last row is no interval's begin */
  double left = system->grid[k] - r->t;
  if (left > PASSED * h && left <= h) return left;
  left = k + 1 < n ? system->grid[k + 1] - r->t : 0.0;
  return left > h && left < 2.0 * h ? 0.5 * left : h;
}

/* The step within `end`, the stretch, and what the base has found smooth. */
static enum um_status step_fit(struct um_thermal_sensitivity_run *r, double end)
{
  UM_TRY(um_thermal_base_reach(&r->base, r->t + r->h));
  if (r->base.ended) end = fmin(end, r->base.t[r->base.npoint - 1]);
  double left = end - r->t;
  if (left <= r->h)
    r->h = left;
  else if (left < 2.0 * r->h)
    r->h = 0.5 * left; /* no sliver is left */
  return UM_OK;
}

enum um_status um_thermal_sensitivity_step(struct um_thermal_sensitivity_run *r, double end)
{
  if (r->continued) swap(&r->stage[0], &r->stage[STAGES - 1]);
  r->continued = false;
  bool refused = false;
  for (;;) {
    UM_TRY(um_core_stop_check(r->context, "heat sensitivities were computed"));
    r->h = step_to_row(r, fmin(r->h, LONGEST * um_thermal_base_step(&r->base)));
    double wanted = r->h, error;
    UM_TRY(step_fit(r, end));
    for (int i = 1; i < STAGES; i++) UM_TRY(stage_make(r, i));
    UM_TRY(error_find(r, &error));
    if (!isfinite(error))
      return um_core_fail(r->context, UM_ERR_NUMERIC,
                          "heat sensitivities are not finite %.3f s after the start", r->t);
    double factor = error > 0.0 ? SAFETY * pow(error, -1.0 / 3.0) : FASTEST;
    factor = fmax(SLOWEST, fmin(FASTEST, factor));
    double h = r->h;
    if (error <= 1.0) {
      mean_add(r, h);
      take(r);
      r->continued = true;
      if (r->opening) r->pulses.h = factor * h;
      r->opening = false;
      /* a step cut short by `end` says little of the next; one that was refused before, enough */
      r->h = fmax((refused ? fmin(factor, 1.0) : factor) * h,
                  !refused && factor > 1.0 && h < wanted ? wanted : 0.0);
      return UM_OK;
    }
    refused = true;
    r->refused++;
    r->h = fmin(factor, 0.9) * h;
    if (r->h < SHORTEST)
      return um_core_fail(r->context, UM_ERR_NUMERIC,
                          "heat sensitivities need steps below %g s, %.3f s after the start",
                          SHORTEST, r->t);
  }
}
