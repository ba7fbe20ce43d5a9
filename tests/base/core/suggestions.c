/* Suggestions in messages. Edit distances: by hand, the classic kitten-sitting among them. */
#include "base/core/suggestions.h"

#include <string.h>

#include "base/core/json.h"
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
  static const char *const good[] = {"a",    "solar array",     "b.+x",         "caf\xc3\xa9",
                                     "it's", "a/b,c;d#",        "\xe2\x82\xac", "a=b",
                                     "x-1",  "\xf0\x9f\x9b\xb0"};
  static const char *const bad[] = {"`id`", "a\"b", "a\\b", "$x", "a\nb", "\r", "\t", "\x7f",
                                    "\x1b[2J", "b\xc2\x85",
                                    /* what a spreadsheet runs */
                                    "=cmd|'/C calc'!A0", "+1", "-1", "@SUM(A1)", "\tx", "\rx",
                                    /* no UTF-8: CSI of one byte, a cut, overlong, a surrogate */
                                    "\x9b"
                                    "2J",
                                    "\xe2\x82", "\xc0\xaf", "\xed\xa0\x80",
                                    /* right to left, nothing, a line's end, a mark of order */
                                    "a\xe2\x80\xae"
                                    "b",
                                    "a\xe2\x80\x8b"
                                    "b",
                                    "a\xe2\x80\xa8"
                                    "b",
                                    "\xef\xbb\xbf"
                                    "a"};
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

/* A name behind another may begin as it likes; else it is held to the same. */
static void test_names_behind(void **state)
{
  (void)state;
  assert_true(um_core_name_is_safe_behind("+x") && um_core_name_is_safe_behind("=a"));
  assert_false(um_core_name_is_safe_behind("+`x`") || um_core_name_is_safe_behind("\tx") ||
               um_core_name_is_safe_behind("-\x1b"));
}

/* Texts may have lines; nothing that a terminal obeys. */
static void test_texts(void **state)
{
  (void)state;
  char line[64], shown[64] = "";
  assert_true(um_core_text_is_plain("two\n\tlines of caf\xc3\xa9, \"quoted\" = 1"));
  assert_false(um_core_text_is_plain("a\x1b[2J") || um_core_text_is_plain("\a") ||
               um_core_text_is_plain("\xc2\x9b") || um_core_text_is_plain("\xff") ||
               um_core_text_is_plain("\x7f"));
  strcpy(line, "caf\xc3\xa9\n\x1b[2J\xc2\x9b"
               "2J\xff.\xe2\x82");
  um_core_text_make_line(line);
  assert_string_equal(line, "caf\xc3\xa9  [2J\?\?2J?.\?\?");
  FILE *file = fmemopen(shown, sizeof shown, "w");
  assert_non_null(file);
  um_core_text_put(file, "caf\xc3\xa9\n\x1b[2J\xc2\x9b"
                         "2J\xff.\xe2\x82");
  fclose(file);
  assert_string_equal(shown, "caf\xc3\xa9\?\?[2J?2J?.\?\?");
  char quoted[64] = "";
  file = fmemopen(quoted, sizeof quoted, "w");
  assert_non_null(file);
  um_core_json_string(file, "\"\\\x1b\x7f\xff\xc2\x9b"
                            "caf\xc3\xa9");
  fclose(file);
  assert_string_equal(quoted, "\"\\\"\\\\\\u001b\\u007f\\ufffd\\u009b"
                              "caf\xc3\xa9\"");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_distance),     cmocka_unit_test(test_list),
      cmocka_unit_test(test_guess),        cmocka_unit_test(test_names),
      cmocka_unit_test(test_names_behind), cmocka_unit_test(test_texts)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
