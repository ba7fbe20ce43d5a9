/* Where a fit stands: its memory, its priors, and what is not worth a run. */
#include "base/inference/descent_impl.h"
#include "base/inference/policy.h"

#include <math.h>

enum um_status um_inference_descent_reserve(struct um_context *context,
                                            struct um_inference_descent *d)
{
  double **of_rows[] = {&d->value, &d->r, &d->value_trial, &d->r_trial, &d->base_r};
  double **of_parameters[] = {&d->x,     &d->x_trial, &d->base_x, &d->scale, &d->pull,
                              &d->width, &d->lower,   &d->upper,  &d->u,     &d->v};
  for (size_t i = 0; i < sizeof of_rows / sizeof *of_rows; i++)
    UM_TRY(um_core_allocate(context, d->nobservation, sizeof(double), of_rows[i]));
  for (size_t i = 0; i < sizeof of_parameters / sizeof *of_parameters; i++)
    UM_TRY(um_core_allocate(context, d->n, sizeof(double), of_parameters[i]));
  UM_TRY(um_core_allocate(context, d->n * d->nobservation, sizeof *d->jacobian, &d->jacobian));
  return um_core_allocate(context, d->n * d->nobservation, sizeof *d->base_jacobian,
                          &d->base_jacobian);
}

void um_inference_descent_release(struct um_context *context, struct um_inference_descent *d)
{
  double *block[] = {d->value,   d->r,      d->value_trial, d->r_trial,  d->base_r,       d->x,
                     d->x_trial, d->base_x, d->scale,       d->pull,     d->width,        d->lower,
                     d->upper,   d->u,      d->v,           d->jacobian, d->base_jacobian};
  for (size_t i = 0; i < sizeof block / sizeof *block; i++) um_core_free(context, block[i]);
  *d = (struct um_inference_descent){0};
}

double um_inference_descent_chi2_prior(const struct um_inference_descent *d, const double *x)
{
  double sum = 0.0;
  for (size_t j = 0; j < d->n; j++) {
    const struct um_inference_fit_parameter *p = &d->problem->parameter[j];
    double pull = isinf(p->prior_sigma) ? 0.0 : (p->prior_mean - x[j]) / p->prior_sigma;
    sum += pull * pull;
  }
  return sum;
}

double um_inference_descent_tolerance(const struct um_inference_descent *descent)
{
  double dof = (double)descent->nobservation - (double)descent->n;
  double reduced = (descent->chi2 + descent->chi2_prior) / fmax(dof, 1.0);
  double tolerance =
      descent->problem->tolerance > 0.0 ? descent->problem->tolerance : UM_INFERENCE_END;
  return tolerance * fmax(1.0, reduced);
}
