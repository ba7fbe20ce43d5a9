/* Not a test of Umbra but what unit_support_skipped runs: a program with a test that passes and one
 * that is skipped, fails or passes, as its argument says. */
#include <string.h>

#include "tests/support/cmocka_all.h"

static const char *what;

static void passes(void **state)
{
  (void)state;
  assert_non_null(what);
}

static void does_as_told(void **state)
{
  (void)state;
  if (strcmp(what, "skip") == 0) skip();
  assert_string_equal(what, "pass");
}

static void is_skipped(void **state)
{
  (void)state;
  if (strcmp(what, "pass") != 0) skip();
}

int main(int argc, char **argv)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(passes), cmocka_unit_test(does_as_told),
                                     cmocka_unit_test(is_skipped)};
  what = argc > 1 ? argv[1] : "";
  return cmocka_run_group_tests(tests, NULL, NULL);
}
