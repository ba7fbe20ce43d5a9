/* Passes over a station: rise, culmination and set.
 *
 * The elevation is sampled on a grid fine against the period; every local maximum and minimum of
 * the samples is refined as a root of the elevation's rate (central difference), and inserted, so
 * that each crossing of the limit lies between two samples of opposite sign. Roots by bracketed
 * regula falsi (Illinois), to 0.1 ms. */
#include "orbit/observer.h"

enum { SAMPLES_PER_PERIOD = 100, ROOT_ITERATIONS = 100 };
static const double SAMPLES_MOST = 5e6;    /* of one search */
static const double STEP_SHORTEST = 5.0;   /* [s] */
static const double STEP_LONGEST = 120.0;  /* [s] */
static const double RATE_HALF_WIDTH = 0.5; /* [s] */
static const double ROOT_TOLERANCE = 1e-4; /* [s] */

struct sample {
  double t, elevation; /* t_tai [s], [rad] */
};

struct search {
  struct um_context *context;
  const struct um_orbit_observer *observer;
  const struct um_orbit_trajectory *satellite;
  double from, to;      /* [s] */
  double min_elevation; /* [rad] */
  struct sample *sample;
  size_t n, capacity;
  struct um_orbit_pass *pass;
  size_t passes;
};

/* A function of time whose root is sought. */
typedef enum um_status (*search_function)(struct search *search, double t, double *value);

static enum um_status elevation_at(struct search *s, double t, double *elevation)
{
  struct um_orbit_look look;
  UM_TRY(um_orbit_observer_look(s->context, s->observer, s->satellite, t, &look));
  *elevation = look.elevation;
  return UM_OK;
}

static enum um_status above_limit(struct search *s, double t, double *value)
{
  UM_TRY(elevation_at(s, t, value));
  *value -= s->min_elevation;
  return UM_OK;
}

static enum um_status elevation_rate(struct search *s, double t, double *value)
{
  double before, after;
  UM_TRY(elevation_at(s, t - RATE_HALF_WIDTH, &before));
  UM_TRY(elevation_at(s, t + RATE_HALF_WIDTH, &after));
  *value = (after - before) / (2.0 * RATE_HALF_WIDTH);
  return UM_OK;
}

/* Root of f in [a, b]; when the ends have one sign the end with the smaller |f| is returned. */
static enum um_status root(struct search *s, search_function f, double a, double b, double *t)
{
  double fa, fb, fx;
  UM_TRY(f(s, a, &fa));
  UM_TRY(f(s, b, &fb));
  *t = fabs(fa) < fabs(fb) ? a : b;
  if (!(fa * fb < 0.0)) return UM_OK;
  for (int k = 0, side = 0; k < ROOT_ITERATIONS; k++) {
    double x = (a * fb - b * fa) / (fb - fa);
    /* every fourth step bisects: the bracket itself must shrink */
    if (k % 4 == 3 || !(x > a && x < b)) x = 0.5 * (a + b);
    double moved = fabs(x - *t);
    *t = x;
    if (b - a <= ROOT_TOLERANCE) return UM_OK;
    UM_TRY(f(s, x, &fx));
    if (fx == 0.0 || (k > 2 && moved <= 0.01 * ROOT_TOLERANCE)) return UM_OK;
    if (fx * fb > 0.0) {
      b = x;
      fb = fx;
      if (side == -1) fa *= 0.5;
      side = -1;
    } else {
      a = x;
      fa = fx;
      if (side == 1) fb *= 0.5;
      side = 1;
    }
  }
  return um_core_fail(s->context, UM_ERR_NUMERIC, "pass search did not converge near t_tai %.3f s",
                      *t);
}

static enum um_status sample_add(struct search *s, double t)
{
  if (s->n == s->capacity) {
    size_t capacity = 2 * s->capacity + 64;
    UM_TRY(um_core_reallocate(s->context, capacity, sizeof *s->sample, &s->sample));
    s->capacity = capacity;
  }
  s->sample[s->n].t = t;
  UM_TRY(elevation_at(s, t, &s->sample[s->n].elevation));
  s->n++;
  return UM_OK;
}

/* After a new last sample: is the one before it an extremum? Then put the refined one beside it. */
static enum um_status extremum_insert(struct search *s)
{
  if (s->n < 3) return UM_OK;
  struct sample a = s->sample[s->n - 3], b = s->sample[s->n - 2], c = s->sample[s->n - 1];
  if (!((b.elevation - a.elevation) * (c.elevation - b.elevation) < 0.0)) return UM_OK;
  double t;
  UM_TRY(root(s, elevation_rate, fmax(a.t, s->from + RATE_HALF_WIDTH),
              fmin(c.t, s->to - RATE_HALF_WIDTH), &t));
  if (!(t > a.t && t < c.t) || t == b.t) return UM_OK;
  UM_TRY(sample_add(s, t));
  struct sample refined = s->sample[s->n - 1];
  /* a, b, c, refined -> in order of time */
  s->sample[s->n - 1] = c;
  s->sample[s->n - 2] = refined.t > b.t ? refined : b;
  s->sample[s->n - 3] = refined.t > b.t ? b : refined;
  return UM_OK;
}

static enum um_status elevations_sample(struct search *s)
{
  double period = um_orbit_trajectory_period(s->satellite);
  double step = isfinite(period) ? period / SAMPLES_PER_PERIOD : STEP_LONGEST;
  step = fmin(fmax(step, STEP_SHORTEST), STEP_LONGEST);
  double count = fmax(ceil((s->to - s->from) / step), 2.0);
  if (!(count <= SAMPLES_MOST))
    return um_core_fail(
        s->context, UM_ERR_INPUT,
        "passes: %.3g looks, one every %.3g s for %.3g s; accepted: at most %g, by a "
        "shorter time",
        count, step, s->to - s->from, SAMPLES_MOST);
  for (size_t i = 0; i <= (size_t)count; i++) {
    UM_TRY(um_core_stop_check(s->context, "passes were looked for"));
    UM_TRY(sample_add(s, i == (size_t)count ? s->to
                                            : s->from + (s->to - s->from) * (double)i / count));
    UM_TRY(extremum_insert(s));
  }
  return UM_OK;
}

/* The samples first..last are above the limit; their neighbours, where there are any, are not. */
static enum um_status pass_add(struct search *s, size_t first, size_t last)
{
  struct um_orbit_pass *pass;
  struct um_orbit_look look;
  size_t highest = first;
  UM_TRY(um_core_reallocate(s->context, s->passes + 1, sizeof *s->pass, &s->pass));
  pass = &s->pass[s->passes++];
  for (size_t i = first; i <= last; i++)
    if (s->sample[i].elevation > s->sample[highest].elevation) highest = i;
  pass->rise = s->sample[first].t;
  pass->set = s->sample[last].t;
  pass->culmination = s->sample[highest].t;
  if (first > 0)
    UM_TRY(root(s, above_limit, s->sample[first - 1].t, s->sample[first].t, &pass->rise));
  if (last + 1 < s->n)
    UM_TRY(root(s, above_limit, s->sample[last].t, s->sample[last + 1].t, &pass->set));
  UM_TRY(um_orbit_observer_look(s->context, s->observer, s->satellite, pass->rise, &look));
  pass->rise_azimuth = look.azimuth;
  UM_TRY(um_orbit_observer_look(s->context, s->observer, s->satellite, pass->set, &look));
  pass->set_azimuth = look.azimuth;
  UM_TRY(um_orbit_observer_look(s->context, s->observer, s->satellite, pass->culmination, &look));
  pass->culmination_azimuth = look.azimuth;
  pass->culmination_elevation = look.elevation;
  pass->culmination_range = look.range;
  return UM_OK;
}

static enum um_status passes_collect(struct search *s)
{
  for (size_t i = 0; i < s->n; i++) {
    if (!(s->sample[i].elevation >= s->min_elevation)) continue;
    size_t first = i;
    UM_TRY(um_core_stop_check(s->context, "passes were looked for"));
    while (i + 1 < s->n && s->sample[i + 1].elevation >= s->min_elevation) i++;
    UM_TRY(pass_add(s, first, i));
  }
  return UM_OK;
}

enum um_status um_orbit_passes_find(struct um_context *context,
                                    const struct um_orbit_observer *observer,
                                    const struct um_orbit_trajectory *satellite, double from,
                                    double to, double min_elevation, struct um_orbit_pass **out,
                                    size_t *count)
{
  enum um_status status;
  struct search s = {.context = context,
                     .observer = observer,
                     .satellite = satellite,
                     .from = from,
                     .to = to,
                     .min_elevation = min_elevation};
  *out = NULL;
  *count = 0;
  if (observer->kind != UM_OBSERVER_STATION)
    return um_core_fail(context, UM_ERR_INPUT, "passes: the observer must be a station");
  if (!(to - from > 4.0 * RATE_HALF_WIDTH && to - from < INFINITY))
    return um_core_fail(context, UM_ERR_INPUT,
                        "passes: a window of %g s, more than %g s is accepted", to - from,
                        4.0 * RATE_HALF_WIDTH);
  UM_CHECK(um_core_allocate(context, 1, sizeof *s.pass, &s.pass));
  UM_CHECK(elevations_sample(&s));
  UM_CHECK(passes_collect(&s));
done:
  um_core_free(context, s.sample);
  if (status == UM_OK) {
    *out = s.pass;
    *count = s.passes;
  } else {
    um_core_free(context, s.pass);
  }
  return status;
}
