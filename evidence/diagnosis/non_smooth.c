/* Effects with parameters unidentified under the null. A thermostat that cycles makes chi-square
 * non-smooth: it switches a little earlier or later, and a cycle more or less fits into the pass;
 * and a weak heater that is always on is a minimum of its own.
 *
 * Start. The power is scanned upward from the linear model's, which is that of the always-on
 * heater, and the temperature around the one that its place has, or the one measured there.
 *
 * End. Derivatives lead no further than the next discontinuity, a simplex of Nelder and Mead (1965,
 * Comput. J. 7:308; GSL's nmsimplex2) steps over them: one after another, each from the best point
 * so far with sides of another size, while they help.
 *
 * Sigma. The curvature at one point of a non-smooth valley says little of how wide the valley is.
 * Of a parabola, every point whose chi-square is higher by D lies within sqrt(D) sigma; so sigma is
 * at least what the points seen say, |x - best| / sqrt(max(D, 1)) of those with D < 9. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multimin.h>

#include "base/core/order.h"
#include "evidence/diagnosis/policy.h"
#include "evidence/diagnosis/state_impl.h"
#include "evidence/diagnosis/steps_impl.h"

/* Amplitudes to scan [of the linear model's]. */
static const double powers[] = {1.0, 1.5, 2.5, 4.0, 10.0};

/* Sides of the simplices [1], in units of `side`; one simplex after another. */
static const double sizes[] = {1.0, -1.0, 0.3, 2.0, -0.3, -2.0};

double um_diagnosis_linear_amplitude(const struct um_diagnosis_work *work,
                                     const struct um_diagnosis_state *state,
                                     const struct um_sensitivity_candidate *c)
{
  double dot = 0.0, square = 0.0;
  for (size_t j = 0; j < work->forward->observations.count; j++) {
    double s = c->signature[j] / work->forward->observations.sigma[j];
    dot += s * state->fit->residual[j];
    square += s * s;
  }
  return square > 0.0 ? dot / square : 0.0;
}

static double clamp(const struct um_effect_parameter *p, double value)
{
  return fmin(fmax(value, p->minimum), p->maximum);
}

static enum um_status chi2_at(struct um_context *context, const struct um_diagnosis_work *work,
                              const struct um_diagnosis_state *state, struct um_model_addition *all,
                              double *value, double *out)
{
  const struct um_sensitivity_forward *f = work->forward;
  um_diagnosis_state_additions(state, all);
  enum um_status status =
      um_sensitivity_forward_evaluate(context, work->forward, all, state->nblock, value);
  *out = 0.0;
  if (status == UM_ERR_REFUSED || status == UM_ERR_NUMERIC) { /* cannot begin here */
    um_core_message_clear(context);
    *out = INFINITY;
    return UM_OK;
  }
  for (size_t j = 0; j < f->observations.count && status == UM_OK; j++)
    *out += pow((f->observations.measured[j] - value[j]) / f->observations.sigma[j], 2);
  return status;
}

enum um_status um_diagnosis_chi2(struct um_context *context, const struct um_diagnosis_work *work,
                                 const struct um_diagnosis_state *state, double *out)
{
  enum um_status status;
  struct um_model_addition *all = NULL;
  double *value = NULL;
  UM_CHECK(um_core_allocate(context, state->nblock, sizeof *all, &all));
  UM_CHECK(um_core_allocate(context, work->forward->observations.count, sizeof *value, &value));
  UM_CHECK(chi2_at(context, work, state, all, value, out));
done:
  UM_FREE(context, value, all);
  return status;
}

/* What measured temperatures of its place say of a thermostat: they are hardly ever below on_K, and
 * most of the time between on_K and band_K above it. */
struct unidentified {
  double on, band; /* [K]; NaN: nothing */
};

/* target: NULL for a global effect, which has no temperature of its own. */
static enum um_status measured_shape(struct um_context *context,
                                     const struct um_sensitivity_forward *f, const char *target,
                                     struct unidentified *out)
{
  double *t = NULL;
  size_t n = 0;
  *out = (struct unidentified){NAN, NAN};
  UM_TRY(um_core_allocate(context, f->observations.count, sizeof *t, &t));
  for (size_t j = 0; j < f->observations.count; j++) {
    const struct um_compare_channel *c = &f->measurements->channel[f->observations.channel[j]];
    if (c->quantity == UM_QUANTITY_TEMPERATURE && target != NULL &&
        um_sensitivity_is_of(c->of, target))
      t[n++] = f->observations.measured[j];
  }
  qsort(t, n, sizeof *t, um_core_order_double);
  if (n >= UM_DIAGNOSIS_ROWS_MIN) {
    out->on = t[n / 10];
    out->band = t[n - 1 - n / 10] - t[n / 10];
  }
  um_core_free(context, t);
  return UM_OK;
}

/* Start values of the scan: null values, but the temperature `on` and the width `band` [K] where
 * they are not NaN. */
static void put_unidentified(const struct um_sensitivity_candidate *c,
                             struct unidentified unidentified, double *value)
{
  for (size_t s = 0; s < c->nunidentified; s++) {
    const struct um_effect_parameter *p = &c->effect->parameters[c->unidentified[s]];
    double at = p->is_temperature ? unidentified.on : unidentified.band;
    value[c->unidentified[s]] = clamp(p, isnan(at) ? c->null_value[c->unidentified[s]] : at);
  }
}

enum um_status um_diagnosis_start(struct um_context *context, const struct um_diagnosis_work *work,
                                  const struct um_diagnosis_state *before,
                                  struct um_diagnosis_state *state, size_t b)
{
  enum um_status status;
  const struct um_sensitivity_candidate *c =
      &work->candidates->candidate[state->block[b].candidate];
  double *value = state->block[b].addition.value, found[UM_EFFECT_PARAMETERS_MAX];
  const struct um_diagnosis_shape *shape = &work->shape[state->block[b].candidate];
  double amplitude = um_diagnosis_linear_amplitude(work, before, c), lowest = INFINITY, chi2,
         known = NAN;
  struct um_model_addition *all = NULL;
  struct unidentified measured;
  double *rows = NULL;
  UM_CHECK(um_core_allocate(context, state->nblock, sizeof *all, &all));
  UM_CHECK(um_core_allocate(context, work->forward->observations.count, sizeof *rows, &rows));
  UM_CHECK(measured_shape(context, work->forward, c->target, &measured));
  for (size_t s = 0; s < c->nunidentified; s++)
    if (c->effect->parameters[c->unidentified[s]].is_temperature)
      known = c->null_value[c->unidentified[s]];
  const struct unidentified unidentified_starts[] = {
      {known, NAN}, {known - 0.5, NAN}, {measured.on, NAN}, {measured.on, measured.band}};
  size_t nunidentified = isnan(measured.on) ? 2 : 4;
  memcpy(found, value, sizeof found);
  for (size_t i = 0; i < sizeof powers / sizeof powers[0]; i++)
    for (size_t k = 0; k < nunidentified; k++) {
      size_t p = c->parameter[0];
      value[p] = clamp(&c->effect->parameters[p], c->null_value[p] + powers[i] * amplitude);
      put_unidentified(c, unidentified_starts[k], value);
      UM_CHECK(chi2_at(context, work, state, all, rows, &chi2));
      if (!(chi2 < lowest)) continue;
      lowest = chi2;
      memcpy(found, value, sizeof found);
    }
  if (shape->chi2 > 0.0) { /* where an earlier fit ended */
    memcpy(value, shape->value, sizeof found);
    UM_CHECK(chi2_at(context, work, state, all, rows, &chi2));
    if (chi2 < lowest) memcpy(found, value, sizeof found);
  }
  memcpy(value, found, sizeof found);
  if (um_diagnosis_phase_is_free(c, &state->block[b].addition)) um_diagnosis_phase_free(state, b);
done:
  UM_FREE(context, rows, all);
  return status;
}

/* --- simplex ---------------------------------------------------------------------------------- */

/* Where the parameters of block b begin in those of the fit. */
static size_t first_parameter(const struct um_diagnosis_state *state, size_t b)
{
  size_t first = 0;
  for (size_t i = 0; i < b; i++) first += state->block[i].nfree;
  return first;
}

/* Block b of a state moves, all others stand. */
struct search {
  struct um_context *context;
  const struct um_diagnosis_work *work;
  struct um_diagnosis_state *state;
  size_t b;
  struct um_model_addition *all; /* [nblock] */
  double *value;                 /* [nobservation] */
  double others;                 /* chi-square of the priors of blocks that stand */
  double lowest;                 /* chi-square with the priors' so far */
  double *seen;                  /* [nseen][nfree + 1] transformed values and their chi-square */
  size_t nseen;
  enum um_status status; /* of the evaluations */
};

static enum um_status remember(struct search *search, const gsl_vector *x, double chi2)
{
  size_t n = x->size, at = search->nseen * (n + 1);
  UM_TRY(um_core_reallocate(search->context, at + n + 1, sizeof *search->seen,
                            (void **)&search->seen));
  for (size_t k = 0; k < n; k++) search->seen[at + k] = gsl_vector_get(x, k);
  search->seen[at + n] = chi2;
  search->nseen++;
  return UM_OK;
}

/* First side by a parameter of the block [transformed]: what moves a switching by a good part of
 * its cycle, a fifth of an amplitude or a width; half a kelvin. */
static double side(const struct search *search, size_t k)
{
  const struct um_diagnosis_block *block = &search->state->block[search->b];
  const struct um_effect_parameter *p = &block->addition.effect->parameters[block->parameter[k]];
  if (p->is_temperature) return 0.5;
  if (p->logarithmic) return 0.2;
  if (p->is_phase) return 1.0 / UM_DIAGNOSIS_PHASES;
  return fmax(0.2 * fabs(block->addition.value[block->parameter[k]]), block->step[k]);
}

/* Chi-square of the priors of a block at transformed values x. */
static double prior_of(const struct um_diagnosis_block *block, const double *x)
{
  double sum = 0.0;
  for (size_t k = 0; k < block->nfree; k++)
    if (!isinf(block->prior_sigma[k]))
      sum += pow((x[k] - block->prior_mean[k]) / block->prior_sigma[k], 2);
  return sum;
}

/* Chi-square with that of the priors at transformed values x; 1e300 outside the range. */
static double height(const gsl_vector *x, void *user)
{
  struct search *s = user;
  struct um_diagnosis_block *block = &s->state->block[s->b];
  double chi2 = 1e300;
  if (s->status != UM_OK) return chi2;
  for (size_t k = 0; k < block->nfree; k++) {
    const struct um_effect_parameter *p = &block->addition.effect->parameters[block->parameter[k]];
    double value = um_effect_physical(p, gsl_vector_get(x, k));
    if (!(value >= block->minimum[k] && value <= block->maximum[k])) return chi2;
    block->addition.value[block->parameter[k]] = value;
  }
  s->status = chi2_at(s->context, s->work, s->state, s->all, s->value, &chi2);
  if (!isfinite(chi2)) return 1e300;
  chi2 += s->others + prior_of(block, gsl_vector_const_ptr(x, 0));
  if (s->status == UM_OK) s->status = remember(s, x, chi2);
  return chi2;
}

/* One simplex from x with these sides. x becomes its best vertex where that is the lowest so far.
 */
static enum um_status descend(struct search *search, const double *sides, double *x)
{
  size_t n = search->state->block[search->b].nfree;
  gsl_vector_view at = gsl_vector_view_array(x, n);
  gsl_vector_const_view by = gsl_vector_const_view_array(sides, n);
  gsl_multimin_function function = {height, n, search};
  gsl_set_error_handler_off();
  gsl_multimin_fminimizer *simplex =
      gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, n);
  if (simplex == NULL) return um_core_fail(search->context, UM_ERR_MEMORY, "out of memory");
  int code = gsl_multimin_fminimizer_set(simplex, &function, &at.vector, &by.vector);
  double first = gsl_multimin_fminimizer_size(simplex);
  for (size_t i = 0; i < UM_DIAGNOSIS_EVALUATIONS && code == GSL_SUCCESS && search->status == UM_OK;
       i++) {
    code = gsl_multimin_fminimizer_iterate(simplex);
    if (gsl_multimin_fminimizer_size(simplex) < UM_DIAGNOSIS_SIMPLEX_END * first) break;
  }
  if (search->status == UM_OK && gsl_multimin_fminimizer_minimum(simplex) < search->lowest) {
    search->lowest = gsl_multimin_fminimizer_minimum(simplex);
    for (size_t k = 0; k < n; k++) x[k] = gsl_vector_get(gsl_multimin_fminimizer_x(simplex), k);
  }
  gsl_multimin_fminimizer_free(simplex);
  return search->status;
}

static enum um_status search_from(struct search *search)
{
  struct um_diagnosis_block *block = &search->state->block[search->b];
  double x[UM_EFFECT_PARAMETERS_MAX], sides[UM_EFFECT_PARAMETERS_MAX],
      own[UM_EFFECT_PARAMETERS_MAX];
  for (size_t k = 0; k < block->nfree; k++) {
    const struct um_effect_parameter *p = &block->addition.effect->parameters[block->parameter[k]];
    x[k] = um_effect_transformed(p, block->addition.value[block->parameter[k]]);
    own[k] = side(search, k);
  }
  for (size_t i = 0, vain = 0; i < sizeof sizes / sizeof sizes[0] && vain < 2; i++) {
    double before = search->lowest;
    for (size_t k = 0; k < block->nfree; k++) sides[k] = sizes[i] * own[k];
    UM_TRY(descend(search, sides, x));
    vain = search->lowest < before - UM_DIAGNOSIS_SIMPLEX_GAIN ? 0 : vain + 1;
  }
  for (size_t k = 0; k < block->nfree; k++) {
    size_t p = block->parameter[k];
    block->addition.value[p] = um_effect_physical(&block->addition.effect->parameters[p], x[k]);
  }
  return UM_OK;
}

/* Raise the sigmas of the block to what the evaluations seen say. */
static void widen(const struct search *search, const struct um_diagnosis_state *state)
{
  struct um_inference_fit *fit = state->fit;
  size_t n = state->block[search->b].nfree, first = first_parameter(state, search->b);
  for (size_t i = 0; i < search->nseen; i++) {
    const double *point = search->seen + i * (n + 1);
    double higher = point[n] - fit->chi2 - fit->chi2_prior;
    for (size_t k = 0; k < n && higher < UM_DIAGNOSIS_VALLEY * UM_DIAGNOSIS_VALLEY; k++) {
      double *sigma = &fit->sigma[first + k];
      double away = fabs(point[k] - fit->x[first + k]);
      if (!isnan(*sigma)) *sigma = fmax(*sigma, away / sqrt(fmax(higher, 1.0)));
    }
  }
}

/* Whether a parameter unidentified under the null moves the observations by a sigma within its
 * prior width. An angle about an axis of symmetry does not, and then chi-square is smooth. */
static bool is_non_smooth(const struct um_diagnosis_work *work,
                          const struct um_diagnosis_state *state, size_t b)
{
  const struct um_diagnosis_block *block = &state->block[b];
  const struct um_sensitivity_candidate *c = &work->candidates->candidate[block->candidate];
  const struct um_inference_fit *fit = state->fit;
  size_t first = first_parameter(state, b);
  for (size_t k = c->ncolumn; k < block->nfree; k++) {
    double square = 0.0, *column = fit->jacobian + (first + k) * fit->nobservation;
    for (size_t j = 0; j < fit->nobservation; j++) square += column[j] * column[j];
    if (sqrt(square) * block->prior_sigma[k] > 1.0) return true;
  }
  return false;
}

enum um_status um_diagnosis_simplex_refine(struct um_context *context,
                                           const struct um_diagnosis_work *work,
                                           struct um_diagnosis_state *state, size_t b)
{
  enum um_status status;
  struct um_diagnosis_state trial = {0};
  struct search search = {.context = context, .work = work, .b = b, .status = UM_OK};
  if (!is_non_smooth(work, state, b)) return UM_OK;
  UM_CHECK(um_diagnosis_state_copy(context, state, state->nblock, &trial));
  search.state = &trial;
  search.lowest = state->fit->chi2 + state->fit->chi2_prior;
  search.others = state->fit->chi2_prior -
                  prior_of(&state->block[b], state->fit->x + first_parameter(state, b));
  UM_CHECK(um_core_allocate(context, state->nblock, sizeof *search.all, &search.all));
  UM_CHECK(um_core_allocate(context, work->forward->observations.count, sizeof *search.value,
                            &search.value));
  UM_CHECK(search_from(&search));
  UM_CHECK(um_diagnosis_state_fit(context, work, &trial, NULL, NULL, INFINITY));
  if (trial.fit->bic < state->fit->bic) {
    struct um_diagnosis_state other = *state;
    *state = trial;
    trial = other;
  }
  widen(&search, state);
done:
  UM_FREE(context, search.seen, search.value, search.all);
  um_diagnosis_state_release(context, &trial);
  return status;
}
