/* umbra passes: when the satellite is above the station, and where it meets the Earth's shadow. */
#include <math.h>
#include <string.h>

#include "app/app.h"
#include "base/core/constants.h"
#include "model/build/build.h"
#include "model/build/timeline.h"
#include "orbit/time.h"

static const char *event_text(enum um_environment_event_kind kind)
{
  switch (kind) {
  case UM_EVENT_PENUMBRA_ENTRY:
    return "enters the penumbra";
  case UM_EVENT_HALF_ENTRY:
    return "half of the Sun is hidden";
  case UM_EVENT_UMBRA_ENTRY:
    return "enters the umbra";
  case UM_EVENT_UMBRA_EXIT:
    return "leaves the umbra";
  case UM_EVENT_HALF_EXIT:
    return "half of the Sun is back";
  case UM_EVENT_PENUMBRA_EXIT:
    return "is in full sunlight";
  }
  return "";
}

static void print_point(const char *what, double t, double azimuth)
{
  char utc[32];
  um_orbit_time_format(t, utc);
  printf("  %-12s %s  azimuth %7.3f deg", what, utc, azimuth / UM_DEG);
}

static enum um_status print_pass(struct um_context *context, const struct um_model *model,
                                 const struct um_orbit_pass *p)
{
  struct um_environment_event *event = NULL;
  size_t n = 0;
  print_point("rises", p->rise, p->rise_azimuth);
  printf("\n");
  print_point("culminates", p->culmination, p->culmination_azimuth);
  printf("  elevation %.3f deg  range %.1f km\n", p->culmination_elevation / UM_DEG,
         p->culmination_range * 1e-3);
  print_point("sets", p->set, p->set_azimuth);
  printf("\n");
  UM_TRY(um_model_events(context, model, p->rise, p->set, &event, &n));
  for (size_t i = 0; i < n; i++) {
    char utc[32];
    um_orbit_time_format(event[i].t_tai, utc);
    printf("    %s  %s\n", utc, event_text(event[i].kind));
  }
  um_core_free(context, event);
  return UM_OK;
}

static void print_json(const struct um_orbit_pass *p, size_t n)
{
  puts("[");
  for (size_t i = 0; i < n; i++) {
    char rise[32], culmination[32], set[32];
    um_orbit_time_format(p[i].rise, rise);
    um_orbit_time_format(p[i].culmination, culmination);
    um_orbit_time_format(p[i].set, set);
    printf("  {\"rise_utc\": \"%s\", \"culmination_utc\": \"%s\", \"set_utc\": \"%s\", "
           "\"culmination_elevation_deg\": %.6f, \"culmination_range_km\": %.6f}%s\n",
           rise, culmination, set, p[i].culmination_elevation / UM_DEG,
           p[i].culmination_range * 1e-3, i + 1 < n ? "," : "");
  }
  puts("]");
}

int um_app_passes(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_model *model = NULL;
  struct um_orbit_pass *pass = NULL;
  size_t n = 0;
  struct um_model_options changes = um_app_model_options(options);
  UM_CHECK(um_model_create_orbit(context, options->positional[0], &changes, &model));
  if (!model->has_observer || model->observer.kind != UM_OBSERVER_STATION) {
    status = um_core_fail(context, UM_ERR_INPUT, "%s: passes need observer.station",
                          model->scenario->at.file);
    goto done;
  }
  if (model->points) {
    status = um_core_fail(context, UM_ERR_INPUT, "%s: passes need an orbit, not orbit.points",
                          model->scenario->at.file);
    goto done;
  }
  /* a day around the scenario, so that its own pass is seen whole */
  double middle = 0.5 * (model->scenario->time->start + model->scenario->time->stop);
  double half = fmax(43200.0, 0.5 * (model->scenario->time->stop - model->scenario->time->start));
  UM_CHECK(um_orbit_passes_find(
      context, &model->observer, model->trajectory, middle - half, middle + half,
      model->scenario->observer->minimum_elevation_deg * UM_DEG, &pass, &n));
  if (options->json) {
    print_json(pass, n);
    goto done;
  }
  const char *name = model->scenario->observer->station->name;
  printf("%zu passes above %g deg over %s within half a day of the scenario\n", n,
         model->scenario->observer->minimum_elevation_deg, name == NULL ? "the station" : name);
  for (size_t i = 0; i < n; i++) {
    printf("pass %zu\n", i + 1);
    UM_CHECK(print_pass(context, model, &pass[i]));
  }
done:
  um_core_free(context, pass);
  um_model_destroy(context, &model);
  return status == UM_OK ? UM_APP_DONE : um_app_fail(context);
}
