/* Passes to come, into a folder. */
#include <math.h>

#include "base/core/constants.h"
#include "base/core/text.h"
#include "forecast/forecast_write.h"
#include "library/points_impl.h"
#include "library/scenario_impl.h"
#include "orbit/time_form.h"
#include "study/identity.h"

#define DAYS_MOST 400.0

static enum um_status take_number(struct um_context *context, const char *name, double value,
                                  double least, double most)
{
  if (value >= least && value <= most) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s %g; accepted: %g to %g", name, value, least, most);
}

static enum um_status take_station(struct um_context *context, const struct umbra_station *from,
                                   struct um_forecast_station *to)
{
  if (from->name == NULL || from->name[0] == '\0' || !um_core_name_is_safe(from->name))
    return um_core_fail(context, UM_ERR_INPUT,
                        "a station without a name; accepted: one, printable");
  UM_TRY(take_number(context, "latitude_deg", from->latitude_deg, -90.0, 90.0));
  UM_TRY(take_number(context, "longitude_deg", from->longitude_deg, -360.0, 360.0));
  UM_TRY(take_number(context, "height_m", from->height_m, -1000.0, 1e5));
  *to = (struct um_forecast_station){.name = from->name,
                                     .latitude = from->latitude_deg * UM_DEG,
                                     .longitude = from->longitude_deg * UM_DEG,
                                     .height = from->height_m};
  return UM_OK;
}

static enum um_status take(struct um_context *context, const struct umbra_forecast_settings *s,
                           struct um_forecast_station *station, struct um_forecast_ask *ask)
{
  if (s->days != 0.0) UM_TRY(take_number(context, "days", s->days, 1e-3, DAYS_MOST));
  UM_TRY(take_number(context, "minimum_elevation_deg", s->minimum_elevation_deg, 0.0, 89.0));
  ask->from = NAN;
  if (s->from_unix_s != 0.0 && !um_orbit_time_from_unix(s->from_unix_s, &ask->from))
    return um_core_fail(context, UM_ERR_INPUT,
                        "from_unix_s %.10g; accepted: seconds of 1960 to 2100", s->from_unix_s);
  ask->days = s->days != 0.0 ? s->days : 1.0;
  ask->minimum_elevation =
      s->minimum_elevation_deg != 0.0 ? s->minimum_elevation_deg * UM_DEG : (double)NAN;
  ask->station = station;
  ask->uncertain = s->uncertain;
  ask->nuncertain = s->nuncertain;
  for (; ask->nstation < s->nstation; ask->nstation++)
    UM_TRY(take_station(context, &s->station[ask->nstation], &station[ask->nstation]));
  return UM_OK;
}

/* The folder is begun before the computing: what stands in its way is said at once. */
static enum um_status run(struct um_context *context, const struct um_forecast_ask *ask,
                          struct um_batch_task *task, const struct umbra_points *points,
                          size_t *missing)
{
  enum um_status status;
  struct um_forecast *forecast = NULL;
  struct um_batch *batch = NULL;
  struct um_core_folder *folder = NULL;
  UM_CHECK(um_core_folder_begin(context, points->folder, points->force != 0, &folder));
  UM_CHECK(um_forecast_create(context, ask, task, &forecast));
  UM_CHECK(um_forecast_open(context, forecast, task, &batch));
  UM_CHECK(um_forecast_run(context, forecast, batch));
  *missing = um_batch_lost(batch);
  if (points->nshare > 0) goto done;
  UM_CHECK(um_forecast_write(context, forecast, points->pictures != 0, folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
done:
  um_batch_close(context, &batch);
  if (status == UM_OK && points->nshare == 0 && *missing == 0)
    um_study_records_remove(context, task->folder);
  um_core_folder_abort(&folder);
  um_forecast_destroy(context, &forecast);
  return status;
}

enum umbra_status umbra_forecast(struct umbra *umbra, const struct umbra_scenario *scenario,
                                 const struct umbra_forecast_settings *settings,
                                 const struct umbra_points *points, size_t *missing)
{
  static const struct umbra_forecast_settings defaults = UMBRA_FORECAST_SETTINGS;
  struct um_context *context = um_library_begin(umbra);
  const struct um_model_options options = um_library_source_options(&scenario->source, umbra);
  struct um_forecast_ask ask = {
      .path = scenario->source.path, .options = &options, .version = UM_LIBRARY_VERSION};
  struct um_forecast_station *station = NULL;
  struct um_batch_task task = {.nshare = 0};
  char *records = NULL;
  enum um_status status;
  *missing = 0;
  if (settings == NULL) settings = &defaults;
  UM_CHECK(um_library_check_size(context, "struct umbra_forecast_settings", settings->size,
                                 sizeof *settings));
  UM_CHECK(um_core_allocate(context, settings->nstation, sizeof *station, &station));
  UM_CHECK(take(context, settings, station, &ask));
  UM_CHECK(um_library_points(context, points, &task, &records));
  UM_CHECK(run(context, &ask, &task, points, missing));
done:
  UM_FREE(context, station, records);
  return um_library_status(status);
}
