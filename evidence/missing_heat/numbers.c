/* A course as numbers that are sampled, each with a flat prior: the start; the length of a pulse,
 * the logarithm of a decay's constant, the share of a period that is on; the logarithm of the
 * period. */
#include <math.h>

#include "evidence/missing_heat/fit_impl.h"
#include "evidence/missing_heat/policy.h"

size_t um_missing_heat_numbers(enum um_thermal_course_shape shape)
{
  return um_thermal_course_parameters(shape) - 2; /* less place and power */
}

struct um_thermal_course um_missing_heat_course_of(enum um_thermal_course_shape shape,
                                                   const double *x)
{
  struct um_thermal_course c = {shape, x[0], INFINITY, NAN};
  if (shape == UM_HEAT_PULSE) c.last = x[1];
  if (shape == UM_HEAT_DECAY) c.last = exp(x[1]);
  if (shape == UM_HEAT_PERIODIC) {
    c.period = exp(x[2]);
    c.last = x[1] * c.period;
  }
  return c;
}

void um_missing_heat_numbers_of(const struct um_thermal_course *c, double *x)
{
  x[0] = c->start;
  if (c->shape == UM_HEAT_PULSE) x[1] = c->last;
  if (c->shape == UM_HEAT_DECAY) x[1] = log(c->last);
  if (c->shape == UM_HEAT_PERIODIC) {
    x[1] = c->last / c->period;
    x[2] = log(c->period);
  }
}

bool um_missing_heat_course_allowed(const struct um_missing_heat_bins *bins,
                                    const struct um_thermal_course *c)
{
  double first = bins->edge[0], end = bins->edge[bins->nbin], span = end - first;
  double least = span / UM_MISSING_HEAT_BINS_MAX;
  if (!(c->start >= first && c->start < end)) return false;
  switch (c->shape) {
  case UM_HEAT_PULSE:
    return c->last > 0.0 && c->start + c->last <= end;
  case UM_HEAT_DECAY:
    return c->last >= least * UM_MISSING_HEAT_DECAY_LEAST &&
           c->last <= span * UM_MISSING_HEAT_DECAY_MOST;
  case UM_HEAT_PERIODIC: /* two whole times or more: one and a bit is a pulse that pays twice */
    return c->period >= 2.0 * least && c->start + c->period + c->last <= end &&
           c->last >= UM_MISSING_HEAT_ON_LEAST * c->period &&
           c->last <= (1.0 - UM_MISSING_HEAT_ON_LEAST) * c->period;
  case UM_HEAT_STEP:
  case UM_HEAT_SHAPES:
    break;
  }
  return true;
}
