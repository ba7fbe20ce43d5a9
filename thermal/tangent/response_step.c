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
 * Instants inside, a share a of the step on, have z^j replaced by (a z)^j under the second sum
 * only, a^(j - i), which is of order 4 there; then X^i S and X^i b are kept and summed for each
 * instant.
 *
 * Columns go four at a time: the factors are read once for them. */
#include "thermal/solver/exchange_solve_group.h"
#include "thermal/tangent/response_impl.h"

#include <math.h>
#include <string.h>

#include "thermal/solver/linear_group.h"

#define STAGES       5
#define POLE         0.27805384
#define TOGETHER     4
#define EXCHANGE     1e-9 /* the same with exchange between surfaces */
#define LINEAR_SHARE 1e-8 /* of a right side that iterated linear solutions leave */

struct um_thermal_stepper {
  struct um_thermal_system *system; /* borrowed */
  struct um_thermal_linear *linear;
  struct um_thermal_exchange_solver *exchange; /* NULL: none between surfaces */
  double *matrix;                              /* [nnonzero] 1 - g h J */
  double *work;                                /* [TOGETHER][nunknown] */
  double *b;                                   /* [TOGETHER][nunknown] */
  double *chain[2];                            /* [STAGES][TOGETHER][nunknown] X^i S and X^i b */
  double h;                                    /* [s] */
  double c[STAGES + 1], d[STAGES + 1];
};

static double binomial(int n, int k)
{
  double value = 1.0;
  for (int i = 1; i <= k; i++) value *= (double)(n - k + i) / i;
  return value;
}

/* c and d of the comment above, for a share of the step. */
static void coefficients_set(double share, double c[STAGES + 1], double d[STAGES + 1])
{
  memset(c, 0, (STAGES + 1) * sizeof *c);
  for (int j = 0; j < STAGES; j++) {
    double p = 0.0, term = 1.0; /* share^(j - i) / (j - i)! */
    for (int i = j; i >= 0; i--) {
      if (i < j) term *= share / (j - i);
      p += (i % 2 == 0 ? 1.0 : -1.0) * binomial(STAGES, i) * pow(POLE, i) * term;
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

enum um_status um_thermal_stepper_create(struct um_thermal_system *system,
                                         struct um_thermal_stepper **out)
{
  enum um_status status;
  struct um_context *context = system->context;
  size_t n = system->nunknown;
  struct um_thermal_stepper *stepper = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *stepper, &stepper));
  stepper->system = system;
  coefficients_set(1.0, stepper->c, stepper->d);
  UM_CHECK(um_core_allocate(context, system->nnonzero, sizeof(double), &stepper->matrix));
  UM_CHECK(um_core_allocate(context, TOGETHER * n, sizeof(double), &stepper->work));
  UM_CHECK(um_core_allocate(context, TOGETHER * n, sizeof(double), &stepper->b));
  for (int k = 0; k < 2; k++)
    UM_CHECK(um_core_allocate(context, STAGES * TOGETHER * n, sizeof(double), &stepper->chain[k]));
  UM_CHECK(um_thermal_linear_create(system, &stepper->linear));
  if (system->exchange != NULL)
    UM_CHECK(um_thermal_exchange_solver_create(system, &stepper->exchange));
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
  um_thermal_linear_destroy(&s->linear);
  um_thermal_exchange_solver_destroy(&s->exchange);
  um_core_free(context, s->matrix);
  um_core_free(context, s->work);
  um_core_free(context, s->b);
  um_core_free(context, s->chain[0]);
  um_core_free(context, s->chain[1]);
  um_core_free(context, s);
  *stepper = NULL;
}

/* What a linear solution that failed says. */
static enum um_status fail(const struct um_thermal_stepper *stepper, enum um_status status)
{
  char fault[256];
  if (status != UM_ERR_NUMERIC) return status;
  return um_core_fail(stepper->system->context, UM_ERR_NUMERIC,
                      "the heat responses cannot be solved: %s",
                      um_thermal_linear_fault(stepper->linear, fault, sizeof fault));
}

enum um_status um_thermal_stepper_factor(struct um_thermal_stepper *stepper, const double *jacobian,
                                         double h)
{
  const struct um_thermal_system *system = stepper->system;
  stepper->h = h;
  for (size_t k = 0; k < system->nnonzero; k++) stepper->matrix[k] = -POLE * h * jacobian[k];
  for (size_t k = 0; k < system->nunknown; k++) stepper->matrix[system->diagonal[k]] += 1.0;
  return fail(stepper, um_thermal_linear_factor(stepper->linear, stepper->matrix));
}

/* x[nunknown] <- X x without exchange between surfaces. */
static enum um_status solve_one(void *self, double *x)
{
  struct um_thermal_stepper *stepper = self;
  return um_thermal_linear_solve(stepper->linear, 1, LINEAR_SHARE, x);
}

/* x[count][nunknown] <- X x. */
static enum um_status solve(struct um_thermal_stepper *stepper, size_t count, double *x)
{
  if (stepper->exchange == NULL)
    return fail(stepper, um_thermal_linear_solve(stepper->linear, count, LINEAR_SHARE, x));
  const struct um_thermal_inner inner = {solve_one, stepper};
  for (size_t j = 0; j < count; j++)
    UM_TRY(fail(stepper, um_thermal_exchange_solve(stepper->exchange, &inner, stepper->matrix,
                                                   POLE * stepper->h, EXCHANGE,
                                                   x + j * stepper->system->nunknown)));
  return UM_OK;
}

/* Horner's sum to the end of the step, in place. on: whose source is on. */
static enum um_status advance(struct um_thermal_stepper *stepper, double *s, size_t count,
                              const bool *on)
{
  size_t n = stepper->system->nunknown;
  memset(stepper->work, 0, count * n * sizeof(double));
  for (int stage = STAGES; stage >= 1; stage--) {
    double c = stepper->c[stage], d = stepper->h * stepper->d[stage];
    for (size_t j = 0; j < count; j++) {
      const double *from = s + j * n, *b = stepper->b + j * n;
      double *work = stepper->work + j * n;
      for (size_t k = 0; k < n; k++) work[k] += c * from[k];
      for (size_t k = 0; on[j] && k < n; k++) work[k] += d * b[k];
    }
    UM_TRY(solve(stepper, count, stepper->work));
  }
  memcpy(s, stepper->work, count * n * sizeof(double));
  return UM_OK;
}

/* X^i x for i = 1 to 5 into chain. */
static enum um_status chain_make(struct um_thermal_stepper *stepper, const double *x, size_t count,
                                 double *chain)
{
  size_t size = count * stepper->system->nunknown;
  for (int stage = 0; stage < STAGES; stage++) {
    memcpy(chain, stage == 0 ? x : chain - size, size * sizeof *x);
    UM_TRY(solve(stepper, count, chain));
    chain += size;
  }
  return UM_OK;
}

/* out = sum of c_i X^i S + h d_i X^i b of column j of the chains. */
static void chain_sum(const struct um_thermal_stepper *stepper, const double *c, const double *d,
                      size_t count, size_t j, bool on, double *out)
{
  size_t n = stepper->system->nunknown;
  memset(out, 0, n * sizeof *out);
  for (size_t i = 0; i < STAGES; i++) {
    const double *s = stepper->chain[0] + (i * count + j) * n;
    const double *b = stepper->chain[1] + (i * count + j) * n;
    double of_s = c[i + 1], of_b = stepper->h * d[i + 1];
    for (size_t k = 0; k < n; k++) out[k] += of_s * s[k];
    for (size_t k = 0; on && k < n; k++) out[k] += of_b * b[k];
  }
}

/* The same to the end of the step and to instants inside. first: number of the first column. */
static enum um_status advance_through(struct um_thermal_stepper *stepper, double *s, size_t first,
                                      size_t count, const bool *on,
                                      const struct um_thermal_step *step)
{
  size_t n = stepper->system->nunknown;
  bool any = false;
  for (size_t j = 0; j < count; j++) any = any || on[j];
  UM_TRY(chain_make(stepper, s, count, stepper->chain[0]));
  if (any) UM_TRY(chain_make(stepper, stepper->b, count, stepper->chain[1]));
  for (size_t q = 0; q < step->ninside; q++) {
    double c[STAGES + 1], d[STAGES + 1];
    coefficients_set(step->inside[q], c, d);
    for (size_t j = 0; j < count; j++)
      chain_sum(stepper, c, d, count, j, on[j], step->taken + q * step->stride + (first + j) * n);
  }
  for (size_t j = 0; j < count; j++)
    chain_sum(stepper, stepper->c, stepper->d, count, j, on[j], s + j * n);
  return UM_OK;
}

enum um_status um_thermal_stepper_step(struct um_thermal_stepper *stepper, double *s,
                                       size_t ncolumn, const struct um_thermal_step *step)
{
  size_t n = stepper->system->nunknown;
  for (size_t first = 0; first < ncolumn; first += TOGETHER) {
    size_t count = ncolumn - first < TOGETHER ? ncolumn - first : TOGETHER;
    bool on[TOGETHER];
    for (size_t j = 0; j < count; j++) {
      on[j] = step->rate(step->user, first + j, stepper->b + j * n);
      if (!on[j]) memset(stepper->b + j * n, 0, n * sizeof(double));
    }
    if (step->ninside > 0)
      UM_TRY(advance_through(stepper, s + first * n, first, count, on, step));
    else
      UM_TRY(advance(stepper, s + first * n, count, on));
  }
  return UM_OK;
}
