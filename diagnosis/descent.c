/* Gauss-Newton in a region of trust, within bounds. Each step solves the linear problem
 *
 *   min_u |r - J S u|^2 + priors + lambda |u|^2,   x + S u within the bounds,   S the scales,
 *
 * (Levenberg 1944, Marquardt 1963; bounds by active sets) with lambda 0 unless the step is longer
 * than the radius, which follows from the gain, actual over expected decrease (More 1978, Lecture
 * Notes in Mathematics 630:105).
 *
 * Why not gsl_multifit_nlinear: one evaluation is a run of the whole model. GSL makes a Jacobian
 * anew at every step it accepts, knows no bounds, no failing model, and stops by the length of the
 * step. Here a Jacobian is handed in or made once and updated (Broyden), made anew only when a step
 * fails, gains less than a quarter of what it should, or the solution lies where the Jacobian no
 * longer holds; and the end is reached when the chi-square can fall by 1e-3 no more, 3 % of a
 * sigma. Where the gain is lost in noise of the model itself (a step by a Jacobian made on the spot
 * does not lower chi-square, and less than 0.1 was expected of it) that is the end too. */
#include "diagnosis/descent_impl.h"

#include <math.h>
#include <string.h>

#include "diagnosis/algebra_impl.h"
#include "diagnosis/bounded_impl.h"

#define ITERATIONS_MAX 20
#define ENOUGH         1e-3 /* chi-square still to be gained at the end */
#define LOST           0.1  /* the same that noise of the model may hide */
#define POOR           0.25
#define RICH           0.75

static enum um_status reserve(struct um_context *context, struct um_diagnosis_descent *d)
{
  double **of_rows[] = {&d->value, &d->r, &d->value_trial, &d->r_trial, &d->base_r};
  double **of_parameters[] = {&d->x,     &d->x_trial, &d->base_x, &d->scale, &d->pull,
                              &d->width, &d->lower,   &d->upper,  &d->u,     &d->v};
  for (size_t i = 0; i < sizeof of_rows / sizeof *of_rows; i++)
    UM_TRY(um_core_allocate(context, d->nrow, sizeof(double), of_rows[i]));
  for (size_t i = 0; i < sizeof of_parameters / sizeof *of_parameters; i++)
    UM_TRY(um_core_allocate(context, d->n, sizeof(double), of_parameters[i]));
  UM_TRY(um_core_allocate(context, d->n * d->nrow, sizeof *d->jacobian, &d->jacobian));
  return um_core_allocate(context, d->n * d->nrow, sizeof *d->base_jacobian, &d->base_jacobian);
}

void um_diagnosis_descent_release(struct um_context *context, struct um_diagnosis_descent *d)
{
  double *block[] = {d->value,   d->r,      d->value_trial, d->r_trial,  d->base_r,       d->x,
                     d->x_trial, d->base_x, d->scale,       d->pull,     d->width,        d->lower,
                     d->upper,   d->u,      d->v,           d->jacobian, d->base_jacobian};
  for (size_t i = 0; i < sizeof block / sizeof *block; i++) um_core_free(context, block[i]);
  *d = (struct um_diagnosis_descent){0};
}

static double chi2_prior(const struct um_diagnosis_descent *d, const double *x)
{
  double sum = 0.0;
  for (size_t j = 0; j < d->n; j++) {
    const struct um_diagnosis_fit_parameter *p = &d->problem->parameter[j];
    double pull = isinf(p->prior_sigma) ? 0.0 : (p->prior_mean - x[j]) / p->prior_sigma;
    sum += pull * pull;
  }
  return sum;
}

static void swap(double **a, double **b)
{
  double *c = *a;
  *a = *b;
  *b = c;
}

/* The trial becomes where the fit stands. */
static void accept(struct um_diagnosis_descent *d)
{
  swap(&d->x, &d->x_trial);
  swap(&d->value, &d->value_trial);
  swap(&d->r, &d->r_trial);
  d->chi2 = um_diagnosis_dot(d->nrow, d->r, d->r);
  d->chi2_prior = chi2_prior(d, d->x);
  d->fresh = false;
}

/* The model at the start, handed in or computed; here its errors are the caller's. */
static enum um_status start(struct um_context *context, struct um_diagnosis_descent *d)
{
  const struct um_diagnosis_fit_problem *p = d->problem;
  for (size_t j = 0; j < d->n; j++) d->x_trial[j] = p->parameter[j].start;
  if (p->value != NULL) {
    memcpy(d->value_trial, p->value, d->nrow * sizeof *p->value);
  } else {
    UM_TRY(p->evaluate(context, p->user, d->x_trial, d->value_trial));
    d->evaluations++;
  }
  for (size_t i = 0; i < d->nrow; i++) {
    d->r_trial[i] = (p->measured[i] - d->value_trial[i]) / p->sigma[i];
    if (!isfinite(d->r_trial[i]))
      return um_core_fail(context, UM_ERR_NUMERIC,
                          "row %zu of a fit is not finite at its start: measured %g, model %g, "
                          "sigma %g",
                          i + 1, p->measured[i], d->value_trial[i], p->sigma[i]);
  }
  accept(d);
  return UM_OK;
}

enum um_status um_diagnosis_descent_begin(struct um_context *context,
                                          const struct um_diagnosis_fit_problem *problem,
                                          struct um_diagnosis_descent *out)
{
  *out = (struct um_diagnosis_descent){
      .problem = problem, .n = problem->nparameter, .nrow = problem->nrow, .radius = INFINITY};
  UM_TRY(reserve(context, out));
  UM_TRY(start(context, out));
  for (size_t j = 0; j < out->n; j++) {
    out->scale[j] = problem->parameter[j].step;
    out->width[j] = problem->parameter[j].prior_sigma;
  }
  if (out->n == 0) return UM_OK;
  if (problem->jacobian == NULL) return um_diagnosis_descent_differences(context, out);
  for (size_t j = 0; j < out->n; j++)
    for (size_t i = 0; i < out->nrow; i++)
      out->jacobian[j * out->nrow + i] = problem->jacobian[j * out->nrow + i] / problem->sigma[i];
  memcpy(out->base_jacobian, out->jacobian, out->n * out->nrow * sizeof *out->jacobian);
  memcpy(out->base_x, out->x, out->n * sizeof *out->x);
  memcpy(out->base_r, out->r, out->nrow * sizeof *out->r);
  return UM_OK;
}

static enum um_status linearise(struct um_context *context, struct um_diagnosis_descent *d,
                                struct um_diagnosis_system *out)
{
  for (size_t j = 0; j < d->n; j++) {
    const struct um_diagnosis_fit_parameter *p = &d->problem->parameter[j];
    d->pull[j] = isinf(p->prior_sigma) ? 0.0 : p->prior_mean - d->x[j];
    d->lower[j] = fmin(0.0, (p->minimum - d->x[j]) / d->scale[j]);
    d->upper[j] = fmax(0.0, (p->maximum - d->x[j]) / d->scale[j]);
  }
  return um_diagnosis_system_create(context,
                                    &(struct um_diagnosis_rows){.nrow = d->nrow,
                                                                .n = d->n,
                                                                .jacobian = d->jacobian,
                                                                .residual = d->r,
                                                                .scale = d->scale,
                                                                .pull = d->pull,
                                                                .width = d->width},
                                    out);
}

/* The step u no longer than the radius: damping in decades until it is, then between two of them.
 */
static enum um_status shorten(struct um_context *context, struct um_diagnosis_descent *d,
                              const struct um_diagnosis_system *system, double *left)
{
  double damping = 1e-12 * um_diagnosis_dot(d->n * d->n, system->r, system->r), factor = 10.0;
  if (sqrt(um_diagnosis_dot(d->n, d->u, d->u)) <= d->radius) return UM_OK;
  do {
    damping *= factor;
    UM_TRY(um_diagnosis_system_solve(context, system, damping, d->lower, d->upper, d->u, left));
  } while (sqrt(um_diagnosis_dot(d->n, d->u, d->u)) > d->radius);
  for (size_t k = 0; k < 5; k++) {
    factor = sqrt(factor);
    double less = damping / factor;
    UM_TRY(um_diagnosis_system_solve(context, system, less, d->lower, d->upper, d->u, left));
    if (sqrt(um_diagnosis_dot(d->n, d->u, d->u)) <= d->radius) damping = less;
  }
  return um_diagnosis_system_solve(context, system, damping, d->lower, d->upper, d->u, left);
}

/* x_trial = x + S u, on a bound exactly where u is. */
static void aim(struct um_diagnosis_descent *d)
{
  for (size_t j = 0; j < d->n; j++) {
    const struct um_diagnosis_fit_parameter *p = &d->problem->parameter[j];
    d->x_trial[j] = fmin(fmax(d->x[j] + d->scale[j] * d->u[j], p->minimum), p->maximum);
    if (d->u[j] < 0.0 && d->u[j] <= d->lower[j]) d->x_trial[j] = p->minimum;
    if (d->u[j] > 0.0 && d->u[j] >= d->upper[j]) d->x_trial[j] = p->maximum;
  }
}

/* The trial at x_trial judged by what was expected of it: `end` where only noise is left. */
static enum um_status judge(struct um_context *context, struct um_diagnosis_descent *d,
                            double expected, double promised, bool *end)
{
  bool happened;
  double length = sqrt(um_diagnosis_dot(d->n, d->u, d->u)), gain = -1.0;
  UM_TRY(um_diagnosis_descent_try(context, d, &happened));
  if (happened)
    gain = (d->chi2 + d->chi2_prior - um_diagnosis_dot(d->nrow, d->r_trial, d->r_trial) -
            chi2_prior(d, d->x_trial)) /
           expected;
  if (!(gain > 0.0)) {
    *end = happened && d->fresh && promised < LOST;
    d->radius = POOR * length;
    if (!happened || d->fresh || *end) return UM_OK;
    return um_diagnosis_descent_differences(context, d);
  }
  um_diagnosis_descent_update(d);
  accept(d);
  if (gain > RICH && length > RICH * d->radius) d->radius = 3.0 * length;
  if (gain < POOR) d->radius = 0.5 * length;
  if (gain < POOR || d->updates > 5 + d->n) return um_diagnosis_descent_differences(context, d);
  return UM_OK;
}

/* One step, or the end. */
static enum um_status step(struct um_context *context, struct um_diagnosis_descent *d, bool *end)
{
  enum um_status status;
  struct um_diagnosis_system system = {0};
  double left, now = d->chi2 + d->chi2_prior;
  size_t most = d->problem->iterations_max > 0 ? d->problem->iterations_max : ITERATIONS_MAX;
  UM_CHECK(linearise(context, d, &system));
  UM_CHECK(um_diagnosis_system_solve(context, &system, 0.0, d->lower, d->upper, d->u, &left));
  double promised = now - left;
  if (!(promised >= ENOUGH)) {
    d->converged = *end = um_diagnosis_descent_serves(d);
    if (!*end) status = um_diagnosis_descent_differences(context, d);
    goto done;
  }
  if (d->iterations == most) {
    *end = true;
    goto done;
  }
  UM_CHECK(shorten(context, d, &system, &left));
  aim(d);
  d->iterations++;
  UM_CHECK(judge(context, d, now - left, promised, end));
  d->converged = *end;
done:
  um_diagnosis_system_release(context, &system);
  return status;
}

enum um_status um_diagnosis_descent_run(struct um_context *context,
                                        struct um_diagnosis_descent *descent)
{
  bool end = false;
  descent->converged = descent->n == 0;
  while (descent->n > 0 && !end) UM_TRY(step(context, descent, &end));
  return UM_OK;
}
