/* Derivatives of the observations by one parameter, each with its error.
 *
 *   central    s = (m(h) - m(-h)) / 2h
 *   one-sided  s = (4 m(h/2) - m(h) - 3 m(0)) / h   where the null value lies on a bound, or one
 *                                                   side is refused
 *
 * of which the error is h^2 m'''/6 or h^2 m'''/12. m''' is not known; the bend over the step,
 * e = h m''/(2 m'), is, and what bends over a length L has m''' h^2/m' of the order of e^2. That is
 * the error that is said. Where lines of sight move, it also has to agree with what a longer step
 * said, since a facet's points are shaded one by one; so has what acts behind the satellite, which
 * costs nothing, and where a power law may have no derivative at 0.
 *
 * The first step (difference.c) tells whether anything changes, and how far a line through the null
 * value is good. Where no heat is integrated anew there is no noise but that of numbers, and a
 * hundredth of it serves. Where heat is, the chain rule
 *
 *   dm/dp = dm/dp at given temperatures + dm/dT dT/dp
 *
 * parts what wants short steps from what has to stand above the noise of an integration. */
#include <math.h>
#include <string.h>

#include "effects/effects.h"
#include "evidence/sensitivity/difference_impl.h"
#include "evidence/sensitivity/policy.h"

/* Work on the derivative of a part. */
struct work {
  const struct um_sensitivity_mover *m;
  const struct um_sensitivity_change *first; /* that the first step made */
  enum um_sensitivity_part part;
  bool noisy;  /* heat is integrated anew in it */
  bool moving; /* its slopes are held against each other: lines of sight move, or a law may have no
                  derivative at 0 */
  bool apart;  /* it could be taken */
  size_t ngroup;
  double *far, *near, *slope, *before; /* [nobservation] */
  double *column;                      /* [nobservation] the best so far */
  double *error;                       /* [ngroup] of it, of the largest value of the group */
  bool known, agreed; /* `before` has slopes; those of the column were held against such */
  double step;        /* of the last that was the best somewhere */
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

/* Largest value of a group, in its unit and in sigma. */
struct size {
  double value, of_sigma;
};
static struct size size_of(const struct um_sensitivity_forward *f, size_t group, const double *a,
                           const double *b)
{
  struct size s = {0.0, 0.0};
  for (size_t j = 0; j < f->observations.count; j++) {
    if (!is_of(f, j, group)) continue;
    double value = fabs(b == NULL ? a[j] : a[j] - b[j]);
    s.value = fmax(s.value, value);
    s.of_sigma = fmax(s.of_sigma, value / f->observations.sigma[j]);
  }
  return s;
}

/* The largest error of groups that count: those that the parameter moves as much as others. */
static double error_of(const struct um_sensitivity_forward *f, const double *column,
                       const double *error)
{
  size_t ngroup = f->measurements->nchannel + 1;
  double seen = 0.0, worst = 0.0;
  for (size_t g = 0; g < ngroup; g++) seen = fmax(seen, size_of(f, g, column, NULL).of_sigma);
  for (size_t g = 0; g < ngroup; g++)
    if (seen > 0.0 && size_of(f, g, column, NULL).of_sigma >= UM_SENSITIVITY_COUNTS * seen)
      worst = fmax(worst, error[g]);
  return worst;
}

/* --- stencils --------------------------------------------------------------------------------- */

/* Changes of the part over a step; *there: it may be taken. */
static enum um_status look(struct work *w, double step, double *into, bool *there)
{
  const struct um_sensitivity_mover *m = w->m;
  const struct um_sensitivity_candidate *c = m->candidate;
  struct um_sensitivity_change change;
  double value = m->at[m->p] + step;
  enum um_status status;
  *there = value >= c->minimum[m->p] && value <= c->maximum[m->p];
  if (!*there) return UM_OK;
  if (w->part == UM_SENSITIVITY_WHOLE) {
    struct um_sensitivity_mover at = *m;
    at.column = into;
    status = um_sensitivity_move(&at, step, &change);
  } else {
    struct um_model_addition a = {.effect = c->effect, .target = c->target};
    memcpy(a.value, m->at, c->effect->nparameter * sizeof *a.value);
    a.value[m->p] = value;
    status = um_sensitivity_forward_evaluate_part(m->context, m->point->forward, &a, w->part,
                                                  &w->apart, into);
    for (size_t j = 0; status == UM_OK && j < m->point->forward->observations.count; j++)
      into[j] -= m->point->base[j];
    *there = w->apart;
  }
  if (status != UM_ERR_REFUSED) return status;
  um_core_message_clear(m->context);
  *there = false;
  return UM_OK;
}

/* The error of the slopes of a group, of their largest value: by their bend and by noise; where
 * lines of sight move by what they differ from those before, whose error is sixteen times theirs.
 */
static double judge(const struct work *w, size_t group, double bend, double step)
{
  const struct um_sensitivity_forward *f = w->m->point->forward;
  struct size size = size_of(f, group, w->slope, NULL);
  double error = bend * bend;
  if (!(size.value > 0.0)) return 0.0;
  if (w->noisy) error += w->m->point->noise / (size.of_sigma * fabs(step));
  if (!w->moving || !w->known) return error;
  return fmax(error,
              UM_SENSITIVITY_AGREES * size_of(f, group, w->slope, w->before).value / size.value);
}

/* The derivative over a step, and groups of the column that it is better for. *better: any. */
static enum um_status apply(struct work *w, double step, bool *better)
{
  const struct um_sensitivity_forward *f = w->m->point->forward;
  size_t n = f->observations.count;
  bool there, central = false;
  *better = false;
  UM_TRY(look(w, step, w->far, &there));
  if (there) UM_TRY(look(w, -step, w->near, &central));
  if (there && !central) UM_TRY(look(w, 0.5 * step, w->near, &there));
  if (!there) return UM_OK;
  for (size_t j = 0; j < n; j++) {
    double far = w->far[j], near = w->near[j];
    w->slope[j] = central ? (far - near) / (2.0 * step) : (4.0 * near - far) / step;
    w->near[j] = central ? (far + near) / (2.0 * step) : (4.0 * near - 2.0 * far) / step;
  }
  for (size_t g = 0; g < w->ngroup; g++) {
    double size = size_of(f, g, w->slope, NULL).value;
    double bend = size > 0.0 ? size_of(f, g, w->near, NULL).value / size : 0.0;
    double error = judge(w, g, bend, step);
    bool last = w->moving && w->error[g] < INFINITY && !w->agreed; /* which nothing confirms */
    if (!(error < w->error[g]) && !last) continue;
    w->error[g] = error;
    *better = true;
    for (size_t j = 0; j < n; j++)
      if (is_of(f, j, g)) w->column[j] = w->slope[j];
  }
  memcpy(w->before, w->slope, n * sizeof *w->slope);
  w->agreed = w->known;
  w->known = true;
  if (*better) w->step = step;
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
  double step = change->taken, noise = m->point->noise / change->largest;
  double room = step > 0.0 ? c->maximum[m->p] - m->at[m->p] : m->at[m->p] - c->minimum[m->p];
  if (isfinite(p->prior_sigma))
    room = fmin(room, p->prior_sigma * (p->logarithmic ? fabs(m->at[m->p]) : 1.0));
  double size = fabs(step) * fmax(1.0, noise / UM_SENSITIVITY_NOISE_SHARE);
  return copysign(fmax(fabs(step), fmin(size, room)), step);
}

/* The best of some steps: the first, then shorter ones while the error is too large; where nothing
 * is integrated and shorter is not better, longer ones, since numbers have a noise of their own. */
static enum um_status differentiate(struct work *w)
{
  const struct um_sensitivity_mover *m = w->m;
  bool rough = w->noisy || w->moving;
  double first = w->noisy ? above_noise(m, w->first)
                 : rough  ? w->first->taken / UM_SENSITIVITY_CLOSER
                          : w->first->taken * UM_SENSITIVITY_SMALL;
  double factor = rough ? UM_SENSITIVITY_CLOSER : UM_SENSITIVITY_SHORTER, step = first;
  memset(w->column, 0, m->point->forward->observations.count * sizeof *w->column);
  for (size_t g = 0; g < w->ngroup; g++) w->error[g] = INFINITY;
  w->known = w->agreed = false;
  for (int i = 0; i < UM_SENSITIVITY_TRIES; i++) {
    bool better;
    UM_TRY(apply(w, step, &better));
    if (!w->apart) return UM_OK;
    bool once = w->moving && i == 0; /* nothing to agree with yet */
    if (!once && error_of(m->point->forward, w->column, w->error) <= UM_SENSITIVITY_GOOD)
      return UM_OK;
    if (!better && ((w->noisy && !once) || factor < 1.0)) return UM_OK;
    if (!better && !w->moving) {
      factor = 1.0 / factor;
      step = first;
    }
    step /= factor;
  }
  return UM_OK;
}

/* The derivative in two parts, added into the mover's column and w->error. heat: [nobservation],
 * then [ngroup]. */
static enum um_status differentiate_apart(struct work *w, double *heat)
{
  const struct um_sensitivity_forward *f = w->m->point->forward;
  size_t n = f->observations.count;
  double *column = w->column, *error = w->error;
  w->noisy = false;
  w->part = UM_SENSITIVITY_HELD;
  UM_TRY(differentiate(w));
  if (!w->apart) return UM_OK;
  w->column = heat;
  w->error = heat + n;
  w->part = UM_SENSITIVITY_HEAT;
  w->noisy = true;
  enum um_status status = differentiate(w);
  for (size_t g = 0; g < w->ngroup; g++) {
    double a = size_of(f, g, column, NULL).value, b = size_of(f, g, heat, NULL).value;
    for (size_t j = 0; j < n; j++)
      if (is_of(f, j, g)) column[j] += heat[j];
    double size = size_of(f, g, column, NULL).value;
    double off = (a > 0.0 ? a * error[g] : 0.0) + (b > 0.0 ? b * w->error[g] : 0.0);
    error[g] = size > 0.0 ? off / size : isfinite(off) ? 0.0 : off;
  }
  w->column = column;
  w->error = error;
  return status;
}

/* How far the line is good: what the first step left, in sigma, grows with the square of the step.
 * first: changes over change->taken. */
static double reach_of(const struct um_sensitivity_mover *m, const double *first,
                       const struct um_sensitivity_change *change)
{
  const struct um_sensitivity_forward *f = m->point->forward;
  double worst = 0.0;
  if (change->smooth) return NAN;
  for (size_t j = 0; j < f->observations.count; j++) {
    double left = fabs(first[j] - change->taken * m->column[j]);
    worst = fmax(worst, left / f->observations.sigma[j]);
  }
  if (!(worst > UM_SENSITIVITY_STRAIGHT * change->largest)) return INFINITY;
  return fabs(change->taken) * sqrt(UM_SENSITIVITY_LINEAR / worst);
}

/* Blocks of `work` [6 nobservation + 2 ngroup], of which the first is the changes over the first
 * step. */
static enum um_status differentiate_in(struct work *w, double *blocks)
{
  const struct um_sensitivity_mover *m = w->m;
  const struct um_sensitivity_change *change = w->first;
  size_t n = m->point->forward->observations.count;
  w->far = blocks + n;
  w->near = blocks + 2 * n;
  w->slope = blocks + 3 * n;
  w->before = blocks + 4 * n;
  double *heat = blocks + 5 * n;
  w->error = blocks + 6 * n + w->ngroup;
  w->column = m->column;
  w->apart = true;
  w->noisy = change->fresh && !change->smooth;
  bool network = (um_effects_reach(m->candidate->effect) & ~(uint32_t)UM_REACH_THERMAL) == 0;
  w->moving = w->moving || (w->noisy && !network); /* edges of a shadow pass between instants */
  if (w->noisy && !network && m->point->naddition == 0) {
    UM_TRY(differentiate_apart(w, heat));
    if (w->apart) return UM_OK;
    w->noisy = w->apart = true;
  }
  w->part = UM_SENSITIVITY_WHOLE;
  return differentiate(w);
}

enum um_status um_sensitivity_derivative(const struct um_sensitivity_mover *m, double *step,
                                         struct um_sensitivity_change *change,
                                         struct um_sensitivity_quality *q)
{
  const struct um_sensitivity_forward *f = m->point->forward;
  size_t n = f->observations.count;
  struct work w = {.m = m, .first = change, .ngroup = f->measurements->nchannel + 1};
  double *blocks;
  UM_TRY(um_sensitivity_difference(m, step, change));
  if (!m->point->derivatives) return UM_OK;
  *q = (struct um_sensitivity_quality){.way = UM_SENSITIVITY_BY_NONE};
  if (!um_sensitivity_alive(change, m->point->noise)) return UM_OK;
  q->way = way_of(m, change);
  UM_TRY(um_core_allocate(m->context, 6 * n + 2 * w.ngroup, sizeof *blocks, &blocks));
  for (size_t j = 0; j < n; j++) blocks[j] = m->column[j] * change->taken;
  w.moving = q->way == UM_SENSITIVITY_BY_MOTION || q->way == UM_SENSITIVITY_BY_BEHIND;
  enum um_status status = differentiate_in(&w, blocks);
  if (status == UM_OK) {
    q->step = w.step;
    q->error = error_of(f, m->column, w.error);
    if (change->smooth) q->error = fmax(q->error, UM_SENSITIVITY_TANGENT);
    q->reach = reach_of(m, blocks, change);
  }
  um_core_free(m->context, blocks);
  return status;
}
