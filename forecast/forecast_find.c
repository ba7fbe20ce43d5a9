/* Passes of a station, without what a run gives: when, where, and what the shadow does. */
#include <math.h>

#include "forecast/forecast_impl.h"
#include "model/build/build.h"
#include "model/build/timeline.h"

#define HOUR  3600.0 /* between observations where none are made [s], */
#define STEPS 10000  /* .. of which there are no more than so many */
#define BEYOND                                                                                     \
  7200.0 /* passes are looked for this far outside the days, so that theirs are whole [s] */

/* Shadow, Sun and times of a pass that need no run and no attitude. */
static enum um_status describe(struct um_context *context, const struct um_model *orbit,
                               struct um_forecast_pass *pass)
{
  struct um_environment_event *event = NULL;
  struct um_orbit_look look;
  size_t n = 0;
  const struct um_orbit_pass *p = &pass->pass;
  pass->entry = pass->exit = NAN;
  pass->delay = NAN;
  pass->start = ceil(p->rise); /* whole seconds of TAI are whole seconds of UTC */
  pass->stop = floor(p->set);
  UM_TRY(
      um_orbit_observer_look(context, &orbit->observer, orbit->trajectory, p->culmination, &look));
  pass->sun_elevation = look.sun_elevation;
  /* what the last edge of the shadow before the rise was; none in so long a time: there is no
   * shadow */
  bool sunlit = true;
  UM_TRY(um_model_events(context, orbit, p->rise - BEYOND, p->set, &event, &n));
  pass->sunlit_at_rise = true;
  for (size_t i = 0; i < n; i++) {
    double t = event[i].t_tai;
    bool entry = event[i].kind == UM_EVENT_HALF_ENTRY, exit = event[i].kind == UM_EVENT_HALF_EXIT;
    if (entry || exit) sunlit = exit;
    if ((entry || exit) && t < p->rise) pass->sunlit_at_rise = sunlit;
    if (entry && t >= p->rise && isnan(pass->entry)) pass->entry = t;
    if (exit && t >= p->rise && isnan(pass->exit)) pass->exit = t;
  }
  pass->sunlit_at_set = sunlit;
  size_t before = 0;
  while (before < n && event[before].t_tai < p->rise) before++;
  pass->event = event;
  pass->nevent = n - before;
  for (size_t i = 0; i < pass->nevent; i++) event[i] = event[before + i];
  return UM_OK;
}

/* Is it one of these days, and long enough to be run? */
static bool belongs(const struct um_forecast *f, const struct um_orbit_pass *pass)
{
  return pass->culmination >= f->from && pass->culmination < f->to &&
         floor(pass->set) - ceil(pass->rise) >= 1.0;
}

static enum um_status add_pass(struct um_context *context, struct um_forecast *f,
                               const struct um_model *orbit, size_t station,
                               const struct um_orbit_pass *pass)
{
  if (f->npass >= UM_FORECAST_MOST)
    return um_core_fail(context, UM_ERR_INPUT,
                        "more than %d passes; accepted: fewer days, fewer stations or a higher "
                        "minimum elevation",
                        UM_FORECAST_MOST);
  UM_TRY(um_core_reallocate(context, f->npass + 1, sizeof *f->pass, &f->pass));
  struct um_forecast_pass *to = &f->pass[f->npass];
  *to = (struct um_forecast_pass){.station = station, .pass = *pass};
  f->npass++;
  return describe(context, orbit, to);
}

enum um_status um_forecast_check_orbit(struct um_context *context, const struct um_model *orbit)
{
  const char *file = orbit->scenario->at.file;
  if (!orbit->has_observer || orbit->observer.kind != UM_OBSERVER_STATION)
    return um_core_fail(context, UM_ERR_INPUT, "%s: passes need observer.station", file);
  if (orbit->points)
    return um_core_fail(context, UM_ERR_INPUT, "%s: passes need an orbit, not orbit.points", file);
  return UM_OK;
}

/* The scenario over the days, at the station: of a forecast a variant, of times an orbit alone. */
static enum um_status make_orbit(struct um_context *context, const struct um_forecast_work *work,
                                 const struct um_model_changes *changes, struct um_model **out)
{
  enum um_status status;
  struct um_model_options options;
  um_core_quiet_begin(context); /* what is to be said of the orbit was said of the scenario */
  if (work->times == NULL) {
    status = um_model_variant_create(context, work->model, changes, out);
  } else {
    options = *work->times->options;
    options.set = changes->key;
    options.nset = changes->nkey;
    status = um_model_create_orbit(context, work->times->path, &options, out);
  }
  um_core_quiet_end(context);
  return status;
}

enum um_status um_forecast_orbit(struct um_context *context, const struct um_forecast_work *work,
                                 const struct um_forecast *f, size_t station, struct um_model **out)
{
  struct um_forecast_changes changes;
  double step = fmax(HOUR, (f->to - f->from) / STEPS);
  enum um_status status =
      um_forecast_changes(context, work, station, f->from, f->to, step, &changes);
  if (status == UM_OK) status = make_orbit(context, work, &changes.all, out);
  um_forecast_changes_clear(context, &changes);
  return status;
}

enum um_status um_forecast_find(struct um_context *context, const struct um_forecast_work *work,
                                struct um_forecast *f, size_t station)
{
  enum um_status status;
  struct um_model *orbit = NULL;
  struct um_orbit_pass *pass = NULL;
  size_t n = 0;
  UM_CHECK(um_forecast_orbit(context, work, f, station, &orbit));
  UM_CHECK(um_forecast_check_orbit(context, orbit));
  UM_CHECK(um_orbit_passes_find(context, &orbit->observer, orbit->trajectory, f->from - BEYOND,
                                f->to + BEYOND, f->minimum_elevation, &pass, &n));
  for (size_t i = 0; i < n; i++)
    if (belongs(f, &pass[i])) UM_CHECK(add_pass(context, f, orbit, station, &pass[i]));
done:
  um_core_free(context, pass);
  um_model_destroy(context, &orbit);
  return status;
}
