/* What a test program returns to CTest when tests were skipped. */
#include <stdbool.h>

#include "tests/support/cmocka_all.h"

static bool skipped;

void um_test_skip_note(void) { skipped = true; }

int um_test_result(int failures)
{
  if (failures != 0) return failures < UM_TEST_SKIPPED ? failures : UM_TEST_SKIPPED - 1;
  return skipped ? UM_TEST_SKIPPED : 0;
}
