/* cfitsio in a child process, the only place that knows it: files are of any origin. It reads from
 * memory and can open no file, so that names within one lead nowhere. The first byte of an answer
 * is '+', or '-' with what is wrong behind it. */
#include "output/fits_library.h"

#include <fitsio.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/resource.h>

#include "base/core/child.h"
#include "base/core/csv.h"
#include "base/core/text.h"

#define SECONDS  20.0  /* and one for every so many bytes: */
#define BYTES    1.0e7 /* a tenth of what is read in one */
#define MEGABYTE 4096
#define SIDE     8192
#define CARD     80
#define ROWS     1000 /* of a table, read at once */
#define COLUMNS  200

struct work {
  const char *bytes;
  size_t length;
  bool table;
  FILE *out;
};

/* Ends the child with what is wrong. */
static int say(const struct work *w, const char *what)
{
  fprintf(w->out, "-%s", what);
  return 0;
}

static int say_status(const struct work *w, int status)
{
  char text[FLEN_STATUS];
  fits_get_errstatus(status, text);
  fprintf(w->out, "-is not read: %s; accepted: a whole file", text);
  return 0;
}

static double key_of(fitsfile *f, const char *key)
{
  int status = 0;
  double value = NAN;
  fits_read_key(f, TDOUBLE, key, &value, NULL, &status);
  return status == 0 ? value : (double)NAN;
}

/* Do all numbers of this part stand in the file? The library reads zeros where it ends. */
static bool is_whole(const struct work *w, fitsfile *f)
{
  LONGLONG header = 0, data = 0, end = 0;
  int status = 0, axes = 0;
  fits_read_key(f, TINT, "NAXIS", &axes, NULL, &status);
  double bytes = fabs(key_of(f, "BITPIX")) / 8.0, beside = key_of(f, "PCOUNT");
  fits_get_hduaddrll(f, &header, &data, &end, &status);
  double count = 1.0;
  for (int i = 1; i <= axes; i++) {
    char key[24];
    snprintf(key, sizeof key, "NAXIS%d", i);
    count *= key_of(f, key);
  }
  return status == 0 &&
         (double)data + bytes * (count + (isnan(beside) ? 0.0 : beside)) <= (double)w->length;
}

/* --- pictures -------------------------------------------------------------------------------- */

/* To the first part with a picture. */
static bool find_picture(fitsfile *f, int *status)
{
  int parts = 0, kind = 0, naxis = 0;
  fits_get_num_hdus(f, &parts, status);
  for (int i = 1; i <= parts && *status == 0; i++) {
    fits_movabs_hdu(f, i, &kind, status);
    fits_get_img_dim(f, &naxis, status);
    if (*status != 0 && kind != IMAGE_HDU && !fits_is_compressed_image(f, status)) *status = 0;
    if (*status == 0 && naxis > 0 && (kind == IMAGE_HDU || fits_is_compressed_image(f, status)))
      return true;
    naxis = 0;
  }
  return false;
}

static int put_picture(const struct work *w, fitsfile *f, const long axis[9])
{
  int status = 0, cards = 0, empty = 0;
  long first[9] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
  float blank = NAN, *row = calloc((size_t)axis[0], sizeof *row);
  if (row == NULL) return 1;
  fits_get_hdrspace(f, &cards, NULL, &status);
  int32_t head[3] = {(int32_t)axis[0], (int32_t)axis[1], cards};
  fputc('+', w->out);
  fwrite(head, sizeof head, 1, w->out);
  for (int i = 1; i <= cards; i++) {
    char card[FLEN_CARD] = "";
    fits_read_record(f, i, card, &status);
    fprintf(w->out, "%-80.80s", card);
  }
  for (long y = 1; y <= axis[1] && status == 0; y++) {
    first[1] = y;
    fits_read_pix(f, TFLOAT, first, axis[0], &blank, row, &empty, &status);
    fwrite(row, sizeof *row, (size_t)axis[0], w->out);
  }
  free(row);
  return status == 0 ? 0 : 1; /* what was sent is too short */
}

static int picture(const struct work *w, fitsfile *f)
{
  int status = 0, naxis = 0, kind = 0;
  long axis[9] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
  if (!find_picture(f, &status)) return say(w, "has no picture; accepted: one of two axes");
  fits_get_img_param(f, 9, &kind, &naxis, axis, &status);
  if (status != 0) return say_status(w, status);
  for (int i = 2; i < 9; i++)
    if (axis[i] != 1) return say(w, "has more than two axes; accepted: one picture");
  if (naxis < 2) return say(w, "has one axis; accepted: a picture of two");
  for (int i = 0; i < 2; i++)
    if (axis[i] < 1 || axis[i] > SIDE) {
      fprintf(w->out, "-NAXIS%d = %ld; accepted: 1 to %d", i + 1, axis[i], SIDE);
      return 0;
    }
  if (!is_whole(w, f)) {
    fprintf(w->out, "-ends before its %ld x %ld pixels; accepted: a whole file", axis[0], axis[1]);
    return 0;
  }
  return put_picture(w, f, axis);
}

/* --- tables ---------------------------------------------------------------------------------- */

struct column {
  int number;
  bool text;
  double reference, unit; /* of a time: date of 0, days of one [d]; NaN: none */
  char *words;            /* [ROWS][width + 1] */
  char *word[ROWS];
  double *value; /* [ROWS] */
};

/* NAMEI + NAMEF, or NAME; NaN: there is none. */
static double reference_of(fitsfile *f, const char *name)
{
  char whole[16], part[16];
  snprintf(whole, sizeof whole, "%sI", name);
  snprintf(part, sizeof part, "%sF", name);
  double i = key_of(f, whole), fraction = key_of(f, part), one = key_of(f, name);
  if (!isnan(one)) return one;
  return isnan(i) ? (double)NAN : i + (isnan(fraction) ? 0.0 : fraction);
}

static bool is_utc(fitsfile *f)
{
  char system[FLEN_VALUE] = "";
  int status = 0;
  fits_read_key(f, TSTRING, "TIMESYS", system, NULL, &status);
  return status != 0 || system[0] == '\0' || strcasecmp(system, "UTC") == 0;
}

/* A column of one number or text a row; false: another. */
static bool take_column(fitsfile *f, int number, struct column *c, char name[FLEN_VALUE])
{
  char key[16], unit[FLEN_VALUE] = "";
  int status = 0, type = 0;
  long repeat = 0, width = 0;
  *c = (struct column){.number = number, .reference = NAN, .unit = 1.0};
  fits_get_coltype(f, number, &type, &repeat, &width, &status);
  snprintf(key, sizeof key, "TTYPE%d", number);
  fits_read_key(f, TSTRING, key, name, NULL, &status);
  if (status != 0 || type < 0) return false;
  c->text = type == TSTRING;
  if (c->text ? width < 1 || width > 200 || repeat != width : repeat != 1 || type >= TCOMPLEX)
    return false;
  snprintf(key, sizeof key, "TUNIT%d", number);
  fits_read_key(f, TSTRING, key, unit, NULL, &status);
  if (strcasecmp(name, "TIME") == 0) {
    double day = reference_of(f, "MJDREF");
    c->reference = isnan(day) ? reference_of(f, "JDREF") : day;
    c->unit = strcmp(unit, "d") == 0 ? 1.0 : 1.0 / 86400.0;
  }
  c->value = calloc(ROWS, sizeof *c->value);
  if (c->text) c->words = calloc(ROWS, (size_t)width + 1);
  for (int i = 0; i < ROWS && c->words != NULL; i++) c->word[i] = c->words + i * (width + 1);
  return c->value != NULL && (!c->text || c->words != NULL);
}

static void put_field(const struct work *w, const struct column *c, long row)
{
  char text[32] = "";
  double value = c->value[row];
  if (c->text) {
    um_core_text_make_line(c->word[row]);
    um_core_csv_put(w->out, c->word[row], "");
    return;
  }
  if (!isnan(c->reference)) value = c->reference + c->unit * value;
  if (isfinite(value)) um_core_number_text(value, text);
  fputs(text, w->out);
}

static int put_rows(const struct work *w, fitsfile *f, struct column *c, int n, long rows)
{
  int status = 0, empty = 0;
  double none = NAN;
  char blank[] = "";
  for (long first = 1; first <= rows; first += ROWS) {
    long count = rows - first + 1 < ROWS ? rows - first + 1 : ROWS;
    for (int k = 0; k < n; k++)
      if (c[k].text)
        fits_read_col(f, TSTRING, c[k].number, first, 1, count, blank, c[k].word, &empty, &status);
      else
        fits_read_col(f, TDOUBLE, c[k].number, first, 1, count, &none, c[k].value, &empty, &status);
    if (status != 0) return 1;
    for (long i = 0; i < count; i++)
      for (int k = 0; k < n; k++) {
        put_field(w, &c[k], i);
        fputc(k + 1 < n ? ',' : '\n', w->out);
      }
  }
  return 0;
}

static int table(const struct work *w, fitsfile *f)
{
  static struct column column[COLUMNS];
  static char name[COLUMNS][FLEN_VALUE];
  int status = 0, parts = 0, kind = IMAGE_HDU, columns = 0, n = 0;
  long rows = 0;
  fits_get_num_hdus(f, &parts, &status);
  for (int i = 1; i <= parts && rows == 0 && status == 0; i++) {
    fits_movabs_hdu(f, i, &kind, &status);
    if (kind != IMAGE_HDU && !fits_is_compressed_image(f, &status))
      fits_get_num_rows(f, &rows, &status);
  }
  if (status != 0) return say_status(w, status);
  if (rows == 0) return say(w, "has no table with rows; accepted: a table, or umbra photometry");
  if (!is_whole(w, f)) return say(w, "ends before its rows; accepted: a whole file");
  if (!is_utc(f)) return say(w, "TIMESYS is not UTC; accepted: UTC, or none stated");
  fits_get_num_cols(f, &columns, &status);
  for (int i = 1; i <= columns && n < COLUMNS; i++) n += take_column(f, i, &column[n], name[n]);
  if (n == 0) return say(w, "has no column of one number or text a row");
  fputc('+', w->out);
  for (int k = 0; k < n; k++) {
    um_core_text_make_line(name[k]);
    um_core_csv_put(w->out, name[k], "");
    fputc(k + 1 < n ? ',' : '\n', w->out);
  }
  return put_rows(w, f, column, n, rows);
}

/* --- the child ------------------------------------------------------------------------------- */

static int child_work(void *self, int pipe_end)
{
  struct work *w = self;
  const struct rlimit none = {0, 0};
  fitsfile *f = NULL;
  int status = 0;
  void *bytes = (void *)w->bytes; /* read alone */
  size_t length = w->length;
  w->out = fdopen(pipe_end, "w");
  if (w->out == NULL || setrlimit(RLIMIT_NOFILE, &none) != 0) return 1;
  fits_open_memfile(&f, "file.fits", READONLY, &bytes, &length, 0, NULL, &status);
  int code = status != 0 ? say_status(w, status) : w->table ? table(w, f) : picture(w, f);
  return fflush(w->out) == 0 ? code : 1;
}

/* The child's answer behind its '+'; the caller frees. */
static enum um_status ask(struct um_context *context, const char *path, struct work *w,
                          struct um_core_child_result *in)
{
  const struct um_core_child_limits limits = {SECONDS + (double)w->length / BYTES, MEGABYTE};
  UM_TRY(um_core_child_run(context, "cfitsio", child_work, w, &limits, in));
  if (in->end == UM_CHILD_TIMED_OUT)
    return um_core_fail(context, UM_ERR_INPUT, "%s: was not read within %.0f s: is it whole?", path,
                        limits.seconds);
  if (in->end == UM_CHILD_SIGNALLED || in->code != 0 || in->count == 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: ends before its numbers, or is not FITS within; accepted: a whole "
                        "file",
                        path);
  if (in->answer[0] == '+') return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s: %.*s", path,
                      (int)(in->count < 300 ? in->count - 1 : 300), in->answer + 1);
}

bool um_output_fits_is(const char *bytes, size_t length)
{
  static const char first[] = "SIMPLE  =";
  return length >= CARD && memcmp(bytes, first, sizeof first - 1) == 0;
}

enum um_status um_output_fits_picture(struct um_context *context, const char *path,
                                      const char *bytes, size_t length,
                                      struct um_output_fits_picture *out)
{
  enum um_status status;
  struct work w = {.bytes = bytes, .length = length};
  struct um_core_child_result in = {0};
  int32_t head[3] = {0, 0, 0};
  *out = (struct um_output_fits_picture){0};
  if (!um_output_fits_is(bytes, length))
    return um_core_fail(context, UM_ERR_INPUT, "%s: is no FITS file: it does not begin with SIMPLE",
                        path);
  UM_CHECK(ask(context, path, &w, &in));
  if (in.count > sizeof head) memcpy(head, in.answer + 1, sizeof head);
  size_t cards = (size_t)head[2] * CARD, n = (size_t)head[0] * (size_t)head[1];
  if (head[2] < 0 || in.count != 1 + sizeof head + cards + n * sizeof *out->value) {
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: ends before its %d x %d pixels; accepted: a whole file", path,
                          head[0], head[1]);
    goto done;
  }
  const char *at = in.answer + 1 + sizeof head;
  UM_CHECK(um_core_allocate(context, cards, 1, &out->header));
  UM_CHECK(um_core_allocate(context, n, sizeof *out->value, &out->value));
  memcpy(out->header, at, cards);
  memcpy(out->value, at + cards, n * sizeof *out->value);
  out->ncard = (size_t)head[2];
  out->width = head[0];
  out->height = head[1];
done:
  um_core_free(context, in.answer);
  return status;
}

enum um_status um_output_fits_table(struct um_context *context, const char *path, const char *bytes,
                                    size_t length, char **csv, size_t *n)
{
  enum um_status status;
  struct work w = {.bytes = bytes, .length = length, .table = true};
  struct um_core_child_result in = {0};
  *csv = NULL;
  UM_CHECK(ask(context, path, &w, &in));
  *n = in.count - 1;
  UM_CHECK(um_core_allocate(context, *n + 1, 1, csv));
  memcpy(*csv, in.answer + 1, *n);
done:
  um_core_free(context, in.answer);
  return status;
}
