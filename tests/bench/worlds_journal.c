/* Answers as CSV, a row when it is known, so that an interrupted run keeps them. */
#include <math.h>
#include <string.h>

#include "base/core/csv.h"
#include "tests/bench/worlds.h"

static const char *const columns[] = {"world",  "method",      "verdict", "certain", "groups",
                                      "values", "probability", "seconds", "note"};
#define NCOLUMN (sizeof columns / sizeof columns[0])
/* Columns that other programs need not have. */
#define HALF   "half"
#define STATED "stated"

void worlds_append(char *list, size_t size, const char *between, const char *text)
{
  size_t n = strlen(list);
  snprintf(list + n, size - n, "%s%s", n > 0 ? between : "", text);
}

static void row_of(const struct um_core_csv *csv, size_t i, const size_t *column,
                   struct worlds_answer *a)
{
  size_t half = um_core_csv_find(csv, HALF), stated = um_core_csv_find(csv, STATED);
  const struct {
    char *to;
    size_t size;
  } text[] = {{a->world, sizeof a->world},
              {a->method, sizeof a->method},
              {a->verdict, sizeof a->verdict},
              {a->certain, sizeof a->certain},
              {a->groups, sizeof a->groups},
              {a->values, sizeof a->values},
              {NULL, 0},
              {NULL, 0},
              {a->note, sizeof a->note}};
  double *const number[] = {&a->probability, &a->seconds};
  for (size_t c = 0; c < NCOLUMN; c++)
    if (text[c].to != NULL)
      snprintf(text[c].to, text[c].size, "%s", um_core_csv_text(csv, i, column[c]));
  for (size_t c = 0; c < 2; c++)
    if (!um_core_number_parse(um_core_csv_text(csv, i, column[6 + c]), number[c])) *number[c] = NAN;
  if (half < um_core_csv_columns(csv))
    snprintf(a->half, sizeof a->half, "%s", um_core_csv_text(csv, i, half));
  if (stated < um_core_csv_columns(csv))
    snprintf(a->stated, sizeof a->stated, "%s", um_core_csv_text(csv, i, stated));
}

enum um_status worlds_journal_read(struct um_context *context, const char *path,
                                   struct worlds_answer **out, size_t *count)
{
  enum um_status status;
  struct um_core_csv *csv = NULL;
  size_t column[NCOLUMN];
  *out = NULL;
  *count = 0;
  UM_TRY(um_core_csv_read(context, path, &csv));
  for (size_t c = 0; c < NCOLUMN; c++)
    UM_CHECK(um_core_csv_require(context, csv, columns[c], &column[c]));
  UM_CHECK(um_core_allocate(context, um_core_csv_rows(csv), sizeof **out, out));
  for (; *count < um_core_csv_rows(csv); (*count)++) row_of(csv, *count, column, &(*out)[*count]);
done:
  um_core_csv_destroy(&csv);
  return status;
}

bool worlds_journal_append(const char *path, const struct worlds_answer *a)
{
  FILE *file = fopen(path, "a");
  if (file == NULL) return false;
  if (fseek(file, 0, SEEK_END) == 0 && ftell(file) == 0)
    for (size_t c = 0; c < NCOLUMN; c++)
      fprintf(file, "%s%s", columns[c], c + 1 < NCOLUMN ? "," : "," HALF "," STATED "\n");
  um_core_csv_put(file, a->world, "");
  um_core_csv_put_text(file, a->method, "");
  um_core_csv_put_text(file, a->verdict, "");
  um_core_csv_put_text(file, a->certain, "");
  um_core_csv_put_text(file, a->groups, "");
  um_core_csv_put_text(file, a->values, "");
  um_core_csv_put_number(file, a->probability);
  um_core_csv_put_number(file, a->seconds);
  um_core_csv_put_text(file, a->note, "");
  um_core_csv_put_text(file, a->half, "");
  um_core_csv_put_text(file, a->stated, "");
  fputc('\n', file);
  bool written = ferror(file) == 0;
  return fclose(file) == 0 && written;
}

const struct worlds_answer *worlds_journal_find(const struct worlds_answer *answer, size_t count,
                                                const char *world, const char *method)
{
  for (size_t i = count; i-- > 0;)
    if (strcmp(answer[i].world, world) == 0 && strcmp(answer[i].method, method) == 0)
      return &answer[i];
  return NULL;
}
