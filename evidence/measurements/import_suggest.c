/* The command that imports a table, guessed from its header and first row. */
#include <ctype.h>
#include <stdint.h>
#include <string.h>
#include <strings.h>

#include "base/core/number.h"
#include "evidence/measurements/foreign_table.h"
#include "evidence/measurements/import_impl.h"

/* Does a name hold a word, in any case, at its beginning, behind what is no letter, or as the next
 * of words written together? A word of two letters or less ends there. */
static bool holds(const char *name, const char *word)
{
  size_t n = strlen(word);
  for (const char *c = name; *c != '\0'; c++) {
    size_t i = 0;
    while (i < n && tolower((unsigned char)c[i]) == word[i]) i++;
    bool begins = c == name || !isalpha((unsigned char)c[-1]) ||
                  (islower((unsigned char)c[-1]) && isupper((unsigned char)*c));
    bool ends = n > 2 || !isalpha((unsigned char)word[n - 1]) || !isalpha((unsigned char)c[n]);
    if (i == n && begins && ends) return true;
  }
  return false;
}

static bool holds_any(const char *name, const char *const *words)
{
  for (; *words != NULL; words++)
    if (holds(name, *words)) return true;
  return false;
}

static bool ends_with(const char *name, const char *const *words)
{
  size_t n = strlen(name);
  for (; *words != NULL; words++) {
    size_t k = strlen(*words);
    if (n > k && strcasecmp(name + n - k, *words) == 0) return true;
  }
  return false;
}

static const char *const sigmas[] = {"err", "sig", "unc", "std", "e_", "d_", NULL};
static const char *const sigma_ends[] = {"err", "error", "sig", "sigma", "unc", "std", NULL};
static const char *const others[] = {"az",  "el",   "alt",   "ra",   "dec", "range",   "dist",
                                     "exp", "flag", "phase", "site", "id",  "airmass", "x",
                                     "y",   "snr",  "num",   "lat",  "lon", "track",   NULL};

/* Columns of the guess; SIZE_MAX: none. */
struct guess {
  size_t date, time, value, sigma;
};

static bool is_sigma(const char *name)
{
  return holds_any(name, sigmas) || ends_with(name, sigma_ends);
}

static bool is_number(const struct um_core_csv *csv, size_t column)
{
  double value;
  for (size_t row = 0; row < um_core_csv_rows(csv) && row < 100; row++)
    if (um_core_number_parse(um_core_csv_text(csv, row, column), &value)) return true;
  return false;
}

/* The time: a column that holds one; else a day and a clock side by side. */
static void guess_time(const struct um_core_csv *csv, struct guess *g)
{
  enum um_orbit_time_form form;
  char joined[80];
  g->date = g->time = SIZE_MAX;
  if (um_core_csv_rows(csv) == 0) return;
  for (size_t i = 0; i + 1 < um_core_csv_columns(csv); i++) {
    snprintf(joined, sizeof joined, "%.36s %.36s", um_core_csv_text(csv, 0, i),
             um_core_csv_text(csv, 0, i + 1));
    if (strchr(um_core_csv_text(csv, 0, i + 1), ':') == NULL ||
        !um_orbit_time_form_recognise(joined, &form))
      continue;
    g->date = i;
    g->time = i + 1;
    return;
  }
  for (size_t i = 0; i < um_core_csv_columns(csv) && g->time == SIZE_MAX; i++)
    if (um_orbit_time_form_recognise(um_core_csv_text(csv, 0, i), &form)) g->time = i;
}

static bool has_degrees(const char *column)
{
  return um_compare_import_unit(column, UM_QUANTITY_TEMPERATURE) != NULL;
}

/* The first of several columns that name degrees, as telemetry has them beside volts; SIZE_MAX:
 * there are not two. */
static size_t sensors(const struct um_core_csv *csv)
{
  size_t n = 0, first = SIZE_MAX;
  for (size_t i = 0; i < um_core_csv_columns(csv); i++) {
    const char *name = um_core_csv_header(csv, i);
    if (has_degrees(name) && !is_sigma(name) && is_number(csv, i) && n++ == 0) first = i;
  }
  return n > 1 ? first : SIZE_MAX;
}

static void guess_value(const struct um_core_csv *csv, struct guess *g)
{
  g->sigma = SIZE_MAX;
  g->value = sensors(csv);
  for (size_t i = 0; i < um_core_csv_columns(csv); i++) {
    const char *name = um_core_csv_header(csv, i);
    if (i == g->time || i == g->date || !is_number(csv, i)) continue;
    if (is_sigma(name)) {
      if (g->sigma == SIZE_MAX) g->sigma = i;
    } else if (g->value == SIZE_MAX && !holds_any(name, others)) {
      g->value = i;
    }
  }
}

/* One character, where there is room for it and the end. */
static void put_character(char *line, size_t size, char c)
{
  size_t n = strlen(line);
  if (n + 2 > size) return;
  line[n] = c;
  line[n + 1] = '\0';
}

/* One word of a command line, in quotes where a shell would part it. */
static void put_word(char *line, size_t size, const char *word)
{
  bool plain = *word != '\0';
  for (const char *c = word; *c != '\0'; c++)
    plain = plain && (isalnum((unsigned char)*c) || strchr("._/+-=:,@", *c) != NULL);
  if (!plain) put_character(line, size, '\'');
  for (const char *c = word; *c != '\0'; c++) {
    for (const char *quote = "'\\'"; *c == '\'' && *quote != '\0'; quote++)
      put_character(line, size, *quote); /* ' becomes '\'' */
    put_character(line, size, *c);
  }
  if (!plain) put_character(line, size, '\'');
}

static void put(char *line, size_t size, const char *option, const char *word)
{
  size_t n = strlen(line);
  snprintf(line + n, size - n, " %s ", option);
  put_word(line, size, word);
}

static bool is_temperature(const char *column)
{
  static const char *const words[] = {"temp", "t_", NULL};
  return holds_any(column, words) || has_degrees(column);
}

/* All columns of temperatures: of one the place is said beside it, of several in one list. */
static void put_temperatures(const struct um_core_csv *csv, char *line, size_t size)
{
  char list[1200] = "";
  size_t n = 0, used = 0, first = 0;
  bool unit = true;
  for (size_t i = 0; i < um_core_csv_columns(csv); i++) {
    const char *column = um_core_csv_header(csv, i);
    if (!is_temperature(column) || is_sigma(column) || !is_number(csv, i) ||
        strchr(column, ',') != NULL)
      continue;
    int more = snprintf(list + used, sizeof list - used, "%s%s=PLACE", n > 0 ? "," : "", column);
    if (more < 0 || used + (size_t)more >= sizeof list) {
      list[used] = '\0';
      break;
    }
    used += (size_t)more;
    if (n++ == 0) first = i;
    unit = unit && has_degrees(column);
  }
  put(line, size, "--temperature", n > 1 ? list : um_core_csv_header(csv, first));
  if (n <= 1) put(line, size, "--of", "PLACE");
  if (!unit) put(line, size, "--unit", "K");
}

/* The value's option, and what has to be said beside it. */
static void put_value(const struct um_core_csv *csv, char *line, size_t size, const char *column)
{
  static const char *const fluxes[] = {"flux", "irradiance", "intensity", NULL};
  static const char *const counts[] = {"count", "adu", "rate", NULL};
  char band[64];
  if (is_temperature(column)) {
    put_temperatures(csv, line, size);
  } else if (holds_any(column, fluxes)) {
    put(line, size, "--flux", column);
    put(line, size, "--unit", "W/m2");
    put(line, size, "--band", "BAND");
  } else if (holds_any(column, counts)) {
    put(line, size, "--counts", column);
    put(line, size, "--of", "SENSOR");
  } else {
    bool named = um_compare_import_band(column, band, sizeof band);
    put(line, size, "--magnitude", column);
    if (!named) put(line, size, "--band", "BAND");
    if (!named || um_compare_import_system(band) == NULL) put(line, size, "--system", "vega");
  }
}

/* "lc-measured.csv" of "dir/lc.csv". */
static void put_output(char *line, size_t size, const char *path)
{
  char name[300];
  const char *slash = strrchr(path, '/'), *plain = slash == NULL ? path : slash + 1;
  const char *dot = strrchr(plain, '.');
  size_t n = dot == NULL || dot == plain ? strlen(plain) : (size_t)(dot - plain);
  snprintf(name, sizeof name, "%.*s-measured.csv", (int)(n < 250 ? n : 250), plain);
  put(line, size, "-o", name);
}

enum um_status um_compare_import_suggest(struct um_context *context, const char *path, char **out)
{
  struct um_core_csv *csv = NULL;
  struct guess g;
  char line[2000] = "umbra import ", time[300];
  *out = NULL;
  UM_TRY(um_compare_foreign_table_read(context, path, &csv));
  if (um_core_csv_find(csv, "quantity") != SIZE_MAX && um_core_csv_find(csv, "value") != SIZE_MAX) {
    um_core_csv_destroy(&csv);
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: is a measurement file as it stands; accepted: another table", path);
  }
  guess_time(csv, &g);
  guess_value(csv, &g);
  enum um_status status;
  if (g.time == SIZE_MAX || g.value == SIZE_MAX) {
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: no column looks like %s; accepted: a table with a time (UTC, Julian "
                          "date, POSIX seconds) and a value in each row",
                          path, g.time == SIZE_MAX ? "a time" : "a value");
  } else {
    snprintf(time, sizeof time, "%s%s%s", g.date == SIZE_MAX ? "" : um_core_csv_header(csv, g.date),
             g.date == SIZE_MAX ? "" : "+", um_core_csv_header(csv, g.time));
    put_word(line, sizeof line, path);
    put(line, sizeof line, "--time", time);
    put_value(csv, line, sizeof line, um_core_csv_header(csv, g.value));
    if (g.sigma != SIZE_MAX) put(line, sizeof line, "--sigma", um_core_csv_header(csv, g.sigma));
    put_output(line, sizeof line, path);
    status = um_core_strdup(context, line, out);
  }
  um_core_csv_destroy(&csv);
  return status;
}
