/* Where the search for a rate begins: how fast the axis of a spinning body goes about, which does
 * nothing while the axis stands along the angular momentum.
 *
 * Light that moves with the body alone answers to small turns theta(t) of it as
 *
 *   dm_j = sum_i  dm_j/dtheta_i  theta_i(t_j),   i the body's axes,
 *
 * whatever makes it turn, so that six evaluations of lines of sight give the signatures at every
 * value of the rate: theta follows from the attitude laws, without tracing. Heat, which follows the
 * load of whole turns, is left out: this says where to begin, and nothing is judged by it. The rate
 * is the one at which the amplitudes explain most of the residual, after a factor on every channel.
 *
 * Values are laid out over the range and between them, until the columns of neighbours explain half
 * of each other; the peak is at least as wide (a shift of phase by a quarter of a turn at the end
 * of the observations). So many values are that many tests. */
#include <math.h>
#include <string.h>

#include "base/inference/algebra.h"
#include "base/inference/score.h"
#include "effects/effects.h"
#include "evidence/sensitivity/difference_impl.h"
#include "evidence/sensitivity/scan_impl.h"
#include "model/build/build.h"
#include "model/build/timeline.h"

#define TURN     0.01 /* of the differences [rad]: half a degree */
#define FIRST    16   /* intervals of the range */
#define MOST     128  /* values that are looked at */
#define ALIKE    0.5  /* of a column that those of its neighbour explain [1] */
#define REFINED  3    /* halvings of the distance at the best value */
#define NOTHING  1e-9 /* [rad] */
#define OBSERVED 8    /* observations beyond one of every channel, at least */

struct value {
  double at;      /* of the rate */
  double *column; /* [namplitude][nobservation] whitened; NULL: the model refuses it */
};

struct scan {
  struct um_context *context;
  const struct um_sensitivity_forward *forward;
  const struct um_sensitivity_candidate *candidate;
  size_t n;      /* observations */
  double *slope; /* [3][n] by turns about the body's axes [per rad], whitened */
  double *theta; /* [nobs][3] scratch */
  size_t rate;   /* parameter */
  size_t namplitude, amplitude[UM_EFFECT_PARAMETERS_MAX];
  size_t nvalue;
  struct value value[MOST + FIRST + 1 + 2 * REFINED];
};

/* --- turns ------------------------------------------------------------------------------------ */

static enum um_status find_slopes(struct um_context *context, struct um_sensitivity_forward *f,
                                  double *slope)
{
  enum um_status status = UM_OK;
  size_t n = f->observations.count;
  double *back = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *back, &back));
  for (size_t i = 0; i < 3; i++) {
    struct um_vec3 turn = um_vec3(i == 0 ? TURN : 0.0, i == 1 ? TURN : 0.0, i == 2 ? TURN : 0.0);
    double *column = slope + i * n;
    UM_CHECK(um_sensitivity_forward_evaluate_turned(context, f, turn, column));
    UM_CHECK(um_sensitivity_forward_evaluate_turned(context, f, um_vec3_scale(turn, -1.0), back));
    for (size_t j = 0; j < n; j++)
      column[j] = (column[j] - back[j]) / (2.0 * TURN * f->observations.sigma[j]);
  }
done:
  um_core_free(context, back);
  return status;
}

/* Turn of the body in its own axes [rad], from the attitude that it has to another. */
static struct um_vec3 turn_between(struct um_quat from, struct um_quat to)
{
  struct um_quat q = um_quat_then(um_quat_conjugate(from), to);
  double sign = q.w < 0.0 ? -1.0 : 1.0, half = sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
  double angle = 2.0 * atan2(half, sign * q.w);
  return um_vec3_scale(um_vec3(q.x, q.y, q.z), half > 0.0 ? sign * angle / half : 2.0 * sign);
}

/* Turns theta at the middle of every observation with these values of the effect; *largest [rad].
 * UM_ERR_REFUSED: the model refuses them. */
static enum um_status find_turns(struct scan *scan, const double *values, double *largest)
{
  struct um_context *context = scan->context;
  const struct um_model_tables *tables = scan->forward->base.tables;
  struct um_model_addition a = {.effect = scan->candidate->effect,
                                .target = scan->candidate->target};
  const struct um_model_changes changes = {.addition = &a, .naddition = 1};
  struct um_model *model = NULL;
  enum um_status status = UM_OK;
  *largest = 0.0;
  memcpy(a.value, values, a.effect->nparameter * sizeof *values);
  UM_CHECK(um_model_variant_create(context, scan->forward->model, &changes, &model));
  for (size_t k = 0; k < tables->nobs; k++) {
    const struct um_environment_sample *s = &tables->sample[k * tables->nsub + tables->nsub / 2];
    struct um_quat q;
    UM_CHECK(um_model_sample_turned(context, model, s, 0.0, &q));
    struct um_vec3 theta = turn_between(s->q, q);
    memcpy(scan->theta + 3 * k, &(double[3]){theta.x, theta.y, theta.z}, 3 * sizeof(double));
    *largest = fmax(*largest, um_vec3_norm(theta));
  }
done:
  um_model_destroy(context, &model);
  return status == UM_ERR_INPUT ? UM_ERR_REFUSED : status;
}

/* --- signatures ------------------------------------------------------------------------------- */

static enum um_status fill_column(struct scan *scan, size_t a, double at, double *column)
{
  const struct um_sensitivity_forward *f = scan->forward;
  const struct um_sensitivity_candidate *c = scan->candidate;
  double values[UM_EFFECT_PARAMETERS_MAX], largest;
  size_t p = scan->amplitude[a];
  double step = um_sensitivity_first_step(c, p, c->null_value[p]);
  memcpy(values, c->null_value, sizeof values);
  values[scan->rate] = at;
  values[p] += step;
  UM_TRY(find_turns(scan, values, &largest));
  for (size_t j = 0; j < scan->n; j++) {
    const double *theta = scan->theta + 3 * f->plan->observation[f->observations.row[j]];
    column[j] = 0.0;
    for (size_t i = 0; i < 3; i++) column[j] += scan->slope[i * scan->n + j] * theta[i] / step;
  }
  return UM_OK;
}

/* Another value of the rate, with its columns. */
static enum um_status look_at(struct scan *scan, double at, size_t *index)
{
  struct value *v = &scan->value[scan->nvalue];
  enum um_status status = UM_OK;
  *index = scan->nvalue++;
  *v = (struct value){.at = at};
  UM_TRY(
      um_core_allocate(scan->context, scan->namplitude * scan->n, sizeof *v->column, &v->column));
  for (size_t a = 0; a < scan->namplitude && status == UM_OK; a++)
    status = fill_column(scan, a, at, v->column + a * scan->n);
  if (status != UM_ERR_REFUSED && status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(scan->context);
  um_core_free(scan->context, v->column);
  v->column = NULL;
  return UM_OK;
}

static enum um_status score(struct scan *scan, const double *residual, size_t from, size_t count,
                            const struct um_inference_nuisance *nuisance,
                            struct um_inference_score *out)
{
  static const double any[2][UM_EFFECT_PARAMETERS_MAX] = {
      {-INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY, -INFINITY},
      {INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY}};
  struct um_inference_direction *d = NULL;
  UM_TRY(um_core_allocate(scan->context, count, sizeof *d, &d));
  for (size_t i = 0; i < count; i++) {
    const struct value *v = &scan->value[from + i];
    d[i] = (struct um_inference_direction){.ncolumn = v->column == NULL ? 0 : scan->namplitude,
                                           .column = v->column,
                                           .minimum_step = any[0],
                                           .maximum_step = any[1],
                                           .prior_sigma = any[1]};
  }
  enum um_status status =
      um_inference_score_test(scan->context, scan->n, residual, nuisance, count, d, out);
  um_core_free(scan->context, d);
  return status;
}

/* Do the columns of a explain those of b? */
static enum um_status are_alike(struct scan *scan, size_t a, size_t b, bool *out)
{
  const struct um_inference_nuisance none = {0};
  *out = scan->value[a].column == NULL || scan->value[b].column == NULL;
  if (*out) return UM_OK;
  *out = true;
  for (size_t k = 0; k < scan->namplitude && *out; k++) {
    const double *column = scan->value[b].column + k * scan->n;
    struct um_inference_score s;
    UM_TRY(score(scan, column, a, 1, &none, &s));
    *out = s.statistic >= ALIKE * um_inference_dot(scan->n, column, column);
  }
  return UM_OK;
}

/* Values between two, until neighbours are alike. */
static enum um_status lay_between(struct scan *scan, size_t a, size_t b)
{
  bool alike;
  size_t between;
  UM_TRY(are_alike(scan, a, b, &alike));
  if (alike || scan->nvalue >= MOST) return UM_OK;
  UM_TRY(look_at(scan, 0.5 * (scan->value[a].at + scan->value[b].at), &between));
  UM_TRY(lay_between(scan, a, between));
  return lay_between(scan, between, b);
}

static enum um_status lay_out(struct scan *scan)
{
  const struct um_sensitivity_candidate *c = scan->candidate;
  double from = c->minimum[scan->rate], to = c->maximum[scan->rate];
  for (size_t i = 0, last = 0; i <= FIRST; i++) {
    size_t now;
    UM_TRY(look_at(scan, from + (to - from) * (double)i / FIRST, &now));
    if (i > 0) UM_TRY(lay_between(scan, last, now));
    last = now;
  }
  return UM_OK;
}

/* --- the best --------------------------------------------------------------------------------- */

/* A factor on every channel of light, whitened. */
static void factors_of(const struct um_sensitivity_forward *f, double *column, double *sigma)
{
  size_t n = f->observations.count;
  for (size_t c = 0; c < f->measurements->nchannel; c++) {
    sigma[c] = INFINITY;
    if (f->measurements->channel[c].quantity == UM_QUANTITY_TEMPERATURE) continue;
    for (size_t j = 0; j < n; j++)
      if (f->observations.channel[j] == c)
        column[c * n + j] = f->cache->base[j] / f->observations.sigma[j];
  }
}

/* The best of the values from `from` on, where it is better than *best. */
static enum um_status find_best(struct scan *scan, size_t from, const double *residual,
                                const struct um_inference_nuisance *nuisance, double *highest,
                                double *best)
{
  struct um_inference_score *s = NULL;
  size_t count = scan->nvalue - from;
  UM_TRY(um_core_allocate(scan->context, count, sizeof *s, &s));
  enum um_status status = score(scan, residual, from, count, nuisance, s);
  for (size_t i = 0; i < count && status == UM_OK; i++) {
    if (!(s[i].statistic > *highest)) continue;
    *highest = s[i].statistic;
    *best = scan->value[from + i].at;
  }
  um_core_free(scan->context, s);
  return status;
}

/* Distance of the nearest other value. */
static double spacing(const struct scan *scan, double at)
{
  double nearest = INFINITY;
  for (size_t i = 0; i < scan->nvalue; i++)
    if (scan->value[i].at != at) nearest = fmin(nearest, fabs(scan->value[i].at - at));
  return nearest;
}

static enum um_status search(struct scan *scan, struct um_sensitivity_candidate *c)
{
  enum um_status status = UM_OK;
  const struct um_sensitivity_forward *f = scan->forward;
  size_t n = scan->n, nchannel = f->measurements->nchannel;
  double *factor = NULL, *sigma = NULL, *residual = NULL;
  double highest = 0.0, best = c->null_value[scan->rate];
  UM_CHECK(um_core_allocate(scan->context, nchannel * n, sizeof *factor, &factor));
  UM_CHECK(um_core_allocate(scan->context, nchannel, sizeof *sigma, &sigma));
  UM_CHECK(um_core_allocate(scan->context, n, sizeof *residual, &residual));
  factors_of(f, factor, sigma);
  const struct um_inference_nuisance nuisance = {nchannel, factor, sigma};
  for (size_t j = 0; j < n; j++)
    residual[j] = (f->observations.measured[j] - f->cache->base[j]) / f->observations.sigma[j];
  UM_CHECK(lay_out(scan));
  c->trials = scan->nvalue;
  UM_CHECK(find_best(scan, 0, residual, &nuisance, &highest, &best));
  double apart = spacing(scan, best);
  for (size_t i = 0; i < REFINED; i++) {
    size_t from = scan->nvalue, at;
    apart *= 0.5;
    const double beside[2] = {best - apart, best + apart};
    for (size_t k = 0; k < 2; k++)
      UM_CHECK(look_at(scan, fmin(fmax(beside[k], c->minimum[scan->rate]), c->maximum[scan->rate]),
                       &at));
    UM_CHECK(find_best(scan, from, residual, &nuisance, &highest, &best));
  }
  c->null_value[scan->rate] = best;
done:
  UM_FREE(scan->context, factor, sigma, residual);
  return status;
}

/* --- which ------------------------------------------------------------------------------------ */

/* The rate of an effect and what it goes on; false: it has none. */
static bool has_rate(const struct um_effect *effect, struct scan *scan)
{
  bool any = false;
  scan->namplitude = 0;
  for (size_t p = 0; p < um_effect_fitted(effect); p++) {
    if (effect->parameters[p].is_rate)
      scan->rate = p, any = true;
    else
      scan->amplitude[scan->namplitude++] = p;
  }
  return any && scan->namplitude > 0;
}

/* Does the rate matter only beside the others? Alone it turns nothing, and one of them does. */
static enum um_status is_unidentified(struct scan *scan, bool *out)
{
  const struct um_sensitivity_candidate *c = scan->candidate;
  double values[UM_EFFECT_PARAMETERS_MAX], alone = 0.0, beside = 0.0;
  enum um_status status = UM_OK;
  for (size_t a = 0; a <= scan->namplitude && status == UM_OK; a++) {
    size_t p = a == 0 ? scan->rate : scan->amplitude[a - 1];
    double largest;
    memcpy(values, c->null_value, sizeof values);
    values[p] += um_sensitivity_first_step(c, p, values[p]);
    status = find_turns(scan, values, &largest);
    *(a == 0 ? &alone : &beside) = fmax(a == 0 ? alone : beside, largest);
  }
  *out = status == UM_OK && alone < NOTHING && beside > NOTHING;
  if (status != UM_ERR_REFUSED && status != UM_ERR_NUMERIC) return status;
  um_core_message_clear(scan->context);
  return UM_OK;
}

enum um_status um_sensitivity_scan_rates(struct um_context *context,
                                         struct um_sensitivity_forward *forward,
                                         struct um_sensitivity_candidate *candidate, size_t count)
{
  enum um_status status = UM_OK;
  const struct um_model_tables *tables = forward->base.tables;
  size_t n = forward->observations.count;
  struct scan *scan = NULL;
  if (forward->model->points || tables->view == NULL ||
      n < forward->measurements->nchannel + OBSERVED)
    return UM_OK;
  um_core_quiet_begin(context);
  UM_CHECK(um_core_allocate(context, 1, sizeof *scan, &scan));
  *scan = (struct scan){.context = context, .forward = forward, .n = n};
  UM_CHECK(um_core_allocate(context, 3 * tables->nobs, sizeof *scan->theta, &scan->theta));
  for (size_t i = 0; i < count; i++) {
    struct um_sensitivity_candidate *c = &candidate[i];
    bool wanted;
    scan->candidate = c;
    if (c->insensitive || !has_rate(c->effect, scan)) continue;
    UM_CHECK(is_unidentified(scan, &wanted));
    if (!wanted) continue;
    if (scan->slope == NULL) {
      UM_CHECK(um_core_allocate(context, 3 * n, sizeof *scan->slope, &scan->slope));
      UM_CHECK(find_slopes(context, forward, scan->slope));
    }
    UM_CHECK(search(scan, c));
    for (; scan->nvalue > 0; scan->nvalue--)
      um_core_free(context, scan->value[scan->nvalue - 1].column);
  }
done:
  for (size_t i = 0; scan != NULL && i < scan->nvalue; i++)
    um_core_free(context, scan->value[i].column);
  if (scan != NULL) UM_FREE(context, scan->slope, scan->theta);
  um_core_free(context, scan);
  um_core_quiet_end(context);
  return status;
}
