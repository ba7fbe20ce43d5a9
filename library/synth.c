/* Measurements made of a scenario, and what measurements hold: columns and a file. */
#include "evidence/inversion/synth.h"

#include <unistd.h>

#include "base/core/constants.h"
#include "evidence/measurements/write.h"
#include "library/measurements_impl.h"
#include "library/run_impl.h"
#include "library/scenario_impl.h"
#include "orbit/time.h"

#define TEMPERATURE_SIGMA 0.5     /* [K] */
#define MADE              "synth" /* what messages call them */

enum umbra_status umbra_synth(struct umbra *umbra, const struct umbra_scenario *scenario,
                              const struct umbra_synth_settings *settings,
                              struct umbra_measurements **out)
{
  struct um_context *context = um_library_begin(umbra);
  struct um_compare_measurements *set = NULL;
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_library_check_size(context, "struct umbra_synth_settings", settings->size,
                                 sizeof *settings));
  const struct um_compare_synth how = {.relative = settings->noise,
                                       .floor = settings->floor,
                                       .seed = settings->seed,
                                       .place = settings->place,
                                       .nplace = settings->nplace,
                                       .grey_body = settings->grey_body != 0,
                                       .temperature_sigma = settings->temperature_sigma != 0.0
                                                                ? settings->temperature_sigma
                                                                : TEMPERATURE_SIGMA};
  const struct um_model_options options = um_library_source_options(&scenario->source, umbra);
  UM_CHECK(um_compare_synth_run(context, scenario->source.path, &options, &how, MADE, &set));
  UM_CHECK(um_library_measurements_take(context, umbra, &set, out));
done:
  um_compare_measurements_destroy(context, &set);
  return um_library_status(status);
}

enum umbra_status umbra_measurements_write(struct umbra *umbra,
                                           const struct umbra_measurements *measurements,
                                           const char *path, int force)
{
  struct um_context *context = um_library_begin(umbra);
  if (force == 0 && access(path, F_OK) == 0)
    return um_library_status(
        um_core_fail(context, UM_ERR_IO, "%s: exists; accepted: a new name, or force", path));
  return um_library_status(um_compare_measurements_write(context, measurements->set, path));
}

/* --- columns --------------------------------------------------------------------------------- */

/* Columns of numbers and of texts in the memory that holds them. */
enum { TIME, VALUE, SIGMA, EXPOSURE, HEIGHT, AZIMUTH, ELEVATION, NUMBERS };
enum { QUANTITY, OF, TRACK, STATION, TEXTS };

static void put_row(struct umbra_measurements *m, size_t i)
{
  const struct um_compare_measurements *set = m->set;
  const struct um_compare_measurement *row = &set->row[i];
  const double number[NUMBERS] = {[TIME] = um_orbit_time_unix(row->t_tai),
                                  [VALUE] = row->value,
                                  [SIGMA] = row->sigma,
                                  [EXPOSURE] = row->exposure,
                                  [HEIGHT] = row->satellite_height / 1e3,
                                  [AZIMUTH] = row->azimuth / UM_DEG,
                                  [ELEVATION] = row->elevation / UM_DEG};
  const char *text[TEXTS] = {
      [QUANTITY] = um_compare_quantity_name(set->channel[row->channel].quantity),
      [OF] = set->channel[row->channel].of,
      [TRACK] = set->track[row->track],
      [STATION] = row->station < set->nstation ? set->station[row->station] : NULL};
  for (size_t c = 0; c < NUMBERS; c++) m->number[c * set->count + i] = number[c];
  for (size_t c = 0; c < TEXTS; c++) m->text[c * set->count + i] = text[c];
  m->flag[i] = row->flag;
}

static enum um_status say_columns(struct um_context *context, struct umbra_measurements *m)
{
  const struct um_compare_measurements *set = m->set;
  size_t n = set->count;
  bool named = set->ntrack > 1 || (set->ntrack == 1 && set->track[0][0] != '\0');
  UM_TRY(um_core_reallocate(context, NUMBERS * n, sizeof *m->number, &m->number));
  UM_TRY(um_core_reallocate(context, TEXTS * n, sizeof *m->text, &m->text));
  UM_TRY(um_core_reallocate(context, n, sizeof *m->flag, &m->flag));
  for (size_t i = 0; i < n; i++) put_row(m, i);
  const double *number = m->number;
  m->said =
      (struct umbra_columns){.size = sizeof m->said,
                             .count = n,
                             .time_unix_s = number + TIME * n,
                             .quantity = m->text + QUANTITY * n,
                             .of = m->text + OF * n,
                             .value = number + VALUE * n,
                             .sigma = number + SIGMA * n,
                             .exposure_s = number + EXPOSURE * n,
                             .flag = m->flag,
                             .track = named ? m->text + TRACK * n : NULL,
                             .station = set->nstation > 0 ? m->text + STATION * n : NULL,
                             .satellite_height_km = set->independent ? number + HEIGHT * n : NULL,
                             .azimuth_deg = set->independent ? number + AZIMUTH * n : NULL,
                             .elevation_deg = set->independent ? number + ELEVATION * n : NULL};
  return UM_OK;
}

enum umbra_status umbra_measurements_columns(struct umbra *umbra,
                                             struct umbra_measurements *measurements,
                                             const struct umbra_columns **out)
{
  struct um_context *context = um_library_begin(umbra);
  enum um_status status = UM_OK;
  *out = NULL;
  if (measurements->said.size == 0) status = say_columns(context, measurements);
  if (status == UM_OK) *out = &measurements->said;
  return um_library_status(status);
}
