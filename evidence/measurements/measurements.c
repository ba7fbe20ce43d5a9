/* The reader of measurement files. What holds between rows (order, uniqueness) is checked in set.c.
 */
#include "evidence/measurements/measurements.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "base/core/suggestions.h"
#include "evidence/measurements/import.h"
#include "evidence/measurements/set_group.h"
#include "orbit/time_form.h"

#define MAGNITUDE_MAX 40.0 /* [mag]; the Sun is -26.7, beyond 40 nothing is measured */

enum column {
  TIME,
  QUANTITY,
  OF,
  VALUE,
  SIGMA,
  EXPOSURE,
  FLAG,
  TRACK,
  HEIGHT,
  AZIMUTH,
  ELEVATION,
  STATION,
  COLUMNS
};                        /* TIME stands for any of enum um_orbit_time_form */
#define REQUIRED EXPOSURE /* those before it */

static const char *const column_names[COLUMNS] = {
    "time_utc",    "quantity",      "of",
    "value",       "sigma",         "exposure_s",
    "flag",        "track",         "satellite_height_km",
    "azimuth_deg", "elevation_deg", "station"};

/* The file being read and where its columns stand. */
struct reader {
  struct um_context *context;
  struct um_core_csv *csv;
  enum um_orbit_time_form form; /* of the times */
  size_t at[COLUMNS];           /* SIZE_MAX: absent */
};

/* Every name a column may have: those of times, then the others. */
#define ALL_NAMES (UM_ORBIT_TIME_FORMS + COLUMNS - 1)
static const char *name_at(size_t i)
{
  return i < UM_ORBIT_TIME_FORMS ? um_orbit_time_form_column((enum um_orbit_time_form)i)
                                 : column_names[i - UM_ORBIT_TIME_FORMS + 1];
}

/* A table of somebody else's: how it becomes a measurement file. UM_OK: it is none. */
static enum um_status refuse_foreign(struct um_context *context, const struct um_core_csv *csv)
{
  char *command = NULL;
  enum um_status status = um_compare_import_suggest(context, um_core_csv_name(csv), &command);
  if (status != UM_OK) return status == UM_ERR_INPUT ? UM_OK : status;
  status = um_core_fail(context, UM_ERR_INPUT,
                        "%s: header: no measurement file, but a table that can be made one: %s",
                        um_core_csv_name(csv), command);
  um_core_free(context, command);
  return status;
}

static enum um_status refuse_column(struct um_context *context, const struct um_core_csv *csv,
                                    const char *name)
{
  if (um_core_csv_find(csv, column_names[QUANTITY]) == SIZE_MAX &&
      um_core_csv_find(csv, column_names[VALUE]) == SIZE_MAX)
    UM_TRY(refuse_foreign(context, csv));
  struct um_core_words_guess guess = {.written = name};
  char accepted[400] = "", hint[UM_CORE_WORDS_HINT];
  for (size_t c = 0; c < ALL_NAMES; c++) {
    um_core_words_append(accepted, sizeof accepted, name_at(c));
    um_core_words_consider(&guess, name_at(c));
  }
  return um_core_fail(context, UM_ERR_INPUT, "%s: header: unknown column '%s'%s; accepted: %s",
                      um_core_csv_name(csv), name, um_core_words_hint(&guess, hint), accepted);
}

static enum um_status find_columns(struct reader *r)
{
  for (size_t i = 0; i < um_core_csv_columns(r->csv); i++) {
    size_t c = 0;
    while (c < ALL_NAMES && strcmp(um_core_csv_header(r->csv, i), name_at(c)) != 0) c++;
    if (c == ALL_NAMES) return refuse_column(r->context, r->csv, um_core_csv_header(r->csv, i));
  }
  UM_TRY(um_orbit_time_form_find(r->context, r->csv, &r->form, &r->at[TIME]));
  for (size_t c = TIME + 1; c < COLUMNS; c++) {
    if (c < REQUIRED)
      UM_TRY(um_core_csv_require(r->context, r->csv, column_names[c], &r->at[c]));
    else
      r->at[c] = um_core_csv_find(r->csv, column_names[c]);
  }
  size_t present = 0, absent = COLUMNS;
  for (size_t c = HEIGHT; c <= ELEVATION; c++) {
    if (r->at[c] != SIZE_MAX)
      present++;
    else if (absent == COLUMNS)
      absent = c;
  }
  if (present == 0 || present == 3) return UM_OK;
  return um_core_fail(r->context, UM_ERR_INPUT,
                      "%s: header: column '%s' is missing; accepted: satellite_height_km, "
                      "azimuth_deg and elevation_deg together, or none of them",
                      um_core_csv_name(r->csv), column_names[absent]);
}

static const char *field(const struct reader *r, size_t row, enum column c)
{
  return r->at[c] == SIZE_MAX ? "" : um_core_csv_text(r->csv, row, r->at[c]);
}

/* A number, or NaN where the column or the field is empty. */
static enum um_status optional_number(const struct reader *r, size_t row, enum column c,
                                      double *out)
{
  *out = NAN;
  if (field(r, row, c)[0] == '\0') return UM_OK;
  return um_core_csv_number(r->context, r->csv, row, r->at[c], out);
}

/* A number in [low, high]. */
static enum um_status check_range(const struct reader *r, size_t row, enum column c, double value,
                                  double low, double high, const char *accepted)
{
  if (value >= low && value <= high) return UM_OK;
  return um_core_csv_fail(r->context, r->csv, row, r->at[c], "%s; accepted: %s", field(r, row, c),
                          accepted);
}

/* Temperatures that name their unit. */
#define CELSIUS "temperature_C"
#define KELVIN  "temperature_K"

static enum um_status read_quantity(const struct reader *r, size_t row,
                                    enum um_compare_quantity *quantity)
{
  const char *text = field(r, row, QUANTITY);
  struct um_core_words_guess guess = {.written = text};
  char accepted[256] = "", hint[UM_CORE_WORDS_HINT];
  *quantity = UM_QUANTITY_TEMPERATURE;
  if (strcmp(text, CELSIUS) == 0 || strcmp(text, KELVIN) == 0) return UM_OK;
  for (int q = 0; q < UM_QUANTITY_COUNT; q++) {
    *quantity = (enum um_compare_quantity)q;
    if (strcmp(text, um_compare_quantity_name(*quantity)) == 0) return UM_OK;
    um_core_words_append(accepted, sizeof accepted, um_compare_quantity_name(*quantity));
    um_core_words_consider(&guess, um_compare_quantity_name(*quantity));
  }
  um_core_words_append(accepted, sizeof accepted, CELSIUS);
  um_core_words_append(accepted, sizeof accepted, KELVIN);
  um_core_words_consider(&guess, CELSIUS);
  um_core_words_consider(&guess, KELVIN);
  return um_core_csv_fail(r->context, r->csv, row, r->at[QUANTITY],
                          "unknown quantity '%s'%s; accepted: %s", text,
                          um_core_words_hint(&guess, hint), accepted);
}

/* A temperature as written, to [K]. */
static enum um_status read_temperature(const struct reader *r, size_t row, double *value)
{
  const char *text = field(r, row, VALUE);
  if (strcmp(field(r, row, QUANTITY), CELSIUS) == 0) {
    if (!(*value > -UM_ZERO_CELSIUS))
      return um_core_csv_fail(r->context, r->csv, row, r->at[VALUE],
                              "temperature %s C; accepted: above -273.15 C", text);
    *value += UM_ZERO_CELSIUS;
  }
  if (*value > 0.0) return UM_OK;
  return um_core_csv_fail(
      r->context, r->csv, row, r->at[VALUE],
      "temperature %s K; accepted: above 0 K (Celsius is the quantity " CELSIUS ")", text);
}

/* Temperatures whose unit is not named and that never reach UM_COMPARE_COLD are refused as Celsius:
 * what is so cold in every row is a cooled instrument, which can name its unit. Rows of the file
 * and of the set are the same. */
static enum um_status check_celsius(const struct reader *r, const struct um_compare_set *set)
{
  enum um_status status = UM_OK;
  double *warmest; /* [channel] of rows that name no unit, 0: none [K] */
  size_t *first;
  size_t n = set->channels.count;
  if (n == 0) return UM_OK;
  UM_TRY(um_core_allocate(r->context, n, sizeof *warmest, &warmest));
  UM_CHECK(um_core_allocate(r->context, n, sizeof *first, &first));
  for (size_t row = 0; row < set->made->count; row++) {
    const struct um_compare_measurement *m = &set->made->row[row];
    if (strcmp(field(r, row, QUANTITY), um_compare_quantity_name(UM_QUANTITY_TEMPERATURE)) != 0)
      continue;
    if (m->flag != 0) continue;
    if (warmest[m->channel] == 0.0) first[m->channel] = row;
    warmest[m->channel] = fmax(warmest[m->channel], m->value);
  }
  for (size_t c = 0; c < n && status == UM_OK; c++)
    if (warmest[c] > 0.0 && warmest[c] < UM_COMPARE_COLD)
      status = um_core_csv_fail(
          r->context, r->csv, first[c], r->at[VALUE],
          "temperature of '%s' is never above %.10g K, is it Celsius? accepted: %g K somewhere, or "
          "a quantity that names its unit, " CELSIUS " or " KELVIN,
          set->channels.text[c], warmest[c], UM_COMPARE_COLD);
  um_core_free(r->context, first);
done:
  um_core_free(r->context, warmest);
  return status;
}

static enum um_status read_value(const struct reader *r, size_t row,
                                 enum um_compare_quantity quantity,
                                 struct um_compare_measurement *m)
{
  UM_TRY(um_core_csv_number(r->context, r->csv, row, r->at[VALUE], &m->value));
  if (quantity == UM_QUANTITY_TEMPERATURE) UM_TRY(read_temperature(r, row, &m->value));
  if (um_compare_is_grey_body(quantity) && !(m->value > 0.0))
    return um_core_csv_fail(r->context, r->csv, row, r->at[VALUE], "%s %s %s; accepted: above 0",
                            um_compare_quantity_name(quantity), field(r, row, VALUE),
                            um_compare_quantity_unit(quantity));
  bool magnitude = quantity == UM_QUANTITY_MAGNITUDE_AB || quantity == UM_QUANTITY_MAGNITUDE_VEGA;
  if (magnitude && !(fabs(m->value) <= MAGNITUDE_MAX))
    return um_core_csv_fail(r->context, r->csv, row, r->at[VALUE],
                            "magnitude %s mag; accepted: -40 to 40 mag", field(r, row, VALUE));
  UM_TRY(optional_number(r, row, SIGMA, &m->sigma));
  if (m->sigma <= 0.0)
    return um_core_csv_fail(r->context, r->csv, row, r->at[SIGMA],
                            "%s %s; accepted: above 0, or empty where the scenario gives a noise "
                            "model",
                            field(r, row, SIGMA), um_compare_quantity_unit(quantity));
  return UM_OK;
}

static enum um_status read_flag(const struct reader *r, size_t row, int *flag)
{
  double value;
  UM_TRY(optional_number(r, row, FLAG, &value));
  *flag = 0;
  if (isnan(value)) return UM_OK;
  if (!(fabs(value) <= INT_MAX) || value != floor(value))
    return um_core_csv_fail(r->context, r->csv, row, r->at[FLAG],
                            "'%s' is not a whole number; accepted: 0 (use), any other (leave out)",
                            field(r, row, FLAG));
  *flag = (int)value;
  return UM_OK;
}

static enum um_status read_geometry(const struct reader *r, size_t row,
                                    struct um_compare_measurement *m)
{
  m->satellite_height = m->azimuth = m->elevation = NAN;
  if (r->at[HEIGHT] == SIZE_MAX) return UM_OK;
  for (enum column c = HEIGHT; c <= ELEVATION; c++)
    if (field(r, row, c)[0] == '\0')
      return um_core_csv_fail(r->context, r->csv, row, r->at[c],
                              "empty; accepted: satellite height, azimuth and elevation in every "
                              "row");
  double height, azimuth, elevation; /* [km], [deg], [deg] */
  UM_TRY(um_core_csv_number(r->context, r->csv, row, r->at[HEIGHT], &height));
  UM_TRY(um_core_csv_number(r->context, r->csv, row, r->at[AZIMUTH], &azimuth));
  UM_TRY(um_core_csv_number(r->context, r->csv, row, r->at[ELEVATION], &elevation));
  UM_TRY(check_range(r, row, HEIGHT, height, 1e-3, 1e6, "0.001 to 1e6 km"));
  UM_TRY(check_range(r, row, AZIMUTH, azimuth, -360.0, 360.0, "-360 to 360 deg"));
  UM_TRY(check_range(r, row, ELEVATION, elevation, -90.0, 90.0, "-90 to 90 deg"));
  m->satellite_height = 1e3 * height;
  m->azimuth = azimuth * UM_DEG;
  m->elevation = elevation * UM_DEG;
  return UM_OK;
}

/* The columns that hold names, which go on into tables and scripts of pictures; a place may be a
 * group, as "+x". */
static enum um_status check_names(const struct reader *r, size_t row)
{
  static const enum column names[] = {OF, TRACK, STATION};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    const char *name = field(r, row, names[i]);
    bool group = names[i] == OF;
    if (!(group ? um_core_name_is_safe_behind : um_core_name_is_safe)(name))
      return um_core_csv_fail(r->context, r->csv, row, r->at[names[i]], "'%.100s'; accepted: %s",
                              name, group ? UM_CORE_NAME_ACCEPTED_BEHIND : UM_CORE_NAME_ACCEPTED);
  }
  return UM_OK;
}

static enum um_status read_row(const struct reader *r, size_t row, struct um_compare_set *set)
{
  struct um_compare_measurement m = {.station = SIZE_MAX, .line = um_core_csv_line(r->csv, row)};
  enum um_compare_quantity quantity;
  char why[256];
  if (!um_orbit_time_form_parse(r->form, field(r, row, TIME), &m.t_tai, why, sizeof why))
    return um_core_csv_fail(r->context, r->csv, row, r->at[TIME], "%s", why);
  UM_TRY(read_quantity(r, row, &quantity));
  UM_TRY(check_names(r, row));
  if (field(r, row, OF)[0] == '\0')
    return um_core_csv_fail(r->context, r->csv, row, r->at[OF],
                            "empty; accepted: the name of a band, part, side, node, filter or "
                            "sensor");
  UM_TRY(um_compare_set_channel(r->context, set, quantity, field(r, row, OF), &m.channel));
  UM_TRY(um_compare_set_track(r->context, set, field(r, row, TRACK), &m.track));
  UM_TRY(read_value(r, row, quantity, &m));
  UM_TRY(optional_number(r, row, EXPOSURE, &m.exposure));
  if (m.exposure < 0.0)
    return um_core_csv_fail(r->context, r->csv, row, r->at[EXPOSURE],
                            "%s s; accepted: 0 s or more, or empty", field(r, row, EXPOSURE));
  UM_TRY(read_flag(r, row, &m.flag));
  UM_TRY(read_geometry(r, row, &m));
  if (field(r, row, STATION)[0] != '\0')
    UM_TRY(um_compare_set_station(r->context, set, field(r, row, STATION), &m.station));
  return um_compare_set_add(r->context, set, &m);
}

enum um_status um_compare_measurements_read(struct um_context *context, const char *path,
                                            struct um_compare_measurements **out)
{
  struct reader r = {.context = context};
  struct um_compare_set set = {0};
  enum um_status status;
  *out = NULL;
  UM_CHECK(um_core_csv_read(context, path, &r.csv));
  UM_CHECK(find_columns(&r));
  UM_CHECK(um_compare_set_begin(context, path, um_orbit_time_form_column(r.form), &set));
  for (size_t row = 0; row < um_core_csv_rows(r.csv); row++) {
    if (row % 4096 == 0) UM_CHECK(um_core_stop_check(context, "measurements were read"));
    UM_CHECK(read_row(&r, row, &set));
  }
  UM_CHECK(check_celsius(&r, &set));
  set.made->independent = r.at[HEIGHT] != SIZE_MAX;
  UM_CHECK(um_compare_set_finish(context, &set, out));
done:
  um_compare_set_abandon(context, &set);
  um_core_csv_destroy(&r.csv);
  return status;
}
