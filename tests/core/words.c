/* Words in messages. Edit distances: by hand, the classic kitten-sitting among them. */
#include "core/words.h"

#include <string.h>

#include "tests/support/cmocka_all.h"

static void test_distance(void **state)
{
  (void)state;
  assert_int_equal(um_core_words_distance("kitten", "sitting"), 3);
  assert_int_equal(um_core_words_distance("", "abc"), 3);
  assert_int_equal(um_core_words_distance("abc", ""), 3);
  assert_int_equal(um_core_words_distance("same", "same"), 0);
  assert_int_equal(um_core_words_distance("Albedo", "albedo"), 0);
  assert_int_equal(um_core_words_distance("height", "height_m"), 1); /* only the unit is missing */
  assert_int_equal(um_core_words_distance("height", "heights"), 1);
  /* neighbours swapped are one slip; "ca" to "abc" is 3 where no letter is touched twice */
  assert_int_equal(um_core_words_distance("albdeo", "albedo"), 1);
  assert_int_equal(um_core_words_distance("LAbedo", "albedo"), 1);
  assert_int_equal(um_core_words_distance("ca", "abc"), 3);
  assert_int_equal(um_core_words_distance("run", "nur"), 2);
  assert_true(um_core_words_are_near("emitance", "emittance"));
  assert_false(um_core_words_are_near("mass", "emittance"));
  assert_false(um_core_words_are_near("ab", "xy"));
  char many[300];
  memset(many, 'a', sizeof many);
  many[sizeof many - 1] = '\0';
  assert_int_equal(um_core_words_distance(many, many), 0);
}

static void test_list(void **state)
{
  (void)state;
  char text[20] = "";
  um_core_words_append(text, sizeof text, "one");
  assert_string_equal(text, "one");
  um_core_words_append(text, sizeof text, "two");
  assert_string_equal(text, "one, two");
  um_core_words_append(text, sizeof text, "three");
  assert_string_equal(text, "one, two, ...");
  um_core_words_append(text, sizeof text, "x");
  assert_string_equal(text, "one, two, ...");
}

/* The nearest of those that are near, the first of two alike; nothing where nothing is. */
static void test_guess(void **state)
{
  (void)state;
  static const char *const known[] = {"solar_absorptance", "emittance", "mli_emittance", "albedo"};
  static const struct {
    const char *written, *hint;
  } cases[] = {{"emitance", "; did you mean 'emittance'?"},
               {"ablbedo", "; did you mean 'albedo'?"},
               {"solar_absorbtance", "; did you mean 'solar_absorptance'?"},
               {"gravity", ""},
               {"", ""}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    struct um_core_words_guess guess = {.written = cases[i].written};
    char hint[UM_CORE_WORDS_HINT];
    for (size_t k = 0; k < 4; k++) um_core_words_consider(&guess, known[k]);
    assert_string_equal(um_core_words_hint(&guess, hint), cases[i].hint);
  }
  struct um_core_words_guess guess = {.written = "bax"};
  um_core_words_consider(&guess, "bay");
  um_core_words_consider(&guess, "box");
  assert_string_equal(guess.nearest, "bay");
}

/* What may name a thing, up to 255 bytes of it. */
static void test_names(void **state)
{
  (void)state;
  static const char *const good[] = {"a",    "solar array", "b.+x",        "caf\xc3\xa9",
                                     "it's", "a/b,c;d#",    "\xe2\x82\xac"};
  static const char *const bad[] = {"`id`", "a\"b", "a\\b", "$x",      "a\nb",
                                    "\r",   "\t",   "\x7f", "\x1b[2J", "b\xc2\x85"};
  char longest[UM_CORE_NAME_LONGEST + 2];
  for (size_t i = 0; i < sizeof good / sizeof good[0]; i++)
    if (!um_core_name_is_safe(good[i])) fail_msg("'%s' is refused", good[i]);
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
    if (um_core_name_is_safe(bad[i])) fail_msg("'%s' is accepted", bad[i]);
  memset(longest, 'x', sizeof longest);
  longest[UM_CORE_NAME_LONGEST + 1] = '\0';
  assert_false(um_core_name_is_safe(longest));
  longest[UM_CORE_NAME_LONGEST] = '\0';
  assert_true(um_core_name_is_safe(longest));
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_distance), cmocka_unit_test(test_list),
                                     cmocka_unit_test(test_guess), cmocka_unit_test(test_names)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
