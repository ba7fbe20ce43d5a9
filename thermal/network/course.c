/* Courses of heat in time. */
#include "thermal/network/course.h"

#include <math.h>
#include <stdbool.h>

#define ROWS_OF_A_DECAY 16 /* to a time constant: a chord leaves the curve by 1 / (8 * 16^2) */
#define DECAYED         12 /* time constants; 6e-6 is left */

const char *um_thermal_course_name(enum um_thermal_course_shape shape)
{
  static const char *const name[] = {"step", "pulse", "decay", "periodic"};
  return name[shape];
}

size_t um_thermal_course_parameters(enum um_thermal_course_shape shape)
{
  static const size_t count[] = {3, 4, 4, 5};
  return count[shape];
}

double um_thermal_course_energy(const struct um_thermal_course *course, double t)
{
  double since = t - course->start, turns;
  if (!(since > 0.0)) return 0.0;
  switch (course->shape) {
  case UM_HEAT_PULSE:
    return fmin(since, course->last);
  case UM_HEAT_DECAY:
    return -course->last * expm1(-since / course->last);
  case UM_HEAT_PERIODIC:
    turns = floor(since / course->period);
    return turns * course->last + fmin(since - turns * course->period, course->last);
  case UM_HEAT_STEP:
  case UM_HEAT_SHAPES:
    break;
  }
  return since;
}

struct rows {
  size_t n;
  double *t, *power; /* NULL: counted only */
};

static void put(struct rows *rows, double t, double power)
{
  if (rows->t != NULL) {
    rows->t[rows->n] = t;
    rows->power[rows->n] = power;
  }
  rows->n++;
}

static void put_on(struct rows *rows, double from, double to)
{
  put(rows, from, 0.0);
  put(rows, from, 1.0);
  put(rows, to, 1.0);
  put(rows, to, 0.0);
}

static void put_decay(struct rows *rows, const struct um_thermal_course *course, double end)
{
  double step = course->last / ROWS_OF_A_DECAY;
  put(rows, course->start, 0.0);
  for (size_t k = 0; k <= DECAYED * ROWS_OF_A_DECAY; k++) {
    double since = (double)k * step;
    put(rows, course->start + since, exp(-since / course->last));
    if (course->start + since > end) break;
  }
}

size_t um_thermal_course_rows(const struct um_thermal_course *course, double end, double *t,
                              double *power)
{
  struct rows rows = {0, t, power};
  double from = course->start;
  switch (course->shape) {
  case UM_HEAT_PULSE:
    put_on(&rows, from, from + course->last);
    break;
  case UM_HEAT_DECAY:
    put_decay(&rows, course, end);
    break;
  case UM_HEAT_PERIODIC:
    for (size_t k = 0; k == 0 || from + (double)k * course->period < end; k++)
      put_on(&rows, from + (double)k * course->period,
             from + (double)k * course->period + course->last);
    break;
  case UM_HEAT_STEP:
  case UM_HEAT_SHAPES:
    put_on(&rows, from, fmax(from, end) + 1.0);
    break;
  }
  return rows.n;
}
