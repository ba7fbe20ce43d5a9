/* Documents that are written again elsewhere: new elements of lists keep comments and layout, and
 * names of files lead to the same files. The expected texts are written by hand. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/csv.h"
#include "tests/base/document/sample_schema.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

#define HEAD "name: a\naltitude_km: 1\ntime: {start: T0+1}\n"

static struct um_context *context;
static char base[UM_TEST_PATH];

static int set_up(void **state)
{
  (void)state;
  if (um_test_folder_create(base) != 0 || chdir(base) != 0) return -1;
  return um_core_context_create(NULL, &context) == UM_OK ? 0 : -1;
}

static int tear_down(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  return chdir("/") == 0 && um_test_folder_remove(base) == 0 ? 0 : -1;
}

static struct um_document *parse(const char *path, const char *text, const char *const *set,
                                 size_t count)
{
  struct um_document *document;
  void *root;
  um_core_message_clear(context);
  if (um_document_parse(context, path, text, &sample_schema, set, count, &document, &root) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return document;
}

static void expect_text(struct um_document *document, const char *expected)
{
  char *text;
  assert_int_equal(um_document_text(context, document, &text), UM_OK);
  assert_string_equal(text, expected);
  um_core_free(context, text);
  um_document_destroy(&document);
}

static void test_elements(void **state)
{
  (void)state;
  static const struct {
    const char *before, *after;
  } cases[] = {
      /* no list, at the end of a text with and without a last newline */
      {HEAD "verbose: true # b", HEAD "verbose: true # b\neffects:\n  - {effect: x, target: t}\n"
                                      "  - {effect: y, efficiency: 0.5}\n"},
      /* block list, its last element in braces or not, something behind it */
      {HEAD "effects:\n - {effect: a}  # one\n# two\nverbose: true\n",
       HEAD "effects:\n - {effect: a}  # one\n - {effect: x, target: t}\n"
            " - {effect: y, efficiency: 0.5}\n# two\nverbose: true\n"},
      {HEAD "effects:\n- effect: \"a\"\n  efficiency: 1 # one\nverbose: true\n",
       HEAD "effects:\n- effect: \"a\"\n  efficiency: 1 # one\n- {effect: x, target: t}\n"
            "- {effect: y, efficiency: 0.5}\nverbose: true\n"},
      /* in brackets, over lines */
      {HEAD "effects: [{effect: a},\n  {effect: b, off: true }] # c\n",
       HEAD "effects: [{effect: a},\n  {effect: b, off: true }, {effect: x, target: t}, "
            "{effect: y, efficiency: 0.5}] # c\n"},
  };
  static const char *const sets[] = {"effects.+={effect: x, target: t}",
                                     "effects.+={effect: y, efficiency: 0.5}"};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
    expect_text(parse("s.yaml", cases[i].before, sets, 2), cases[i].after);
  /* what cannot be edited is written anew, without its comment */
  expect_text(parse("s.yaml", HEAD "effects: [] # c\n", sets, 1),
              "name: a\naltitude_km: 1\ntime: {start: T0+1}\n"
              "effects: [{effect: x, target: t}]\n");
}

static void test_element_refusal(void **state)
{
  (void)state;
  const char *set = "effects.+.off=true";
  struct um_document *document;
  void *root;
  assert_int_equal(um_document_parse(context, "s.yaml", HEAD "effects:\n- {effect: a}\n",
                                     &sample_schema, &set, 1, &document, &root),
                   UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "--set: effects.+.off: no list element '+'; accepted: a");
}

/* base/scene/s.yaml moves to base/out/improved and to a folder beside it; a link on the way is
 * followed, a link at the end keeps its name. */
static void test_move(void **state)
{
  (void)state;
  static const struct {
    const char *from, *before, *to, *after;
  } cases[] = {
      {"scene/s.yaml", "tags: [m.obj, d/m.obj, ../n.obj] # c\n", "out/improved",
       "tags: [../../scene/m.obj, ../../scene/d/m.obj, ../../n.obj] # c\n"},
      {"scene/s.yaml", "tags: [m.obj, d/m.obj]\n", "scene", "tags: [m.obj, d/m.obj]\n"},
      {"scene/s.yaml", "tags: [m.obj]\n", "scene/d", "tags: [../m.obj]\n"},
      {"scene/s.yaml", "tags: [d/m.obj]\n", "scene/d", "tags: [m.obj]\n"},
      {"link/s.yaml", "tags: [../m.obj, s.yaml]\n", "out",
       "tags: [../scene/m.obj, ../scene/d/s.yaml]\n"},
      {"s.yaml", "tags: [m.obj]\n", "out", "tags: [../m.obj]\n"},
      {"s.yaml", "tags: ['a b.obj', /dev/null] # c\n", "out",
       "tags: [\"../a b.obj\", /dev/null] # c\n"},
      {"s.yaml", "tags: [/dev/null, \"a b.obj\"] # c\n", "out",
       "tags: [/dev/null, \"../a b.obj\"] # c\n"},
  };
  static const char *const folders[] = {"scene", "scene/d", "out", "out/improved"};
  for (size_t i = 0; i < 4; i++) assert_int_equal(mkdir(folders[i], 0777), 0);
  assert_int_equal(symlink("scene/d", "link"), 0);
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char before[512], after[512];
    snprintf(before, sizeof before, HEAD "%s", cases[i].before);
    snprintf(after, sizeof after, HEAD "%s", cases[i].after);
    struct um_document *document = parse(cases[i].from, before, NULL, 0);
    assert_int_equal(um_document_move(context, document, &sample_schema, cases[i].to), UM_OK);
    expect_text(document, after);
  }
  /* only the root in common: a relative name would be as long and break sooner */
  struct um_document *document = parse("s.yaml", HEAD "tags: [m.obj]\n", NULL, 0);
  char expected[512], *real = realpath(".", NULL);
  assert_non_null(real);
  snprintf(expected, sizeof expected, HEAD "tags: [%s/m.obj]\n", real);
  assert_int_equal(um_document_move(context, document, &sample_schema, "/"), UM_OK);
  expect_text(document, expected);
  free(real);
  /* a file that nobody reads needs no folder, but for the document's own */
  document = parse("scene/s.yaml", HEAD "tags: [no/m.obj]\n", NULL, 0);
  assert_int_equal(um_document_move(context, document, &sample_schema, "out"), UM_OK);
  expect_text(document, HEAD "tags: [../scene/no/m.obj]\n");
  document = parse("gone/s.yaml", HEAD "tags: [no/m.obj]\n", NULL, 0);
  um_core_message_clear(context);
  assert_int_equal(um_document_move(context, document, &sample_schema, "out"), UM_ERR_IO);
  assert_string_equal(um_core_message(context), "no/m.obj: No such file or directory");
  um_document_destroy(&document);
  remove("link");
  for (size_t i = 4; i-- > 0;) assert_int_equal(rmdir(folders[i]), 0);
}

static void test_numbers(void **state)
{
  (void)state;
  static const struct {
    double value;
    const char *text;
  } cases[] = {{0.18, "0.18"},    {0.1 + 0.2, "0.30000000000000004"}, {-0.0, "0"},
               {1e300, "1e+300"}, {1.0 / 3.0, "0.3333333333333333"},  {-5.0, "-5"}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char text[32];
    double again;
    um_core_number_text(cases[i].value, text);
    assert_string_equal(text, cases[i].text);
    assert_true(um_core_number_parse(text, &again) && again == cases[i].value);
  }
}

/* A number arrives with all its bits, a time too; the origin stays; the text says what was set. */
static void test_changes(void **state)
{
  (void)state;
  static const char *const set[] = {"verbose=true"};
  const double third = 1.0 / 3.0, instant = nextafter(2.0, 3.0);
  const struct um_document_change changes[] = {
      {.key = "altitude_km", .number = third},
      {.key = "time.start", .number = instant, .text = "T0+2"},
      {.key = "orbits", .number = 3.0},
      {.key = "effects.+", .number = NAN, .text = "{effect: x, target: t}"}};
  struct um_document *origin = parse("s.yaml", HEAD, set, 1), *document;
  void *root;
  assert_int_equal(
      um_document_change(context, origin, &sample_schema, changes, 4, &document, &root), UM_OK);
  const struct sample *sample = root;
  assert_memory_equal(&sample->altitude, &third, sizeof third);
  assert_memory_equal(&sample->time->start, &instant, sizeof instant);
  assert_int_equal(sample->orbits, 3);
  assert_true(sample->verbose);
  assert_int_equal(sample->effects.count, 1);
  assert_true(um_document_number(document, "altitude_km") == third);
  assert_true(um_document_number(origin, "altitude_km") == 1.0);
  expect_text(document, "name: a\naltitude_km: 0.3333333333333333\nverbose: true\n"
                        "orbits: 3\ntime: {start: T0+2}\neffects:\n  - {effect: x, target: t}\n");
  expect_text(origin, "name: a\naltitude_km: 1\nverbose: true\ntime: {start: T0+1}\n");
}

/* What a text would be refused for, a number is refused for; nothing is left behind. */
static void test_changes_refused(void **state)
{
  (void)state;
  static const struct {
    struct um_document_change change;
    const char *message;
  } cases[] = {
      {{.key = "name", .number = 2.0}, NULL},
      {{.key = "time.step_s", .number = -1.0},
       "--set: time.step_s: -1 is out of range; accepted: "},
      {{.key = "altitude_km", .number = INFINITY},
       "--set: altitude_km: 'inf' is not accepted; accepted: "},
      {{.key = "orbits", .number = 2.5}, "--set: orbits: '2.5' is not accepted; accepted: "},
      {{.key = "altitude", .number = 2.0}, "--set: altitude: unknown key"},
      {{.key = "name.part", .number = 2.0}, "--set: name.part: leads into a single value"}};
  struct um_document *origin = parse("s.yaml", HEAD, NULL, 0), *document;
  void *root;
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    um_core_message_clear(context);
    enum um_status status =
        um_document_change(context, origin, &sample_schema, &cases[i].change, 1, &document, &root);
    if (cases[i].message == NULL) { /* a name may look like a number */
      assert_int_equal(status, UM_OK);
      um_document_destroy(&document);
      continue;
    }
    assert_int_equal(status, UM_ERR_INPUT);
    assert_null(document);
    if (strstr(um_core_message(context), cases[i].message) == NULL)
      fail_msg("'%s', not '%s'", um_core_message(context), cases[i].message);
  }
  um_document_destroy(&origin);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_elements), cmocka_unit_test(test_element_refusal),
      cmocka_unit_test(test_move),     cmocka_unit_test(test_numbers),
      cmocka_unit_test(test_changes),  cmocka_unit_test(test_changes_refused)};
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
