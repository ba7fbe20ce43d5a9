/* One step of dS/dt = J S + b, J and b constant in it, for many columns.
 *
 * exp(z) is replaced by the rational function with one pole that is L-stable and of order 5 with
 * STAGES = 5 (Norsett 1978; Hairer and Wanner 1996, Solving ODEs II, table IV.6.4),
 *
 *   R(z) = P(z) / (1 - g z)^5,   g = 0.27805384,
 *   P(z) = sum_{j<5} z^j sum_{i<=j} (-1)^i binom(5, i) g^i / (j - i)!
 *
 * With x = 1 / (1 - g z), z = (x - 1) / (g x): R = sum_j P_j g^-j (x - 1)^j x^(5-j) is a polynomial
 * c_1 x + ... + c_5 x^5, and the step of the inhomogeneous equation
 *
 *   (R(z) - 1) / z = g x (R - 1) / (x - 1) = d_1 x + ... + d_5 x^5,
 *
 * is one as well. So with X = (1 - g h J)^-1 a step is five solutions with one factorisation,
 *
 *   S <- X (w_1 + X (w_2 + X (w_3 + X (w_4 + X w_5)))),   w_i = c_i S + h d_i b.
 *
 * Columns go four at a time, as KLU solves them. */
#include "thermal/response_impl.h"

#include <math.h>
#include <string.h>

#include <suitesparse/klu.h>

#define STAGES      5
#define POLE        0.27805384
#define TOGETHER    4
#define WORST_PIVOT 1e-14 /* reciprocal condition at which pivots are chosen anew */

struct um_thermal_stepper {
  const struct um_thermal_system *system; /* borrowed */
  klu_l_common common;
  klu_l_symbolic *symbolic;
  klu_l_numeric *numeric;
  SuiteSparse_long *column, *row; /* of the pattern */
  double *matrix;                 /* [nnonzero] 1 - g h J */
  double *work;                   /* [TOGETHER][nunknown] */
  double *b;                      /* [TOGETHER][nunknown] */
  double h;                       /* [s] */
  double c[STAGES + 1], d[STAGES + 1];
};

static double binomial(int n, int k)
{
  double value = 1.0;
  for (int i = 1; i <= k; i++) value *= (double)(n - k + i) / i;
  return value;
}

/* c and d of the comment above. */
static void coefficients_set(struct um_thermal_stepper *stepper)
{
  double *c = stepper->c, *d = stepper->d;
  memset(c, 0, sizeof stepper->c);
  for (int j = 0; j < STAGES; j++) {
    double p = 0.0, factorial = 1.0;
    for (int i = j; i >= 0; i--) { /* (j - i)! grows */
      if (j - i > 0) factorial *= j - i;
      p += (i % 2 == 0 ? 1.0 : -1.0) * binomial(STAGES, i) * pow(POLE, i) / factorial;
    }
    p *= pow(POLE, -j);
    for (int k = 0; k <= j; k++) /* (x - 1)^j x^(5-j) */
      c[STAGES - j + k] += p * binomial(j, k) * ((j - k) % 2 == 0 ? 1.0 : -1.0);
  }
  /* (R - 1) / (x - 1) by Horner's division at x = 1, from the highest power; times g x */
  double quotient = 0.0;
  for (int i = STAGES; i >= 1; i--) {
    quotient += c[i];
    d[i] = POLE * quotient;
  }
  d[0] = 0.0;
}

enum um_status um_thermal_stepper_create(const struct um_thermal_system *system,
                                         struct um_thermal_stepper **out)
{
  enum um_status status;
  struct um_context *context = system->context;
  size_t n = system->nunknown;
  struct um_thermal_stepper *stepper = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *stepper, &stepper));
  stepper->system = system;
  klu_l_defaults(&stepper->common);
  coefficients_set(stepper);
  UM_CHECK(um_core_allocate(context, n + 1, sizeof *stepper->column, &stepper->column));
  UM_CHECK(um_core_allocate(context, system->nnonzero, sizeof *stepper->row, &stepper->row));
  UM_CHECK(um_core_allocate(context, system->nnonzero, sizeof(double), &stepper->matrix));
  UM_CHECK(um_core_allocate(context, TOGETHER * n, sizeof(double), &stepper->work));
  UM_CHECK(um_core_allocate(context, TOGETHER * n, sizeof(double), &stepper->b));
  for (size_t k = 0; k <= n; k++) stepper->column[k] = (SuiteSparse_long)system->column[k];
  for (size_t k = 0; k < system->nnonzero; k++) stepper->row[k] = (SuiteSparse_long)system->row[k];
  stepper->symbolic =
      klu_l_analyze((SuiteSparse_long)n, stepper->column, stepper->row, &stepper->common);
  if (stepper->symbolic == NULL)
    UM_CHECK(um_core_fail(context, UM_ERR_MEMORY, "out of memory in the heat responses"));
  *out = stepper;
  return UM_OK;
done:
  um_thermal_stepper_destroy(&stepper);
  return status;
}

void um_thermal_stepper_destroy(struct um_thermal_stepper **stepper)
{
  if (stepper == NULL || *stepper == NULL) return;
  struct um_thermal_stepper *s = *stepper;
  struct um_context *context = s->system->context;
  if (s->numeric != NULL) klu_l_free_numeric(&s->numeric, &s->common);
  if (s->symbolic != NULL) klu_l_free_symbolic(&s->symbolic, &s->common);
  um_core_free(context, s->column);
  um_core_free(context, s->row);
  um_core_free(context, s->matrix);
  um_core_free(context, s->work);
  um_core_free(context, s->b);
  um_core_free(context, s);
  *stepper = NULL;
}

/* With the pivots of the last time where they serve. */
static bool refactor(struct um_thermal_stepper *stepper)
{
  if (stepper->numeric == NULL) return false;
  if (!klu_l_refactor(stepper->column, stepper->row, stepper->matrix, stepper->symbolic,
                      stepper->numeric, &stepper->common))
    return false;
  return klu_l_rcond(stepper->symbolic, stepper->numeric, &stepper->common) != 0 &&
         stepper->common.rcond > WORST_PIVOT;
}

enum um_status um_thermal_stepper_factor(struct um_thermal_stepper *stepper, const double *jacobian,
                                         double h)
{
  const struct um_thermal_system *system = stepper->system;
  stepper->h = h;
  for (size_t k = 0; k < system->nnonzero; k++) stepper->matrix[k] = -POLE * h * jacobian[k];
  for (size_t k = 0; k < system->nunknown; k++) stepper->matrix[system->diagonal[k]] += 1.0;
  if (refactor(stepper)) return UM_OK;
  if (stepper->numeric != NULL) klu_l_free_numeric(&stepper->numeric, &stepper->common);
  stepper->numeric = klu_l_factor(stepper->column, stepper->row, stepper->matrix, stepper->symbolic,
                                  &stepper->common);
  if (stepper->numeric != NULL) return UM_OK;
  return um_core_fail(system->context, UM_ERR_NUMERIC,
                      "the heat balance cannot be factored (KLU status %ld)",
                      (long)stepper->common.status);
}

/* w_i of one column into work, added to what is there. */
static void stage_add(const struct um_thermal_stepper *stepper, int stage, const double *s,
                      const double *b, bool on, double *work)
{
  size_t n = stepper->system->nunknown;
  double c = stepper->c[stage], d = stepper->h * stepper->d[stage];
  if (on)
    for (size_t k = 0; k < n; k++) work[k] += c * s[k] + d * b[k];
  else
    for (size_t k = 0; k < n; k++) work[k] += c * s[k];
}

enum um_status um_thermal_stepper_step(struct um_thermal_stepper *stepper, double *s,
                                       size_t ncolumn,
                                       bool (*rate)(void *user, size_t column, double *b),
                                       void *user)
{
  size_t n = stepper->system->nunknown;
  for (size_t first = 0; first < ncolumn; first += TOGETHER) {
    size_t count = ncolumn - first < TOGETHER ? ncolumn - first : TOGETHER;
    bool on[TOGETHER];
    for (size_t k = 0; k < count; k++) on[k] = rate(user, first + k, stepper->b + k * n);
    memset(stepper->work, 0, count * n * sizeof(double));
    for (int stage = STAGES; stage >= 1; stage--) {
      for (size_t k = 0; k < count; k++)
        stage_add(stepper, stage, s + (first + k) * n, stepper->b + k * n, on[k],
                  stepper->work + k * n);
      if (!klu_l_solve(stepper->symbolic, stepper->numeric, (SuiteSparse_long)n,
                       (SuiteSparse_long)count, stepper->work, &stepper->common))
        return um_core_fail(stepper->system->context, UM_ERR_NUMERIC,
                            "the heat balance cannot be solved (KLU status %ld)",
                            (long)stepper->common.status);
    }
    memcpy(s + first * n, stepper->work, count * n * sizeof(double));
  }
  return UM_OK;
}
