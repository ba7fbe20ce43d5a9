/* Shared by the tests of this folder. */
#ifndef UMBRA_TESTS_MATERIALS_CHECK_H
#define UMBRA_TESTS_MATERIALS_CHECK_H

#include <math.h>
#include <stdio.h>

#include "tests/materials/sun.h"
#include "tests/support/cmocka_all.h"

/* |computed - expected| <= tolerance, NaN fails; says what was compared. */
static inline void check_near(const char *what, double computed, double expected, double tolerance)
{
  if (!(fabs(computed - expected) <= tolerance))
    fail_msg("%s: computed %.9g, expected %.9g within %.2g", what, computed, expected, tolerance);
}

/* Library of the source tree; the caller destroys both. */
#define UM_TEST_LIBRARY UMBRA_SOURCE_DIR "/materials/library"

#endif
