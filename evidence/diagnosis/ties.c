/* Fitted parameters, and pairs of them of which only a combination is known. With x_a, x_b values,
 * of factors their logarithms, sigmas s_a, s_b and correlation r, the combination that varies least
 * is
 *
 *   x_a - g x_b,  g = r s_a / s_b,   with sigma s_a sqrt(1 - r^2):
 *
 * of two factors the product a b^-g. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/steps_impl.h"

static void take_block(const struct um_diagnosis_state *state, size_t b, struct um_diagnosis *d)
{
  const struct um_diagnosis_block *block = &state->block[b];
  size_t free = 0;
  for (size_t i = 0; i < b; i++) free += state->block[i].nfree;
  for (size_t p = 0; p < block->nfree; p++)
    d->fitted[d->nfitted++] =
        (struct um_diagnosis_fitted){.effect = block->addition.effect,
                                     .target = block->addition.target,
                                     .parameter = block->parameter[p],
                                     .nuisance = b < state->nnuisance,
                                     .value = block->addition.value[block->parameter[p]],
                                     .free = free + p};
}

enum um_status um_diagnosis_fitted_list(struct um_context *context,
                                        const struct um_diagnosis_state *state,
                                        struct um_diagnosis *d)
{
  d->nfitted = 0;
  UM_TRY(um_core_allocate(context, state->nparameter, sizeof *d->fitted, &d->fitted));
  for (size_t i = 0; i < d->naddition; i++)
    for (size_t b = state->nnuisance; b < state->nblock; b++)
      if (state->block[b].addition.effect == d->addition[i].effect &&
          state->block[b].addition.target == d->addition[i].target)
        take_block(state, b, d);
  for (size_t b = 0; b < state->nnuisance; b++) take_block(state, b, d);
  return UM_OK;
}

static const struct um_effect_parameter *parameter_of(const struct um_diagnosis_fitted *f)
{
  return &f->effect->parameters[f->parameter];
}

/* Whether a value multiplies what its effect is about, so that its logarithm is what adds. */
static bool is_factor(const struct um_effect_parameter *of)
{
  return of->logarithmic || (strcmp(of->name, "factor") == 0 && of->minimum >= 0.0);
}

double um_diagnosis_fitted_additive(const struct um_diagnosis_fitted *fitted, double value)
{
  return is_factor(parameter_of(fitted)) ? log(value) : value;
}

/* Of fitted a and b with variances aa, bb and covariance ab about x; where only one of them is a
 * factor, it is taken as its value. */
static struct um_diagnosis_tie tie_of(const struct um_diagnosis *d, size_t a, size_t b, double aa,
                                      double bb, double ab, const double *x)
{
  bool by_log[2] = {is_factor(parameter_of(&d->fitted[a])), is_factor(parameter_of(&d->fitted[b]))};
  struct um_diagnosis_tie out = {.a = a, .b = b, .correlation = ab / sqrt(aa * bb)};
  double va = by_log[0] ? exp(x[a]) : x[a], vb = by_log[1] ? exp(x[b]) : x[b];
  out.product = by_log[0] && by_log[1];
  double by_a = by_log[0] && !out.product ? va : 1.0, by_b = by_log[1] && !out.product ? vb : 1.0;
  double left = by_a * sqrt(fmax(0.0, aa - ab * ab / bb));
  out.power = -ab / bb * by_a / by_b;
  out.value = out.product ? va * pow(vb, out.power) : va + out.power * vb;
  out.sigma = out.product ? out.value * left : left;
  return out;
}

enum um_status um_diagnosis_ties_find(struct um_context *context, const double *x,
                                      const double *covariance, struct um_diagnosis *d)
{
  size_t n = d->nfitted;
  um_core_free(context, d->tie);
  d->tie = NULL;
  d->ntie = 0;
  UM_TRY(um_core_allocate(context, n * n, sizeof *d->tie, &d->tie));
  for (size_t a = 0; a < n; a++)
    for (size_t b = a + 1; b < n; b++) {
      double aa = covariance[a * n + a], bb = covariance[b * n + b], ab = covariance[a * n + b];
      if (fabs(ab) > UM_DIAGNOSIS_TIED * sqrt(aa * bb))
        d->tie[d->ntie++] = tie_of(d, a, b, aa, bb, ab, x);
    }
  return UM_OK;
}

enum um_status um_diagnosis_ties_of_fit(struct um_context *context,
                                        const struct um_diagnosis_state *state,
                                        struct um_diagnosis *d)
{
  size_t n = d->nfitted;
  double *x = NULL;
  UM_TRY(um_core_allocate(context, 2 * n + n * n, sizeof *x, &x));
  double *slope = x + n, *covariance = x + 2 * n; /* slope: d(additive) / d(fitted) */
  for (size_t a = 0; a < n; a++) {
    const struct um_effect_parameter *of = parameter_of(&d->fitted[a]);
    double value = d->fitted[a].value;
    x[a] = um_diagnosis_fitted_additive(&d->fitted[a], value);
    slope[a] = um_effect_transformed_slope(of, value) / (is_factor(of) ? value : 1.0);
    if (!isfinite(x[a])) slope[a] = 0.0; /* a factor of 0 has no logarithm */
  }
  for (size_t a = 0; a < n; a++)
    for (size_t b = 0; b < n; b++)
      covariance[a * n + b] =
          slope[a] * slope[b] *
          state->fit->covariance[d->fitted[a].free * state->nparameter + d->fitted[b].free];
  enum um_status status = um_diagnosis_ties_find(context, x, covariance, d);
  um_core_free(context, x);
  return status;
}

void um_diagnosis_fitted_text(const struct um_diagnosis_fitted *fitted, char out[160])
{
  snprintf(out, 160, "%.50s%s%.60s %.40s", fitted->effect->name, fitted->target != NULL ? ":" : "",
           fitted->target != NULL ? fitted->target : "", parameter_of(fitted)->name);
}

void um_diagnosis_tie_text(const struct um_diagnosis_fitted *fitted,
                           const struct um_diagnosis_tie *tie, char out[640])
{
  const struct um_effect_parameter *of = parameter_of(&fitted[tie->a]);
  char a[160], b[160], what[120];
  um_diagnosis_fitted_text(&fitted[tie->a], a);
  um_diagnosis_fitted_text(&fitted[tie->b], b);
  if (tie->product && fabs(tie->power - 1.0) < UM_DIAGNOSIS_ONE)
    snprintf(what, sizeof what, "their product");
  else if (tie->product && fabs(tie->power + 1.0) < UM_DIAGNOSIS_ONE)
    snprintf(what, sizeof what, "the ratio of the first to the second");
  else if (tie->product)
    snprintf(what, sizeof what, "the first times the second to the power of %.3g", tie->power);
  else
    snprintf(what, sizeof what, "the first %s %.4g times the second", tie->power < 0.0 ? "-" : "+",
             fabs(tie->power));
  bool plain = of->unit[0] == '1' && of->unit[1] == '\0';
  snprintf(
      out, 640,
      "%s and %s cannot be told apart (correlation %.3f): what is known is %s, %.4g +- %.2g%s%s", a,
      b, tie->correlation, what, tie->value, tie->sigma, tie->product || plain ? "" : " ",
      tie->product || plain ? "" : of->unit);
}
