/* The reader of measurement files. What holds between rows (order, uniqueness) is checked in set.c.
 */
#include "compare/measurements.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "compare/set_impl.h"
#include "core/constants.h"
#include "core/csv.h"
#include "core/words.h"
#include "orbit/time.h"

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
};
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
  size_t at[COLUMNS]; /* SIZE_MAX: absent */
};

static enum um_status refuse_column(struct um_context *context, const struct um_core_csv *csv,
                                    const char *name)
{
  char accepted[320] = "", hint[96] = "";
  size_t nearest = COLUMNS, distance = SIZE_MAX;
  for (size_t c = 0; c < COLUMNS; c++) {
    um_core_words_append(accepted, sizeof accepted, column_names[c]);
    size_t d = um_core_words_distance(name, column_names[c]);
    if (!um_core_words_are_near(name, column_names[c]) || d >= distance) continue;
    nearest = c;
    distance = d;
  }
  if (nearest < COLUMNS) snprintf(hint, sizeof hint, "; did you mean '%s'?", column_names[nearest]);
  return um_core_fail(context, UM_ERR_INPUT, "%s: header: unknown column '%s'%s; accepted: %s",
                      um_core_csv_name(csv), name, hint, accepted);
}

static enum um_status find_columns(struct reader *r)
{
  for (size_t i = 0; i < um_core_csv_columns(r->csv); i++) {
    size_t c = 0;
    while (c < COLUMNS && strcmp(um_core_csv_header(r->csv, i), column_names[c]) != 0) c++;
    if (c == COLUMNS) return refuse_column(r->context, r->csv, um_core_csv_header(r->csv, i));
  }
  for (size_t c = 0; c < COLUMNS; c++) {
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

static enum um_status read_quantity(const struct reader *r, size_t row,
                                    enum um_compare_quantity *quantity)
{
  const char *text = field(r, row, QUANTITY);
  char accepted[160] = "";
  for (int q = 0; q < UM_QUANTITY_COUNT; q++) {
    *quantity = (enum um_compare_quantity)q;
    if (strcmp(text, um_compare_quantity_name(*quantity)) == 0) return UM_OK;
    um_core_words_append(accepted, sizeof accepted, um_compare_quantity_name(*quantity));
  }
  return um_core_csv_fail(r->context, r->csv, row, r->at[QUANTITY],
                          "unknown quantity '%s'; accepted: %s", text, accepted);
}

static enum um_status read_value(const struct reader *r, size_t row,
                                 enum um_compare_quantity quantity,
                                 struct um_compare_measurement *m)
{
  UM_TRY(um_core_csv_number(r->context, r->csv, row, r->at[VALUE], &m->value));
  if (quantity == UM_QUANTITY_TEMPERATURE && !(m->value > 0.0))
    return um_core_csv_fail(r->context, r->csv, row, r->at[VALUE],
                            "temperature %s K; accepted: above 0 K", field(r, row, VALUE));
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

static enum um_status read_row(const struct reader *r, size_t row, struct um_compare_set *set)
{
  struct um_compare_measurement m = {.station = SIZE_MAX, .line = um_core_csv_line(r->csv, row)};
  enum um_compare_quantity quantity;
  char why[160];
  if (!um_orbit_time_parse_field(field(r, row, TIME), &m.t_tai, why, sizeof why))
    return um_core_csv_fail(r->context, r->csv, row, r->at[TIME], "%s", why);
  UM_TRY(read_quantity(r, row, &quantity));
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
  UM_CHECK(um_compare_set_begin(context, path, column_names[TIME], &set));
  for (size_t row = 0; row < um_core_csv_rows(r.csv); row++) UM_CHECK(read_row(&r, row, &set));
  set.made->independent = r.at[HEIGHT] != SIZE_MAX;
  UM_CHECK(um_compare_set_finish(context, &set, out));
done:
  um_compare_set_abandon(context, &set);
  um_core_csv_destroy(&r.csv);
  return status;
}
