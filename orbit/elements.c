/* Element sets of a file: what it is written in, and which of them are asked for. */
#include "orbit/elements.h"

#include <math.h>
#include <string.h>

#include "base/core/file.h"
#include "base/core/sort.h"
#include "orbit/omm_impl.h"

#define FILE_BYTES ((size_t)2 << 20)

void um_orbit_elements_release(struct um_context *context, struct um_orbit_elements *elements)
{
  um_core_free(context, elements->set);
  *elements = (struct um_orbit_elements){0};
}

/* End of the two-line set that begins at `text`: behind its line 2, or the end of all. */
static size_t set_length(const char *text)
{
  size_t at = 0;
  while (text[at] != '\0') {
    bool second = strncmp(text + at, "2 ", 2) == 0;
    at += strcspn(text + at, "\n");
    at += text[at] == '\n';
    if (second) break;
  }
  return at;
}

static int lines_of(const char *text, size_t length)
{
  int lines = 0;
  for (size_t i = 0; i < length; i++) lines += text[i] == '\n';
  return lines;
}

/* Two-line sets, one after another. Faults of the first are told by its own lines alone. */
static enum um_status read_lines(struct um_context *context, const char *name, char *text,
                                 struct um_orbit_elements *out)
{
  int line = 1;
  do {
    size_t length = set_length(text);
    char kept = text[length];
    struct um_orbit_tle set;
    text[length] = '\0';
    enum um_status status = um_orbit_tle_parse(context, text, 1, &set);
    if (status != UM_OK && line == 1) um_core_message_prefix(context, "%s", name);
    if (status != UM_OK && line > 1)
      um_core_message_prefix(context, "%s: set that begins in line %d", name, line);
    UM_TRY(status);
    UM_TRY(um_orbit_elements_add(context, out, &set));
    line += lines_of(text, length);
    text[length] = kept;
    text += length;
    size_t blank = strspn(text, " \t\r\n");
    line += lines_of(text, blank);
    text += blank;
  } while (*text != '\0');
  return UM_OK;
}

static bool begins_with(const char *text, const char *word)
{
  return strncmp(text, word, strlen(word)) == 0;
}

/* Is the first line a header with this column? */
static bool has_column(const char *text, const char *column)
{
  const char *found = strstr(text, column);
  return found != NULL && (size_t)(found - text) < strcspn(text, "\n") &&
         memchr(text, ',', strcspn(text, "\n")) != NULL;
}

static enum um_status read_sets(struct um_context *context, const char *name, char *text,
                                size_t length, struct um_orbit_elements *out)
{
  static const char accepted[] =
      "two-line elements, mean-elements messages (OMM) as key = value, XML, JSON or CSV";
  char *all = text + (begins_with(text, "\xEF\xBB\xBF") ? 3 : 0);
  const char *first = all + strspn(all, " \t\r\n");
  if (strlen(text) != length)
    return um_core_fail(context, UM_ERR_INPUT, "%s: not a text file; accepted: %s", name, accepted);
  if (first[0] == '{' || first[0] == '[') return um_orbit_omm_json(context, name, all, out);
  if (begins_with(first, "CCSDS_OMM_VERS")) return um_orbit_omm_kvn(context, name, all, out);
  if (begins_with(first, "CCSDS_"))
    return um_core_fail(context, UM_ERR_INPUT, "%s: another message, %.14s; accepted: %s", name,
                        first, accepted);
  if (first[0] == '<') return um_orbit_omm_xml(context, name, all, strlen(all), out);
  if (has_column(first, "MEAN_MOTION"))
    return um_orbit_omm_csv(context, name, all, strlen(all), out);
  return read_lines(context, name, text, out);
}

/* --- which ----------------------------------------------------------------------------------- */

/* Those of one object alone. */
static enum um_status keep_object(struct um_context *context, const char *name, int object,
                                  struct um_orbit_elements *sets)
{
  size_t kept = 0;
  if (sets->count == 0)
    return um_core_fail(context, UM_ERR_INPUT, "%s: no element set; accepted: one or more", name);
  int first = sets->set[0].catalogue_number;
  for (size_t i = 0; i < sets->count; i++) {
    int own = sets->set[i].catalogue_number;
    if (object == 0 && own != first)
      return um_core_fail(context, UM_ERR_INPUT,
                          "%s: sets of several objects, %d and %d the first of them; accepted: "
                          "sets of one, or orbit.elements.object",
                          name, first, own);
    if (object == 0 || own == object) sets->set[kept++] = sets->set[i];
  }
  sets->count = kept;
  if (kept > 0) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s: no set of object %d; the first one is of %d",
                      name, object, first);
}

static int compare_epochs(const void *pa, const void *pb)
{
  const struct um_orbit_tle *a = pa, *b = pb;
  return (a->epoch_tai > b->epoch_tai) - (a->epoch_tai < b->epoch_tai);
}

/* By epochs; of equal ones the last is kept. */
static enum um_status sort(struct um_context *context, struct um_orbit_elements *sets)
{
  size_t kept = 0;
  UM_TRY(um_core_sort(context, sets->set, sets->count, sizeof *sets->set, compare_epochs));
  for (size_t i = 0; i < sets->count; i++) {
    if (kept > 0 && sets->set[kept - 1].epoch_tai == sets->set[i].epoch_tai) kept--;
    sets->set[kept++] = sets->set[i];
  }
  sets->count = kept;
  return UM_OK;
}

enum um_status um_orbit_elements_parse(struct um_context *context, const char *name,
                                       const char *text, size_t length, int object,
                                       struct um_orbit_elements *out)
{
  enum um_status status;
  char *copy = NULL; /* which is written into */
  *out = (struct um_orbit_elements){0};
  UM_CHECK(um_core_allocate(context, length + 1, 1, &copy));
  memcpy(copy, text, length);
  UM_CHECK(read_sets(context, name, copy, length, out));
  UM_CHECK(keep_object(context, name, object, out));
  UM_CHECK(sort(context, out));
done:
  um_core_free(context, copy);
  if (status != UM_OK) um_orbit_elements_release(context, out);
  return status;
}

enum um_status um_orbit_elements_read(struct um_context *context, const char *path, int object,
                                      struct um_orbit_elements *out)
{
  char *text = NULL;
  size_t length;
  *out = (struct um_orbit_elements){0};
  UM_TRY(um_core_file_read(context, path, FILE_BYTES, &text, &length));
  enum um_status status = um_orbit_elements_parse(context, path, text, length, object, out);
  um_core_free(context, text);
  return status;
}

size_t um_orbit_elements_nearest(const struct um_orbit_elements *elements, double t_tai)
{
  size_t nearest = 0;
  for (size_t i = 1; i < elements->count; i++)
    if (fabs(elements->set[i].epoch_tai - t_tai) < fabs(elements->set[nearest].epoch_tai - t_tai))
      nearest = i;
  return nearest;
}
