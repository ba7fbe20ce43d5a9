/* A map of the Earth from netCDF, in a child process: the library meets files of any origin.
 *
 * Variables lat and lon [degrees], and time in "days since ..." (or ctime, months 1 to 12, of a
 * climatology); quantities with the axes (time, lat, lon) or (lat, lon). CERES EBAF calls them
 * toa_sw_all_mon and solar_mon, whose ratio is the albedo, and toa_lw_all_mon; in a climatology
 * they end in _clim. Of a file with many years, a calendar month within half a year of the
 * scenario's date is taken alone; the others are means over the years, of the albedo a ratio of
 * sums. */
#include <math.h>
#include <netcdf.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/child.h"
#include "base/core/constants.h"
#include "environment/knocke.h"
#include "environment/map_impl.h"

#define SECONDS    120.0 /* [s] */
#define MEGABYTE   2048
#define TIMES_MOST 20000
#define DARK       5.0   /* mean insolation below which a ratio says nothing [W/m^2] */
#define HALF_YEAR  183.0 /* [d] */
#define TEXT       400

/* What the child sends first; then latitudes, longitudes, months and the quantities that it has. */
struct header {
  char message[TEXT]; /* "": all is well */
  int32_t nlatitude, nlongitude, nmonth;
  int32_t has[UM_MAP_QUANTITIES];
};

/* Quantities are made of one variable, or of a ratio of two. */
static const struct {
  int quantity;
  const char *name, *over; /* over NULL: taken as it is */
  double unit;             /* of the variable in that of the quantity */
} sources[] = {
    {UM_MAP_ALBEDO, "albedo", NULL, 1.0},
    {UM_MAP_ALBEDO, "toa_sw_all_mon", "solar_mon", 1.0},
    {UM_MAP_ALBEDO, "toa_sw_all_clim", "solar_clim", 1.0},
    {UM_MAP_LONGWAVE, "olr", NULL, 1.0},
    {UM_MAP_LONGWAVE, "toa_lw_all_mon", NULL, 1.0},
    {UM_MAP_LONGWAVE, "toa_lw_all_clim", NULL, 1.0},
    {UM_MAP_BRIGHTNESS, "brightness_temperature", NULL, 1.0},
    {UM_MAP_SURFACE, "surface_temperature", NULL, 1.0},
    {UM_MAP_CLOUD, "cloud_fraction", NULL, 1.0},
    {UM_MAP_CLOUD, "cldarea_total_daynight_mon", NULL, 0.01},
    {UM_MAP_CLOUD, "cldarea_total_daynight_clim", NULL, 0.01},
};

struct reader {
  int file, latitude_axis, longitude_axis, time_axis; /* dimensions; time -1: there is none */
  size_t nlatitude, nlongitude, ntime;
  double *latitude, *longitude; /* in degrees, as in the file */
  double *day;                  /* [ntime] since 2000-03-01 0 h */
  int *calendar;                /* [ntime] month 0..11 */
  double wanted;                /* date of the scenario, as day */
  char *message;                /* [TEXT] */
};

#define FAIL(reader, ...) (snprintf((reader)->message, TEXT, __VA_ARGS__), false)

static bool axis_values(struct reader *r, const char *const *names, int *dimension, size_t *n,
                        double **out)
{
  int variable = -1, naxis = 0, axis[NC_MAX_VAR_DIMS];
  const char *name = names[0];
  for (int i = 0; names[i] != NULL && variable < 0; i++)
    if (nc_inq_varid(r->file, names[i], &variable) == NC_NOERR)
      name = names[i];
    else
      variable = -1;
  if (variable < 0) return FAIL(r, "no variable '%s'; accepted: lat, lon and time", name);
  if (nc_inq_var(r->file, variable, NULL, NULL, &naxis, axis, NULL) != NC_NOERR || naxis != 1 ||
      nc_inq_dimlen(r->file, axis[0], n) != NC_NOERR)
    return FAIL(r, "variable '%s' has %d axes; accepted: 1", name, naxis);
  if (*n < 1 || *n > TIMES_MOST)
    return FAIL(r, "variable '%s' has %zu values; accepted: 1 to %d", name, *n, TIMES_MOST);
  *dimension = axis[0];
  *out = malloc(*n * sizeof **out);
  if (*out == NULL) return FAIL(r, "out of memory");
  int code = nc_get_var_double(r->file, variable, *out);
  if (code != NC_NOERR) return FAIL(r, "variable '%s': netCDF: %s", name, nc_strerror(code));
  for (size_t i = 0; i < *n; i++)
    if (!isfinite((*out)[i])) return FAIL(r, "variable '%s': value %zu is not finite", name, i + 1);
  return true;
}

/* Days of a civil date since 2000-03-01: years begin in March, so that leap days end them. */
static double civil_days(int year, int month, double day)
{
  int y = year - (month < 3), m = (month + 9) % 12;
  return 365.0 * (y - 2000) + floor(y / 4.0) - floor(y / 100.0) + floor(y / 400.0) - 485.0 +
         floor((153 * m + 2) / 5.0) + day - 1.0;
}

/* "days since 2000-03-01 ...": the unit's word and the date; false: it does not say so. */
static bool since_date(const char *text, char word[16], int *year, int *month, int *day)
{
  const char *since = strstr(text, " since ");
  char *end = NULL;
  if (since == NULL || since - text > 15) return false;
  memcpy(word, text, (size_t)(since - text));
  word[since - text] = '\0';
  long y = strtol(since + strlen(" since "), &end, 10);
  if (*end != '-') return false;
  long m = strtol(end + 1, &end, 10);
  if (*end != '-') return false;
  long d = strtol(end + 1, &end, 10);
  if (y < 1 || y > 9999 || m < 1 || m > 12 || d < 1 || d > 31) return false;
  *year = (int)y;
  *month = (int)m;
  *day = (int)d;
  return true;
}

/* Unit of time and its origin. */
static bool time_unit(struct reader *r, const char *name, double *unit, double *origin)
{
  static const struct {
    const char *word;
    double days;
  } units[] = {
      {"day", 1.0}, {"hour", 1.0 / 24.0}, {"minute", 1.0 / 1440.0}, {"second", 1.0 / 86400.0}};
  char text[128] = "", word[16] = "";
  int variable, year = 0, month = 0, day = 0;
  size_t length = 0;
  nc_type type;
  if (nc_inq_varid(r->file, name, &variable) == NC_NOERR &&
      nc_inq_att(r->file, variable, "units", &type, &length) == NC_NOERR && type == NC_CHAR &&
      length < sizeof text)
    (void)nc_get_att_text(r->file, variable, "units", text);
  *origin = NAN; /* months of a climatology */
  if (strncmp(text, "month", 5) == 0 && strstr(text, "since") == NULL) return true;
  if (since_date(text, word, &year, &month, &day))
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
      if (strncmp(word, units[i].word, strlen(units[i].word)) == 0) {
        *unit = units[i].days;
        *origin = civil_days(year, month, day);
        return true;
      }
  return FAIL(r,
              "variable '%s' is in '%.100s'; accepted: days, hours, minutes or seconds since a "
              "date, or month",
              name, text);
}

static bool read_times(struct reader *r)
{
  static const char *const names[] = {"time", NULL}, *const climatology[] = {"ctime", NULL};
  int variable, year;
  double unit = 1.0, origin = NAN, *value = NULL, in_month;
  bool has_time = nc_inq_varid(r->file, "time", &variable) == NC_NOERR;
  bool has_climatology = nc_inq_varid(r->file, "ctime", &variable) == NC_NOERR;
  r->time_axis = -1;
  r->ntime = 1;
  if (has_time || has_climatology) {
    if (!axis_values(r, has_time ? names : climatology, &r->time_axis, &r->ntime, &value))
      return false;
    if (!time_unit(r, has_time ? "time" : "ctime", &unit, &origin)) return false;
  }
  r->day = calloc(r->ntime, sizeof *r->day);
  r->calendar = calloc(r->ntime, sizeof *r->calendar);
  if (r->day == NULL || r->calendar == NULL) return FAIL(r, "out of memory");
  for (size_t i = 0; i < r->ntime && value != NULL; i++) {
    r->day[i] = isnan(origin) ? (double)INFINITY : origin + unit * value[i];
    r->calendar[i] = isnan(origin) ? (int)value[i] - 1 : 0;
    if (isnan(origin) && !(value[i] >= 1.0 && value[i] < 13.0))
      return FAIL(r, "variable 'ctime': month %g; accepted: 1 to 12", value[i]);
    if (!isnan(origin) && !(fabs(r->day[i]) < 4e5))
      return FAIL(r, "variable 'time': value %zu lies beyond all dates", i + 1);
    if (!isnan(origin)) r->calendar[i] = um_environment_month_split(r->day[i], &year, &in_month);
  }
  return true;
}

static bool open_axes(struct reader *r)
{
  static const char *const latitudes[] = {"lat", "latitude", NULL};
  static const char *const longitudes[] = {"lon", "longitude", NULL};
  if (!axis_values(r, latitudes, &r->latitude_axis, &r->nlatitude, &r->latitude)) return false;
  if (!axis_values(r, longitudes, &r->longitude_axis, &r->nlongitude, &r->longitude)) return false;
  for (size_t i = 0; i < r->nlatitude; i++) {
    double x = r->latitude[i], before = i > 0 ? r->latitude[i - 1] : x;
    bool in_order = i < 2 || (x > before) == (r->latitude[1] > r->latitude[0]);
    if (!(fabs(x) <= 90.0) || (i > 0 && x == before) || !in_order)
      return FAIL(r, "variable 'lat': value %zu, %g; accepted: ascending or descending, -90 to 90",
                  i + 1, x);
  }
  for (size_t i = 0; i < r->nlongitude; i++) {
    double x = r->longitude[i];
    bool in_order = i == 0 || x > r->longitude[i - 1];
    if (!(x >= -180.0 && x <= 360.0) || !in_order || x - r->longitude[0] >= 360.0)
      return FAIL(r, "variable 'lon': value %zu, %g; accepted: ascending, one turn, -180 to 360",
                  i + 1, x);
  }
  if (r->nlatitude * r->nlongitude > UM_MAP_CELLS_MOST)
    return FAIL(r, "%zu x %zu places; accepted: up to %d", r->nlatitude, r->nlongitude,
                UM_MAP_CELLS_MOST);
  return read_times(r);
}

static double number_attribute(int file, int variable, const char *name, double otherwise)
{
  double value = otherwise;
  size_t length = 0;
  if (nc_inq_attlen(file, variable, name, &length) != NC_NOERR || length != 1) return otherwise;
  return nc_get_att_double(file, variable, name, &value) == NC_NOERR ? value : otherwise;
}

/* One time of a variable; NaN where it is missing. */
static bool read_page(struct reader *r, const char *name, size_t time, double *out)
{
  int variable, naxis = 0, axis[NC_MAX_VAR_DIMS], code;
  size_t start[3] = {0}, count[3], n = r->nlatitude * r->nlongitude;
  if (nc_inq_varid(r->file, name, &variable) != NC_NOERR) return FAIL(r, "no variable '%s'", name);
  code = nc_inq_var(r->file, variable, NULL, NULL, &naxis, axis, NULL);
  bool timed = code == NC_NOERR && naxis == 3 && axis[0] == r->time_axis;
  bool fits = timed || (code == NC_NOERR && naxis == 2);
  if (!fits || axis[naxis - 2] != r->latitude_axis || axis[naxis - 1] != r->longitude_axis)
    return FAIL(r, "variable '%s' has other axes; accepted: (time, lat, lon) or (lat, lon)", name);
  start[0] = timed ? time : 0;
  count[0] = 1;
  count[naxis - 2] = r->nlatitude;
  count[naxis - 1] = r->nlongitude;
  code = nc_get_vara_double(r->file, variable, start, count, out);
  if (code != NC_NOERR) return FAIL(r, "variable '%s': netCDF: %s", name, nc_strerror(code));
  double fill = number_attribute(r->file, variable, "_FillValue", NAN);
  double missing = number_attribute(r->file, variable, "missing_value", NAN);
  double scale = number_attribute(r->file, variable, "scale_factor", 1.0);
  double offset = number_attribute(r->file, variable, "add_offset", 0.0);
  for (size_t i = 0; i < n; i++)
    out[i] = out[i] == fill || out[i] == missing || fabs(out[i]) > 9e36 ? (double)NAN
                                                                        : offset + scale * out[i];
  return true;
}

/* Is a time of the file taken for its calendar month: the nearest to the date, or all. */
static bool is_taken(const struct reader *r, size_t time, int month)
{
  size_t nearest = SIZE_MAX;
  if (r->calendar[time] != month && r->time_axis >= 0) return false;
  for (size_t i = 0; i < r->ntime; i++)
    if (r->calendar[i] == month && fabs(r->day[i] - r->wanted) <= HALF_YEAR &&
        (nearest == SIZE_MAX || fabs(r->day[i] - r->wanted) < fabs(r->day[nearest] - r->wanted)))
      nearest = i;
  return nearest == SIZE_MAX || nearest == time;
}

/* One calendar month of one source: sums over its times, a ratio of sums; NaN where nothing is. */
static bool read_month(struct reader *r, size_t source, int month, double *work, float *out)
{
  size_t n = r->nlatitude * r->nlongitude;
  double *page = work, *sum = work + n, *below = work + 2 * n, *count = work + 3 * n;
  const struct um_environment_map_range *range =
      &um_environment_map_range[sources[source].quantity];
  bool ratio = sources[source].over != NULL;
  memset(sum, 0, 3 * n * sizeof *sum);
  for (size_t t = 0; t < r->ntime; t++) {
    if (!is_taken(r, t, month)) continue;
    if (!read_page(r, sources[source].name, t, page)) return false;
    double *light = work + 4 * n;
    if (ratio && !read_page(r, sources[source].over, t, light)) return false;
    for (size_t i = 0; i < n; i++) {
      if (isnan(page[i]) || (ratio && !(light[i] >= DARK))) continue;
      sum[i] += page[i];
      below[i] += ratio ? light[i] : 1.0;
      count[i] += 1.0;
    }
  }
  for (size_t i = 0; i < n; i++) {
    double value = count[i] > 0.0 ? sum[i] / below[i] : (double)NAN;
    value *= sources[source].unit;
    if (ratio) value = fmin(value, 1.0); /* at the terminator a mean may exceed what falls in */
    if (ratio && isnan(sum[i] / below[i])) value = NAN;
    if (!isnan(value) && !(value >= range->minimum && value <= range->maximum))
      return FAIL(r, "variable '%s': %g in the cell %zu of month %d; accepted: %g to %g %s",
                  sources[source].name, value, i + 1, month + 1, range->minimum, range->maximum,
                  range->unit);
    out[i] = (float)value;
  }
  return true;
}

/* Source of a quantity that the file has; SIZE_MAX: none. */
static size_t source_of(const struct reader *r, int quantity)
{
  int variable;
  for (size_t s = 0; s < sizeof sources / sizeof sources[0]; s++)
    if (sources[s].quantity == quantity &&
        nc_inq_varid(r->file, sources[s].name, &variable) == NC_NOERR &&
        (sources[s].over == NULL || nc_inq_varid(r->file, sources[s].over, &variable) == NC_NOERR))
      return s;
  return SIZE_MAX;
}

struct work {
  const char *path;
  double wanted;
};

/* Everything is read before anything is sent. */
static bool read_all(struct reader *r, struct header *h, float **out, double months[12])
{
  size_t n = r->nlatitude * r->nlongitude, used = 0;
  bool there[12] = {false};
  for (size_t t = 0; t < r->ntime; t++) there[r->calendar[t]] = true;
  for (int m = 0; m < 12; m++)
    if (there[m]) months[h->nmonth++] = m;
  for (int q = 0; q < UM_MAP_QUANTITIES; q++) h->has[q] = source_of(r, q) != SIZE_MAX;
  size_t nhas = 0;
  for (int q = 0; q < UM_MAP_QUANTITIES; q++) nhas += h->has[q] != 0;
  if (nhas == 0)
    return FAIL(r, "none of its variables is known; accepted: toa_sw_all_mon with solar_mon, "
                   "toa_lw_all_mon, cldarea_total_daynight_mon, albedo, olr, "
                   "brightness_temperature, surface_temperature, cloud_fraction");
  *out = malloc(nhas * (size_t)h->nmonth * n * sizeof **out);
  double *work = malloc(5 * n * sizeof *work);
  if (*out == NULL || work == NULL) return FAIL(r, "out of memory");
  for (int q = 0; q < UM_MAP_QUANTITIES; q++)
    for (int m = 0; m < h->nmonth && h->has[q]; m++, used += n)
      if (!read_month(r, source_of(r, q), (int)months[m], work, *out + used)) return false;
  h->nlatitude = (int32_t)r->nlatitude;
  h->nlongitude = (int32_t)r->nlongitude;
  return true;
}

/* The child's life; what it allocates goes with it. */
static int child_work(void *self, int pipe_end)
{
  const struct work *w = self;
  struct header h = {0};
  struct reader r = {.wanted = w->wanted, .message = h.message};
  float *value = NULL;
  double months[12];
  int code = nc_open(w->path, NC_NOWRITE, &r.file);
  bool well = code == NC_NOERR ? open_axes(&r) && read_all(&r, &h, &value, months)
                               : FAIL(&r, "netCDF: %s", nc_strerror(code));
  if (!well) return um_core_child_write(pipe_end, &h, sizeof h) ? 0 : 1;
  size_t n =
      (size_t)(h.has[0] + h.has[1] + h.has[2]) * (size_t)h.nmonth * r.nlatitude * r.nlongitude;
  bool sent = um_core_child_write(pipe_end, &h, sizeof h) &&
              um_core_child_write(pipe_end, r.latitude, r.nlatitude * sizeof(double)) &&
              um_core_child_write(pipe_end, r.longitude, r.nlongitude * sizeof(double)) &&
              um_core_child_write(pipe_end, months, (size_t)h.nmonth * sizeof(double)) &&
              um_core_child_write(pipe_end, value, n * sizeof(float));
  return sent ? 0 : 1;
}

static int by_longitude(const void *a, const void *b)
{
  const double *x = a, *y = b;
  return (x[0] > y[0]) - (x[0] < y[0]);
}

/* Is what came as long as its header says? A child that was overwritten could say anything. */
static bool is_whole(const struct um_core_child_result *in, struct header *h)
{
  if (in->end != UM_CHILD_EXITED || in->code != 0 || in->count < sizeof *h) return false;
  memcpy(h, in->answer, sizeof *h);
  if (h->message[0] != '\0') return true;
  if (h->nlatitude < 1 || h->nlatitude > TIMES_MOST || h->nlongitude < 1 ||
      h->nlongitude > TIMES_MOST || h->nmonth < 1 || h->nmonth > 12)
    return false;
  size_t places = (size_t)h->nlatitude * (size_t)h->nlongitude, quantities = 0;
  for (int q = 0; q < UM_MAP_QUANTITIES; q++) quantities += h->has[q] != 0;
  size_t axes = (size_t)h->nlatitude + (size_t)h->nlongitude + (size_t)h->nmonth;
  return in->count == sizeof *h + axes * sizeof(double) +
                          quantities * (size_t)h->nmonth * places * sizeof(float);
}

/* From the received bytes; latitudes turned to ascending, longitudes to -pi..pi ascending. */
static enum um_status unpack(struct um_context *context, const struct header *h, const char *data,
                             struct um_environment_map **out)
{
  enum um_status status;
  bool has[UM_MAP_QUANTITIES];
  for (int q = 0; q < UM_MAP_QUANTITIES; q++) has[q] = h->has[q] != 0;
  size_t nlat = (size_t)h->nlatitude, nlon = (size_t)h->nlongitude, npage = (size_t)h->nmonth;
  struct um_environment_map *map = NULL;
  double(*order)[2] = NULL; /* longitude and its column in the file */
  UM_CHECK(um_environment_map_create(context, nlat, nlon, npage, has, &map));
  UM_CHECK(um_core_allocate(context, nlon, sizeof *order, &order));
  memcpy(map->latitude, data, nlat * sizeof(double));
  memcpy(map->longitude, data + nlat * sizeof(double), nlon * sizeof(double));
  memcpy(map->month, data + (nlat + nlon) * sizeof(double), npage * sizeof(double));
  const char *from = data + (nlat + nlon + npage) * sizeof(double);
  bool upside_down = nlat > 1 && map->latitude[1] < map->latitude[0];
  for (size_t j = 0; j < nlon; j++) {
    order[j][0] = map->longitude[j] >= 180.0 ? map->longitude[j] - 360.0 : map->longitude[j];
    order[j][1] = (double)j;
  }
  qsort(order, nlon, sizeof *order, by_longitude);
  for (int q = 0; q < UM_MAP_QUANTITIES; q++)
    for (size_t i = 0; i < npage * nlat && has[q]; i++, from += nlon * sizeof(float)) {
      size_t row = upside_down ? i / nlat * nlat + (nlat - 1 - i % nlat) : i;
      for (size_t j = 0; j < nlon; j++)
        memcpy(&map->value[q][row * nlon + j], from + (size_t)order[j][1] * sizeof(float),
               sizeof(float));
    }
  for (size_t i = 0; i < nlat / 2 && upside_down; i++) {
    double keep = map->latitude[i];
    map->latitude[i] = map->latitude[nlat - 1 - i];
    map->latitude[nlat - 1 - i] = keep;
  }
  for (size_t i = 0; i < nlat; i++) map->latitude[i] *= UM_DEG;
  for (size_t j = 0; j < nlon; j++) map->longitude[j] = order[j][0] * UM_DEG;
  *out = map;
  map = NULL;
done:
  um_core_free(context, order);
  um_environment_map_destroy(context, &map);
  return status;
}

enum um_status um_environment_map_read_netcdf(struct um_context *context, const char *path,
                                              double t_tai, struct um_environment_map **out)
{
  struct work work = {path, t_tai / 86400.0 + 0.5 - 60.0};
  struct um_core_child_limits limits = {SECONDS, MEGABYTE};
  struct um_core_child_result in;
  struct header h;
  *out = NULL;
  UM_TRY(um_core_child_run(context, "netCDF", child_work, &work, &limits, &in));
  enum um_status status = UM_OK;
  bool whole = is_whole(&in, &h);
  if (!whole)
    status =
        um_core_fail(context, UM_ERR_LIBRARY, "%s: the netCDF library %s; check the file", path,
                     in.end == UM_CHILD_TIMED_OUT ? "did not finish within 120 s" : "crashed");
  if (whole && h.message[0] != '\0') {
    h.message[TEXT - 1] = '\0';
    status = um_core_fail(context, UM_ERR_INPUT, "%s: %s", path, h.message);
  }
  if (status == UM_OK) status = unpack(context, &h, in.answer + sizeof h, out);
  um_core_free(context, in.answer);
  return status;
}
