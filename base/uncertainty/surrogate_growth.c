/* Points of a growing surrogate and what they say. */
#include "base/uncertainty/surrogate_growth_impl.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/uncertainty/design.h"

double um_uncertainty_growth_asked(const struct um_uncertainty_growth *g, size_t group,
                                   double value)
{
  const struct um_uncertainty_group *of = &g->request->group[group];
  return of->absolute + of->relative * fmax(fabs(value), of->floor * g->largest[group]);
}

static enum um_status refuse_point(struct um_context *context, size_t d, const double *place)
{
  char text[200] = "";
  size_t used = 0;
  for (size_t k = 0; k < d && used < sizeof text; k++) {
    int more = snprintf(text + used, sizeof text - used, "%s%.4g", k ? ", " : "", place[k]);
    used += more > 0 ? (size_t)more : 0;
  }
  return um_core_fail(context, UM_ERR_REFUSED,
                      "a surrogate wants every point, and the one at (%s) of the axes' lengths "
                      "failed; narrow the ranges or compute each point exactly",
                      text);
}

/* The function at n places, all of which must succeed. A value that is NaN at the first of all
 * places is one that is nowhere: 0 here, NaN in what the surrogate says. */
static enum um_status evaluate(struct um_context *context, struct um_uncertainty_growth *g,
                               const double *place, size_t n, double *value)
{
  const struct um_uncertainty_surrogate_request *r = g->request;
  bool *nowhere = g->s->nowhere;
  UM_TRY(um_core_stop_check(context, "making a surrogate"));
  UM_TRY(r->evaluate(context, r->user, place, n, value));
  bool all = true;
  for (size_t k = 0; k < r->nvalue && g->evaluations == 0; k++) {
    nowhere[k] = isnan(value[k]);
    all = all && nowhere[k];
  }
  if (g->evaluations == 0 && all) return refuse_point(context, r->d, place);
  g->evaluations += n;
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < r->nvalue; k++) {
      double *v = &value[i * r->nvalue + k];
      if (nowhere[k] ? !isnan(*v) : !isfinite(*v))
        return refuse_point(context, r->d, place + i * r->d);
      if (nowhere[k]) *v = 0.0;
    }
  return UM_OK;
}

/* Largest |difference| [nvalue] over what is asked; of: the values themselves. */
static double size_of(const struct um_uncertainty_growth *g, const double *difference,
                      const double *of)
{
  double size = 0.0;
  for (size_t i = 0; i < g->s->ngroup; i++) {
    const struct um_uncertainty_group *group = &g->request->group[i];
    for (size_t k = group->first; k < group->first + group->count; k++) {
      if (difference[k] == 0.0) continue;
      size = fmax(size, fabs(difference[k]) / um_uncertainty_growth_asked(g, i, of[k]));
    }
  }
  return size;
}

double um_uncertainty_growth_judge(struct um_uncertainty_growth *g)
{
  struct um_uncertainty_surrogate *s = g->s;
  double worst = 0.0;
  for (size_t i = 0; i < s->ngroup; i++) {
    const struct um_uncertainty_group *group = &g->request->group[i];
    struct um_uncertainty_surrogate_error e = {0};
    for (size_t h = 0; h < s->nheld; h++)
      for (size_t k = 0; k < group->count; k++) {
        size_t at = h * s->nvalue + group->first + k;
        double difference = fabs(g->left[at]);
        if (difference == 0.0) continue;
        double share = difference / um_uncertainty_growth_asked(g, i, g->held_value[at]);
        e.absolute = fmax(e.absolute, difference);
        e.relative = fmax(e.relative,
                          difference / fmax(fabs(g->held_value[at]), group->floor * g->largest[i]));
        if (share <= e.share) continue;
        e.share = share;
        e.value = k;
        e.point = h;
      }
    s->error[i] = e;
    worst = fmax(worst, e.share);
  }
  return worst;
}

/* Room for so many terms more. */
static enum um_status reserve(struct um_context *context, struct um_uncertainty_growth *g,
                              size_t more)
{
  struct um_uncertainty_surrogate *s = g->s;
  size_t want = s->nterm + more;
  if (want <= s->room) return UM_OK;
  want += want / 2;
  UM_TRY(um_core_reallocate(context, want, sizeof *s->term, &s->term));
  UM_TRY(um_core_reallocate(context, want, sizeof *g->basis, &g->basis));
  s->room = want;
  return UM_OK;
}

/* What the terms from `from` on say, taken from what is left of held-out points first .. last - 1.
 */
static void take(struct um_uncertainty_growth *g, size_t first, size_t last, size_t from)
{
  const struct um_uncertainty_surrogate *s = g->s;
  for (size_t h = first; h < last; h++) {
    um_uncertainty_surrogate_basis(s, g->held + h * s->d, from, s->nterm, g->basis);
    for (size_t t = from; t < s->nterm; t++)
      for (size_t k = 0; k < s->nvalue; k++)
        g->left[h * s->nvalue + k] -= g->basis[t - from] * s->term[t].surplus[k];
  }
}

/* Terms of these degrees [n][d] with the function's values [n][nvalue] at their points:
 * s_nu = f(x_nu) - sum of the terms before; those made together do not see each other. */
static enum um_status add_values(struct um_context *context, struct um_uncertainty_growth *g,
                                 const unsigned char *degree, size_t n, const double *place,
                                 const double *value)
{
  struct um_uncertainty_surrogate *s = g->s;
  size_t d = s->d, before = s->nterm;
  UM_TRY(reserve(context, g, n));
  for (size_t i = 0; i < n; i++) {
    struct um_uncertainty_term *term = &s->term[before + i];
    const double *f = value + i * s->nvalue;
    *term = (struct um_uncertainty_term){0};
    memcpy(term->degree, degree + i * d, d);
    UM_TRY(um_core_allocate(context, s->nvalue, sizeof *term->surplus, &term->surplus));
    s->nterm++;
    um_uncertainty_surrogate_basis(s, place + i * d, 0, before, g->basis);
    memcpy(term->surplus, f, s->nvalue * sizeof *f);
    for (size_t t = 0; t < before; t++)
      for (size_t k = 0; k < s->nvalue && g->basis[t] != 0.0; k++)
        term->surplus[k] -= g->basis[t] * s->term[t].surplus[k];
    term->size = size_of(g, term->surplus, f);
  }
  for (size_t i = 0; i < n * d; i++)
    if (degree[i] >= s->levels[i % d]) s->levels[i % d] = (size_t)degree[i] + 1;
  take(g, 0, s->nheld, before);
  return UM_OK;
}

enum um_status um_uncertainty_growth_add(struct um_context *context,
                                         struct um_uncertainty_growth *g,
                                         const unsigned char *degree, size_t n)
{
  enum um_status status;
  const struct um_uncertainty_surrogate *s = g->s;
  double *place = NULL, *value = NULL;
  UM_CHECK(um_core_allocate(context, n, s->d * sizeof *place, &place));
  UM_CHECK(um_core_allocate(context, n, s->nvalue * sizeof *value, &value));
  for (size_t i = 0; i < n * s->d; i++) place[i] = s->axis.x[degree[i]];
  UM_CHECK(evaluate(context, g, place, n, value));
  UM_CHECK(add_values(context, g, degree, n, place, value));
done:
  UM_FREE(context, place, value);
  return status;
}

/* Places of the first n held-out points: Halton's sequence, whose numbers are on no grid, gathered
 * toward the ends of the axes, where polynomials err most. */
static enum um_status first_places(struct um_context *context, struct um_uncertainty_growth *g,
                                   size_t n, double *place)
{
  double *u = NULL;
  UM_TRY(um_uncertainty_halton(context, g->s->d, 2, n, &u));
  for (size_t i = 0; i < n * g->s->d; i++) place[i] = 0.5 - 0.5 * cos(UM_PI * u[i]);
  um_core_free(context, u);
  return UM_OK;
}

static enum um_status reserve_held(struct um_context *context, struct um_uncertainty_growth *g,
                                   size_t n)
{
  size_t bytes = sizeof(double), all = g->s->nheld + n;
  UM_TRY(um_core_reallocate(context, all, g->s->d * bytes, &g->held));
  UM_TRY(um_core_reallocate(context, all, g->s->nvalue * bytes, &g->held_value));
  return um_core_reallocate(context, all, g->s->nvalue * bytes, &g->left);
}

enum um_status um_uncertainty_growth_hold(struct um_context *context,
                                          struct um_uncertainty_growth *g, const double *place,
                                          size_t n)
{
  struct um_uncertainty_surrogate *s = g->s;
  size_t before = s->nheld, count = n * s->nvalue;
  UM_TRY(reserve_held(context, g, n));
  double *value = g->held_value + before * s->nvalue;
  memcpy(g->held + before * s->d, place, n * s->d * sizeof *place);
  UM_TRY(evaluate(context, g, place, n, value));
  memcpy(g->left + before * s->nvalue, value, count * sizeof *value);
  s->nheld += n;
  take(g, before, s->nheld, 0);
  return UM_OK;
}

enum um_status um_uncertainty_growth_begin(struct um_context *context,
                                           struct um_uncertainty_growth *g, size_t nheld)
{
  enum um_status status;
  struct um_uncertainty_surrogate *s = g->s;
  const unsigned char middle[UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX] = {0};
  double *place = NULL, *value = NULL;
  UM_CHECK(um_core_allocate(context, 1 + nheld, s->d * sizeof *place, &place));
  UM_CHECK(um_core_allocate(context, 1 + nheld, s->nvalue * sizeof *value, &value));
  UM_CHECK(reserve_held(context, g, nheld));
  for (size_t k = 0; k < s->d; k++) place[k] = s->axis.x[0];
  UM_CHECK(first_places(context, g, nheld, place + s->d));
  UM_CHECK(evaluate(context, g, place, 1 + nheld, value)); /* in one go, for many processes */
  memcpy(g->held, place + s->d, nheld * s->d * sizeof *place);
  memcpy(g->held_value, value + s->nvalue, nheld * s->nvalue * sizeof *value);
  memcpy(g->left, g->held_value, nheld * s->nvalue * sizeof *value);
  s->nheld = nheld;
  for (size_t i = 0; i < s->ngroup; i++) {
    const struct um_uncertainty_group *group = &g->request->group[i];
    for (size_t k = 0; k < group->count; k++)
      g->largest[i] = fmax(g->largest[i], fabs(value[group->first + k]));
  }
  UM_CHECK(add_values(context, g, middle, 1, place, value));
done:
  UM_FREE(context, place, value);
  return status;
}
