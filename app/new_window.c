/* When a new scenario looks: a pass in which something happens. */
#include <math.h>

#include "app/app.h"
#include "app/new.h"
#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/build/timeline.h"
#include "orbit/time.h"

#define DAYS     3.0     /* in which passes are looked for [d] */
#define ALONE    600.0   /* how long it looks where there is none [s] */
#define BEFORE   43200.0 /* where the search begins, before the time of the scenario [s] */
#define DARK     (-6.0 * UM_DEG)
#define HIGH     (30.0 * UM_DEG)
#define INSTANTS 200.0 /* of a pass, about */
#define LEAST    1.0   /* between instants [s] */

static enum um_status judge(struct um_context *context, const struct um_model *model,
                            const struct um_orbit_pass *pass, struct um_app_new_window *out,
                            int *score)
{
  struct um_environment_event *event = NULL;
  struct um_environment_sample sample;
  struct um_orbit_look look;
  size_t n = 0;
  UM_TRY(um_model_sample_seen(context, model, pass->culmination, &sample, &look));
  UM_TRY(um_model_events(context, model, pass->rise, pass->set, &event, &n));
  *out = (struct um_app_new_window){.start = floor(pass->rise),
                                    .stop = ceil(pass->set),
                                    .seen = true,
                                    .dark = look.sun_elevation < DARK,
                                    .highest = pass->culmination_elevation};
  for (size_t i = 0; i < n; i++)
    out->edge =
        out->edge || event[i].kind == UM_EVENT_HALF_ENTRY || event[i].kind == UM_EVENT_HALF_EXIT;
  um_core_free(context, event);
  bool light = out->edge || sample.sunlit_fraction > 0.5;
  *score = 8 * light + 4 * out->dark + 2 * out->edge + (out->highest > HIGH);
  return UM_OK;
}

enum um_status um_app_new_window_find(struct um_context *context, const char *scenario, double from,
                                      struct um_app_new_window *out)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_orbit_pass *pass = NULL;
  size_t n = 0;
  int best = -1;
  UM_CHECK(um_model_create_orbit(context, scenario, NULL, &model));
  if (isnan(from)) from = model->scenario->time->start - BEFORE;
  *out = (struct um_app_new_window){.start = floor(from), .stop = floor(from) + ALONE};
  UM_CHECK(um_orbit_passes_find(
      context, &model->observer, model->trajectory, from, from + DAYS * 86400.0,
      model->scenario->observer->minimum_elevation_deg * UM_DEG, &pass, &n));
  for (size_t i = 0; i < n; i++) {
    struct um_app_new_window window;
    int score;
    UM_CHECK(judge(context, model, &pass[i], &window, &score));
    if (score <= best) continue;
    best = score;
    *out = window;
  }
done:
  um_core_free(context, pass);
  um_model_destroy(context, &model);
  return status;
}

enum um_status um_app_new_window_put(struct um_context *context, char **text,
                                     const struct um_app_new_window *window)
{
  char start[32], stop[32], value[160];
  double step = fmax(LEAST, round((window->stop - window->start) / INSTANTS));
  um_orbit_time_format(window->start, start);
  um_orbit_time_format(window->stop, stop);
  snprintf(value, sizeof value, "time: {start_utc: %s, stop_utc: %s, step_s: %g}\n", start, stop,
           step);
  return um_app_new_put(context, text, "time", NULL, value);
}
