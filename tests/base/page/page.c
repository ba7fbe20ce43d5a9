/* The document of a page: valid JSON whatever texts it holds, numbers that come back, no markup
 * from a name. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "base/page/writer.h"
#include "tests/app/json.h"
#include "tests/support/cmocka_all.h"

#define HOSTILE "</script><img src=x onerror=\"alert(1)\">&'\\"

/* A page with one figure of each kind, as text; the caller frees. */
static char *make(struct um_context *context)
{
  const struct um_page_head head = {"umbra run " HOSTILE, "run", HOSTILE, NULL, NULL};
  const double x[] = {1.5e9, 1.5e9 + 1.0, 1.5e9 + 2.5}, y[] = {1.0, NAN, 3.0};
  const double z[] = {0, 1, 2, 3, 4, 5, 6, 7, 8}, error[] = {0.1, 0.2, 0.3};
  const double *derivative[] = {y};
  const char *names[] = {HOSTILE, "b", "c"};
  const struct um_page_figure figure = {"figure", HOSTILE, HOSTILE, "lightcurve.csv"};
  const struct um_page_axis time = {"time", "UTC", UM_PAGE_TIME, x, 3};
  const struct um_page_axis linear = {HOSTILE, "m", UM_PAGE_LINEAR, x, 3};
  const struct um_page_shade shade = {x[0], x[1], "umbra"};
  const struct um_page_series series = {.name = HOSTILE, .value = y, .error = error};
  const struct um_page_panel panel = {
      .name = HOSTILE, .unit = "K", .series = &series, .nseries = 1};
  const struct um_page_column column[] = {{.name = HOSTILE, .text = names},
                                          {.name = "v", .unit = "W", .value = y}};
  const struct um_page_bar bar = {HOSTILE, HOSTILE, 2.0, NAN};
  const struct um_page_mark_at mark = {x[0], HOSTILE};
  const struct um_page_sky sky = {x, y, y, error, 3, &mark, 1};
  const struct um_page_slider slider = {.name = HOSTILE,
                                        .label = HOSTILE,
                                        .unit = "1",
                                        .null_value = 1.0,
                                        .minimum = 0.0,
                                        .maximum = INFINITY,
                                        .reach = INFINITY,
                                        .width = 0.1};
  const struct um_page_curve curve = {HOSTILE, "K", "temperature", y, derivative, error};
  const uint32_t corner[] = {0, 1, 2}, none[] = {0};
  const struct um_page_quantity quantity = {"temperature", HOSTILE, "K", UM_PAGE_LINEAR, y};
  const struct um_page_scene scene = {.nvertex = 3,
                                      .ntriangle = 1,
                                      .nsurface = 1,
                                      .ntime = 3,
                                      .vertex = z,
                                      .triangle = corner,
                                      .surface = none,
                                      .part = none,
                                      .material = none,
                                      .part_name = names,
                                      .material_name = names,
                                      .npart = 1,
                                      .nmaterial = 1,
                                      .time = x,
                                      .sun = z,
                                      .quantity = &quantity,
                                      .nquantity = 1};
  struct um_page *page;
  char *text = NULL;
  size_t length = 0;
  FILE *file = open_memstream(&text, &length);
  assert_non_null(file);
  assert_int_equal(um_page_create(context, &head, &page), UM_OK);
  um_page_lead(page, "%s", HOSTILE);
  um_page_fact(page, "fact", "%s", HOSTILE);
  um_page_section(page, "empty", "Nothing?", UM_PAGE_GOOD);
  um_page_section(page, "all", HOSTILE, UM_PAGE_BAD);
  um_page_text(page, "%s", HOSTILE);
  um_page_text(page, "more");
  um_page_axes(page, &figure, &time, &shade, 1, &panel, 1);
  um_page_table(page, &figure, column, 2, 3);
  um_page_bars(page, &figure, &linear, &bar, 1);
  um_page_map(page, &figure, &linear, &linear, HOSTILE, "K", z, true);
  um_page_sky(page, &figure, &sky);
  um_page_sliders(page, &figure, &time, &shade, 1, &slider, 1, &curve, 1);
  um_page_scene(page, &figure, &scene);
  assert_int_equal(um_page_write(context, page, file), UM_OK);
  um_page_destroy(context, &page);
  assert_null(page);
  assert_int_equal(fclose(file), 0);
  return text;
}

/* What stands between two marks; the caller frees. */
static char *between(const char *text, const char *from, const char *to)
{
  const char *at = strstr(text, from);
  assert_non_null(at);
  at += strlen(from);
  const char *end = strstr(at, to);
  assert_non_null(end);
  char *out = strndup(at, (size_t)(end - at));
  assert_non_null(out);
  return out;
}

static char *document(const char *text)
{
  return between(text, "<script type=\"application/json\" id=\"umbra-document\">", "</script>");
}

static void test_document(void **state)
{
  struct um_context *context = *state;
  char *text = make(context), *json = document(text);
  const char *where = json;
  if (!json_is_valid(json, &where)) fail_msg("no JSON at: %.60s", where);
  assert_null(strchr(json, '<'));
  static const char *const kinds[] = {"axes", "table", "bars", "map", "sky", "sliders", "scene"};
  for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
    char key[40];
    snprintf(key, sizeof key, "\"kind\": \"%s\"", kinds[i]);
    assert_non_null(strstr(json, key));
  }
  free(json);
  free(text);
}

/* No name of a file becomes an element: of '<img' there is none, and as many scripts as we wrote.
 */
static void test_hostile(void **state)
{
  char *text = make(*state);
  size_t scripts = 0;
  char *page =
      um_page_has_viewer() ? between(text, "</head>", "id=\"umbra-numbers\"") : strdup(text);
  assert_null(strstr(page, "<img src=x"));
  for (const char *at = page; (at = strstr(at, "<script")) != NULL; at++) scripts++;
  assert_int_equal(scripts, 2);
  assert_non_null(strstr(text, "default-src 'none'"));
  free(page);
  free(text);
}

static int sextet(char c)
{
  static const char letter[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const char *at = strchr(letter, c);
  return c == '=' || at == NULL ? 0 : (int)(at - letter);
}

/* The bytes of umbra-numbers; the caller frees. */
static unsigned char *numbers(const char *text, size_t *length)
{
  char *base64 = between(text, "<script type=\"text/plain\" id=\"umbra-numbers\">", "</script>");
  size_t n = strlen(base64);
  unsigned char *packed = calloc(n + 4, 1), *out = calloc(1, 1 << 16);
  uLongf room = 1 << 16;
  assert_int_equal(n % 4, 0);
  for (size_t i = 0; i < n; i += 4) {
    int group = sextet(base64[i]) << 18 | sextet(base64[i + 1]) << 12 | sextet(base64[i + 2]) << 6 |
                sextet(base64[i + 3]);
    packed[i / 4 * 3] = (unsigned char)(group >> 16);
    packed[i / 4 * 3 + 1] = (unsigned char)(group >> 8 & 255);
    packed[i / 4 * 3 + 2] = (unsigned char)(group & 255);
  }
  assert_int_equal(uncompress(out, &room, packed, (uLong)(n / 4 * 3)), Z_OK);
  *length = room;
  free(packed);
  free(base64);
  return out;
}

/* Where an array of the document begins, and its description. */
static const char *array_of(const char *json, size_t index, unsigned long *at)
{
  const char *entry = strstr(json, "\"arrays\": [");
  assert_non_null(entry);
  for (size_t i = 0; i <= index; i++) {
    entry = strstr(entry + 1, "{\"type\"");
    assert_non_null(entry);
  }
  const char *where = strstr(entry, "\"at\": ");
  assert_non_null(where);
  *at = strtoul(where + 6, NULL, 10);
  return entry;
}

/* The first figure's axis and curve have all their bits, NaN included; steps of a scene come back
 * to half a step. */
static void test_numbers(void **state)
{
  char *text = make(*state), *json = document(text);
  const double x[] = {1.5e9, 1.5e9 + 1.0, 1.5e9 + 2.5}, y[] = {1.0, NAN, 3.0};
  unsigned long at;
  size_t length;
  unsigned char *bytes = numbers(text, &length);
  assert_int_equal(strncmp(array_of(json, 0, &at), "{\"type\": \"f64\", \"count\": 3", 26), 0);
  assert_int_equal(at % 8, 0);
  assert_memory_equal(bytes + at, x, sizeof x);
  (void)array_of(json, 1, &at);
  double read[3];
  memcpy(read, bytes + at, sizeof read);
  assert_true(read[0] == y[0] && isnan(read[1]) && read[2] == y[2]);
  const char *steps = strstr(json, "{\"type\": \"u16\"");
  assert_non_null(steps);
  double scale = strtod(strstr(steps, "\"scale\": ") + 9, NULL);
  double offset = strtod(strstr(steps, "\"offset\": ") + 10, NULL);
  uint16_t stored[3];
  memcpy(stored, bytes + strtoul(strstr(steps, "\"at\": ") + 6, NULL, 10), sizeof stored);
  assert_int_equal(stored[1], UINT16_MAX);
  assert_true(fabs(offset + scale * stored[0] - 1.0) <= 0.5 * scale);
  assert_true(fabs(offset + scale * stored[2] - 3.0) <= 0.5 * scale);
  assert_true(scale > 0.0 && scale < 1e-3);
  free(bytes);
  free(json);
  free(text);
}

/* A sentence of a verdict may be long: it stands whole. */
static void test_long(void **state)
{
  struct um_context *context = *state;
  const struct um_page_head head = {"c", "run", "t", NULL, NULL};
  struct um_page *page;
  char *text = NULL, *sentence = malloc(10001);
  size_t length = 0;
  assert_non_null(sentence);
  memset(sentence, 'x', 9999);
  memcpy(sentence + 9999, "y", 2);
  FILE *file = open_memstream(&text, &length);
  assert_non_null(file);
  assert_int_equal(um_page_create(context, &head, &page), UM_OK);
  um_page_lead(page, "%s", sentence);
  assert_int_equal(um_page_write(context, page, file), UM_OK);
  assert_int_equal(fclose(file), 0);
  um_page_destroy(context, &page);
  assert_non_null(strstr(text, "xy\"]"));
  free(sentence);
  free(text);
}

/* Where a line holds everywhere no reach is written; where that is not known, it is 0. */
static void test_reach(void **state)
{
  char *text = make(*state), *json = document(text);
  assert_null(strstr(json, "\"reach\""));
  assert_non_null(strstr(json, "\"maximum\": null"));
  free(json);
  free(text);
}

/* Curves over time, with the instants that lie in the shadow; `of`: what the filling returns. */
static enum um_status fill(struct um_page_writer *w, const void *of)
{
  static const double t[] = {0.0, 10.0, 20.0, 30.0}, sunlit[] = {1.0, 0.5, 0.0, 1.0};
  const char *words;
  UM_TRY(um_page_writer_times(w, 4, t, sunlit));
  UM_TRY(um_page_words(w, &words, "%s %d", "light", 7));
  const struct um_page_series series = {.name = words, .value = t};
  const struct um_page_panel panel = {.name = "p", .unit = "1", .series = &series, .nseries = 1};
  const struct um_page_figure figure = {.id = "f", .title = "f"};
  um_page_section(w->page, "s", "S?", UM_PAGE_PLAIN);
  um_page_axes(w->page, &figure, &w->time, w->shade, w->nshade, &panel, 1);
  return *(const enum um_status *)of;
}

/* A page in one call: its title ends in what it is about, shadows reach halfway to their
 * neighbours; of a filling that fails nothing is written. */
static void test_writer(void **state)
{
  struct um_context *context = *state;
  const struct um_page_head head = {"c", "run", "box", ": what moves it", NULL};
  enum um_status said = UM_OK;
  char *text = NULL;
  size_t length = 0;
  FILE *file = open_memstream(&text, &length);
  assert_non_null(file);
  assert_int_equal(um_page_put(context, &head, fill, &said, file), UM_OK);
  assert_int_equal(fclose(file), 0);
  assert_non_null(strstr(text, "\"title\": \"box: what moves it\""));
  assert_non_null(strstr(text, "\"name\": \"light 7\""));
  assert_non_null(strstr(text, "{\"from\": 5, \"to\": 15, \"name\": \"penumbra\"}"));
  assert_non_null(strstr(text, "{\"from\": 15, \"to\": 25, \"name\": \"umbra\"}"));
  free(text);
  said = UM_ERR_NUMERIC;
  file = open_memstream(&text, &length);
  assert_non_null(file);
  assert_int_equal(um_page_put(context, &head, fill, &said, file), UM_ERR_NUMERIC);
  assert_int_equal(fclose(file), 0);
  assert_int_equal(length, 0);
  free(text);
}

static int enter(void **state)
{
  struct um_context *context = NULL;
  if (um_core_context_create(NULL, &context) != UM_OK) return -1;
  *state = context;
  return 0;
}

static int leave(void **state)
{
  struct um_context *context = *state;
  um_core_context_destroy(&context);
  return 0;
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_document), cmocka_unit_test(test_hostile),
      cmocka_unit_test(test_numbers),  cmocka_unit_test(test_reach),
      cmocka_unit_test(test_long),     cmocka_unit_test(test_writer)};
  return cmocka_run_group_tests(tests, enter, leave);
}
