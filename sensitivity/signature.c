/* How the observations change with the parameters of an effect, by one-sided differences
 *
 *   s_j = (m_j(null + h) - m_j(null)) / h.
 *
 * h begins at a fifth of the prior width (a tenth of it moves a derivative of a smooth model by
 * some percent, less than it matters for a score), or the way to the default value without a
 * prior. It grows once where the observations hardly move beside the noise that an integration of
 * the same heat anew makes, and shrinks once where they move by tens of sigma.
 *
 * A parameter that changes nothing alone, while another one of the effect does, is unidentified
 * under the null (a period, a delay): it is not free but stays at its default value. Where no
 * parameter changes anything alone, each is tried with the others at their default value. */
#include "sensitivity/signature_impl.h"

#include <math.h>
#include <string.h>

#include "effects/effects.h"
#include "sensitivity/forward_impl.h"

#define SHARE_OF_PRIOR 0.2
#define PRIORS_MAX     2.0   /* widths that a step may reach */
#define LONGEST        100.0 /* factor on a first step that is too short */
#define MARGIN         1.5   /* beyond what is asked of a longer one */
#define SHORTER        10.0  /* divides a step that goes too far, or is refused */
#define SEEN           1e-3 /* largest change of an observation [sigma] that a step makes at least */
#define ABOVE_NOISE    10.0 /* and how often the noise it is */
#define UNSEEN         1.0 /* root of the chi-square of all observations that no value is found by */
#define FAR            30.0 /* rms change [sigma] at which a step is far from a derivative */
#define NOTHING        1e-6 /* largest change [sigma] that is none */
#define LOST           3.0  /* changes below so many times the noise are not seen */

/* Changes of the observations that one step makes. */
struct change {
  double largest, rms; /* [sigma] */
  double length;       /* root of their chi-square */
  bool fresh;          /* heat was integrated anew, with its noise */
};

/* A candidate's values with one parameter elsewhere; shape: [nparameter] values of the others. */
static enum um_status step_to(struct um_context *context, const struct um_sensitivity_point *point,
                              const struct um_sensitivity_candidate *c, const double *values,
                              double *difference, struct change *out)
{
  enum um_status status;
  struct um_sensitivity_forward *f = point->forward;
  struct um_model_addition *all = NULL;
  UM_TRY(um_core_allocate(context, point->naddition + 1, sizeof *all, &all));
  if (point->naddition > 0) memcpy(all, point->addition, point->naddition * sizeof *all);
  all[point->naddition] = (struct um_model_addition){.effect = c->effect, .target = c->target};
  memcpy(all[point->naddition].value, values, c->effect->nparameter * sizeof *values);
  UM_CHECK(um_sensitivity_forward_evaluate(context, f, all, point->naddition + 1, difference));
  *out = (struct change){.fresh = f->cache->fresh_heat};
  for (size_t j = 0; j < f->observations.count; j++) {
    difference[j] -= point->base[j];
    double d = fabs(difference[j]) / f->observations.sigma[j];
    out->largest = fmax(out->largest, d);
    out->length += d * d;
  }
  out->length = sqrt(out->length);
  out->rms = out->length / sqrt((double)f->observations.count);
done:
  um_core_free(context, all);
  return status;
}

/* The first step [unit of the parameter], signed, into the range. */
static double first_step(const struct um_sensitivity_candidate *c, size_t which, double null)
{
  const struct um_effect_parameter *p = &c->effect->parameters[which];
  double minimum = c->minimum[which], maximum = c->maximum[which];
  double size = fabs(p->default_value - null);
  if (isfinite(p->prior_sigma))
    size = SHARE_OF_PRIOR * p->prior_sigma * (p->logarithmic ? fabs(null) : 1.0);
  if (!(size > 0.0)) size = 0.01 * (maximum - minimum);
  if (null + size <= maximum) return size;
  if (null - size >= minimum) return -size;
  return maximum - null > null - minimum ? maximum - null : minimum - null;
}

/* What the largest change of an observation should be [sigma]. */
static double wanted(const struct change *change, double noise)
{
  return change->fresh ? fmax(SEEN, ABOVE_NOISE * noise) : SEEN;
}

/* The step that moves the observations enough, from how far they moved, within range and
 * plausibility; the same when it does or when there is none. What changes nothing at all, with the
 * same heat, is not reached by a longer step either; and a longer one is not worth its time where
 * even the furthest plausible value is not seen. */
static double longer(const struct um_sensitivity_candidate *c, size_t which, double null,
                     double step, const struct change *change, double noise)
{
  const struct um_effect_parameter *p = &c->effect->parameters[which];
  double aim = wanted(change, noise), size = fabs(step);
  if (change->largest >= aim || (change->largest == 0.0 && !change->fresh)) return step;
  double room = step > 0.0 ? c->maximum[which] - null : null - c->minimum[which];
  if (isfinite(p->prior_sigma))
    room =
        fmin(room, fmax(size, PRIORS_MAX * p->prior_sigma * (p->logarithmic ? fabs(null) : 1.0)));
  if (change->length * room / size < UNSEEN) return step;
  size *= fmin(LONGEST, fmax(2.0, MARGIN * aim / change->largest));
  return copysign(fmin(size, room), step);
}

/* Calibrations that only add or scale are linear in their parameter as far as one likes. */
static bool acts_behind(const struct um_effect *effect)
{
  return um_effects_reach(effect) == UM_REACH_OBSERVATION;
}

/* What moves: parameter p of the values, by a step. */
struct mover {
  struct um_context *context;
  const struct um_sensitivity_point *point;
  const struct um_sensitivity_candidate *candidate;
  const double *at; /* [nparameter] */
  size_t p;
  double *column; /* [nobservation] the difference that it makes */
};

static enum um_status move(const struct mover *m, double step, struct change *change)
{
  double values[UM_EFFECT_PARAMETERS_MAX];
  memcpy(values, m->at, sizeof values);
  values[m->p] += step;
  return step_to(m->context, m->point, m->candidate, values, m->column, change);
}

/* The first step; where that is refused (an observation would fall below the horizon, a factor pass
 * 1) the same the other way, and both again shorter. */
static enum um_status move_first(const struct mover *m, double *step, struct change *change)
{
  static const double part[] = {1.0, -1.0, 1.0 / SHORTER, -1.0 / SHORTER};
  const struct um_sensitivity_candidate *c = m->candidate;
  enum um_status status = UM_ERR_REFUSED;
  double first = *step;
  for (size_t i = 0; i < sizeof part / sizeof part[0] && status == UM_ERR_REFUSED; i++) {
    double at = m->at[m->p] + part[i] * first;
    if (i > 0 && !(at >= c->minimum[m->p] && at <= c->maximum[m->p])) continue;
    um_core_message_clear(m->context);
    *step = part[i] * first;
    status = move(m, *step, change);
  }
  return status;
}

/* *step in and out; the column is not yet divided by it. */
static enum um_status difference(const struct mover *m, double *step, struct change *change)
{
  UM_TRY(move_first(m, step, change));
  double more = longer(m->candidate, m->p, m->at[m->p], *step, change, m->point->noise);
  if (fabs(more) > fabs(*step)) {
    enum um_status status = move(m, more, change);
    if (status == UM_ERR_REFUSED) { /* too far: what was before stands */
      um_core_message_clear(m->context);
      return move(m, *step, change);
    }
    UM_TRY(status);
    *step = more;
  }
  if (change->rms > FAR && !acts_behind(m->candidate->effect)) {
    *step /= SHORTER;
    UM_TRY(move(m, *step, change));
  }
  return UM_OK;
}

static bool alive(const struct change *change, double noise)
{
  return change->largest >= NOTHING && !(change->fresh && change->largest < LOST * noise);
}

/* An effect that refuses what it is asked is no error of the diagnosis: its words are kept. */
static enum um_status refused(struct um_context *context, struct um_sensitivity_candidate *c,
                              enum um_status status)
{
  if (status != UM_ERR_REFUSED && status != UM_ERR_NUMERIC) return status;
  c->insensitive = true;
  um_core_free(context, c->why);
  c->why = NULL;
  enum um_status kept = um_core_strdup(context, um_core_message(context), &c->why);
  if (kept == UM_OK) um_core_message_clear(context);
  return kept;
}

static void divide(double *column, size_t n, double step)
{
  for (size_t j = 0; j < n; j++) column[j] /= step;
}

/* The change when a switch is turned on. */
static enum um_status make_switch(struct um_context *context,
                                  const struct um_sensitivity_point *point,
                                  struct um_sensitivity_candidate *c)
{
  struct change change;
  c->ncolumn = 1;
  c->step[0] = 1.0;
  UM_TRY(step_to(context, point, c, c->null_value, c->signature, &change));
  c->insensitive = !alive(&change, point->noise);
  return UM_OK;
}

/* Columns of the parameters that change something at `at`; the others are counted out. */
static enum um_status make_columns(struct um_context *context,
                                   const struct um_sensitivity_point *point, const double *at,
                                   struct um_sensitivity_candidate *c)
{
  size_t n = point->forward->observations.count;
  c->ncolumn = 0;
  for (size_t p = 0; p < c->effect->nparameter; p++) {
    struct change change;
    double step = first_step(c, p, at[p]);
    double *column = c->signature + c->ncolumn * n;
    const struct mover mover = {context, point, c, at, p, column};
    UM_TRY(difference(&mover, &step, &change));
    if (!alive(&change, point->noise)) continue;
    divide(column, n, step);
    c->parameter[c->ncolumn] = p;
    c->step[c->ncolumn++] = step;
  }
  return UM_OK;
}

/* Where the columns are taken: null values, shapes at their default. */
static bool put_shapes(struct um_sensitivity_candidate *c)
{
  bool any = false;
  for (size_t p = 0; p < c->effect->nparameter; p++) {
    bool is_free = false;
    for (size_t k = 0; k < c->ncolumn; k++) is_free = is_free || c->parameter[k] == p;
    const struct um_effect_parameter *parameter = &c->effect->parameters[p];
    if (is_free || c->null_value[p] != parameter->null_value ||
        c->null_value[p] == parameter->default_value)
      continue;
    c->null_value[p] = parameter->default_value;
    any = true;
  }
  return any;
}

/* Default values of all parameters, but temperatures where the scan put them. */
static void set_defaults(const struct um_sensitivity_candidate *c, double *at)
{
  for (size_t k = 0; k < c->effect->nparameter; k++)
    at[k] = c->effect->parameters[k].is_temperature ? c->null_value[k]
                                                    : c->effect->parameters[k].default_value;
}

/* The one parameter whose null value makes the effect vanish whatever the others are. Where not
 * even all default values together do something, there is none. */
static enum um_status find_amplitude(struct um_context *context,
                                     const struct um_sensitivity_point *point,
                                     struct um_sensitivity_candidate *c)
{
  size_t n = c->effect->nparameter;
  double at[UM_EFFECT_PARAMETERS_MAX];
  struct change change;
  set_defaults(c, at);
  UM_TRY(step_to(context, point, c, at, c->signature, &change));
  if (!alive(&change, point->noise)) return UM_OK;
  for (size_t p = 0; p < n; p++) {
    set_defaults(c, at);
    at[p] = c->null_value[p];
    if (memcmp(at, c->null_value, n * sizeof *at) == 0) continue; /* tried */
    UM_TRY(step_to(context, point, c, at, c->signature, &change));
    if (!(change.largest < NOTHING)) continue; /* noise of the heat is not nothing */
    double step = first_step(c, p, at[p]);
    const struct mover mover = {context, point, c, at, p, c->signature};
    UM_TRY(difference(&mover, &step, &change));
    if (!alive(&change, point->noise)) continue;
    divide(c->signature, point->forward->observations.count, step);
    memcpy(c->null_value, at, n * sizeof *at);
    c->ncolumn = 1;
    c->parameter[0] = p;
    c->step[0] = step;
    return UM_OK;
  }
  return UM_OK;
}

/* What is not free is unidentified under the null. */
static void put_rest(struct um_sensitivity_candidate *c)
{
  c->nunidentified = 0;
  for (size_t p = 0; p < c->effect->nparameter && !c->insensitive; p++) {
    bool is_free = false;
    for (size_t k = 0; k < c->ncolumn; k++) is_free = is_free || c->parameter[k] == p;
    if (!is_free) c->unidentified[c->nunidentified++] = p;
  }
}

static enum um_status make(struct um_context *context, const struct um_sensitivity_point *point,
                           struct um_sensitivity_candidate *c)
{
  if (c->is_switch) return make_switch(context, point, c);
  UM_TRY(make_columns(context, point, c->null_value, c));
  if (c->effect->nparameter > 1) {
    if (c->ncolumn == 0)
      UM_TRY(find_amplitude(context, point, c));
    else if (c->ncolumn < c->effect->nparameter && put_shapes(c))
      UM_TRY(um_sensitivity_signature_renew(context, point, c));
  }
  c->insensitive = c->ncolumn == 0;
  put_rest(c);
  return UM_OK;
}

enum um_status um_sensitivity_signature_create(struct um_context *context,
                                               const struct um_sensitivity_point *point,
                                               struct um_sensitivity_candidate *c)
{
  size_t columns = c->is_switch ? 1 : c->effect->nparameter;
  UM_TRY(um_core_allocate(context, columns * point->forward->observations.count,
                          sizeof *c->signature, &c->signature));
  enum um_status status = c->insensitive ? UM_OK : make(context, point, c);
  if (status != UM_OK) status = refused(context, c, status);
  if (c->insensitive) {
    c->ncolumn = columns;
    memset(c->signature, 0, columns * point->forward->observations.count * sizeof *c->signature);
    for (size_t k = 0; k < columns; k++) c->parameter[k] = k;
  }
  return status;
}

enum um_status um_sensitivity_signature_renew(struct um_context *context,
                                              const struct um_sensitivity_point *point,
                                              struct um_sensitivity_candidate *c)
{
  size_t n = point->forward->observations.count;
  if (c->is_switch) return make_switch(context, point, c);
  for (size_t k = 0; k < c->ncolumn; k++) {
    struct change change;
    double *column = c->signature + k * n;
    const struct mover mover = {context, point, c, c->null_value, c->parameter[k], column};
    UM_TRY(difference(&mover, &c->step[k], &change));
    divide(column, n, c->step[k]);
  }
  return UM_OK;
}
