/* cases.csv: one row a case, written when it is known, so that an interrupted run keeps them. */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/csv.h"
#include "tests/lab/lab.h"

static const char *const columns[] = {
    "part",       "world",      "hidden",    "value",         "seed",    "verdict",
    "first",      "group",      "found",     "fitted",        "sigma",   "chi2_before",
    "chi2_after", "rms_before", "rms_after", "start_error_s", "seconds", "note"};
#define NCOLUMN (sizeof columns / sizeof columns[0])

static void path_of(const char *folder, char *out, size_t size)
{
  snprintf(out, size, "%s/cases.csv", folder);
}

static void number(double value, char out[32])
{
  if (isfinite(value))
    snprintf(out, 32, "%.9g", value);
  else
    out[0] = '\0';
}

/* One write, so that rows of several processes do not mix. */
static bool put(const char *folder, const char *line, size_t n)
{
  char path[LAB_TEXT * 4];
  path_of(folder, path, sizeof path);
  int file = open(path, O_WRONLY | O_APPEND | O_CREAT, 0666);
  if (file < 0) return false;
  bool written = write(file, line, n) == (ssize_t)n;
  return close(file) == 0 && written;
}

static bool begin(const char *folder)
{
  char path[LAB_TEXT * 4], line[512] = "";
  struct stat st;
  path_of(folder, path, sizeof path);
  if (stat(path, &st) == 0 && st.st_size > 0) return true;
  for (size_t i = 0; i < NCOLUMN; i++)
    snprintf(line + strlen(line), sizeof line - strlen(line), "%s%s", i > 0 ? "," : "", columns[i]);
  snprintf(line + strlen(line), sizeof line - strlen(line), "\n");
  return put(folder, line, strlen(line));
}

bool lab_journal_begin(const char *folder, bool again)
{
  char path[LAB_TEXT * 4];
  path_of(folder, path, sizeof path);
  if (again && unlink(path) != 0 && errno != ENOENT) return false;
  return begin(folder);
}

bool lab_journal_append(const char *folder, const struct lab_row *r)
{
  char line[sizeof(struct lab_row) + 1024], n[6][32];
  const double value[6] = {r->chi2_before, r->chi2_after,    r->rms_before,
                           r->rms_after,   r->start_error_s, r->seconds};
  for (size_t i = 0; i < 6; i++) number(value[i], n[i]);
  int length = snprintf(
      line, sizeof line, "%s,%s,%s,%s,%llu,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s\n", r->part,
      r->world, r->hidden, r->value, (unsigned long long)r->seed, r->verdict, r->first, r->group,
      r->found, r->fitted, r->sigma, n[0], n[1], n[2], n[3], n[4], n[5], r->note);
  return length > 0 && (size_t)length < sizeof line && put(folder, line, (size_t)length);
}

static double number_of(const char *text)
{
  double value;
  return um_core_number_parse(text, &value) ? value : (double)NAN;
}

static void row_of(const struct um_core_csv *csv, size_t i, struct lab_row *row)
{
  const struct {
    char *to;
    size_t size;
  } text[] = {{row->part, sizeof row->part},
              {row->world, sizeof row->world},
              {row->hidden, sizeof row->hidden},
              {row->value, sizeof row->value},
              {NULL, 0},
              {row->verdict, sizeof row->verdict},
              {row->first, sizeof row->first},
              {row->group, sizeof row->group},
              {row->found, sizeof row->found},
              {row->fitted, sizeof row->fitted},
              {row->sigma, sizeof row->sigma}};
  double *const value[] = {&row->chi2_before, &row->chi2_after,    &row->rms_before,
                           &row->rms_after,   &row->start_error_s, &row->seconds};
  size_t ntext = sizeof text / sizeof text[0];
  for (size_t c = 0; c < ntext; c++)
    if (text[c].to != NULL) snprintf(text[c].to, text[c].size, "%s", um_core_csv_text(csv, i, c));
  row->seed = strtoull(um_core_csv_text(csv, i, 4), NULL, 10);
  for (size_t c = 0; c < 6; c++) *value[c] = number_of(um_core_csv_text(csv, i, ntext + c));
  snprintf(row->note, sizeof row->note, "%s", um_core_csv_text(csv, i, NCOLUMN - 1));
}

enum um_status lab_journal_read(struct um_context *context, const char *folder,
                                struct lab_row **out, size_t *count)
{
  enum um_status status;
  char path[LAB_TEXT * 4];
  struct um_core_csv *csv = NULL;
  *out = NULL;
  *count = 0;
  path_of(folder, path, sizeof path);
  UM_TRY(um_core_csv_read(context, path, &csv));
  UM_CHECK(um_core_allocate(context, um_core_csv_rows(csv), sizeof **out, out));
  for (size_t c = 0; c < NCOLUMN; c++) {
    size_t index;
    UM_CHECK(um_core_csv_require(context, csv, columns[c], &index));
  }
  for (*count = 0; *count < um_core_csv_rows(csv); (*count)++) row_of(csv, *count, &(*out)[*count]);
done:
  um_core_csv_destroy(&csv);
  return status;
}

const struct lab_row *lab_journal_find(const struct lab_row *row, size_t count,
                                       const struct lab_case *c)
{
  char hidden[LAB_TEXT], value[LAB_TEXT];
  lab_case_hidden(c, hidden);
  lab_case_value(c, value);
  for (size_t i = 0; i < count; i++)
    if (row[i].seed == c->seed && strcmp(row[i].part, c->part) == 0 &&
        strcmp(row[i].world, c->world->name) == 0 && strcmp(row[i].hidden, hidden) == 0 &&
        strcmp(row[i].value, value) == 0)
      return &row[i];
  return NULL;
}
