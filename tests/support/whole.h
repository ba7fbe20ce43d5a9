/* Sweeps run whole in `make nightly`, which sets UMBRA_TESTS=whole; elsewhere a part of them does
 * that still asserts every equation. */
#ifndef UMBRA_TESTS_SUPPORT_WHOLE_H
#define UMBRA_TESTS_SUPPORT_WHOLE_H

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static inline bool um_test_whole(void)
{
  const char *asked = getenv("UMBRA_TESTS");
  return asked != NULL && strcmp(asked, "whole") == 0;
}

/* The number of a whole sweep, or of a part. */
static inline int um_test_number(int whole, int part) { return um_test_whole() ? whole : part; }

#endif
