/* The Jacobian of a fit: forward differences with the parameter's own step into its allowed range,
 * and Broyden's rank-one update (1965, Math. Comput. 19:577) between them, which makes J agree with
 * the change of the residuals over the last step: with u the step over the parameters' scales,
 *
 *   J S <- J S + (dv - J S u) u' / |u|^2. */
#include <math.h>
#include <string.h>

#include "base/inference/descent_impl.h"

#define BEND_MAX  0.05 /* share of the change of the residuals that J may miss */
#define NOT_MOVED 3.0  /* change of the residuals that is no move, in roots of the tolerance */

/* r_trial of model values [nobservation]; false where one is not finite. */
static bool residuals(struct um_inference_descent *d, const double *value)
{
  const struct um_inference_fit_problem *p = d->problem;
  bool finite = true;
  for (size_t i = 0; i < d->nobservation; i++) {
    d->r_trial[i] = (p->measured[i] - value[i]) / p->sigma[i];
    finite = finite && isfinite(d->r_trial[i]);
  }
  if (finite) um_inference_noise_whiten(p->noise, d->r_trial);
  return finite;
}

enum um_status um_inference_descent_try(struct um_context *context,
                                        struct um_inference_descent *descent, bool *happened)
{
  const struct um_inference_fit_problem *p = descent->problem;
  enum um_status status = p->evaluate(context, p->user, descent->x_trial, descent->value_trial);
  descent->evaluations++;
  *happened = false;
  if (status == UM_ERR_REFUSED || status == UM_ERR_NUMERIC) {
    um_core_message_clear(context);
    return UM_OK;
  }
  UM_TRY(status);
  *happened = residuals(descent, descent->value_trial);
  return UM_OK;
}

/* x_trial with parameter j moved by h; false where that leaves the range. */
static bool put_step(struct um_inference_descent *d, size_t j, double h)
{
  const struct um_inference_fit_parameter *p = &d->problem->parameter[j];
  memcpy(d->x_trial, d->x, d->n * sizeof *d->x);
  d->x_trial[j] = d->x[j] + h;
  return h != 0.0 && d->x_trial[j] >= p->minimum && d->x_trial[j] <= p->maximum;
}

/* Column j from r_trial. */
static void put_column(struct um_inference_descent *d, size_t j)
{
  double *column = d->jacobian + j * d->nobservation;
  double step = d->x_trial[j] - d->x[j]; /* what h was after rounding */
  for (size_t i = 0; i < d->nobservation; i++) column[i] = (d->r[i] - d->r_trial[i]) / step;
}

/* The step that is tried first: the parameter's own, or what its range leaves. */
static double first_step(const struct um_inference_descent *d, size_t j)
{
  const struct um_inference_fit_parameter *p = &d->problem->parameter[j];
  double above = p->maximum - d->x[j], below = d->x[j] - p->minimum, h = p->step;
  if (h > above && h > below) h = above > below ? above : -below; /* a range below the step */
  return h;
}

/* Columns of the first steps, all at once. done: [n] */
static enum um_status first_columns(struct um_context *context, struct um_inference_descent *d,
                                    bool *done)
{
  enum um_status status;
  size_t n = d->n, count = 0, *which = NULL;
  double *x = NULL, *value = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *which, &which));
  UM_CHECK(um_core_allocate(context, n * n, sizeof *x, &x));
  UM_CHECK(um_core_allocate(context, n * d->nobservation, sizeof *value, &value));
  for (size_t j = 0; j < n; j++) {
    if (!put_step(d, j, first_step(d, j))) continue;
    memcpy(x + count * n, d->x_trial, n * sizeof *x);
    which[count++] = j;
  }
  UM_CHECK(d->problem->evaluate_all(context, d->problem->user, count, x, value));
  d->evaluations += count;
  for (size_t k = 0; k < count; k++) {
    size_t j = which[k];
    memcpy(d->x_trial, x + k * n, n * sizeof *x);
    done[j] = residuals(d, value + k * d->nobservation);
    if (done[j]) put_column(d, j);
  }
done:
  um_core_free(context, which);
  um_core_free(context, x);
  um_core_free(context, value);
  return status;
}

/* Column j by one step after another, where the first one is refused or leaves the range. */
static enum um_status column(struct um_context *context, struct um_inference_descent *d, size_t j,
                             bool *done)
{
  static const double part[] = {1.0, -1.0, 0.25, -0.25};
  size_t from = d->problem->evaluate_all != NULL ? 1 : 0; /* the first was tried */
  for (size_t k = from; !*done && k < sizeof part / sizeof *part; k++) {
    if (!put_step(d, j, first_step(d, j) * part[k])) continue;
    UM_TRY(um_inference_descent_try(context, d, done));
    if (*done) put_column(d, j);
  }
  if (*done) return UM_OK;
  const struct um_inference_fit_parameter *p = &d->problem->parameter[j];
  if (p->minimum < p->maximum)
    return um_core_fail(context, UM_ERR_NUMERIC,
                        "the model cannot be computed beside %g of parameter %zu of a fit", d->x[j],
                        j + 1);
  memset(d->jacobian + j * d->nobservation, 0, d->nobservation * sizeof *d->jacobian);
  return UM_OK;
}

static void keep_base(struct um_inference_descent *d)
{
  memcpy(d->base_jacobian, d->jacobian, d->n * d->nobservation * sizeof *d->jacobian);
  memcpy(d->base_x, d->x, d->n * sizeof *d->x);
  memcpy(d->base_r, d->r, d->nobservation * sizeof *d->r);
}

enum um_status um_inference_descent_differences(struct um_context *context,
                                                struct um_inference_descent *descent)
{
  enum um_status status;
  bool *done = NULL;
  UM_CHECK(um_core_allocate(context, descent->n, sizeof *done, &done));
  if (descent->problem->evaluate_all != NULL) UM_CHECK(first_columns(context, descent, done));
  for (size_t j = 0; j < descent->n; j++) UM_CHECK(column(context, descent, j, &done[j]));
  keep_base(descent);
  descent->fresh = true;
  descent->updates = 0;
done:
  um_core_free(context, done);
  return status;
}

void um_inference_descent_update(struct um_inference_descent *descent)
{
  size_t n = descent->n, nobservation = descent->nobservation;
  double *u = descent->v, square = 0.0, moved = 0.0;
  for (size_t j = 0; j < n; j++) {
    u[j] = (descent->x_trial[j] - descent->x[j]) / descent->scale[j];
    square += u[j] * u[j];
  }
  if (!(square > 0.0)) return;
  for (size_t i = 0; i < nobservation; i++)
    moved += (descent->r[i] - descent->r_trial[i]) * (descent->r[i] - descent->r_trial[i]);
  /* what is lost in the model's own noise says nothing of the slope */
  if (!(moved > NOT_MOVED * NOT_MOVED * um_inference_descent_tolerance(descent))) return;
  if (n == 1) keep_base(descent); /* the next update tells how far the secant bends */
  for (size_t i = 0; i < nobservation; i++) {
    double missed = descent->r[i] - descent->r_trial[i];
    for (size_t j = 0; j < n; j++)
      missed -= descent->jacobian[j * nobservation + i] * descent->scale[j] * u[j];
    for (size_t j = 0; j < n; j++)
      descent->jacobian[j * nobservation + i] += missed * u[j] / square / descent->scale[j];
  }
  descent->updates++;
}

/* Whether the bounds hold all parameters: their slopes are only asked for their signs. */
static bool is_held(const struct um_inference_descent *d)
{
  for (size_t j = 0; j < d->n; j++)
    if (d->x[j] > d->problem->parameter[j].minimum && d->x[j] < d->problem->parameter[j].maximum)
      return false;
  return true;
}

/* Along the way from where J was made (one parameter: from the point before), dv = J dx + m: slope
 * that J has not is m / |dv| per sigma of the way, which shifts the zero of the gradient by m'r /
 * |dv| sigma, much where r is not noise; its square is the chi-square lost. */
bool um_inference_descent_jacobian_is_valid(struct um_inference_descent *descent)
{
  double missed = 0.0, moved = 0.0, bias = 0.0;
  double shift = sqrt(um_inference_descent_tolerance(descent));
  if (descent->fresh || is_held(descent)) return true;
  for (size_t i = 0; i < descent->nobservation; i++) {
    double change = descent->base_r[i] - descent->r[i], miss = change;
    for (size_t j = 0; j < descent->n; j++)
      miss -= descent->base_jacobian[j * descent->nobservation + i] *
              (descent->x[j] - descent->base_x[j]);
    moved += change * change;
    missed += miss * miss;
    bias += miss * descent->r[i];
  }
  moved = sqrt(moved);
  if (fabs(bias) > shift * moved) return false;
  return moved < NOT_MOVED * shift || sqrt(missed) < BEND_MAX * moved;
}
