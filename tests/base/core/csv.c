/* The CSV reader. Expected fields are read off the texts by hand; refusals are compared as whole
 * messages, because the message is the contract: file, line, what is wrong, what is accepted. */
#include "base/core/csv.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

static struct um_core_csv *parse(const char *text)
{
  struct um_core_csv *csv;
  um_core_message_clear(context);
  if (um_core_csv_parse(context, "t.csv", text, strlen(text), &csv) != UM_OK)
    fail_msg("%s", um_core_message(context));
  return csv;
}

static void test_plain(void **state)
{
  (void)state;
  struct um_core_csv *csv = parse("# comment\n\n a , b,c\n1, 2.5 ,x y\n  # more\n-3e2,,\"\"\n");
  assert_int_equal(um_core_csv_rows(csv), 2);
  assert_int_equal(um_core_csv_columns(csv), 3);
  assert_string_equal(um_core_csv_name(csv), "t.csv");
  assert_string_equal(um_core_csv_header(csv, 0), "a");
  assert_string_equal(um_core_csv_header(csv, 2), "c");
  assert_int_equal(um_core_csv_line(csv, 0), 4);
  assert_int_equal(um_core_csv_line(csv, 1), 6);
  assert_string_equal(um_core_csv_text(csv, 0, 2), "x y");
  assert_string_equal(um_core_csv_text(csv, 1, 1), "");
  assert_string_equal(um_core_csv_text(csv, 1, 2), "");
  double v;
  assert_int_equal(um_core_csv_number(context, csv, 0, 1, &v), UM_OK);
  assert_true(v == 2.5);
  assert_int_equal(um_core_csv_number(context, csv, 1, 0, &v), UM_OK);
  assert_true(v == -300.0);
  assert_int_equal(um_core_csv_find(csv, "c"), 2);
  assert_true(um_core_csv_find(csv, "d") == SIZE_MAX);
  um_core_csv_destroy(&csv);
  assert_null(csv);
  um_core_csv_destroy(&csv);
  um_core_csv_destroy(NULL);
}

/* RFC 4180: quotes, doubled quotes, commas and line breaks in quotes; CRLF; byte order mark; no
 * newline at the end. */
static void test_quotes(void **state)
{
  (void)state;
  struct um_core_csv *csv = parse(
      "\xef\xbb\xbf\"na,me\",v\r\n \"say \"\"hi\"\"\" ,1\r\n\"two\nlines\",2\r\n#x\r\nlast,3");
  assert_int_equal(um_core_csv_rows(csv), 3);
  assert_string_equal(um_core_csv_header(csv, 0), "na,me");
  assert_string_equal(um_core_csv_text(csv, 0, 0), "say \"hi\"");
  assert_string_equal(um_core_csv_text(csv, 1, 0), "two\nlines");
  assert_string_equal(um_core_csv_text(csv, 1, 1), "2");
  assert_string_equal(um_core_csv_text(csv, 2, 1), "3");
  assert_int_equal(um_core_csv_line(csv, 1), 3);
  assert_int_equal(um_core_csv_line(csv, 2), 6);
  um_core_csv_destroy(&csv);
}

/* What is written is read back as it was; only what needs quotes gets them (RFC 4180, 2.5-2.7). */
static void test_written(void **state)
{
  (void)state;
  static const struct {
    const char *text, *tail, *written;
  } cases[] = {{"bus.+x", "", "bus.+x"},
               {"a b'c`d$e\\f", "", "a b'c`d$e\\f"},
               {"", "", ""},
               {"a,b", "", "\"a,b\""},
               {"a,b", ".mean_K", "\"a,b.mean_K\""},
               {"vis", "_mag_ab", "vis_mag_ab"},
               {"say \"x\"", "", "\"say \"\"x\"\"\""},
               {"\"", "\"", "\"\"\"\"\"\""},
               {"two\nlines", "", "\"two\nlines\""},
               {"two\rlines", "", "\"two\rlines\""},
               {"#c", "", "\"#c\""},
               {"c#", "", "c#"},
               {" blank", "", "\" blank\""},
               {"blank\t", "", "\"blank\t\""},
               {"blank ", "_x", "blank _x"},
               {"", " x", "\" x\""}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char text[128] = "", whole[64];
    FILE *file = fmemopen(text, sizeof text, "w");
    assert_non_null(file);
    fputs("one,two\n", file);
    um_core_csv_put(file, cases[i].text, cases[i].tail);
    fputs(",3\n", file);
    fclose(file);
    assert_memory_equal(text + 8, cases[i].written, strlen(cases[i].written));
    assert_string_equal(text + 8 + strlen(cases[i].written), ",3\n");
    snprintf(whole, sizeof whole, "%s%s", cases[i].text, cases[i].tail);
    struct um_core_csv *csv = parse(text);
    assert_int_equal(um_core_csv_rows(csv), 1);
    assert_string_equal(um_core_csv_text(csv, 0, 0), whole);
    assert_string_equal(um_core_csv_text(csv, 0, 1), "3");
    um_core_csv_destroy(&csv);
  }
}

/* No field begins as a formula does, whatever is written, and none holds what a terminal obeys. */
static void test_written_tame(void **state)
{
  (void)state;
  static const struct {
    const char *text, *tail, *written;
  } cases[] = {{"=cmd|'/C calc'!A0", "", "\"'=cmd|'/C calc'!A0\""},
               {"+1", "", "\"'+1\""},
               {"-x", ".mean_K", "\"'-x.mean_K\""},
               {"@SUM(A1)", "", "\"'@SUM(A1)\""},
               {"\t=1", "", "\"'\t=1\""},
               {"\r=1", "", "\"'\r=1\""},
               {"", "=1", "\"'=1\""},
               {"=1,\"2\"", "", "\"'=1,\"\"2\"\"\""},
               {"a=1", "", "a=1"},
               {"\x1b[31mX\x07", "", "?[31mX?"},
               {"\x9b"
                "2J\xc2\x9b"
                "2J",
                "\x7f", "?2J?2J?"},
               {"caf\xc3\xa9", "", "caf\xc3\xa9"}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char text[128] = "";
    FILE *file = fmemopen(text, sizeof text, "w");
    assert_non_null(file);
    um_core_csv_put(file, cases[i].text, cases[i].tail);
    fclose(file);
    assert_string_equal(text, cases[i].written);
  }
}

/* What is written so reads as it was; an apostrophe before another character is a part of it. */
static void test_tame_reads_back(void **state)
{
  (void)state;
  struct um_core_csv *csv = parse("of,value\n\"'+x\",\"'-x.mean_K\"\n'=1,'Oumuamua\n'+x,'-2.5\n");
  double value;
  assert_string_equal(um_core_csv_text(csv, 0, 0), "+x");
  assert_string_equal(um_core_csv_text(csv, 0, 1), "-x.mean_K");
  assert_string_equal(um_core_csv_text(csv, 1, 0), "=1");
  assert_string_equal(um_core_csv_text(csv, 1, 1), "'Oumuamua");
  assert_string_equal(um_core_csv_text(csv, 2, 0), "+x");
  assert_int_equal(um_core_csv_number(context, csv, 2, 1, &value), UM_OK);
  assert_true(value == -2.5);
  um_core_csv_destroy(&csv);
}

static void test_header_only(void **state)
{
  (void)state;
  struct um_core_csv *csv = parse("a,b");
  assert_int_equal(um_core_csv_rows(csv), 0);
  assert_int_equal(um_core_csv_columns(csv), 2);
  um_core_csv_destroy(&csv);
}

static void test_refusals(void **state)
{
  (void)state;
  static const struct {
    const char *text, *message;
  } cases[] = {
      {"", "t.csv: empty; accepted: CSV with a header row"},
      {"# only a comment\n\n", "t.csv: empty; accepted: CSV with a header row"},
      {"a,b\n1,2\n3\n", "t.csv:3: 1 fields; accepted: 2, as many as the header has columns"},
      {"a,b\n1,2,3\n", "t.csv:2: 3 fields; accepted: 2, as many as the header has columns"},
      {"a,b,a\n", "t.csv:1: column 'a' appears twice"},
      {"a,,c\n", "t.csv:1: column 2 has no name in the header"},
      {"a,b\n1,\"2\n", "t.csv:2: a quote that opens here never closes"},
      {"a,b\n\"1\"2,3\n",
       "t.csv:2: text behind a closing quote; accepted: a comma or the end of line"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    struct um_core_csv *csv;
    um_core_message_clear(context);
    assert_int_equal(
        um_core_csv_parse(context, "t.csv", cases[i].text, strlen(cases[i].text), &csv),
        UM_ERR_INPUT);
    assert_null(csv);
    assert_string_equal(um_core_message(context), cases[i].message);
  }
  struct um_core_csv *csv;
  um_core_message_clear(context);
  assert_int_equal(um_core_csv_parse(context, "t.csv", "a\n\0\n", 5, &csv), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "t.csv: not a text file (zero byte at offset 2); accepted: CSV");
}

static void test_field_messages(void **state)
{
  (void)state;
  struct um_core_csv *csv = parse("time,value\n1,abc\n2,\n");
  double v;
  size_t index;
  um_core_message_clear(context);
  assert_int_equal(um_core_csv_number(context, csv, 0, 1, &v), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "t.csv:2: column 'value': 'abc' is not a finite number");
  um_core_message_clear(context);
  assert_int_equal(um_core_csv_number(context, csv, 1, 1, &v), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "t.csv:3: column 'value': '' is not a finite number");
  um_core_message_clear(context);
  assert_int_equal(um_core_csv_require(context, csv, "sigma", &index), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "t.csv:1: column 'sigma' is missing; the file has: time, value");
  assert_int_equal(um_core_csv_require(context, csv, "value", &index), UM_OK);
  assert_int_equal(index, 1);
  um_core_message_clear(context);
  assert_int_equal(um_core_csv_fail(context, csv, 1, 0, "%d is early", 2), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context), "t.csv:3: column 'time': 2 is early");
  um_core_csv_destroy(&csv);
}

static void test_files(void **state)
{
  (void)state;
  struct um_core_csv *csv;
  um_core_message_clear(context);
  assert_int_equal(um_core_csv_read(context, "no-such-file.csv", &csv), UM_ERR_IO);
  assert_string_equal(um_core_message(context), "no-such-file.csv: No such file or directory");
  um_core_message_clear(context);
  assert_int_equal(um_core_csv_read(context, ".", &csv), UM_ERR_IO);
  assert_string_equal(um_core_message(context), ".: is not a plain file but a folder");
}

static void check_numbers(void)
{
  static const struct {
    const char *text;
    double value;
  } good[] = {{"0", 0},
              {"-0.5", -0.5},
              {"+7", 7},
              {".25", 0.25},
              {"3.", 3},
              {"1e3", 1000},
              {"1.5E-2", 0.015},
              {"1361.0", 1361},
              {"00012", 12},
              {"1e-400", 0},
              {"6.62607015e-34", 6.62607015e-34}};
  static const char *const bad[] = {
      "",   " ", "nan", "NaN", "inf",  "-inf",  "1,5",   "1.5 m", "1.5m", " 1",   "1 ",  "1e",
      "e3", ".", "+",   "--1", "0x10", "1.2.3", "1e999", "1_000", "1d3",  "true", "1e+", "١"};
  for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
    double v = NAN;
    assert_true(um_core_number_parse(good[i].text, &v));
    assert_true(v == good[i].value);
  }
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
    double v = 1.0;
    if (um_core_number_parse(bad[i], &v)) fail_msg("'%s' was accepted as %g", bad[i], v);
  }
  assert_false(um_core_number_parse(NULL, NULL));
}

static void test_numbers(void **state)
{
  (void)state;
  check_numbers();
  char many[400];
  double v;
  memset(many, '1', sizeof many);
  many[sizeof many - 1] = '\0';
  assert_false(um_core_number_parse(many, &v)); /* 399 digits */
}

/* Switch numbers to a locale with a decimal comma: an installed one, or one compiled into `folder`
 * from Debian's package `locales`. */
static bool set_comma(const char *folder)
{
  static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"};
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
    if (setlocale(LC_NUMERIC, names[i]) != NULL) return true;
  char command[3 * UM_TEST_PATH];
  snprintf(command, sizeof command,
           "localedef --no-archive -i de_DE -f UTF-8 '%s/comma' >'%s/said' 2>&1", folder, folder);
  if (system(command) != 0) return false;
  assert_int_equal(setenv("LOCPATH", folder, 1), 0);
  return setlocale(LC_NUMERIC, "comma") != NULL;
}

/* A locale whose decimal point is a comma must not change how files are read. */
static void test_numbers_in_comma_locale(void **state)
{
  (void)state;
  char folder[UM_TEST_PATH], command[UM_TEST_PATH + 16];
  assert_int_equal(um_test_folder_create(folder), 0);
  bool found = set_comma(folder);
  snprintf(command, sizeof command, "rm -rf '%s'/*", folder);
  assert_int_equal(system(command), 0);
  assert_int_equal(um_test_folder_remove(folder), 0);
  if (!found) {
    print_message("no locale with a decimal comma, and none can be compiled (package locales)\n");
    skip();
  }
  assert_string_equal(localeconv()->decimal_point, ",");
  check_numbers();
  setlocale(LC_NUMERIC, "C");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_plain),
      cmocka_unit_test(test_quotes),
      cmocka_unit_test(test_written),
      cmocka_unit_test(test_written_tame),
      cmocka_unit_test(test_tame_reads_back),
      cmocka_unit_test(test_header_only),
      cmocka_unit_test(test_refusals),
      cmocka_unit_test(test_field_messages),
      cmocka_unit_test(test_files),
      cmocka_unit_test(test_numbers),
      cmocka_unit_test(test_numbers_in_comma_locale),
  };
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
