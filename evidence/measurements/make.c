/* Measurements from a caller's numbers. What holds between rows is checked in set.c. */
#include "evidence/measurements/make.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/suggestions.h"
#include "base/core/text.h"
#include "evidence/measurements/set_group.h"

#define MAGNITUDE_MAX 40.0 /* [mag], as in a file */
#define HEIGHT_LEAST  1.0  /* [m] */
#define HEIGHT_MOST   1e9  /* [m] */

/* A row by the number that messages have. */
struct place {
  struct um_context *context;
  const char *name;
  int line;
};

static enum um_status refuse(const struct place *at, const char *what, double value,
                             const char *accepted)
{
  return um_core_fail(at->context, UM_ERR_INPUT, "%s:%d: %s %.10g; accepted: %s", at->name,
                      at->line, what, value, accepted);
}

static enum um_status find_quantity(const struct place *at, const char *text,
                                    enum um_compare_quantity *out)
{
  struct um_core_words_guess guess = {.written = text == NULL ? "" : text};
  char accepted[256] = "", hint[UM_CORE_WORDS_HINT];
  for (int q = 0; q < UM_QUANTITY_COUNT; q++) {
    const char *name = um_compare_quantity_name((enum um_compare_quantity)q);
    *out = (enum um_compare_quantity)q;
    if (strcmp(guess.written, name) == 0) return UM_OK;
    um_core_words_append(accepted, sizeof accepted, name);
    um_core_words_consider(&guess, name);
  }
  return um_core_fail(at->context, UM_ERR_INPUT, "%s:%d: unknown quantity '%.60s'%s; accepted: %s",
                      at->name, at->line, guess.written, um_core_words_hint(&guess, hint),
                      accepted);
}

static enum um_status check_name(const struct place *at, const char *what, const char *name,
                                 bool behind)
{
  bool safe = name == NULL || (behind ? um_core_name_is_safe_behind(name) && name[0] != '\0'
                                      : um_core_name_is_safe(name));
  if (safe) return UM_OK;
  return um_core_fail(at->context, UM_ERR_INPUT, "%s:%d: %s '%.100s'; accepted: %s", at->name,
                      at->line, what, name, UM_CORE_NAME_ACCEPTED_BEHIND);
}

static enum um_status check_value(const struct place *at, const struct um_compare_row *row,
                                  enum um_compare_quantity quantity)
{
  bool positive = quantity == UM_QUANTITY_TEMPERATURE || um_compare_is_grey_body(quantity);
  if (!isfinite(row->t_tai)) return refuse(at, "time", row->t_tai, "a finite number");
  if (!isfinite(row->value)) return refuse(at, "value", row->value, "a finite number");
  if (positive && !(row->value > 0.0)) return refuse(at, "value", row->value, "above 0");
  if (um_compare_is_magnitude(quantity) && !(fabs(row->value) <= MAGNITUDE_MAX))
    return refuse(at, "magnitude", row->value, "-40 to 40 mag");
  if (!isnan(row->sigma) && !(row->sigma > 0.0 && isfinite(row->sigma)))
    return refuse(at, "sigma", row->sigma,
                  "above 0, or NaN where the scenario gives a noise model");
  if (!isnan(row->exposure) && !(row->exposure >= 0.0 && isfinite(row->exposure)))
    return refuse(at, "exposure", row->exposure, "0 s or more, or NaN");
  return UM_OK;
}

/* All of it or nothing, in every row. */
static enum um_status check_geometry(const struct place *at, const struct um_compare_row *row,
                                     bool wanted)
{
  bool none = isnan(row->satellite_height) && isnan(row->azimuth) && isnan(row->elevation);
  if (!wanted && none) return UM_OK;
  if (!wanted && !isnan(row->satellite_height))
    return refuse(at, "satellite height [km]", 1e-3 * row->satellite_height,
                  "none, as in the first row");
  if (!(row->satellite_height >= HEIGHT_LEAST && row->satellite_height <= HEIGHT_MOST))
    return refuse(at, "satellite height [km]", 1e-3 * row->satellite_height,
                  "0.001 to 1e6 km, in every row or none");
  if (!(fabs(row->azimuth) <= 2.0 * UM_PI))
    return refuse(at, "azimuth [deg]", row->azimuth / UM_DEG, "-360 to 360 deg");
  if (!(fabs(row->elevation) <= 0.5 * UM_PI))
    return refuse(at, "elevation [deg]", row->elevation / UM_DEG, "-90 to 90 deg");
  return UM_OK;
}

static enum um_status add_row(const struct place *at, const struct um_compare_row *row,
                              struct um_compare_set *set)
{
  struct um_context *context = at->context;
  struct um_compare_measurement m = {.t_tai = row->t_tai,
                                     .value = row->value,
                                     .sigma = row->sigma,
                                     .exposure = row->exposure,
                                     .flag = row->flag,
                                     .satellite_height = row->satellite_height,
                                     .azimuth = row->azimuth,
                                     .elevation = row->elevation,
                                     .line = at->line,
                                     .station = SIZE_MAX};
  enum um_compare_quantity quantity;
  UM_TRY(find_quantity(at, row->quantity, &quantity));
  UM_TRY(check_value(at, row, quantity));
  UM_TRY(check_geometry(at, row, set->made->independent));
  UM_TRY(check_name(at, "of", row->of == NULL ? "" : row->of, true));
  UM_TRY(check_name(at, "track", row->track, false));
  UM_TRY(check_name(at, "station", row->station, false));
  UM_TRY(um_compare_set_channel(context, set, quantity, row->of, &m.channel));
  UM_TRY(um_compare_set_track(context, set, row->track == NULL ? "" : row->track, &m.track));
  if (row->station != NULL && row->station[0] != '\0')
    UM_TRY(um_compare_set_station(context, set, row->station, &m.station));
  return um_compare_set_add(context, set, &m);
}

enum um_status um_compare_measurements_make(struct um_context *context, const char *name,
                                            const struct um_compare_row *row, size_t count,
                                            struct um_compare_measurements **out)
{
  struct um_compare_set set = {0};
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_compare_set_begin(context, name, "time", &set));
  set.made->independent = count > 0 && !isnan(row[0].satellite_height);
  for (size_t i = 0; i < count; i++) {
    const struct place at = {context, name, (int)i + 1};
    if (i % 4096 == 0) UM_CHECK(um_core_stop_check(context, "measurements were taken"));
    UM_CHECK(add_row(&at, &row[i], &set));
  }
  UM_CHECK(um_compare_set_finish(context, &set, out));
done:
  um_compare_set_abandon(context, &set);
  return status;
}
