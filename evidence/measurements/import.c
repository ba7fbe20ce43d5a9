/* Measurements out of a table with any header. Rules of single values are those of the reader of
 * measurement files; what holds between rows is checked in set.c. */
#include "evidence/measurements/import.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "base/core/suggestions.h"
#include "evidence/measurements/foreign_table.h"
#include "evidence/measurements/import_impl.h"
#include "evidence/measurements/set_group.h"

/* Units of values: value = factor x number + offset, in the quantity's unit. */
static const struct unit {
  const char *name;
  enum um_compare_quantity quantity;
  double factor, offset;
} units[] = {
    {"W/m2", UM_QUANTITY_BAND_IRRADIANCE, 1.0, 0.0},
    {"W/m^2", UM_QUANTITY_BAND_IRRADIANCE, 1.0, 0.0},
    {"W/cm2", UM_QUANTITY_BAND_IRRADIANCE, 1e4, 0.0},
    {"erg/s/cm2", UM_QUANTITY_BAND_IRRADIANCE, 1e-3, 0.0},
    {"W/sr", UM_QUANTITY_RADIANT_INTENSITY, 1.0, 0.0},
    {"K", UM_QUANTITY_TEMPERATURE, 1.0, 0.0},
    {"C", UM_QUANTITY_TEMPERATURE, 1.0, UM_ZERO_CELSIUS},
    {"1/s", UM_QUANTITY_COUNT_RATE, 1.0, 0.0},
};
#define UNITS (sizeof units / sizeof *units)

/* A column of values, and what they are of. */
struct value {
  size_t column;
  const char *of;
  struct unit unit;
};

/* The table, where its columns stand, and what the values are. */
struct importer {
  struct um_context *context;
  struct um_core_csv *csv;
  struct um_compare_imported *found;
  size_t date, time, sigma, flag, exposure, track; /* SIZE_MAX: absent */
  enum um_compare_quantity quantity;
  struct value *value; /* [nvalue] one, or a column a place */
  size_t nvalue;
  char *places;                        /* texts of those */
  enum um_compare_import_frame *frame; /* [rows] NULL: one value a row */
};

enum um_status um_compare_import_column(struct um_context *context, const struct um_core_csv *csv,
                                        const char *name, size_t *index)
{
  char has[500] = "", hint[UM_CORE_WORDS_HINT];
  struct um_core_words_guess guess = {.written = name};
  *index = um_core_csv_find(csv, name);
  if (*index != SIZE_MAX) return UM_OK;
  for (size_t i = 0; i < um_core_csv_columns(csv); i++) {
    um_core_words_append(has, sizeof has, um_core_csv_header(csv, i));
    um_core_words_consider(&guess, um_core_csv_header(csv, i));
  }
  return um_core_fail(context, UM_ERR_INPUT, "%s: no column '%.80s'%s; the file has: %s",
                      um_core_csv_name(csv), name, um_core_words_hint(&guess, hint), has);
}

static enum um_status optional_column(struct importer *r, const char *name, size_t *index)
{
  *index = SIZE_MAX;
  return name == NULL ? UM_OK : um_compare_import_column(r->context, r->csv, name, index);
}

/* A column, or DATE+TIME. */
static enum um_status time_columns(struct importer *r, const char *name)
{
  char *first;
  r->date = SIZE_MAX;
  if (name == NULL)
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "%s: which column is the time? accepted: --time COLUMN, or DATE+TIME",
                        um_core_csv_name(r->csv));
  const char *plus = strchr(name, '+');
  if (plus == NULL || um_core_csv_find(r->csv, name) != SIZE_MAX)
    return um_compare_import_column(r->context, r->csv, name, &r->time);
  UM_TRY(um_core_asprintf(r->context, &first, "%.*s", (int)(plus - name), name));
  enum um_status status = um_compare_import_column(r->context, r->csv, first, &r->date);
  um_core_free(r->context, first);
  UM_TRY(status);
  return um_compare_import_column(r->context, r->csv, plus + 1, &r->time);
}

/* The one kind of value that is said. */
static enum um_status value_column(struct importer *r, struct um_compare_columns *c,
                                   const char **column)
{
  const char *said[] = {c->magnitude, c->flux, c->counts, c->temperature};
  static const enum um_compare_quantity quantities[] = {
      UM_QUANTITY_MAGNITUDE_VEGA, UM_QUANTITY_BAND_IRRADIANCE, UM_QUANTITY_COUNT_RATE,
      UM_QUANTITY_TEMPERATURE};
  size_t n = 0;
  for (size_t i = 0; i < 4; i++) {
    if (said[i] == NULL) continue;
    *column = said[i];
    r->quantity = quantities[i];
    n++;
  }
  if (n == 1) return UM_OK;
  return um_core_fail(r->context, UM_ERR_INPUT,
                      "%s: %s accepted: one of --magnitude, --flux, --counts, --temperature "
                      "COLUMN",
                      um_core_csv_name(r->csv),
                      n == 0 ? "which column is the value?" : "more than one kind of value;");
}

/* Takes `tail` off the end of a text of *length characters; false: it does not stand there. */
static bool take_end(const char *text, size_t *length, const char *tail)
{
  size_t n = strlen(tail);
  if (*length < n || strncmp(text + *length - n, tail, n) != 0) return false;
  *length -= n;
  return true;
}

/* "_C", "(K)", "[degC]", "[W/m2]" at the end of a column's name. */
const char *um_compare_import_unit(const char *column, enum um_compare_quantity quantity)
{
  size_t n = strlen(column), end = n;
  while (end > 0 && strchr(")] ", column[end - 1]) != NULL) end--;
  for (size_t i = 0; i < UNITS; i++) {
    size_t before = end;
    if (!take_end(column, &before, units[i].name)) continue;
    if (units[i].quantity == UM_QUANTITY_TEMPERATURE && !take_end(column, &before, "deg"))
      (void)take_end(column, &before, "\xC2\xB0"); /* the sign of a degree */
    if (before > 0 && strchr("_([ ", column[before - 1]) != NULL &&
        (units[i].quantity == quantity || (quantity == UM_QUANTITY_BAND_IRRADIANCE &&
                                           units[i].quantity == UM_QUANTITY_RADIANT_INTENSITY)))
      return units[i].name;
  }
  return NULL;
}

static enum um_status choose_unit(struct importer *r, struct um_compare_columns *c,
                                  const char *column, struct value *value)
{
  char accepted[120] = "";
  value->unit = (struct unit){NULL, r->quantity, 1.0, 0.0};
  if (um_compare_is_magnitude(r->quantity)) {
    if (c->unit == NULL) return UM_OK;
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "--unit %s: magnitudes have none; accepted: --system ab or --system vega",
                        c->unit);
  }
  bool light = r->quantity == UM_QUANTITY_BAND_IRRADIANCE;
  const char *unit = c->unit != NULL ? c->unit : um_compare_import_unit(column, r->quantity);
  if (r->nvalue == 1) c->unit = unit;
  if (unit == NULL && r->quantity == UM_QUANTITY_COUNT_RATE) return UM_OK;
  for (size_t i = 0; i < UNITS; i++) {
    bool fits = units[i].quantity == r->quantity ||
                (light && units[i].quantity == UM_QUANTITY_RADIANT_INTENSITY);
    if (!fits) continue;
    um_core_words_append(accepted, sizeof accepted, units[i].name);
    if (unit == NULL || strcmp(unit, units[i].name) != 0) continue;
    value->unit = units[i];
    r->quantity = units[i].quantity;
    return UM_OK;
  }
  return um_core_fail(r->context, UM_ERR_INPUT, "%s: column '%s': unit %s; accepted: --unit %s",
                      um_core_csv_name(r->csv), column, unit == NULL ? "not said" : unit, accepted);
}

static enum um_status check_of(struct importer *r, const char *of)
{
  if (um_core_name_is_safe_behind(of) && of[0] != '\0') return UM_OK;
  return um_core_fail(r->context, UM_ERR_INPUT, "'%.100s'; accepted: " UM_CORE_NAME_ACCEPTED_BEHIND,
                      of);
}

/* What the values are of: a band, a place, a sensor. */
static enum um_status choose_of(struct importer *r, struct um_compare_columns *c,
                                const char *column)
{
  bool light = r->quantity != UM_QUANTITY_TEMPERATURE && r->quantity != UM_QUANTITY_COUNT_RATE;
  if (light && c->of != NULL)
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "--of %s: is for temperatures and counts; accepted: --band BAND", c->of);
  if (!light && c->band != NULL)
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "--band %s: is for magnitudes and fluxes; accepted: --of %s", c->band,
                        r->quantity == UM_QUANTITY_TEMPERATURE ? "PLACE" : "SENSOR");
  char *name = r->found->name;
  if (um_compare_is_magnitude(r->quantity) && c->band == NULL &&
      um_compare_import_band(column, name, sizeof r->found->name))
    c->band = name;
  const char *of = r->value[0].of = light ? c->band : c->of;
  if (of == NULL)
    return um_core_fail(
        r->context, UM_ERR_INPUT, "%s: column '%s': %s accepted: %s", um_core_csv_name(r->csv),
        column, light ? "of which band of the scenario is it?" : "what is it of?",
        light                                    ? "--band BAND"
        : r->quantity == UM_QUANTITY_TEMPERATURE ? "--of PLACE, as temperatures.csv calls it"
                                                 : "--of SENSOR, as the scenario calls it");
  return check_of(r, of);
}

static enum um_status choose_system(struct importer *r, struct um_compare_columns *c,
                                    const char *column)
{
  if (!um_compare_is_magnitude(r->quantity)) {
    if (c->system == NULL) return UM_OK;
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "--system %s: is for magnitudes; accepted: --magnitude COLUMN beside it",
                        c->system);
  }
  if (c->system == NULL) c->system = um_compare_import_system(c->band);
  if (c->system == NULL) {
    char name[64];
    if (um_compare_import_band(column, name, sizeof name))
      c->system = um_compare_import_system(name);
  }
  if (c->system != NULL && strcmp(c->system, "ab") == 0)
    r->quantity = UM_QUANTITY_MAGNITUDE_AB;
  else if (c->system == NULL || strcmp(c->system, "vega") != 0)
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "%s: column '%s': magnitudes of system %s accepted: --system vega (as of "
                        "Johnson, Cousins and Gaia filters), --system ab (SDSS, LSST)",
                        um_core_csv_name(r->csv), column,
                        c->system == NULL ? "AB or Vega?" : "that is unknown;");
  return UM_OK;
}

/* COLUMN=PLACE,COLUMN=PLACE,...: a column each, which may have a unit each. */
static enum um_status place_columns(struct importer *r, struct um_compare_columns *c)
{
  char *rest;
  if (c->of != NULL)
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "--of %s: beside --temperature COLUMN=PLACE; accepted: one of the two",
                        c->of);
  UM_TRY(um_core_strdup(r->context, c->temperature, &r->places));
  r->nvalue = 1;
  for (const char *comma = r->places; (comma = strchr(comma, ',')) != NULL; comma++) r->nvalue++;
  UM_TRY(um_core_allocate(r->context, r->nvalue, sizeof *r->value, &r->value));
  rest = r->places;
  for (size_t i = 0; i < r->nvalue; i++) {
    char *column = rest, *end = rest + strcspn(rest, ","), *equals;
    rest = *end == ',' ? end + 1 : end;
    *end = '\0';
    equals = strrchr(column, '=');
    if (equals == NULL || equals == column)
      return um_core_fail(r->context, UM_ERR_INPUT,
                          "--temperature: '%.80s'; accepted: COLUMN=PLACE,COLUMN=PLACE,...",
                          column);
    *equals = '\0';
    r->value[i].of = equals + 1;
    UM_TRY(um_compare_import_column(r->context, r->csv, column, &r->value[i].column));
    UM_TRY(choose_unit(r, c, column, &r->value[i]));
    UM_TRY(check_of(r, equals + 1));
  }
  return UM_OK;
}

static enum um_status one_column(struct importer *r, struct um_compare_columns *c,
                                 const char *column)
{
  r->nvalue = 1;
  UM_TRY(um_core_allocate(r->context, 1, sizeof *r->value, &r->value));
  UM_TRY(um_compare_import_column(r->context, r->csv, column, &r->value->column));
  UM_TRY(choose_unit(r, c, column, r->value));
  UM_TRY(choose_of(r, c, column));
  return choose_system(r, c, column);
}

static enum um_status find_columns(struct importer *r)
{
  struct um_compare_columns *c = &r->found->columns;
  const char *column = NULL;
  UM_TRY(time_columns(r, c->time));
  UM_TRY(value_column(r, c, &column));
  bool wide = c->temperature != NULL && strchr(column, '=') != NULL &&
              um_core_csv_find(r->csv, column) == SIZE_MAX;
  UM_TRY(wide ? place_columns(r, c) : one_column(r, c, column));
  UM_TRY(optional_column(r, c->sigma, &r->sigma));
  UM_TRY(optional_column(r, c->flag, &r->flag));
  UM_TRY(optional_column(r, c->exposure, &r->exposure));
  return optional_column(r, c->track, &r->track);
}

static bool is_empty(const char *text)
{
  static const char *const words[] = {"", "nan", "-", "--", "null", "none", "indef", "n/a"};
  for (size_t i = 0; i < sizeof words / sizeof *words; i++)
    if (strcasecmp(text, words[i]) == 0) return true;
  return false;
}

static enum um_status read_time(struct importer *r, size_t row, double *t)
{
  char joined[80], why[256];
  const char *text = um_core_csv_text(r->csv, row, r->time);
  if (r->date != SIZE_MAX) {
    snprintf(joined, sizeof joined, "%s %s", um_core_csv_text(r->csv, row, r->date), text);
    text = joined;
  }
  if (row == 0 && !um_orbit_time_form_recognise(text, &r->found->form))
    return um_core_csv_fail(r->context, r->csv, row, r->time,
                            "'%.60s' is no time that is known; accepted: UTC as "
                            "2016-09-21T20:33:00.000Z, a Julian date, a modified one, POSIX "
                            "seconds (not milliseconds)",
                            text);
  if (um_orbit_time_form_parse(r->found->form, text, t, why, sizeof why)) return UM_OK;
  return um_core_csv_fail(r->context, r->csv, row, r->time, "%s", why);
}

/* A number of an optional column, NaN where it is empty. */
static enum um_status read_optional(struct importer *r, size_t row, size_t column, double *out)
{
  *out = NAN;
  if (column == SIZE_MAX || is_empty(um_core_csv_text(r->csv, row, column))) return UM_OK;
  return um_core_csv_number(r->context, r->csv, row, column, out);
}

static enum um_status read_value(struct importer *r, size_t row, const struct value *value,
                                 struct um_compare_measurement *m)
{
  double exposure, flag;
  UM_TRY(um_core_csv_number(r->context, r->csv, row, value->column, &m->value));
  m->value = value->unit.factor * m->value + value->unit.offset;
  UM_TRY(um_compare_import_check(r->context, r->csv, row, value->column, r->quantity, m->value));
  UM_TRY(read_optional(r, row, r->sigma, &m->sigma));
  if (m->sigma <= 0.0)
    return um_core_csv_fail(r->context, r->csv, row, r->sigma, "%s; accepted: above 0, or empty",
                            um_core_csv_text(r->csv, row, r->sigma));
  m->sigma *= value->unit.factor;
  UM_TRY(read_optional(r, row, r->exposure, &exposure));
  if (exposure < 0.0)
    return um_core_csv_fail(r->context, r->csv, row, r->exposure, "%s s; accepted: 0 s or more",
                            um_core_csv_text(r->csv, row, r->exposure));
  m->exposure = exposure;
  UM_TRY(read_optional(r, row, r->flag, &flag));
  if (isnan(flag)) return UM_OK;
  if (!(fabs(flag) <= INT_MAX) || flag != floor(flag))
    return um_core_csv_fail(r->context, r->csv, row, r->flag,
                            "'%s'; accepted: 0 (use), another whole number (leave out)",
                            um_core_csv_text(r->csv, row, r->flag));
  m->flag = (int)flag;
  return UM_OK;
}

/* A value of a row with its place in the table. */
struct dated {
  double t;
  size_t row, value;
};

static int by_time(const void *a, const void *b)
{
  const struct dated *x = a, *y = b;
  if (x->t != y->t) return x->t < y->t ? -1 : 1;
  if (x->row != y->row) return x->row < y->row ? -1 : 1;
  return x->value < y->value ? -1 : 1;
}

static enum um_status add_rows(struct importer *r, struct dated *dated, size_t n,
                               struct um_compare_set *set)
{
  for (size_t i = 0; i < n; i++) {
    size_t row = dated[i].row;
    struct um_compare_measurement m = {.t_tai = dated[i].t,
                                       .station = SIZE_MAX,
                                       .line = um_core_csv_line(r->csv, row),
                                       .satellite_height = NAN,
                                       .azimuth = NAN,
                                       .elevation = NAN};
    const char *track = r->track == SIZE_MAX ? "" : um_core_csv_text(r->csv, row, r->track);
    if (i % 4096 == 0) UM_TRY(um_core_stop_check(r->context, "measurements were imported"));
    if (!um_core_name_is_safe(track))
      return um_core_csv_fail(r->context, r->csv, row, r->track,
                              "'%.100s'; accepted: " UM_CORE_NAME_ACCEPTED, track);
    const struct value *value = &r->value[dated[i].value];
    UM_TRY(read_value(r, row, value, &m));
    if (r->frame != NULL && r->frame[row] != UM_IMPORT_FRAME_GOOD)
      m.flag = m.flag != 0 ? m.flag : 1;
    UM_TRY(um_compare_set_channel(r->context, set, r->quantity, value->of, &m.channel));
    UM_TRY(um_compare_set_track(r->context, set, track, &m.track));
    UM_TRY(um_compare_set_add(r->context, set, &m));
  }
  return UM_OK;
}

/* A row of zeros that are no temperatures is left out, another is flagged. */
static bool is_left_out(const struct importer *r, size_t row, const struct value *value)
{
  bool zeros = r->frame != NULL && r->frame[row] == UM_IMPORT_FRAME_ZEROS;
  return (zeros && value->unit.offset == 0.0) ||
         is_empty(um_core_csv_text(r->csv, row, value->column));
}

/* Of rows at one time the first, as a receiver's log may have two. */
static size_t once(struct dated *dated, size_t n, size_t *doubled)
{
  size_t kept = 0, first = 0, last = SIZE_MAX;
  for (size_t i = 0; i < n; i++) {
    if (i == 0 || dated[i].t != dated[i - 1].t) first = dated[i].row;
    if (dated[i].row == first) {
      dated[kept++] = dated[i];
    } else if (dated[i].row != last) {
      last = dated[i].row;
      ++*doubled;
    }
  }
  return kept;
}

static enum um_status read_rows(struct importer *r, struct um_compare_set *set)
{
  enum um_status status;
  struct dated *dated = NULL;
  size_t n = 0, rows = um_core_csv_rows(r->csv);
  double before = -INFINITY, t = 0.0;
  UM_CHECK(um_core_allocate(r->context, rows * r->nvalue + 1, sizeof *dated, &dated));
  for (size_t row = 0; row < rows; row++) {
    UM_CHECK(read_time(r, row, &t));
    bool any = false;
    for (size_t v = 0; v < r->nvalue; v++) {
      if (is_left_out(r, row, &r->value[v])) {
        r->found->empty++;
        continue;
      }
      dated[n++] = (struct dated){t, row, v};
      any = true;
    }
    r->found->sorted = r->found->sorted || (any && t < before);
    if (any) before = t;
  }
  if (r->found->sorted) qsort(dated, n, sizeof *dated, by_time);
  if (r->nvalue > 1) n = once(dated, n, &r->found->doubled);
  UM_CHECK(add_rows(r, dated, n, set));
done:
  um_core_free(r->context, dated);
  return status;
}

/* Which rows of a table of several sensors are no readings. */
static enum um_status judge_frames(struct importer *r)
{
  enum um_status status;
  size_t *column = NULL;
  if (r->nvalue < 2) return UM_OK;
  UM_CHECK(um_core_allocate(r->context, r->nvalue, sizeof *column, &column));
  for (size_t v = 0; v < r->nvalue; v++) column[v] = r->value[v].column;
  UM_CHECK(um_compare_import_frames(r->context, r->csv, column, r->nvalue, &r->frame));
  for (size_t row = 0; row < um_core_csv_rows(r->csv); row++) {
    r->found->zeros += r->frame[row] == UM_IMPORT_FRAME_ZEROS;
    r->found->held += r->frame[row] == UM_IMPORT_FRAME_HELD;
  }
done:
  um_core_free(r->context, column);
  return status;
}

enum um_status um_compare_import(struct um_context *context, const char *path,
                                 const struct um_compare_columns *columns,
                                 struct um_compare_imported *found,
                                 struct um_compare_measurements **out)
{
  struct importer r = {.context = context, .found = found};
  struct um_compare_set set = {0};
  enum um_status status;
  *out = NULL;
  *found = (struct um_compare_imported){.columns = *columns};
  UM_CHECK(um_compare_foreign_table_read(context, path, &r.csv));
  UM_CHECK(find_columns(&r));
  UM_CHECK(judge_frames(&r));
  UM_CHECK(um_compare_set_begin(context, path, "time", &set));
  UM_CHECK(read_rows(&r, &set));
  UM_CHECK(um_compare_set_finish(context, &set, out));
done:
  um_compare_set_abandon(context, &set);
  UM_FREE(context, r.value, r.places, r.frame);
  um_core_csv_destroy(&r.csv);
  return status;
}
