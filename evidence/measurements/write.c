/* The writer of measurement files: beside the place under a temporary name, then renamed, so that a
 * reader never meets half a file. Something that is not a regular file (a pipe) is written into. */
#include "evidence/measurements/write.h"

#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "base/core/file.h"
#include "base/core/text.h"
#include "evidence/measurements/measurements.h"
#include "evidence/measurements/time_text.h"

#define WRITTEN "the measurements were written"

/* Which optional columns have something to say. */
struct layout {
  bool exposure, flag, track, geometry, station;
};

static struct layout choose_layout(const struct um_compare_measurements *m)
{
  struct layout l = {.geometry = m->independent};
  for (size_t i = 0; i < m->count; i++) {
    l.exposure = l.exposure || !isnan(m->row[i].exposure);
    l.flag = l.flag || m->row[i].flag != 0;
    l.track = l.track || m->track[m->row[i].track][0] != '\0';
    l.station = l.station || m->row[i].station != SIZE_MAX;
  }
  return l;
}

/* ",value" with the fewest digits that read back as the same double; ",": NaN. The decimal point of
 * the locale becomes '.'. */
static void put_number(FILE *file, double value)
{
  char text[40] = "";
  if (!isnan(value)) {
    for (int digits = 9; digits <= 17; digits++) {
      snprintf(text, sizeof text, "%.*g", digits, value == 0.0 ? 0.0 : value); /* no "-0" */
      if (strtod(text, NULL) == value) break;
    }
    char mark = localeconv()->decimal_point[0], *point = strchr(text, mark);
    if (mark != '.' && point != NULL) *point = '.';
  }
  fprintf(file, ",%s", text);
}

/* An angle or height in the unit of the file, to 1e-10 of that unit: what conversion there and back
 * leaves in the last bit is not shown. */
static void put_converted(FILE *file, double value)
{
  char text[40];
  snprintf(text, sizeof text, "%.10f", value);
  put_number(file, strtod(text, NULL));
}

static void put_row(FILE *file, const struct um_compare_measurements *m, const struct layout *l,
                    const struct um_compare_measurement *row)
{
  char time[40];
  um_compare_time_text(row->t_tai, time);
  fputs(time, file);
  enum um_compare_quantity quantity = m->channel[row->channel].quantity;
  um_core_csv_put_text(file, um_compare_quantity_name(quantity), "");
  /* below this bound a temperature states its unit, else it would be taken for Celsius */
  if (quantity == UM_QUANTITY_TEMPERATURE && row->value < UM_COMPARE_COLD) fputs("_K", file);
  um_core_csv_put_text(file, m->channel[row->channel].of, "");
  put_number(file, row->value);
  put_number(file, row->sigma);
  if (l->exposure) put_number(file, row->exposure);
  if (l->flag) fprintf(file, ",%d", row->flag);
  if (l->track) um_core_csv_put_text(file, m->track[row->track], "");
  if (l->geometry) {
    put_converted(file, 1e-3 * row->satellite_height);
    put_converted(file, row->azimuth / UM_DEG);
    put_converted(file, row->elevation / UM_DEG);
  }
  if (l->station)
    um_core_csv_put_text(file, row->station == SIZE_MAX ? "" : m->station[row->station], "");
  fputc('\n', file);
}

static void put_file(FILE *file, const char *note, const struct um_compare_measurements *m)
{
  struct layout l = choose_layout(m);
  if (note != NULL) {
    fputs("# ", file);
    um_core_text_put(file, note);
    fputc('\n', file);
  }
  fprintf(file, "time_utc,quantity,of,value,sigma%s%s%s%s%s\n", l.exposure ? ",exposure_s" : "",
          l.flag ? ",flag" : "", l.track ? ",track" : "",
          l.geometry ? ",satellite_height_km,azimuth_deg,elevation_deg" : "",
          l.station ? ",station" : "");
  for (size_t i = 0; i < m->count; i++) put_row(file, m, &l, &m->row[i]);
}

/* What the reader would refuse as a number must not be written. */
static enum um_status check_rows(struct um_context *context,
                                 const struct um_compare_measurements *m, const char *path)
{
  for (size_t i = 0; i < m->count; i++) {
    const struct um_compare_measurement *row = &m->row[i];
    bool place = !m->independent || (isfinite(row->satellite_height) && isfinite(row->azimuth) &&
                                     isfinite(row->elevation));
    if (isfinite(row->t_tai) && isfinite(row->value) && !isinf(row->sigma) &&
        !isinf(row->exposure) && place)
      continue;
    return um_core_fail(context, UM_ERR_NUMERIC,
                        "%s: row %zu (%s '%s'): time, value, sigma, exposure or geometry is not "
                        "finite",
                        path, i + 1, um_compare_quantity_name(m->channel[row->channel].quantity),
                        m->channel[row->channel].of);
  }
  return UM_OK;
}

/* A pipe or a device that the user names is written to where it stands; a pipe that nobody reads is
 * not waited for. */
static enum um_status write_in_place(struct um_context *context,
                                     const struct um_compare_measurements *m, const char *note,
                                     const char *path)
{
  int descriptor = open(path, O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor >= 0) (void)fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  FILE *file = descriptor < 0 ? NULL : fdopen(descriptor, "w");
  if (file == NULL) {
    int reason = errno;
    if (descriptor >= 0) close(descriptor);
    return um_core_fail(context, UM_ERR_IO, "%s: %s", path,
                        reason == ENXIO ? "nobody reads this pipe" : strerror(reason));
  }
  put_file(file, note, m);
  UM_TRY(um_core_file_close(context, path, &file));
  return um_core_stop_check(context, WRITTEN);
}

enum um_status
um_compare_measurements_write_noted(struct um_context *context,
                                    const struct um_compare_measurements *measurements,
                                    const char *note, const char *path)
{
  struct um_core_whole_file whole;
  struct stat st;
  UM_TRY(check_rows(context, measurements, path));
  if (stat(path, &st) == 0 && !S_ISREG(st.st_mode))
    return write_in_place(context, measurements, note, path);
  UM_TRY(um_core_whole_begin(context, path, &whole));
  put_file(whole.file, note, measurements);
  return um_core_whole_end(context, &whole, um_core_stop_check(context, WRITTEN));
}

enum um_status um_compare_measurements_write(struct um_context *context,
                                             const struct um_compare_measurements *measurements,
                                             const char *path)
{
  return um_compare_measurements_write_noted(context, measurements, NULL, path);
}
