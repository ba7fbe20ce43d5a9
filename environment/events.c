/* Eclipse events: the times at which the centre of the Sun stands at +a, 0 and -a above the limb,
 * a = angular radius of the Sun (0 for a point or a cylinder, whose three events coincide).
 *
 * The limb angle is sampled at the scan step; each local minimum and maximum of it is found by
 * golden sections (Press et al. 2007, 10.2), so that between neighbouring knots it is monotonic and
 * a grazing eclipse shorter than the step is not missed; each change of side is bisected. */
#include <math.h>
#include <stdlib.h>

#include "base/core/constants.h"
#include "base/core/golden.h"
#include "environment/environment.h"

#define TIME_TOLERANCE 1e-6 /* [s] */
#define MAX_STEPS      1e8

struct knot {
  double t;     /* [s] */
  double angle; /* of the centre of the Sun above the limb [rad] */
  double disc;  /* angular radius of the Sun [rad] */
};

struct search {
  struct um_context *context;
  const struct um_environment *environment;
  um_environment_geometry geometry;
  void *self;
  struct um_environment_event *events;
  size_t count, capacity;
};

static enum um_status knot_at(struct search *search, double t, struct knot *out)
{
  struct um_vec3 r, sun, pole;
  double distance;
  UM_TRY(search->geometry(search->self, t, &r, &sun, &distance, &pole));
  const struct um_environment *environment = search->environment;
  out->t = t;
  out->angle = um_environment_limb_angle(environment, r, sun, distance, pole);
  out->disc = 0.0;
  if (environment->shadow != UM_SHADOW_CYLINDER && environment->disc != UM_DISC_POINT)
    out->disc = asin(fmin(UM_SOLAR_RADIUS / distance, 1.0));
  if (!isfinite(out->angle) || !isfinite(out->disc))
    return um_core_fail(search->context, UM_ERR_NUMERIC,
                        "eclipse search: position or Sun is not finite at t_tai = %.3f s", t);
  return UM_OK;
}

/* The Sun is above level * a: +1 penumbra, 0 centre, -1 umbra. */
static int above(const struct knot *knot, int level) { return knot->angle > level * knot->disc; }

static enum um_status event_add(struct search *search, double t,
                                enum um_environment_event_kind kind)
{
  if (search->count == search->capacity) {
    size_t capacity = search->capacity ? 2 * search->capacity : 32;
    UM_TRY(um_core_reallocate(search->context, capacity, sizeof *search->events, &search->events));
    search->capacity = capacity;
  }
  search->events[search->count++] = (struct um_environment_event){t, kind};
  return UM_OK;
}

/* The changes of side between two knots, by bisection. */
static enum um_status crossings_find(struct search *search, struct knot left, struct knot right)
{
  static const enum um_environment_event_kind entry[] = {UM_EVENT_UMBRA_ENTRY, UM_EVENT_HALF_ENTRY,
                                                         UM_EVENT_PENUMBRA_ENTRY};
  static const enum um_environment_event_kind leave[] = {UM_EVENT_UMBRA_EXIT, UM_EVENT_HALF_EXIT,
                                                         UM_EVENT_PENUMBRA_EXIT};
  for (int level = -1; level <= 1; level++) {
    int side = above(&left, level);
    if (side == above(&right, level)) continue;
    struct knot low = left, high = right, middle;
    while (high.t - low.t > TIME_TOLERANCE) {
      double t = low.t + 0.5 * (high.t - low.t);
      if (!(t > low.t && t < high.t)) break; /* the resolution of the time itself */
      UM_TRY(knot_at(search, t, &middle));
      if (above(&middle, level) == side)
        low = middle;
      else
        high = middle;
    }
    UM_TRY(event_add(search, low.t + 0.5 * (high.t - low.t),
                     side ? entry[level + 1] : leave[level + 1]));
  }
  return UM_OK;
}

/* The lowest (sign +1) or highest (-1) limb angle in [from, to], by golden sections. */
static enum um_status extremum_find(struct search *search, double from, double to, int sign,
                                    struct knot *out)
{
  struct um_core_golden g = um_core_golden(from, to);
  struct knot knot[2];
  for (int k = 0; k < 2; k++) UM_TRY(knot_at(search, g.x[k], &knot[k]));
  while (g.to - g.from > 1e-3) { /* an angle of 1e-13 rad at the extremum from a low orbit */
    int k = um_core_golden_narrow(&g, sign * knot[0].angle < sign * knot[1].angle);
    knot[1 - k] = knot[k];
    UM_TRY(knot_at(search, g.x[k], &knot[k]));
  }
  *out = sign * knot[0].angle < sign * knot[1].angle ? knot[0] : knot[1];
  return UM_OK;
}

/* A knot and the sign of the rate of its limb angle. */
static enum um_status knot_with_rate(struct search *search, double t, double beside,
                                     struct knot *out, double *rate)
{
  struct knot other;
  UM_TRY(knot_at(search, t, out));
  UM_TRY(knot_at(search, beside, &other));
  *rate = (other.angle - out->angle) / (beside - t);
  return UM_OK;
}

static enum um_status scan(struct search *search, double from, double to, double step)
{
  size_t steps = (size_t)ceil((to - from) / step);
  double width = (to - from) / (double)steps, nudge = fmin(0.1, 0.25 * width);
  struct knot left, right, middle;
  double left_rate, right_rate;
  UM_TRY(knot_with_rate(search, from, from + nudge, &left, &left_rate));
  for (size_t i = 1; i <= steps; i++) {
    double t = i < steps ? from + width * (double)i : to;
    UM_TRY(um_core_stop_check(search->context, "eclipses were looked for"));
    UM_TRY(knot_with_rate(search, t, t - nudge, &right, &right_rate));
    if (left_rate * right_rate < 0.0) {
      UM_TRY(extremum_find(search, left.t, right.t, left_rate < 0.0 ? 1 : -1, &middle));
      UM_TRY(crossings_find(search, left, middle));
      UM_TRY(crossings_find(search, middle, right));
    } else {
      UM_TRY(crossings_find(search, left, right));
    }
    left = right;
    left_rate = right_rate;
  }
  return UM_OK;
}

static int event_compare(const void *a, const void *b)
{
  const struct um_environment_event *x = a, *y = b;
  if (x->t_tai != y->t_tai) return x->t_tai < y->t_tai ? -1 : 1;
  return (x->kind > y->kind) - (x->kind < y->kind);
}

enum um_status um_environment_events_find(struct um_context *context,
                                          const struct um_environment *environment,
                                          um_environment_geometry geometry, void *self, double from,
                                          double to, double step, struct um_environment_event **out,
                                          size_t *count)
{
  *out = NULL;
  *count = 0;
  if (!(isfinite(from) && isfinite(to) && from <= to))
    return um_core_fail(context, UM_ERR_INPUT,
                        "eclipse search: interval %.3f to %.3f s, the end must not be before the "
                        "start",
                        from, to);
  if (!(step > 0.0 && (to - from) / step <= MAX_STEPS))
    return um_core_fail(context, UM_ERR_INPUT,
                        "eclipse search: step %g s, must be above 0 and at least the interval / %g",
                        step, MAX_STEPS);
  struct search search = {context, environment, geometry, self, NULL, 0, 0};
  enum um_status status = um_core_allocate(context, 1, sizeof *search.events, &search.events);
  if (status == UM_OK) search.capacity = 1;
  if (status == UM_OK && from < to && environment->shadow != UM_SHADOW_NONE)
    status = scan(&search, from, to, step);
  if (status != UM_OK) {
    um_core_free(context, search.events);
    return status;
  }
  qsort(search.events, search.count, sizeof *search.events, event_compare);
  *out = search.events;
  *count = search.count;
  return UM_OK;
}
