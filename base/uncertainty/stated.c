/* Statements from residuals, and those of a growing surrogate. */
#include "base/uncertainty/stated.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/uncertainty/design.h"
#include "base/uncertainty/surrogate_growth_impl.h"

#define EVEN      0.1  /* of the mean square of errors, spread evenly */
#define ELSEWHERE 1000 /* places over which the spread of errors is looked at */

double um_uncertainty_stated_factor(size_t n, double miss)
{
  return gsl_cdf_tdist_Qinv(0.5 * miss, (double)n);
}

double um_uncertainty_rms_factor(size_t n, double miss)
{
  return sqrt((double)n / gsl_cdf_chisq_Pinv(miss, (double)n));
}

/* --- how the error is spread over the places ------------------------------------------------- */

/* Terms that would come next, and how large they may be. */
struct margin {
  size_t n;
  unsigned char *degree; /* [n][d] */
  double *size;          /* [n] of the group at hand, of what is asked */
};

static size_t find(const struct um_uncertainty_surrogate *s, const unsigned char *degree)
{
  for (size_t t = 0; t < s->nterm; t++)
    if (memcmp(s->term[t].degree, degree, s->d) == 0) return t;
  return SIZE_MAX;
}

/* Whether all terms of one degree less are there, and this one is not. */
static bool borders(const struct um_uncertainty_surrogate *s, unsigned char *degree)
{
  bool all = find(s, degree) == SIZE_MAX;
  for (size_t k = 0; k < s->d && all; k++) {
    if (degree[k] == 0) continue;
    degree[k]--;
    all = find(s, degree) != SIZE_MAX;
    degree[k]++;
  }
  return all;
}

/* Largest surplus of a term over a group, of what is asked of values at the middle. */
static double size_of(const struct um_uncertainty_growth *g, size_t group, size_t t)
{
  const struct um_uncertainty_surrogate *s = g->s;
  const struct um_uncertainty_group *of = &g->request->group[group];
  double size = 0.0;
  for (size_t k = of->first; k < of->first + of->count; k++) {
    double surplus = fabs(s->term[t].surplus[k]);
    if (surplus > 0.0)
      size = fmax(size, surplus / um_uncertainty_growth_asked(g, group, s->term[0].surplus[k]));
  }
  return size;
}

static enum um_status find_margin(struct um_context *context, const struct um_uncertainty_growth *g,
                                  struct margin *m)
{
  const struct um_uncertainty_surrogate *s = g->s;
  size_t d = s->d;
  UM_TRY(um_core_allocate(context, s->nterm * d, d * sizeof *m->degree, &m->degree));
  UM_TRY(um_core_allocate(context, s->nterm * d, sizeof *m->size, &m->size));
  for (size_t t = 0; t < s->nterm; t++)
    for (size_t k = 0; k < d; k++) {
      unsigned char *next = m->degree + m->n * d;
      memcpy(next, s->term[t].degree, d);
      bool listed = ++next[k] >= UM_UNCERTAINTY_LEVELS || !borders(s, next);
      for (size_t i = 0; i < m->n; i++) listed = listed || memcmp(m->degree + i * d, next, d) == 0;
      m->n += !listed;
    }
  return UM_OK;
}

/* Each is as large as the largest of those below it. */
static void size_margin(const struct um_uncertainty_growth *g, size_t group, struct margin *m)
{
  const struct um_uncertainty_surrogate *s = g->s;
  for (size_t i = 0; i < m->n; i++) {
    unsigned char *degree = m->degree + i * s->d;
    m->size[i] = 0.0;
    for (size_t k = 0; k < s->d; k++) {
      if (degree[k] == 0) continue;
      degree[k]--;
      m->size[i] = fmax(m->size[i], size_of(g, group, find(s, degree)));
      degree[k]++;
    }
  }
}

/* out [n]: sum of the squares of the margin's terms at places [n][d]. */
static void squares_at(const struct um_uncertainty_growth *g, const struct margin *m,
                       const double *place, size_t n, double *out)
{
  const struct um_uncertainty_surrogate *s = g->s;
  double h[UM_UNCERTAINTY_SURROGATE_DIMENSIONS_MAX][UM_UNCERTAINTY_LEVELS];
  for (size_t i = 0; i < n; i++) {
    out[i] = 0.0;
    for (size_t k = 0; k < s->d; k++)
      um_uncertainty_axis_basis(
          &s->axis, place[i * s->d + k],
          s->levels[k] < UM_UNCERTAINTY_LEVELS ? s->levels[k] + 1 : s->levels[k], h[k]);
    for (size_t t = 0; t < m->n; t++) {
      double term = m->size[t];
      for (size_t k = 0; k < s->d; k++) term *= h[k][m->degree[t * s->d + k]];
      out[i] += term * term;
    }
  }
}

/* --- statements ------------------------------------------------------------------------------ */

/* Share of values beyond `bound` times q at places whose errors are spread like w [n]. */
static double share_beyond(const double *w, size_t n, size_t degrees, double bound)
{
  double sum = 0.0;
  for (size_t i = 0; i < n; i++) sum += 2.0 * gsl_cdf_tdist_Q(bound / w[i], (double)degrees);
  return sum / (double)n;
}

double um_uncertainty_stated_spread(const double *w, size_t nplace, size_t n, double miss)
{
  double low = 0.0, high = 0.0;
  for (size_t i = 0; i < nplace; i++) high = fmax(high, w[i]);
  high *= um_uncertainty_stated_factor(n, miss);
  for (int i = 0; i < 50; i++) {
    double middle = 0.5 * (low + high);
    *(share_beyond(w, nplace, n, middle) > miss ? &low : &high) = middle;
  }
  return high;
}

/* Largest q of a group's values over the last n held-out points, whose errors are spread like w
 * [n]. */
static double largest_q(const struct um_uncertainty_growth *g, size_t group, const double *w,
                        size_t n)
{
  const struct um_uncertainty_surrogate *s = g->s;
  const struct um_uncertainty_group *of = &g->request->group[group];
  double largest = 0.0;
  for (size_t k = of->first; k < of->first + of->count; k++) {
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) {
      size_t at = (s->nheld - n + i) * s->nvalue + k;
      if (g->left[at] == 0.0) continue;
      double of_asked = g->left[at] / um_uncertainty_growth_asked(g, group, g->held_value[at]);
      sum += pow(of_asked / w[i], 2.0);
    }
    largest = fmax(largest, sum);
  }
  return sqrt(largest / (double)n);
}

/* What n residuals state of a group, places [nelse][d] being elsewhere; work [n + nelse]. */
static double state(const struct um_uncertainty_growth *g, size_t group, struct margin *m, size_t n,
                    const double *elsewhere, size_t nelse, double miss, double *work)
{
  const struct um_uncertainty_surrogate *s = g->s;
  double *w = work + nelse, mean = 0.0;
  size_margin(g, group, m);
  squares_at(g, m, elsewhere, nelse, work);
  squares_at(g, m, g->held + (s->nheld - n) * s->d, n, w);
  for (size_t i = 0; i < nelse; i++) mean += work[i] / (double)nelse;
  for (size_t i = 0; i < n + nelse; i++) work[i] = mean > 0.0 ? sqrt(EVEN + work[i] / mean) : 1.0;
  return um_uncertainty_stated_spread(work, nelse, n, miss) * largest_q(g, group, w, n);
}

/* The next n places of the request, then Halton's. */
static enum um_status places(struct um_context *context, struct um_uncertainty_growth *g, size_t n,
                             double *place)
{
  const struct um_uncertainty_surrogate_request *r = g->request;
  size_t d = r->d, given = r->nasked > g->stated_by ? r->nasked - g->stated_by : 0;
  double *u = NULL;
  if (given > n) given = n;
  if (given > 0) memcpy(place, r->asked_at + g->stated_by * d, given * d * sizeof *place);
  g->stated_by += given;
  if (given == n) return UM_OK;
  UM_TRY(um_uncertainty_halton(context, d, 2 + g->s->nheld, n - given, &u));
  memcpy(place + given * d, u, (n - given) * d * sizeof *u);
  um_core_free(context, u);
  return UM_OK;
}

/* Places elsewhere: those at which it will be asked, or Halton's. */
static enum um_status find_elsewhere(struct um_context *context,
                                     const struct um_uncertainty_growth *g, double **out, size_t *n)
{
  const struct um_uncertainty_surrogate_request *r = g->request;
  *n = ELSEWHERE;
  if (r->nasked == 0) return um_uncertainty_halton(context, r->d, 2, *n, out);
  if (r->nasked < *n) *n = r->nasked;
  UM_TRY(um_core_allocate(context, *n, r->d * sizeof **out, out));
  memcpy(*out, r->asked_at, *n * r->d * sizeof **out);
  return UM_OK;
}

enum um_status um_uncertainty_growth_state(struct um_context *context,
                                           struct um_uncertainty_growth *g, size_t n, double *share)
{
  enum um_status status;
  double *place = NULL, *elsewhere = NULL, *work = NULL;
  struct margin m = {0};
  size_t nelse;
  UM_CHECK(um_core_allocate(context, n, g->s->d * sizeof *place, &place));
  UM_CHECK(places(context, g, n, place));
  UM_CHECK(um_uncertainty_growth_hold(context, g, place, n));
  UM_CHECK(find_elsewhere(context, g, &elsewhere, &nelse));
  UM_CHECK(um_core_allocate(context, n + nelse, sizeof *work, &work));
  UM_CHECK(find_margin(context, g, &m));
  g->s->nstating = n;
  double miss = ldexp(UM_UNCERTAINTY_STATED_MISS, -(int)++g->looks);
  um_uncertainty_growth_judge(g);
  *share = 0.0;
  for (size_t i = 0; i < g->s->ngroup; i++) {
    struct um_uncertainty_surrogate_error *e = &g->s->error[i];
    e->stated = fmax(state(g, i, &m, n, elsewhere, nelse, miss, work), e->share);
    *share = fmax(*share, e->stated);
  }
done:
  UM_FREE(context, place, elsewhere, work, m.degree, m.size);
  return status;
}
