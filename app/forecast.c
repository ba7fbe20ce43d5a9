/* umbra forecast: passes of stations over days, with what is seen of them. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "app/app.h"
#include "app/batch.h"
#include "app/forecast.h"
#include "app/station.h"
#include "app/terminal.h"
#include "base/batch/batch.h"
#include "base/core/constants.h"
#include "base/core/file.h"
#include "base/core/suggestions.h"
#include "forecast/forecast_write.h"
#include "orbit/time.h"
#include "study/identity.h"

#define DAYS_MOST 400.0

/* A number and what is behind it; false: none, or not finite. */
static bool number(const char *text, double *out, const char **behind)
{
  char *end;
  *out = strtod(text, &end);
  *behind = end;
  return end != text && isfinite(*out);
}

static enum um_status parse_range(struct um_context *context, const char *option, const char *text,
                                  double least, double most, double *out)
{
  const char *behind;
  if (text == NULL) return UM_OK;
  if (number(text, out, &behind) && *behind == '\0' && *out >= least && *out <= most) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s '%s': accepted: a number from %g to %g", option,
                      text, least, most);
}

static enum um_status parse(struct um_context *context, const struct um_app_options *options,
                            struct um_forecast_station *station, struct um_forecast_ask *ask)
{
  ask->path = options->positional[0];
  ask->from = NAN;
  ask->days = 1.0;
  ask->minimum_elevation = NAN;
  ask->station = station;
  ask->uncertain = options->uncertain;
  ask->nuncertain = options->nuncertain;
  if (options->time_utc != NULL)
    UM_TRY(um_orbit_time_parse(context, options->time_utc, &ask->from));
  UM_TRY(parse_range(context, "--days", options->days, 1e-3, DAYS_MOST, &ask->days));
  UM_TRY(parse_range(context, "--minimum-elevation", options->minimum_elevation, 0.0, 89.0,
                     &ask->minimum_elevation));
  ask->minimum_elevation *= UM_DEG;
  for (; ask->nstation < options->nstation; ask->nstation++)
    UM_TRY(um_app_station_parse(context, options->station[ask->nstation], &station[ask->nstation]));
  return UM_OK;
}

/* The folder is begun before the computing: what stands in its way is said at once. */
static enum um_status compute_and_write(struct um_context *context,
                                        const struct um_app_options *options, struct um_forecast *f,
                                        struct um_batch *batch, const char *out)
{
  enum um_status status;
  struct um_core_folder *folder = NULL;
  UM_CHECK(um_core_folder_begin(context, out, options->force, &folder));
  UM_CHECK(um_forecast_run(context, f, batch));
  UM_CHECK(um_forecast_write(context, f, !options->no_plots, folder));
  UM_CHECK(um_core_folder_commit(context, &folder));
done:
  um_core_folder_abort(&folder);
  return status;
}

/* The leading process: passes, files, words. */
static enum um_status lead(struct um_context *context, const struct um_app_options *options,
                           struct um_forecast *f, struct um_batch *batch, const char *out)
{
  if (options->share != NULL) {
    UM_TRY(um_forecast_run(context, f, batch));
    um_app_terminal_clear();
    printf("%zu of %zu passes are on record; --resume without --share writes the results\n",
           um_batch_recorded(batch), f->npass);
    return UM_OK;
  }
  UM_TRY(compute_and_write(context, options, f, batch, out));
  um_app_terminal_clear();
  if (options->json)
    um_app_forecast_json(f, out);
  else
    um_app_forecast_print(f, out);
  return UM_OK;
}

/* The times alone. */
static enum um_status tell_times(struct um_context *context, const struct um_app_options *options,
                                 struct um_forecast_ask *ask)
{
  struct um_forecast *forecast;
  if (options->days == NULL && options->time_utc == NULL) ask->days = NAN; /* the scenario's */
  UM_TRY(um_forecast_times(context, ask, &forecast));
  um_app_forecast_times(forecast, options->json);
  um_forecast_destroy(context, &forecast);
  return UM_OK;
}

int um_app_forecast(struct um_context *context, const struct um_app_options *options)
{
  enum um_status status;
  struct um_forecast_station *station = NULL;
  struct um_forecast *forecast = NULL;
  struct um_forecast_ask ask = {.nstation = 0};
  struct um_model_options changes = um_app_model_options(options);
  struct um_batch_task task = {.nshare = 0};
  struct um_batch *batch = NULL;
  char *out = NULL, *name = NULL, *records = NULL;
  bool whole = false;
  int code = UM_APP_DONE;
  if (options->times) {
    code = um_app_options_refuse(options, "out uncertain workers share resume force no-plots",
                                 "does not go with --times, which computes and writes nothing");
    if (code != UM_APP_DONE) return code;
  }
  ask.options = &changes;
  ask.version = UM_APP_VERSION;
  UM_CHECK(um_core_allocate(context, options->nstation, sizeof *station, &station));
  UM_CHECK(parse(context, options, station, &ask));
  if (options->times) {
    UM_CHECK(tell_times(context, options, &ask));
    goto done;
  }
  UM_CHECK(um_app_batch_options(context, options, &task));
  UM_CHECK(um_forecast_create(context, &ask, &task, &forecast));
  UM_CHECK(um_core_asprintf(context, &name, "%s-forecast", forecast->name));
  UM_CHECK(um_app_out_folder(context, options, name, &out));
  UM_CHECK(um_app_batch_records(context, out, &records));
  task.folder = records;
  UM_CHECK(um_forecast_open(context, forecast, &task, &batch));
  if (um_batch_leads(batch))
    UM_CHECK(lead(context, options, forecast, batch, out));
  else
    UM_CHECK(um_batch_serve(context, batch));
  code = um_app_batch_end(um_batch_lost(batch), records);
  whole = um_batch_leads(batch) && options->share == NULL && code == UM_APP_DONE;
done:
  um_batch_close(context, &batch);
  if (whole) um_study_records_remove(context, records);
  um_forecast_destroy(context, &forecast);
  for (size_t i = 0; station != NULL && i < options->nstation; i++)
    um_core_free(context, (void *)station[i].name);
  UM_FREE(context, station, records, out, name);
  return status == UM_OK ? code : um_app_fail(context);
}
