/* Draws from the posterior of all that a fit has free, effects and nuisances: likelihood with the
 * noise that the fit ended with, priors and ranges of the fit. Factors are drawn by their
 * logarithms, in which a product of which only that is known lies on a straight line. With x = exp
 * y the density of y is that of x times x. */
#include "evidence/diagnosis/fitted.h"

#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/uncertainty/design.h"
#include "base/uncertainty/posterior.h"
#include "base/uncertainty/statistics.h"
#include "evidence/diagnosis/steps_impl.h"

/* The density, and what it computes on the way. */
struct drawn {
  struct um_diagnosis_evaluation evaluation;
  const struct um_inference_fit_parameter *parameter; /* [nparameter] */
  bool *by_log;     /* [nparameter] a factor that is fitted as it is */
  double *x;        /* room for UM_UNCERTAINTY_AT_ONCE draws */
  double *value;    /* [ndraw][nobservation] */
  double *residual; /* [nobservation] */
  size_t n;         /* draws so far */
};

/* Of x as it is fitted. */
static double log_density(const struct drawn *drawn, const double *x, const double *value)
{
  const struct um_diagnosis_work *work = drawn->evaluation.work;
  const struct um_sensitivity_observations *o = &work->forward->observations;
  double chi2, volume = 0.0;
  for (size_t j = 0; j < o->count; j++)
    drawn->residual[j] = (o->measured[j] - value[j]) / o->sigma[j];
  um_inference_noise_whiten(work->noise, drawn->residual);
  chi2 = um_inference_dot(o->count, drawn->residual, drawn->residual);
  for (size_t k = 0; k < drawn->evaluation.state->nparameter; k++) {
    const struct um_inference_fit_parameter *p = &drawn->parameter[k];
    if (drawn->by_log[k]) volume += log(x[k]);
    if (isinf(p->prior_sigma)) continue;
    double away = (x[k] - p->prior_mean) / p->prior_sigma;
    chi2 += away * away;
  }
  return volume - 0.5 * chi2;
}

static enum um_status density(struct um_context *context, void *user, size_t n, const double *y,
                              double *out)
{
  struct drawn *drawn = user;
  size_t nparameter = drawn->evaluation.state->nparameter;
  double *x = drawn->x;
  for (size_t i = 0; i < n * nparameter; i++) {
    size_t k = i % nparameter;
    x[i] = drawn->by_log[k] ? exp(y[i]) : y[i];
    x[i] =
        fmin(fmax(x[i], drawn->parameter[k].minimum), drawn->parameter[k].maximum); /* rounding */
  }
  size_t nobservation = drawn->evaluation.work->forward->observations.count;
  double *value = drawn->value + drawn->n * nobservation;
  UM_TRY(um_diagnosis_evaluate_all(context, &drawn->evaluation, n, x, value));
  for (size_t i = 0; i < n; i++)
    out[i] = log_density(drawn, x + i * nparameter, value + i * nobservation);
  drawn->n += n;
  return UM_OK;
}

/* Precision of a state's x about its fit, those at a bound not held there. A range counts as the
 * variance of what is alike in it: draws outside are of no use. out: [nparameter][nparameter] */
static enum um_status precision_of(struct um_context *context, const struct um_diagnosis_work *work,
                                   const struct um_diagnosis_state *state,
                                   const struct um_inference_fit_parameter *parameter, double *out)
{
  size_t k = state->nparameter, n = work->forward->observations.count;
  double *column = NULL;
  UM_TRY(um_core_allocate(context, k * n, sizeof *column, &column));
  memcpy(column, state->fit->jacobian, k * n * sizeof *column);
  for (size_t a = 0; a < k; a++) um_inference_noise_whiten(work->noise, column + a * n);
  for (size_t a = 0; a < k; a++)
    for (size_t b = 0; b < k; b++)
      out[a * k + b] = um_inference_dot(n, column + a * n, column + b * n);
  for (size_t a = 0; a < k; a++) {
    const struct um_inference_fit_parameter *p = &parameter[a];
    double width = p->maximum - p->minimum;
    out[a * k + a] += 1.0 / (p->prior_sigma * p->prior_sigma);
    if (isfinite(width) && width > 0.0) out[a * k + a] += 12.0 / (width * width);
  }
  um_core_free(context, column);
  return UM_OK;
}

/* Values of the draws as the effects have them, and their quantiles. */
static enum um_status keep(struct um_context *context, const struct um_uncertainty_posterior *draws,
                           const double *model, const bool *by_log, struct um_diagnosis *d,
                           struct um_diagnosis_posterior *out)
{
  static const double p[UM_DIAGNOSIS_QUANTILES] = {0.025, 0.16, 0.5, 0.84, 0.975};
  static const double band[UM_DIAGNOSIS_BAND] = {0.05, 0.5, 0.95};
  size_t n = draws->n, m = d->nfitted, nobservation = out->nobservation;
  out->n = n;
  out->nfitted = m;
  out->effective = draws->effective;
  out->tail = draws->tail;
  out->sound = um_uncertainty_posterior_is_sound(draws);
  UM_TRY(um_core_allocate(context, n * m, sizeof *out->value, &out->value));
  UM_TRY(um_core_allocate(context, n, sizeof *out->weight, &out->weight));
  UM_TRY(
      um_core_allocate(context, UM_DIAGNOSIS_QUANTILES * m, sizeof *out->quantile, &out->quantile));
  UM_TRY(
      um_core_allocate(context, UM_DIAGNOSIS_BAND * nobservation, sizeof *out->band, &out->band));
  memcpy(out->weight, draws->weight, n * sizeof *out->weight);
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < m; k++) {
      const struct um_diagnosis_fitted *f = &d->fitted[k];
      double y = draws->x[i * draws->nparameter + f->free];
      out->value[i * m + k] =
          um_effect_physical(&f->effect->parameters[f->parameter], by_log[f->free] ? exp(y) : y);
    }
  UM_TRY(um_uncertainty_quantiles(context, n, m, out->value, out->weight, UM_DIAGNOSIS_QUANTILES, p,
                                  out->quantile));
  return um_uncertainty_quantiles(context, n, nobservation, model, out->weight, UM_DIAGNOSIS_BAND,
                                  band, out->band);
}

/* Pairs by the draws in place of the fit's curvature. */
static enum um_status ties(struct um_context *context, struct um_diagnosis *d)
{
  const struct um_diagnosis_posterior *p = d->posterior;
  size_t n = p->nfitted;
  double *x = NULL;
  UM_TRY(um_core_allocate(context, n + n * n + p->n * n, sizeof *x, &x));
  double *covariance = x + n, *value = covariance + n * n;
  for (size_t i = 0; i < p->n * n; i++)
    value[i] = um_diagnosis_fitted_additive(&d->fitted[i % n], p->value[i]);
  um_uncertainty_covariance(p->n, n, value, p->weight, x, covariance);
  enum um_status status = um_diagnosis_ties_find(context, x, covariance, d);
  um_core_free(context, x);
  return status;
}

static enum um_status check(struct um_context *context, const struct um_diagnosis_work *work,
                            const struct um_diagnosis_state *state)
{
  size_t n = work->forward->observations.count, most = UM_UNCERTAINTY_NUMBERS_MAX / n;
  if (state->nparameter == 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "nothing that is fitted has a value: there is no posterior");
  if (work->options->draws <= most) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%zu draws of %zu observations are more than memory is kept for; accepted: "
                      "%zu draws at most",
                      work->options->draws, n, most);
}

/* From x as it is fitted to y as it is drawn: centre, bounds and precision. */
static void to_drawn(const struct drawn *drawn, double *centre, double *least, double *most,
                     double *precision)
{
  size_t n = drawn->evaluation.state->nparameter;
  for (size_t k = 0; k < n; k++) {
    const struct um_inference_fit_parameter *p = &drawn->parameter[k];
    double x = drawn->evaluation.state->fit->x[k];
    centre[k] = drawn->by_log[k] ? log(x) : x;
    least[k] = drawn->by_log[k] ? log(p->minimum) : p->minimum;
    most[k] = drawn->by_log[k] ? log(p->maximum) : p->maximum;
    for (size_t l = 0; drawn->by_log[k] && l < n; l++) {
      precision[k * n + l] *= x;
      precision[l * n + k] *= x;
    }
  }
}

static enum um_status reserve(struct um_context *context, size_t ndraw, struct drawn *drawn)
{
  const struct um_diagnosis_state *state = drawn->evaluation.state;
  size_t k = state->nparameter, n = drawn->evaluation.work->forward->observations.count;
  UM_TRY(um_core_allocate(context, state->nblock, sizeof *drawn->evaluation.addition,
                          &drawn->evaluation.addition));
  UM_TRY(um_core_allocate(context, k, sizeof *drawn->by_log, &drawn->by_log));
  UM_TRY(um_core_allocate(context, UM_UNCERTAINTY_AT_ONCE * k, sizeof *drawn->x, &drawn->x));
  UM_TRY(um_core_allocate(context, ndraw * n, sizeof *drawn->value, &drawn->value));
  return um_core_allocate(context, n, sizeof *drawn->residual, &drawn->residual);
}

/* A factor that the fit did not leave at 0. */
static void choose_logs(const struct um_diagnosis *d, struct drawn *drawn)
{
  for (size_t i = 0; i < d->nfitted; i++) {
    const struct um_diagnosis_fitted *f = &d->fitted[i];
    drawn->by_log[f->free] = !f->effect->parameters[f->parameter].logarithmic && f->value > 0.0 &&
                             um_diagnosis_fitted_additive(f, f->value) != f->value;
  }
}

enum um_status um_diagnosis_posterior_draw(struct um_context *context,
                                           const struct um_diagnosis_work *work,
                                           const struct um_diagnosis_state *state,
                                           struct um_diagnosis *d)
{
  enum um_status status;
  size_t k = state->nparameter, n = work->forward->observations.count;
  size_t ndraw = work->options->draws;
  struct um_inference_fit_parameter *parameter = NULL;
  struct um_uncertainty_posterior *draws = NULL;
  struct drawn drawn = {.evaluation = {work, state, NULL}};
  double *room = NULL;
  if (ndraw == 0) return UM_OK;
  UM_TRY(check(context, work, state));
  um_core_progress_begin(context, "drawing from the posterior", ndraw);
  UM_CHECK(reserve(context, ndraw, &drawn));
  UM_CHECK(um_core_allocate(context, k, sizeof *parameter, &parameter));
  UM_CHECK(um_core_allocate(context, 3 * k + k * k, sizeof *room, &room));
  um_diagnosis_state_parameters(state, parameter);
  drawn.parameter = parameter;
  choose_logs(d, &drawn);
  double *centre = room, *least = room + k, *most = room + 2 * k, *precision = room + 3 * k;
  UM_CHECK(precision_of(context, work, state, parameter, precision));
  to_drawn(&drawn, centre, least, most, precision);
  const struct um_uncertainty_posterior_problem problem = {.nparameter = k,
                                                           .ndraw = ndraw,
                                                           .centre = centre,
                                                           .precision = precision,
                                                           .least = least,
                                                           .most = most,
                                                           .density = density,
                                                           .user = &drawn,
                                                           .seed = work->options->seed};
  UM_CHECK(um_uncertainty_posterior_create(context, &problem, &draws));
  UM_CHECK(um_core_allocate(context, 1, sizeof *d->posterior, &d->posterior));
  d->posterior->nobservation = n;
  d->posterior->seed = work->options->seed;
  UM_CHECK(keep(context, draws, drawn.value, drawn.by_log, d, d->posterior));
  if (d->posterior->sound) UM_CHECK(ties(context, d));
done:
  um_core_progress_end(context);
  um_uncertainty_posterior_destroy(context, &draws);
  UM_FREE(context, drawn.evaluation.addition, drawn.by_log, drawn.x, drawn.value, drawn.residual);
  UM_FREE(context, parameter, room);
  return status;
}

void um_diagnosis_posterior_destroy(struct um_context *context,
                                    struct um_diagnosis_posterior **posterior)
{
  struct um_diagnosis_posterior *p = *posterior;
  if (p == NULL) return;
  UM_FREE(context, p->value, p->weight, p->quantile, p->band, p);
  *posterior = NULL;
}
