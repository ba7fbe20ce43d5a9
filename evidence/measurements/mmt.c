/* Import of text tracks of the Mini-MegaTORTORA survey. The format is described in series.h. */
#include "evidence/measurements/mmt.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "base/core/file.h"
#include "base/core/suggestions.h"
#include "evidence/measurements/set_group.h"
#include "orbit/time.h"

#define MMT_BYTES_MAX ((size_t)1 << 30)
#define MAGNITUDE_MAX 40.0 /* [mag] */

enum column {
  DATE,
  TIME,
  MAG,
  FILTER,
  STDMAG,
  PENUMBRA,
  DISTANCE,
  PHASE,
  CHANNEL,
  TRACK,
  SATELLITE,
  COLUMNS
};
#define REQUIRED STDMAG /* those before it */

static const char *const column_names[COLUMNS] = {"Date",    "Time",     "Mag",      "Filter",
                                                  "StdMag",  "Penumbra", "Distance", "Phase",
                                                  "Channel", "Track",    "Satellite"};

struct reader {
  struct um_context *context;
  const char *path;
  int line;
  size_t fields;      /* columns of a row; 0: not known yet */
  size_t at[COLUMNS]; /* place in a row; SIZE_MAX: absent */
  char *track;        /* of the '#' lines, borrowed from the text; NULL */
  char *satellite;    /* the one satellite of a column, borrowed; NULL */
  struct um_compare_set set;
  struct um_compare_mmt_point *point;
  size_t capacity;
};

/* Divide a line at blanks, in place; at most COLUMNS + 1 words. */
static size_t split(char *line, char *word[COLUMNS + 1])
{
  size_t n = 0;
  for (char *p = line; n <= COLUMNS;) {
    p += strspn(p, " \t\r");
    if (*p == '\0') break;
    word[n++] = p;
    p += strcspn(p, " \t\r");
    if (*p != '\0') *p++ = '\0';
  }
  return n;
}

static enum um_status read_columns(struct reader *r, size_t n, char **word)
{
  char accepted[160] = "";
  for (size_t c = 0; c < COLUMNS; c++) {
    um_core_words_append(accepted, sizeof accepted, column_names[c]);
    r->at[c] = SIZE_MAX;
  }
  for (size_t i = 0; i < n; i++) {
    size_t c = 0;
    while (c < COLUMNS && strcmp(word[i], column_names[c]) != 0) c++;
    if (c == COLUMNS || r->at[c] != SIZE_MAX)
      return um_core_fail(r->context, UM_ERR_INPUT,
                          "%s:%d: column '%s' is %s; accepted: %s, each once", r->path, r->line,
                          word[i], c == COLUMNS ? "unknown" : "there twice", accepted);
    r->at[c] = i;
  }
  for (size_t c = 0; c < REQUIRED; c++)
    if (r->at[c] == SIZE_MAX)
      return um_core_fail(r->context, UM_ERR_INPUT,
                          "%s:%d: column '%s' is missing; needed: Date, Time, Mag, Filter", r->path,
                          r->line, column_names[c]);
  r->fields = n;
  return UM_OK;
}

/* A line that began with '#': column names, the track's number, or something to step over. */
static enum um_status read_comment(struct reader *r, char *line)
{
  char *word[COLUMNS + 1];
  size_t n = split(line, word);
  if (n >= 2 && strcmp(word[0], "track:") == 0) r->track = word[1];
  if (n >= 1 && strcmp(word[0], column_names[DATE]) == 0) return read_columns(r, n, word);
  return UM_OK;
}

static enum um_status fail_field(const struct reader *r, enum column c, const char *text,
                                 const char *accepted)
{
  return um_core_fail(r->context, UM_ERR_INPUT, "%s:%d: column '%s': '%s'; accepted: %s", r->path,
                      r->line, column_names[c], text, accepted);
}

/* A number in [low, high], NaN where the column is absent. */
static enum um_status number(const struct reader *r, char **word, enum column c, double low,
                             double high, const char *accepted, double *out)
{
  *out = NAN;
  if (r->at[c] == SIZE_MAX) return UM_OK;
  if (um_core_number_parse(word[r->at[c]], out) && *out >= low && *out <= high) return UM_OK;
  return fail_field(r, c, word[r->at[c]], accepted);
}

static enum um_status read_point(struct reader *r, char **word)
{
  size_t i = r->set.made->count;
  if (i == r->capacity) {
    size_t capacity = 2 * i + 64;
    UM_TRY(um_core_reallocate(r->context, capacity, sizeof *r->point, &r->point));
    r->capacity = capacity;
  }
  struct um_compare_mmt_point *p = &r->point[i];
  double penumbra;
  UM_TRY(number(r, word, STDMAG, -MAGNITUDE_MAX, MAGNITUDE_MAX, "-40 to 40 mag",
                &p->standard_magnitude));
  UM_TRY(number(r, word, DISTANCE, 1.0, 1e6, "1 to 1e6 km", &p->distance));
  UM_TRY(number(r, word, PHASE, 0.0, 180.0, "0 to 180 deg", &p->phase));
  UM_TRY(number(r, word, PENUMBRA, 0.0, 1.0, "0 or 1", &penumbra));
  if (penumbra > 0.0 && penumbra < 1.0)
    return fail_field(r, PENUMBRA, word[r->at[PENUMBRA]], "0 or 1");
  p->distance *= 1e3;
  p->phase *= UM_DEG;
  p->penumbra = penumbra == 1.0;
  return UM_OK;
}

/* Words of a line that become names. */
static enum um_status check_name(const struct reader *r, enum column c, const char *text)
{
  if (um_core_name_is_safe(text)) return UM_OK;
  return fail_field(r, c, text, UM_CORE_NAME_ACCEPTED);
}

/* "TRACK/CHANNEL", or what there is of it. */
static enum um_status read_track(struct reader *r, char **word, size_t *track)
{
  const char *number_of = r->track == NULL ? "" : r->track, *camera = "";
  if (r->at[TRACK] != SIZE_MAX) number_of = word[r->at[TRACK]];
  if (r->at[CHANNEL] != SIZE_MAX) camera = word[r->at[CHANNEL]];
  UM_TRY(check_name(r, TRACK, number_of));
  UM_TRY(check_name(r, CHANNEL, camera));
  char *name;
  UM_TRY(um_core_asprintf(r->context, &name, "%s%s%s", number_of, camera[0] != '\0' ? "/" : "",
                          camera));
  enum um_status status = um_compare_set_track(r->context, &r->set, name, track);
  um_core_free(r->context, name);
  return status;
}

static enum um_status check_satellite(struct reader *r, char **word)
{
  if (r->at[SATELLITE] == SIZE_MAX) return UM_OK;
  if (r->satellite == NULL) r->satellite = word[r->at[SATELLITE]];
  if (strcmp(r->satellite, word[r->at[SATELLITE]]) == 0) return UM_OK;
  return um_core_fail(r->context, UM_ERR_INPUT,
                      "%s:%d: satellite %s, the rows before are of %s; accepted: one satellite",
                      r->path, r->line, word[r->at[SATELLITE]], r->satellite);
}

static enum um_status read_row(struct reader *r, char *line)
{
  char *word[COLUMNS + 1], time[64], why[160];
  size_t n = split(line, word);
  if (n == 0) return UM_OK;
  if (r->fields == 0)
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "%s:%d: a row before the line of column names; accepted: '# Date Time "
                        "StdMag Mag Filter Penumbra Distance Phase Channel Track' above the rows",
                        r->path, r->line);
  if (n != r->fields)
    return um_core_fail(r->context, UM_ERR_INPUT,
                        "%s:%d: %s%zu fields; accepted: %zu, as many as there are column names",
                        r->path, r->line, n > COLUMNS ? "more than " : "",
                        n > COLUMNS ? (size_t)COLUMNS : n, r->fields);
  struct um_compare_measurement m = {.sigma = NAN,
                                     .exposure = NAN,
                                     .satellite_height = NAN,
                                     .azimuth = NAN,
                                     .elevation = NAN,
                                     .line = r->line,
                                     .station = SIZE_MAX};
  snprintf(time, sizeof time, "%.30sT%.30s", word[r->at[DATE]], word[r->at[TIME]]);
  if (!um_orbit_time_parse_field(time, &m.t_tai, why, sizeof why))
    return um_core_fail(r->context, UM_ERR_INPUT, "%s:%d: column 'Time': %s", r->path, r->line,
                        why);
  UM_TRY(check_satellite(r, word));
  UM_TRY(number(r, word, MAG, -MAGNITUDE_MAX, MAGNITUDE_MAX, "-40 to 40 mag", &m.value));
  UM_TRY(read_point(r, word));
  UM_TRY(check_name(r, FILTER, word[r->at[FILTER]]));
  UM_TRY(um_compare_set_channel(r->context, &r->set, UM_QUANTITY_MAGNITUDE_VEGA,
                                word[r->at[FILTER]], &m.channel));
  UM_TRY(read_track(r, word, &m.track));
  return um_compare_set_add(r->context, &r->set, &m);
}

static enum um_status read_lines(struct reader *r, char *text, size_t length)
{
  if (memchr(text, '\0', length) != NULL)
    return um_core_fail(r->context, UM_ERR_INPUT, "%s: not a text file; accepted: MMT tracks",
                        r->path);
  for (char *p = text; *p != '\0'; r->line++) {
    char *end = strchr(p, '\n'), *next = end == NULL ? p + strlen(p) : end + 1;
    if (end != NULL) *end = '\0';
    char *line = p + strspn(p, " \t\r");
    UM_TRY(*line == '#' ? read_comment(r, line + 1) : read_row(r, line));
    p = next;
  }
  return UM_OK;
}

enum um_status um_compare_mmt_read(struct um_context *context, const char *path,
                                   struct um_compare_measurements **out,
                                   struct um_compare_mmt_point **points)
{
  struct reader r = {.context = context, .path = path, .line = 1};
  char *text = NULL;
  size_t length;
  enum um_status status;
  *out = NULL;
  if (points != NULL) *points = NULL;
  UM_CHECK(um_core_file_read(context, path, MMT_BYTES_MAX, &text, &length));
  UM_CHECK(um_compare_set_begin(context, path, "Time", &r.set));
  UM_CHECK(read_lines(&r, text, length));
  UM_CHECK(um_compare_set_finish(context, &r.set, out));
  if (points != NULL) {
    *points = r.point;
    r.point = NULL;
  }
done:
  um_compare_set_abandon(context, &r.set);
  UM_FREE(context, r.point, text);
  return status;
}

enum um_status um_compare_mmt_is(struct um_context *context, const char *path, bool *out)
{
  char *text = NULL, *save = NULL;
  size_t length;
  *out = false;
  UM_TRY(um_core_file_read(context, path, MMT_BYTES_MAX, &text, &length));
  for (char *line = strtok_r(text, "\n", &save); line != NULL && !*out;
       line = strtok_r(NULL, "\n", &save)) {
    char *word[COLUMNS + 1];
    bool mag = false, filter = false;
    line += strspn(line, " \t");
    if (*line != '#') continue;
    size_t n = split(line + 1, word);
    for (size_t i = 1; i < n; i++) {
      mag = mag || strcmp(word[i], column_names[MAG]) == 0;
      filter = filter || strcmp(word[i], column_names[FILTER]) == 0;
    }
    *out = n > 0 && strcmp(word[0], column_names[DATE]) == 0 && mag && filter;
  }
  um_core_free(context, text);
  return UM_OK;
}
