/* Nonlinear least squares with priors and bounds: chi-square of the observations plus that of the
 * priors is lowered by the iteration of descent.c; here what is asked of a problem and what its
 * result says: with J whitened at the solution and W the priors' widths, over the parameters that
 * are free,
 *
 *   covariance = (J'C^-1 J + W^-2)^-1,   BIC = chi2 + chi2_prior + nparameter ln nobservation
 *
 * (Schwarz 1978, Ann. Stat. 6:461). */
#include "base/inference/fit.h"

#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/descent_impl.h"
#include "base/inference/policy.h"

static enum um_status check_parameter(struct um_context *context,
                                      const struct um_inference_fit_parameter *p, size_t j)
{
  if (!isfinite(p->start) || !(p->start >= p->minimum && p->start <= p->maximum))
    return um_core_fail(context, UM_ERR_INPUT,
                        "parameter %zu of a fit starts at %g, outside its range %g .. %g", j + 1,
                        p->start, p->minimum, p->maximum);
  if (!(p->step > 0.0) || isinf(p->step))
    return um_core_fail(context, UM_ERR_INPUT,
                        "parameter %zu of a fit has the step %g; above 0 is needed", j + 1,
                        p->step);
  if (!(p->prior_sigma > 0.0) || (!isinf(p->prior_sigma) && !isfinite(p->prior_mean)))
    return um_core_fail(context, UM_ERR_INPUT,
                        "parameter %zu of a fit has the prior %g +- %g; a finite mean and a width "
                        "above 0 are needed",
                        j + 1, p->prior_mean, p->prior_sigma);
  return UM_OK;
}

static enum um_status check(struct um_context *context,
                            const struct um_inference_fit_problem *problem)
{
  size_t nfree = 0;
  for (size_t j = 0; j < problem->nparameter; j++) {
    UM_TRY(check_parameter(context, &problem->parameter[j], j));
    if (isinf(problem->parameter[j].prior_sigma)) nfree++;
  }
  for (size_t i = 0; i < problem->nobservation; i++)
    if (!(problem->sigma[i] > 0.0))
      return um_core_fail(context, UM_ERR_INPUT,
                          "observation %zu of a fit has the sigma %g; above 0 is needed", i + 1,
                          problem->sigma[i]);
  if (problem->nobservation == 0 || nfree > problem->nobservation)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%zu parameters without prior cannot be fitted to %zu measurements", nfree,
                        problem->nobservation);
  return UM_OK;
}

static enum um_status reserve(struct um_context *context, struct um_inference_fit *fit)
{
  size_t n = fit->nparameter;
  UM_TRY(um_core_allocate(context, n, sizeof *fit->x, &fit->x));
  UM_TRY(um_core_allocate(context, n, sizeof *fit->sigma, &fit->sigma));
  UM_TRY(um_core_allocate(context, n * n, sizeof *fit->covariance, &fit->covariance));
  UM_TRY(um_core_allocate(context, n, sizeof *fit->at_bound, &fit->at_bound));
  UM_TRY(um_core_allocate(context, fit->nobservation, sizeof *fit->value, &fit->value));
  UM_TRY(um_core_allocate(context, fit->nobservation, sizeof *fit->residual, &fit->residual));
  return um_core_allocate(context, n * fit->nobservation, sizeof *fit->jacobian, &fit->jacobian);
}

/* Residual and Jacobian over sigma alone, whatever the noise. */
static void take(struct um_inference_fit *fit, const struct um_inference_descent *d)
{
  struct um_inference_noise *noise = d->problem->noise;
  memcpy(fit->x, d->x, fit->nparameter * sizeof *fit->x);
  memcpy(fit->value, d->value, fit->nobservation * sizeof *fit->value);
  memcpy(fit->residual, d->r, fit->nobservation * sizeof *fit->residual);
  memcpy(fit->jacobian, d->jacobian, fit->nparameter * fit->nobservation * sizeof *fit->jacobian);
  um_inference_noise_colour(noise, fit->residual);
  for (size_t j = 0; j < fit->nparameter; j++)
    um_inference_noise_colour(noise, fit->jacobian + j * fit->nobservation);
  fit->iterations = d->iterations;
  fit->evaluations = d->evaluations;
  fit->converged = d->converged;
  fit->chi2 = d->chi2;
  fit->chi2_prior = d->chi2_prior;
  fit->bic = fit->chi2 + fit->chi2_prior + (double)fit->nparameter * log((double)fit->nobservation);
  for (size_t j = 0; j < fit->nparameter; j++) {
    const struct um_inference_fit_parameter *p = &d->problem->parameter[j];
    fit->at_bound[j] = fit->x[j] <= p->minimum || fit->x[j] >= p->maximum;
  }
}

/* Covariance of the free parameters, those at a bound held there; columns over their steps. */
static enum um_status find_covariance(struct um_context *context,
                                      const struct um_inference_fit_problem *problem,
                                      struct um_inference_fit *fit)
{
  enum um_status status;
  struct um_inference_qr *qr = NULL;
  double *column = NULL, *work = NULL;
  bool *determined = NULL;
  size_t n = fit->nparameter, total = fit->nobservation + n;
  UM_CHECK(um_core_allocate(context, n * total, sizeof *column, &column));
  UM_CHECK(um_core_allocate(context, n * n, sizeof *work, &work));
  UM_CHECK(um_core_allocate(context, n, sizeof *determined, &determined));
  for (size_t j = 0; j < n; j++) {
    if (fit->at_bound[j]) continue; /* a column of 0 is beyond the rank */
    memcpy(column + j * total, fit->jacobian + j * fit->nobservation,
           fit->nobservation * sizeof *column);
    um_inference_noise_whiten(problem->noise, column + j * total);
    column[j * total + fit->nobservation + j] = 1.0 / problem->parameter[j].prior_sigma;
  }
  UM_CHECK(um_inference_qr_create(context, total, n, column, UM_INFERENCE_RANK_TOLERANCE, &qr));
  um_inference_qr_covariance(qr, work, fit->covariance, determined);
  for (size_t j = 0; j < n; j++) {
    fit->sigma[j] = determined[j] ? sqrt(fit->covariance[j * n + j]) : INFINITY;
    if (fit->at_bound[j]) fit->sigma[j] = NAN;
  }
done:
  UM_FREE(context, column, work, determined);
  um_inference_qr_destroy(context, &qr);
  return status;
}

enum um_status um_inference_fit_create(struct um_context *context,
                                       const struct um_inference_fit_problem *problem,
                                       struct um_inference_fit **out)
{
  enum um_status status;
  struct um_inference_descent descent = {0};
  struct um_inference_fit *fit = NULL;
  *out = NULL;
  UM_CHECK(check(context, problem));
  UM_CHECK(um_core_allocate(context, 1, sizeof *fit, &fit));
  fit->nobservation = problem->nobservation;
  fit->nparameter = problem->nparameter;
  UM_CHECK(reserve(context, fit));
  UM_CHECK(um_inference_descent_begin(context, problem, &descent));
  UM_CHECK(um_inference_descent_run(context, &descent));
  take(fit, &descent);
  UM_CHECK(find_covariance(context, problem, fit));
  *out = fit;
  fit = NULL;
done:
  um_inference_descent_release(context, &descent);
  um_inference_fit_destroy(context, &fit);
  return status;
}

void um_inference_fit_destroy(struct um_context *context, struct um_inference_fit **fit)
{
  if (*fit == NULL) return;
  UM_FREE(context, (*fit)->x, (*fit)->sigma, (*fit)->covariance, (*fit)->at_bound, (*fit)->value,
          (*fit)->residual, (*fit)->jacobian, *fit);
  *fit = NULL;
}

/* --- as numbers ------------------------------------------------------------------------------ */

#define HEAD   ((sizeof(struct um_inference_fit) + sizeof(double) - 1) / sizeof(double))
#define ARRAYS 6

struct array {
  double *data;
  size_t count;
};

/* Arrays of doubles, in the order in which they are packed. */
static void arrays_of(const struct um_inference_fit *fit, struct array array[ARRAYS])
{
  size_t n = fit->nparameter, m = fit->nobservation;
  const struct array all[ARRAYS] = {{fit->x, n},     {fit->sigma, n},    {fit->covariance, n * n},
                                    {fit->value, m}, {fit->residual, m}, {fit->jacobian, n * m}};
  memcpy(array, all, sizeof all);
}

size_t um_inference_fit_packed(size_t nobservation, size_t nparameter)
{
  return HEAD + nparameter * (3 + nparameter + nobservation) + 2 * nobservation;
}

void um_inference_fit_pack(const struct um_inference_fit *fit, double *out)
{
  struct array array[ARRAYS];
  arrays_of(fit, array);
  memcpy(out, fit, sizeof *fit);
  out += HEAD;
  for (size_t i = 0; i < ARRAYS; out += array[i++].count)
    if (array[i].count > 0) memcpy(out, array[i].data, array[i].count * sizeof *out);
  for (size_t j = 0; j < fit->nparameter; j++) out[j] = fit->at_bound[j];
}

enum um_status um_inference_fit_unpack(struct um_context *context, const double *from,
                                       size_t nobservation, size_t nparameter,
                                       struct um_inference_fit **out)
{
  struct array array[ARRAYS];
  struct um_inference_fit *fit = NULL;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *fit, &fit));
  memcpy(fit, from, sizeof *fit);
  fit->nobservation = nobservation;
  fit->nparameter = nparameter;
  fit->x = fit->sigma = fit->covariance = fit->value = fit->residual = fit->jacobian = NULL;
  fit->at_bound = NULL;
  UM_CHECK(reserve(context, fit));
  arrays_of(fit, array);
  from += HEAD;
  for (size_t i = 0; i < ARRAYS; from += array[i++].count)
    if (array[i].count > 0) memcpy(array[i].data, from, array[i].count * sizeof *from);
  for (size_t j = 0; j < fit->nparameter; j++) fit->at_bound[j] = from[j] != 0.0;
  *out = fit;
  fit = NULL;
done:
  um_inference_fit_destroy(context, &fit);
  return status;
}
