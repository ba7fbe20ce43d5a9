/* bench/worlds/worlds.csv: what each world hides. */
#include <stdlib.h>
#include <string.h>

#include "base/core/csv.h"
#include "tests/bench/worlds.h"

static const char *const columns[] = {"world", "scenario", "measurement", "without",
                                      "set",   "hidden",   "also",        "good"};
#define NCOLUMN (sizeof columns / sizeof columns[0])
const char *const worlds_good_name[WORLDS_GOODS] = {"found",  "group",       "complete",
                                                    "nobody", "unexplained", "open"};

/* "?effect:target|other,name=value,name=value" */
static bool parse_hidden(char *text, struct worlds_hidden *out)
{
  char *rest = NULL;
  *out = (struct worlds_hidden){.optional = text[0] == '?'};
  char *name = strtok_r(text + out->optional, ",", &rest);
  if (name == NULL || strlen(name) >= sizeof out->names) return false;
  strcpy(out->names, name);
  for (char *v = strtok_r(NULL, ",", &rest); v != NULL; v = strtok_r(NULL, ",", &rest)) {
    char *equals = strchr(v, '=');
    if (equals == NULL || out->nvalue == WORLDS_VALUES || equals - v > 31) return false;
    memcpy(out->parameter[out->nvalue], v, (size_t)(equals - v));
    if (!um_core_number_parse(equals + 1, &out->value[out->nvalue++])) return false;
  }
  return true;
}

static bool parse_all_hidden(const char *text, struct worlds_world *world)
{
  char copy[2 * WORLDS_TEXT];
  if (strlen(text) >= sizeof copy) return false;
  strcpy(copy, text);
  for (char *at = copy; at != NULL && *at != '\0';) {
    char *next = strstr(at, " + ");
    if (next != NULL) *next = '\0';
    if (world->nhidden == WORLDS_HIDDEN || !parse_hidden(at, &world->hidden[world->nhidden++]))
      return false;
    at = next != NULL ? next + 3 : NULL;
  }
  return true;
}

static bool parse_row(const struct um_core_csv *csv, size_t i, const size_t *column,
                      struct worlds_world *world)
{
  const struct {
    char *to;
    size_t size;
  } text[] = {{world->name, sizeof world->name},
              {world->scenario, sizeof world->scenario},
              {world->measurement, sizeof world->measurement},
              {world->without, sizeof world->without},
              {world->set, sizeof world->set},
              {NULL, 0},
              {world->also, sizeof world->also}};
  for (size_t c = 0; c < sizeof text / sizeof text[0]; c++) {
    const char *from = um_core_csv_text(csv, i, column[c]);
    if (text[c].to == NULL) continue;
    if (strlen(from) >= text[c].size) return false;
    strcpy(text[c].to, from);
  }
  const char *good = um_core_csv_text(csv, i, column[NCOLUMN - 1]);
  size_t g = 0;
  while (g < WORLDS_GOODS && strcmp(worlds_good_name[g], good) != 0) g++;
  world->good = (enum worlds_good)g;
  return g < WORLDS_GOODS && parse_all_hidden(um_core_csv_text(csv, i, column[5]), world);
}

enum um_status worlds_read(struct um_context *context, const char *path, struct worlds_world **out,
                           size_t *count)
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
  for (; *count < um_core_csv_rows(csv); (*count)++) {
    if (parse_row(csv, *count, column, &(*out)[*count])) continue;
    status = um_core_fail(context, UM_ERR_INPUT, "%s:%d: not a world", path,
                          um_core_csv_line(csv, *count));
    goto done;
  }
done:
  um_core_csv_destroy(&csv);
  return status;
}
