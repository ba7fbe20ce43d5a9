/* One-sided differences of the observations by one parameter,
 *
 *   s_j = (m_j(null + h) - m_j(null)) / h.
 *
 * h begins at a fifth of the prior width (a tenth of it moves a derivative of a smooth model by
 * some percent, less than it matters for a score), or the way to the default value without a
 * prior. It grows once where the observations hardly move beside the noise that an integration of
 * the same heat anew makes, and shrinks once where they move by tens of sigma.
 *
 * Where the temperatures at null + h are T + h dT/dp by a forward sensitivity (moves.c), there is
 * no noise and h need not grow; the step that would be wanted of integrations is said all the same,
 * for fits, which integrate. */
#include "evidence/sensitivity/difference_impl.h"

#include <math.h>
#include <string.h>

#include "effects/effects.h"
#include "evidence/sensitivity/policy.h"

static enum um_status evaluate(struct um_context *context, const struct um_sensitivity_point *point,
                               const struct um_sensitivity_candidate *c, const double *values,
                               double *value)
{
  enum um_status status;
  struct um_sensitivity_forward *f = point->forward;
  struct um_model_addition *all = NULL;
  UM_TRY(um_core_allocate(context, point->naddition + 1, sizeof *all, &all));
  if (point->naddition > 0) memcpy(all, point->addition, point->naddition * sizeof *all);
  all[point->naddition] =
      (struct um_model_addition){.effect = c->effect, .target = c->target, .off = c->off};
  memcpy(all[point->naddition].value, values, c->effect->nparameter * sizeof *values);
  UM_CHECK(um_sensitivity_forward_evaluate(context, f, all, point->naddition + 1, value));
done:
  um_core_free(context, all);
  return status;
}

enum um_status um_sensitivity_step_to(struct um_context *context,
                                      const struct um_sensitivity_point *point,
                                      const struct um_sensitivity_candidate *c,
                                      const double *values, const struct um_sensitivity_move *move,
                                      double *difference, struct um_sensitivity_change *out)
{
  struct um_sensitivity_forward *f = point->forward;
  if (move != NULL && point->naddition == 0)
    UM_TRY(um_sensitivity_forward_evaluate_move(context, f, move, difference));
  else
    UM_TRY(evaluate(context, point, c, values, difference));
  *out =
      (struct um_sensitivity_change){.fresh = f->cache->fresh_heat, .smooth = f->cache->moved_heat};
  for (size_t j = 0; j < f->observations.count; j++) {
    difference[j] -= point->base[j];
    double d = fabs(difference[j]) / f->observations.sigma[j];
    out->largest = fmax(out->largest, d);
    out->length += d * d;
  }
  out->length = sqrt(out->length);
  out->rms = out->length / sqrt((double)f->observations.count);
  return UM_OK;
}

double um_sensitivity_first_step(const struct um_sensitivity_candidate *c, size_t which,
                                 double null)
{
  const struct um_effect_parameter *p = &c->effect->parameters[which];
  double minimum = c->minimum[which], maximum = c->maximum[which];
  double size = fabs(p->default_value - null);
  if (isfinite(p->prior_sigma))
    size = UM_SENSITIVITY_SHARE_OF_PRIOR * p->prior_sigma * (p->logarithmic ? fabs(null) : 1.0);
  if (!(size > 0.0)) size = UM_SENSITIVITY_SHARE_OF_RANGE * (maximum - minimum);
  if (null + size <= maximum) return size;
  if (null - size >= minimum) return -size;
  return maximum - null > null - minimum ? maximum - null : minimum - null;
}

/* What the largest change of an observation should be [sigma]. */
static double wanted(const struct um_sensitivity_change *change, double noise)
{
  return change->fresh ? fmax(UM_SENSITIVITY_SEEN, UM_SENSITIVITY_ABOVE_NOISE * noise)
                       : UM_SENSITIVITY_SEEN;
}

/* The step that moves the observations enough, from how far they moved, within range and
 * plausibility; the same when it does or when there is none. What changes nothing at all, with the
 * same heat, is not reached by a longer step either; and a longer one is not worth its time where
 * even the furthest plausible value is not seen. */
static double longer(const struct um_sensitivity_candidate *c, size_t which, double null,
                     double step, const struct um_sensitivity_change *change, double noise)
{
  const struct um_effect_parameter *p = &c->effect->parameters[which];
  double aim = wanted(change, noise), size = fabs(step);
  if (change->largest >= aim || (change->largest == 0.0 && !change->fresh)) return step;
  double room = step > 0.0 ? c->maximum[which] - null : null - c->minimum[which];
  if (isfinite(p->prior_sigma))
    room = fmin(room, fmax(size, UM_SENSITIVITY_PRIORS_MAX * p->prior_sigma *
                                     (p->logarithmic ? fabs(null) : 1.0)));
  if (change->length * room / size < UM_SENSITIVITY_UNSEEN) return step;
  size *= fmin(UM_SENSITIVITY_LONGEST, fmax(2.0, UM_SENSITIVITY_MARGIN * aim / change->largest));
  return copysign(fmin(size, room), step);
}

/* It adds or scales, and is linear in its parameter, nearly. */
bool um_sensitivity_acts_behind(const struct um_effect *effect)
{
  return um_effects_reach(effect) == UM_REACH_OBSERVATION;
}

enum um_status um_sensitivity_move(const struct um_sensitivity_mover *m, double step,
                                   struct um_sensitivity_change *change)
{
  double values[UM_EFFECT_PARAMETERS_MAX];
  const struct um_sensitivity_candidate *c = m->candidate;
  struct um_sensitivity_move of = {
      .effect = c->effect, .target = c->target, .parameter = m->p, .step = step};
  memcpy(values, m->at, c->effect->nparameter * sizeof *values);
  memcpy(of.at, values, c->effect->nparameter * sizeof *values);
  values[m->p] += step;
  UM_TRY(um_sensitivity_step_to(m->context, m->point, c, values, &of, m->column, change));
  change->taken = step;
  return UM_OK;
}

/* The first step; where that is refused (an observation would fall below the horizon, a factor pass
 * 1) the same the other way, and both again shorter. */
static enum um_status move_first(const struct um_sensitivity_mover *m, double *step,
                                 struct um_sensitivity_change *change)
{
  static const double part[] = {1.0, -1.0, 1.0 / UM_SENSITIVITY_SHORTER,
                                -1.0 / UM_SENSITIVITY_SHORTER};
  const struct um_sensitivity_candidate *c = m->candidate;
  enum um_status status = UM_ERR_REFUSED;
  double first = *step;
  for (size_t i = 0; i < sizeof part / sizeof part[0] && status == UM_ERR_REFUSED; i++) {
    double at = m->at[m->p] + part[i] * first;
    if (i > 0 && !(at >= c->minimum[m->p] && at <= c->maximum[m->p])) continue;
    um_core_message_clear(m->context);
    *step = part[i] * first;
    status = um_sensitivity_move(m, *step, change);
  }
  return status;
}

static void divide(const struct um_sensitivity_mover *m, double step)
{
  for (size_t j = 0; j < m->point->forward->observations.count; j++) m->column[j] /= step;
}

/* The longer step where heat is integrated. */
static enum um_status go_longer(const struct um_sensitivity_mover *m, double more, double *step,
                                struct um_sensitivity_change *change)
{
  enum um_status status = um_sensitivity_move(m, more, change);
  if (status == UM_ERR_REFUSED) { /* too far: what was before stands */
    um_core_message_clear(m->context);
    return um_sensitivity_move(m, *step, change);
  }
  UM_TRY(status);
  *step = more;
  return UM_OK;
}

enum um_status um_sensitivity_difference(const struct um_sensitivity_mover *m, double *step,
                                         struct um_sensitivity_change *change)
{
  UM_TRY(move_first(m, step, change));
  double more = longer(m->candidate, m->p, m->at[m->p], *step, change, m->point->noise);
  double factor = more / *step;
  if (factor > 1.0 && !change->smooth) UM_TRY(go_longer(m, more, step, change));
  if (change->rms > UM_SENSITIVITY_FAR && !m->point->derivatives &&
      !um_sensitivity_acts_behind(m->candidate->effect)) {
    *step /= UM_SENSITIVITY_SHORTER;
    factor = 1.0;
    UM_TRY(um_sensitivity_move(m, *step, change));
  }
  divide(m, *step);
  if (factor > 1.0 && change->smooth) {
    *step = more;
    change->largest *= factor;
    change->rms *= factor;
    change->length *= factor;
  }
  return UM_OK;
}

bool um_sensitivity_alive(const struct um_sensitivity_change *change, double noise)
{
  return change->largest >= UM_SENSITIVITY_NOTHING &&
         !(change->fresh && change->largest < UM_SENSITIVITY_LOST * noise);
}

bool um_sensitivity_is_nothing(const struct um_sensitivity_change *change)
{
  return change->largest < UM_SENSITIVITY_NOTHING;
}
