/* Growth of a surrogate: which terms come next, and when it is good enough. */
#include "base/uncertainty/surrogate.h"

#include <math.h>
#include <stdio.h>

#include "base/uncertainty/surrogate_growth_impl.h"

#define FIRST_LOOK 64 /* evaluations after which the rate of convergence is looked at */

static enum um_status check(struct um_context *context,
                            const struct um_uncertainty_surrogate_request *r)
{
  if (r->d == 0 || r->d > UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX)
    return um_core_fail(context, UM_ERR_INPUT,
                        "a surrogate of %zu parameters, at least 1 and at most %d", r->d,
                        UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX);
  size_t held = r->held_out ? r->held_out : UM_UNCERTAINTY_HELD_OUT;
  held += UM_UNCERTAINTY_STATING * held;
  if (r->evaluations_max > 0 && r->evaluations_max <= held)
    return um_core_fail(context, UM_ERR_INPUT,
                        "a surrogate of at most %zu points, of which %zu are held out",
                        r->evaluations_max, held);
  for (size_t i = 0; i < r->ngroup; i++) {
    const struct um_uncertainty_group *g = &r->group[i];
    if (g->first > r->nvalue || g->count > r->nvalue - g->first)
      return um_core_fail(context, UM_ERR_INPUT, "%s: values %zu to %zu of %zu", g->name, g->first,
                          g->first + g->count, r->nvalue);
    if (!(g->absolute >= 0.0 && g->relative >= 0.0 && g->floor >= 0.0 &&
          g->absolute + g->relative > 0.0))
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s: an asked error of %g and, relative, %g; one must be above 0",
                          g->name, g->absolute, g->relative);
  }
  return UM_OK;
}

static bool all_small(const struct um_uncertainty_surrogate *s)
{
  for (size_t t = 0; t < s->nterm; t++)
    if (!s->term[t].passed && !(s->term[t].size <= 1.0)) return false;
  return true;
}

/* It is further off than asked, and will not be better. */
static enum um_status fall_short(struct um_context *context, const struct um_uncertainty_growth *g,
                                 const char *why)
{
  struct um_uncertainty_surrogate *s = g->s;
  size_t worst = 0;
  for (size_t i = 1; i < s->ngroup; i++)
    if (s->error[i].share > s->error[worst].share) worst = i;
  const struct um_uncertainty_surrogate_error *e = &s->error[worst];
  return um_core_asprintf(
      context, &s->falls_short,
      "the response is not smooth enough for a surrogate: %s, value %zu: after "
      "%zu points off by %.3g at a held-out point, %.3g times what is asked; %s",
      g->request->group[worst].name, e->value, g->evaluations, e->absolute, e->share, why);
}

/* Whether it will not do at the rate at which the last doubling of points helped: the error falls
 * like a power of their number, or faster where the function is smooth. */
static enum um_status look_ahead(struct um_context *context, struct um_uncertainty_growth *g,
                                 double share)
{
  char why[120];
  if (g->evaluations < 2 * g->looked_at && g->looked_at > 0) return UM_OK;
  if (g->evaluations < FIRST_LOOK) return UM_OK;
  double rate = g->looked_at == 0
                    ? INFINITY
                    : log(g->before / share) / log((double)g->evaluations / (double)g->looked_at);
  double wanted =
      rate > 0.0 ? (double)g->evaluations * pow(share / UM_UNCERTAINTY_HELD_OUT_SHARE, 1.0 / rate)
                 : INFINITY;
  g->looked_at = g->evaluations;
  g->before = share;
  /* ten times as many as are allowed: a function may fall into its asymptotic rate late */
  if (wanted <= 10.0 * (double)g->evaluations_max || share <= UM_UNCERTAINTY_HELD_OUT_SHARE)
    return UM_OK;
  if (wanted < 1e9)
    snprintf(why, sizeof why, "at this rate it takes %.0f points, and %zu are allowed", wanted,
             g->evaluations_max);
  else
    snprintf(why, sizeof why, "more points do not help");
  return fall_short(context, g, why);
}

/* Points that are left for growing. */
static size_t room_of(const struct um_uncertainty_growth *g, size_t batch)
{
  double kept =
      fmax((double)batch, floor(UM_UNCERTAINTY_STATED_RESERVE * (double)g->evaluations_max));
  size_t used = g->evaluations + (size_t)kept;
  return used < g->evaluations_max ? g->evaluations_max - used : 0;
}

/* Choose until something is wanted; *n 0: it falls short. */
static enum um_status next(struct um_context *context, struct um_uncertainty_growth *g, size_t room,
                           unsigned char **list, size_t *n)
{
  bool left = true;
  for (*n = 0; *n == 0 && left;) {
    left = false;
    for (size_t t = 0; t < g->s->nterm; t++) left = left || !g->s->term[t].passed;
    if (left) UM_TRY(um_uncertainty_growth_choose(context, g, list, n));
  }
  if (*n == 0) return fall_short(context, g, "the highest degrees are in use");
  if (*n > room) *n = room;
  return *n > 0 ? UM_OK : fall_short(context, g, "no more points are allowed");
}

/* The last word of one that falls short, by all points that are left, or all places at which it
 * will be asked where these are fewer; they may find it good enough after all. */
static enum um_status end_short(struct um_context *context, struct um_uncertainty_growth *g,
                                size_t batch)
{
  double share;
  size_t left = g->evaluations_max - g->evaluations;
  size_t given = g->request->nasked > g->stated_by ? g->request->nasked - g->stated_by : 0;
  if (given < batch) given = batch;
  if (g->request->nasked > 0 && left > given) left = given;
  UM_TRY(um_uncertainty_growth_state(context, g, left, &share));
  if (share <= 1.0) {
    um_core_free(context, g->s->falls_short);
    g->s->falls_short = NULL;
  }
  return UM_OK;
}

static enum um_status grow(struct um_context *context, struct um_uncertainty_growth *g)
{
  enum um_status status;
  unsigned char *list = NULL;
  size_t held = g->request->held_out ? g->request->held_out : UM_UNCERTAINTY_HELD_OUT;
  size_t batch = UM_UNCERTAINTY_STATING * held;
  UM_CHECK(um_uncertainty_growth_begin(context, g, held));
  for (;;) {
    double share = um_uncertainty_growth_judge(g);
    size_t n, room = room_of(g, batch);
    if (share <= UM_UNCERTAINTY_HELD_OUT_SHARE && all_small(g->s)) {
      /* these points had a say in when to end; others have not */
      if (room < batch) {
        UM_CHECK(fall_short(context, g, "no more points are allowed"));
        break;
      }
      UM_CHECK(um_uncertainty_growth_state(context, g, batch, &share));
      if (share <= 1.0) break;
      share = um_uncertainty_growth_judge(g);
      room -= batch;
    }
    UM_CHECK(look_ahead(context, g, share));
    if (g->s->falls_short != NULL) break;
    UM_CHECK(next(context, g, room, &list, &n));
    if (n == 0) break;
    UM_CHECK(um_uncertainty_growth_add(context, g, list, n));
  }
  if (g->s->falls_short != NULL) UM_CHECK(end_short(context, g, batch));
done:
  um_core_free(context, list);
  return status;
}

enum um_status
um_uncertainty_surrogate_create(struct um_context *context,
                                const struct um_uncertainty_surrogate_request *request,
                                struct um_uncertainty_surrogate **out)
{
  enum um_status status;
  struct um_uncertainty_growth g = {.request = request};
  *out = NULL;
  UM_TRY(check(context, request));
  UM_TRY(um_core_allocate(context, 1, sizeof *g.s, &g.s));
  g.s->d = request->d;
  g.s->nvalue = request->nvalue;
  g.s->ngroup = request->ngroup;
  g.evaluations_max =
      request->evaluations_max ? request->evaluations_max : UM_UNCERTAINTY_EVALUATIONS_MAX;
  for (size_t k = 0; k < request->d; k++) g.s->levels[k] = 1;
  um_uncertainty_axis_make(&g.s->axis);
  UM_CHECK(um_core_allocate(context, g.s->nvalue, sizeof *g.s->nowhere, &g.s->nowhere));
  UM_CHECK(um_core_allocate(context, g.s->ngroup, sizeof *g.s->error, &g.s->error));
  UM_CHECK(um_core_allocate(context, g.s->ngroup, sizeof *g.largest, &g.largest));
  UM_CHECK(grow(context, &g));
  g.s->evaluations = g.evaluations;
  *out = g.s;
  g.s = NULL;
done:
  UM_FREE(context, g.largest, g.held, g.held_value, g.left, g.basis);
  um_uncertainty_surrogate_destroy(context, &g.s);
  return status;
}

void um_uncertainty_surrogate_destroy(struct um_context *context,
                                      struct um_uncertainty_surrogate **surrogate)
{
  struct um_uncertainty_surrogate *s = *surrogate;
  if (s == NULL) return;
  for (size_t t = 0; t < s->nterm; t++) um_core_free(context, s->term[t].surplus);
  UM_FREE(context, s->term, s->nowhere, s->error, s->falls_short, s);
  *surrogate = NULL;
}

size_t um_uncertainty_surrogate_evaluations(const struct um_uncertainty_surrogate *surrogate)
{
  return surrogate->evaluations;
}
size_t um_uncertainty_surrogate_terms(const struct um_uncertainty_surrogate *surrogate)
{
  return surrogate->nterm;
}
size_t um_uncertainty_surrogate_values(const struct um_uncertainty_surrogate *surrogate)
{
  return surrogate->nvalue;
}
size_t um_uncertainty_surrogate_held_out(const struct um_uncertainty_surrogate *surrogate)
{
  return surrogate->nheld;
}
size_t um_uncertainty_surrogate_stating(const struct um_uncertainty_surrogate *surrogate)
{
  return surrogate->nstating;
}
const char *um_uncertainty_surrogate_short(const struct um_uncertainty_surrogate *surrogate)
{
  return surrogate->falls_short;
}
size_t um_uncertainty_surrogate_degree(const struct um_uncertainty_surrogate *surrogate,
                                       size_t axis)
{
  return surrogate->levels[axis] - 1;
}
const struct um_uncertainty_surrogate_error *
um_uncertainty_surrogate_errors(const struct um_uncertainty_surrogate *surrogate)
{
  return surrogate->error;
}
