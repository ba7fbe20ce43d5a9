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

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_distance), cmocka_unit_test(test_list)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
