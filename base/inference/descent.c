/* Gauss-Newton in a region of trust, within bounds. Each step solves the linear problem
 *
 *   min_u |r - J S u|^2 + priors + lambda |u|^2,   x + S u within the bounds,   S the scales,
 *
 * (Levenberg 1944, Marquardt 1963; bounds by active sets) with lambda 0 unless the step is longer
 * than the radius, which follows from the gain ratio, actual over predicted reduction (More 1978,
 * Lecture Notes in Mathematics 630:105).
 *
 * Why not gsl_multifit_nlinear: one evaluation is a run of the whole model. GSL makes a Jacobian
 * anew at every step it accepts, knows no bounds, no failing model, and stops by the length of the
 * step. Here a Jacobian is handed in or made once and updated (Broyden), made anew only when two
 * steps in succession fail, one gains less than a quarter of what it should, or the solution
 * lies where the Jacobian no longer holds.
 *
 * The end is reached when the expected decrease of chi-square is no longer worth a run: e = 0.01
 * (a tenth of a sigma) times the reduced chi-square where that is above 1, since observations that
 * scatter more than they say determine parameters less. Also where a model's own noise hides the
 * gain (a step by a Jacobian made on the spot fails, and less than 10 e was expected of it), and
 * where three steps together gain less than 30 e or six in succession fail; that is convergence
 * only where no more than 30 e (after failures 10 e) is predicted by the linear model. A fit that
 * is only of use below some chi-square is pruned when its predicted reduction is far from that. */
#include "base/inference/descent_impl.h"

#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/bounded_impl.h"
#include "base/inference/policy.h"

#define LOST         10.0 /* e, that noise of the model may hide */
#define SLOW         30.0 /* e, the least that steps in succession have to gain .. */
#define SLOW_STEPS   3    /* .. of this number */
#define FAILED_STEPS 6    /* in succession, that are the end */
#define POOR         0.25
#define RICH         0.75
#define FAIR         0.5

static void swap(double **a, double **b)
{
  double *c = *a;
  *a = *b;
  *b = c;
}

/* The trial becomes where the fit stands. */
static void accept(struct um_inference_descent *d)
{
  swap(&d->x, &d->x_trial);
  swap(&d->value, &d->value_trial);
  swap(&d->r, &d->r_trial);
  d->chi2 = um_inference_dot(d->nobservation, d->r, d->r);
  d->chi2_prior = um_inference_descent_chi2_prior(d, d->x);
  d->fresh = false;
}

/* The model at the start, handed in or computed; here its errors are the caller's. */
static enum um_status start(struct um_context *context, struct um_inference_descent *d)
{
  const struct um_inference_fit_problem *p = d->problem;
  for (size_t j = 0; j < d->n; j++) d->x_trial[j] = p->parameter[j].start;
  if (p->value != NULL) {
    memcpy(d->value_trial, p->value, d->nobservation * sizeof *p->value);
  } else {
    UM_TRY(p->evaluate(context, p->user, d->x_trial, d->value_trial));
    d->evaluations++;
  }
  for (size_t i = 0; i < d->nobservation; i++) {
    d->r_trial[i] = (p->measured[i] - d->value_trial[i]) / p->sigma[i];
    if (!isfinite(d->r_trial[i]))
      return um_core_fail(
          context, UM_ERR_NUMERIC,
          "observation %zu of a fit is not finite at its start: measured %g, model %g, "
          "sigma %g",
          i + 1, p->measured[i], d->value_trial[i], p->sigma[i]);
  }
  um_inference_noise_whiten(p->noise, d->r_trial);
  accept(d);
  return UM_OK;
}

enum um_status um_inference_descent_begin(struct um_context *context,
                                          const struct um_inference_fit_problem *problem,
                                          struct um_inference_descent *out)
{
  *out = (struct um_inference_descent){.problem = problem,
                                       .n = problem->nparameter,
                                       .nobservation = problem->nobservation,
                                       .radius = INFINITY};
  UM_TRY(um_inference_descent_reserve(context, out));
  UM_TRY(start(context, out));
  for (size_t j = 0; j < out->n; j++) {
    out->scale[j] = problem->parameter[j].step;
    out->width[j] = problem->parameter[j].prior_sigma;
  }
  if (out->n == 0) return UM_OK;
  if (problem->jacobian == NULL) return um_inference_descent_differences(context, out);
  for (size_t j = 0; j < out->n; j++) {
    double *column = out->jacobian + j * out->nobservation;
    for (size_t i = 0; i < out->nobservation; i++)
      column[i] = problem->jacobian[j * out->nobservation + i] / problem->sigma[i];
    um_inference_noise_whiten(problem->noise, column);
  }
  memcpy(out->base_jacobian, out->jacobian, out->n * out->nobservation * sizeof *out->jacobian);
  memcpy(out->base_x, out->x, out->n * sizeof *out->x);
  memcpy(out->base_r, out->r, out->nobservation * sizeof *out->r);
  return UM_OK;
}

static enum um_status linearise(struct um_context *context, struct um_inference_descent *d,
                                struct um_inference_system *out)
{
  for (size_t j = 0; j < d->n; j++) {
    const struct um_inference_fit_parameter *p = &d->problem->parameter[j];
    d->pull[j] = isinf(p->prior_sigma) ? 0.0 : p->prior_mean - d->x[j];
    d->lower[j] = fmin(0.0, (p->minimum - d->x[j]) / d->scale[j]);
    d->upper[j] = fmax(0.0, (p->maximum - d->x[j]) / d->scale[j]);
  }
  return um_inference_system_create(context,
                                    &(struct um_inference_rows){.nrow = d->nobservation,
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
static enum um_status shorten(struct um_context *context, struct um_inference_descent *d,
                              const struct um_inference_system *system, double *left)
{
  double damping = 1e-12 * um_inference_dot(d->n * d->n, system->r, system->r), factor = 10.0;
  if (sqrt(um_inference_dot(d->n, d->u, d->u)) <= d->radius) return UM_OK;
  do {
    damping *= factor;
    UM_TRY(um_inference_system_solve(context, system, damping, d->lower, d->upper, d->u, left));
  } while (sqrt(um_inference_dot(d->n, d->u, d->u)) > d->radius);
  for (size_t k = 0; k < 5; k++) {
    factor = sqrt(factor);
    double less = damping / factor;
    UM_TRY(um_inference_system_solve(context, system, less, d->lower, d->upper, d->u, left));
    if (sqrt(um_inference_dot(d->n, d->u, d->u)) <= d->radius) damping = less;
  }
  return um_inference_system_solve(context, system, damping, d->lower, d->upper, d->u, left);
}

/* x_trial = x + S u, on a bound exactly where u is. */
static void aim(struct um_inference_descent *d)
{
  for (size_t j = 0; j < d->n; j++) {
    const struct um_inference_fit_parameter *p = &d->problem->parameter[j];
    d->x_trial[j] = fmin(fmax(d->x[j] + d->scale[j] * d->u[j], p->minimum), p->maximum);
    if (d->u[j] < 0.0 && d->u[j] <= d->lower[j]) d->x_trial[j] = p->minimum;
    if (d->u[j] > 0.0 && d->u[j] >= d->upper[j]) d->x_trial[j] = p->maximum;
  }
}

/* A step that failed, or gained nothing: shorter, to where a parabola through what is known along
 * it has its least; the second time by a Jacobian made here. */
static enum um_status reject(struct um_context *context, struct um_inference_descent *d,
                             double length, double expected, double gain, bool *end)
{
  /* the slope along the step is at least twice the expected gain */
  double least = isfinite(gain) ? 1.0 / (1.0 - gain + 1.0) : POOR;
  d->failed++;
  d->radius = fmin(0.5, fmax(0.1, least)) * length;
  if (d->fresh && isfinite(gain) && expected < LOST * um_inference_descent_tolerance(d))
    *end = true;
  if (d->failed >= FAILED_STEPS) *end = true;
  if (*end || d->fresh || d->failed < 2) return UM_OK;
  return um_inference_descent_differences(context, d);
}

/* A step that gained: the region of trust follows, and the Jacobian. */
static enum um_status follow(struct um_context *context, struct um_inference_descent *d,
                             double length, double gain, bool *end)
{
  double before = d->chi2 + d->chi2_prior;
  um_inference_descent_update(d);
  accept(d);
  d->failed = 0;
  d->slow += before - d->chi2 - d->chi2_prior;
  if (++d->slow_steps == SLOW_STEPS) {
    *end = d->slow < SLOW * um_inference_descent_tolerance(d);
    d->slow_steps = 0;
    d->slow = 0.0;
  }
  if (gain > FAIR && length > RICH * d->radius) d->radius = (gain > RICH ? 3.0 : 2.0) * length;
  if (gain < POOR) d->radius = 0.5 * length;
  /* one parameter: the update is the secant, as good as a difference */
  bool stale = d->n > 1 && (gain < POOR || d->updates > 5 + d->n);
  return stale && !*end ? um_inference_descent_differences(context, d) : UM_OK;
}

/* The trial at x_trial, judged by what was expected of it. */
static enum um_status judge(struct um_context *context, struct um_inference_descent *d,
                            double expected, bool *end)
{
  bool happened;
  double length = sqrt(um_inference_dot(d->n, d->u, d->u)), gain = -INFINITY;
  UM_TRY(um_inference_descent_try(context, d, &happened));
  if (happened)
    gain = (d->chi2 + d->chi2_prior - um_inference_dot(d->nobservation, d->r_trial, d->r_trial) -
            um_inference_descent_chi2_prior(d, d->x_trial)) /
           expected;
  if (gain > 0.0) return follow(context, d, length, gain, end);
  return reject(context, d, length, expected, gain, end);
}

/* An alternative of something that is better than this will ever be. */
static bool is_pruned(const struct um_inference_descent *d, double predicted)
{
  double now = d->chi2 + d->chi2_prior;
  bool sure = d->problem->sure;
  double factor = sure ? UM_INFERENCE_PRUNE_SURE : UM_INFERENCE_PRUNE_FACTOR;
  return d->problem->prunes && (sure || d->iterations >= UM_INFERENCE_PRUNE_STEPS) &&
         now - factor * predicted > d->problem->prune_above;
}

/* One step, or the end. */
static enum um_status step(struct um_context *context, struct um_inference_descent *d, bool *end)
{
  enum um_status status;
  struct um_inference_system system = {0};
  double left, now = d->chi2 + d->chi2_prior;
  size_t most =
      d->problem->iterations_max > 0 ? d->problem->iterations_max : UM_INFERENCE_STEPS_MAX;
  UM_CHECK(linearise(context, d, &system));
  UM_CHECK(um_inference_system_solve(context, &system, 0.0, d->lower, d->upper, d->u, &left));
  double predicted = now - left;
  if (!(predicted >= um_inference_descent_tolerance(d))) {
    d->converged = *end = um_inference_descent_jacobian_is_valid(d);
    if (!*end) status = um_inference_descent_differences(context, d);
    goto done;
  }
  if (d->iterations == most || is_pruned(d, predicted)) {
    *end = true;
    goto done;
  }
  UM_CHECK(shorten(context, d, &system, &left));
  aim(d);
  d->iterations++;
  UM_CHECK(judge(context, d, now - left, end));
  if (*end)
    d->converged = predicted < (d->failed > 0 ? LOST : SLOW) * um_inference_descent_tolerance(d);
done:
  um_inference_system_release(context, &system);
  return status;
}

enum um_status um_inference_descent_run(struct um_context *context,
                                        struct um_inference_descent *descent)
{
  bool end = false;
  descent->converged = descent->n == 0;
  while (descent->n > 0 && !end) UM_TRY(step(context, descent, &end));
  return UM_OK;
}
