/* Lines of a calendar are folded at 75 bytes or before (RFC 5545, 3.1), never inside a character.
 */
#include <stdio.h>
#include <string.h>

#include "forecast/forecast_write.h"
#include "tests/support/cmocka_all.h"

static void test_fold(void **state)
{
  (void)state;
  /* two bytes each: the 75th byte is in the middle of one */
  char line[512] = "", text[1024], whole[512] = "";
  for (int i = 0; i < 120; i++) strcat(line, "\xc3\xa9");
  FILE *file = tmpfile();
  assert_non_null(file);
  um_forecast_ics_line(file, line);
  rewind(file);
  size_t n = fread(text, 1, sizeof text - 1, file), lines = 0;
  text[n] = '\0';
  fclose(file);
  for (char *at = text, *end; (end = strstr(at, "\r\n")) != NULL; at = end + 2, lines++) {
    *end = '\0';
    assert_true(end - at <= 75);
    assert_true(lines == 0 || at[0] == ' ');
    const char *behind = at + (lines > 0 ? 1 : 0);
    assert_int_not_equal((unsigned char)behind[0] & 0xc0, 0x80);
    strcat(whole, behind);
  }
  assert_int_equal(lines, 4);
  assert_string_equal(whole, line);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_fold)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
