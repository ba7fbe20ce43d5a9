/* Derivatives of the observations by one parameter, each with its error.
 *
 *   central    s = (m(h) - m(-h)) / 2h
 *   one-sided  s = (4 m(h/2) - m(h) - 3 m(0)) / h   where the null value lies on a bound, or one
 *                                                   side is refused
 *
 * of which the error is h^2 m'''/6 or h^2 m'''/12. m''' is not known; the bend over the step,
 * e = h m''/(2 m'), is, and what bends over a length L has m''' h^2/m' of the order of e^2. That is
 * the error that is said.
 *
 * The first step (difference.c) tells whether anything changes, and how far a line through the null
 * value is good. Where no heat is integrated anew there is no noise but that of numbers, and a
 * hundredth of it serves; where heat is, the step has to stand above the noise, and is halved where
 * the bend is the larger error. */
#include <math.h>
#include <string.h>

#include "effects/effects.h"
#include "evidence/sensitivity/difference_impl.h"
#include "evidence/sensitivity/policy.h"

/* Differences at both ends of a step, or at its half and its end, and what they say. */
struct stencil {
  double *far, *near, *best; /* [nobservation] */
  double *error;             /* [ngroup] of the column as it is */
  size_t ngroup;
};

/* --- norms ------------------------------------------------------------------------------------ */

static bool is_temperature(const struct um_sensitivity_forward *f, size_t j)
{
  return f->measurements->channel[f->observations.channel[j]].quantity == UM_QUANTITY_TEMPERATURE;
}

/* Is observation j of the group: channel c, or, with nchannel, of the temperatures? */
static bool is_of(const struct um_sensitivity_forward *f, size_t j, size_t group)
{
  if (is_temperature(f, j)) return group == f->measurements->nchannel;
  return f->observations.channel[j] == group;
}

struct size {
  double value, of; /* largest of the first [1 or its unit], and of the second [sigma] */
};

/* Largest |a| / largest |b| of a group, beside how large b is there. */
static struct size compare(const struct um_sensitivity_forward *f, size_t group, const double *a,
                           const double *b)
{
  double most = 0.0;
  struct size s = {0.0, 0.0};
  for (size_t j = 0; j < f->observations.count; j++) {
    if (!is_of(f, j, group)) continue;
    s.value = fmax(s.value, fabs(a[j]));
    most = fmax(most, fabs(b[j]));
    s.of = fmax(s.of, fabs(b[j]) / f->observations.sigma[j]);
  }
  s.value = most > 0.0 ? s.value / most : 0.0;
  return s;
}

/* --- stencils --------------------------------------------------------------------------------- */

/* Changes over a step; *there: it may be taken. */
static enum um_status look(const struct um_sensitivity_mover *m, double step, double *into,
                           struct um_sensitivity_change *change, bool *there)
{
  const struct um_sensitivity_candidate *c = m->candidate;
  struct um_sensitivity_mover at = *m;
  double value = m->at[m->p] + step;
  at.column = into;
  *there = value >= c->minimum[m->p] && value <= c->maximum[m->p];
  if (!*there) return UM_OK;
  enum um_status status = um_sensitivity_move(&at, step, change);
  if (status != UM_ERR_REFUSED) return status;
  um_core_message_clear(m->context);
  *there = false;
  return UM_OK;
}

/* What noise makes of the derivative of a group that the step moves by `size` [sigma]. */
static double noise_of(const struct um_sensitivity_mover *m,
                       const struct um_sensitivity_change *change, double size)
{
  return change->fresh && !change->smooth ? m->point->noise / size : 0.0;
}

/* Groups of which the derivative over this step is better than what the column has take it.
 * bend: half the change of the slope over the step. *better: one did. */
static void take(const struct um_sensitivity_mover *m, const struct um_sensitivity_change *change,
                 double step, const double *bend, struct stencil *s, bool *better)
{
  const struct um_sensitivity_forward *f = m->point->forward;
  *better = false;
  for (size_t g = 0; g < s->ngroup; g++) {
    struct size size = compare(f, g, bend, s->best);
    double error = size.value * size.value;
    if (size.of > 0.0) error += noise_of(m, change, size.of * fabs(step));
    if (!(error < s->error[g])) continue;
    s->error[g] = error;
    *better = true;
    for (size_t j = 0; j < f->observations.count; j++)
      if (is_of(f, j, g)) m->column[j] = s->best[j];
  }
}

/* The derivative over a step; known: s->far has the changes over the step itself. *better: in some
 * group it is the best so far. */
static enum um_status apply(const struct um_sensitivity_mover *m,
                            const struct um_sensitivity_change *first, double step, bool known,
                            struct stencil *s, bool *better)
{
  struct um_sensitivity_change change;
  size_t n = m->point->forward->observations.count;
  bool there = true, central = false;
  *better = false;
  if (!known) UM_TRY(look(m, step, s->far, &change, &there));
  if (there) UM_TRY(look(m, -step, s->near, &change, &central));
  if (there && !central) UM_TRY(look(m, 0.5 * step, s->near, &change, &there));
  if (!there) return UM_OK;
  double *bend = s->near; /* in its place, once its number is used */
  for (size_t j = 0; j < n; j++) {
    double far = s->far[j], near = s->near[j];
    s->best[j] = central ? (far - near) / (2.0 * step) : (4.0 * near - far) / step;
    bend[j] = central ? (far + near) / (2.0 * step) : (4.0 * near - 2.0 * far) / step;
  }
  take(m, first, step, bend, s, better);
  return UM_OK;
}

/* --- steps ------------------------------------------------------------------------------------ */

static enum um_sensitivity_way way_of(const struct um_sensitivity_mover *m,
                                      const struct um_sensitivity_change *change)
{
  if (um_sensitivity_acts_behind(m->candidate->effect)) return UM_SENSITIVITY_BY_BEHIND;
  if (um_effects_reach(m->candidate->effect) & UM_REACH_GEOMETRY) return UM_SENSITIVITY_BY_MOTION;
  if (!change->fresh) return UM_SENSITIVITY_BY_LIGHT;
  return change->smooth ? UM_SENSITIVITY_BY_TANGENT : UM_SENSITIVITY_BY_RUNS;
}

/* The longer step that stands above the noise, within the range and what is plausible. */
static double above_noise(const struct um_sensitivity_mover *m,
                          const struct um_sensitivity_change *change)
{
  const struct um_sensitivity_candidate *c = m->candidate;
  const struct um_effect_parameter *p = &c->effect->parameters[m->p];
  double step = change->taken, noise = noise_of(m, change, change->largest);
  double room = step > 0.0 ? c->maximum[m->p] - m->at[m->p] : m->at[m->p] - c->minimum[m->p];
  if (isfinite(p->prior_sigma))
    room = fmin(room, p->prior_sigma * (p->logarithmic ? fabs(m->at[m->p]) : 1.0));
  double size = fabs(step) * fmax(1.0, noise / UM_SENSITIVITY_NOISE_SHARE);
  return copysign(fmax(fabs(step), fmin(size, room)), step);
}

/* How far the line is good: what the first step left, relative to a hundredth of each curve's size,
 * grows with the square of the step. first: changes over change->taken. */
static double reach_of(const struct um_sensitivity_mover *m, const double *first,
                       const struct um_sensitivity_change *change)
{
  const struct um_sensitivity_forward *f = m->point->forward;
  double worst = 0.0;
  for (size_t j = 0; j < f->observations.count; j++) {
    double left = fabs(first[j] - change->taken * m->column[j]);
    worst = fmax(worst, left / f->observations.sigma[j]);
  }
  if (!(worst > UM_SENSITIVITY_STRAIGHT * change->largest)) return INFINITY;
  return fabs(change->taken) * sqrt(UM_SENSITIVITY_LINEAR / worst);
}

/* The largest error of groups that count: those that the parameter moves as much as others. */
static double error_of(const struct um_sensitivity_mover *m, const struct stencil *s)
{
  const struct um_sensitivity_forward *f = m->point->forward;
  double seen = 0.0, worst = 0.0;
  for (size_t g = 0; g < s->ngroup; g++)
    seen = fmax(seen, compare(f, g, m->column, m->column).of);
  for (size_t g = 0; g < s->ngroup; g++)
    if (compare(f, g, m->column, m->column).of >= UM_SENSITIVITY_COUNTS * seen)
      worst = fmax(worst, s->error[g]);
  return worst;
}

/* Derivatives over shorter steps until the error will do or none is better; where nothing is
 * integrated, then over longer ones, since numbers have a noise of their own. */
static enum um_status refine(const struct um_sensitivity_mover *m,
                             const struct um_sensitivity_change *first, bool anew, double step,
                             struct stencil *s, struct um_sensitivity_quality *q)
{
  double factor = anew ? UM_SENSITIVITY_CLOSER : UM_SENSITIVITY_SHORTER, at = step;
  for (int i = 0; i < UM_SENSITIVITY_TRIES && error_of(m, s) > UM_SENSITIVITY_GOOD; i++) {
    bool better;
    at /= factor;
    UM_TRY(apply(m, first, at, false, s, &better));
    if (better) q->step = at;
    if (better || anew) {
      if (!better) return UM_OK;
      continue;
    }
    if (factor < 1.0 || i > 0) return UM_OK;
    factor = 1.0 / factor;
    at = step;
  }
  return UM_OK;
}

enum um_status um_sensitivity_derivative(const struct um_sensitivity_mover *m, double *step,
                                         struct um_sensitivity_change *change,
                                         struct um_sensitivity_quality *q)
{
  enum um_status status;
  const struct um_sensitivity_forward *f = m->point->forward;
  size_t n = f->observations.count;
  struct stencil s = {.ngroup = f->measurements->nchannel + 1};
  double *first = NULL;
  bool better;
  UM_TRY(um_sensitivity_difference(m, step, change));
  if (!m->point->derivatives) return UM_OK;
  *q = (struct um_sensitivity_quality){.way = UM_SENSITIVITY_BY_NONE};
  if (!um_sensitivity_alive(change, m->point->noise)) return UM_OK;
  *q = (struct um_sensitivity_quality){.way = way_of(m, change)};
  UM_CHECK(um_core_allocate(m->context, 4 * n + s.ngroup, sizeof *first, &first));
  s.far = first + n;
  s.near = first + 2 * n;
  s.best = first + 3 * n;
  s.error = first + 4 * n;
  for (size_t g = 0; g < s.ngroup; g++) s.error[g] = INFINITY;
  bool anew = (change->fresh && !change->smooth) || q->way == UM_SENSITIVITY_BY_MOTION;
  q->step = anew ? above_noise(m, change) : UM_SENSITIVITY_SMALL * change->taken;
  bool known = anew && q->step == change->taken;
  for (size_t j = 0; j < n; j++) first[j] = m->column[j] * change->taken;
  if (known) memcpy(s.far, first, n * sizeof *first);
  UM_CHECK(apply(m, change, q->step, known, &s, &better));
  if (better) UM_CHECK(refine(m, change, anew, q->step, &s, q));
  q->error = error_of(m, &s);
  q->reach = reach_of(m, first, change);
done:
  um_core_free(m->context, first);
  return status;
}
