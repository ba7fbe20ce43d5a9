/* A comparison of numbers that says what was compared. */
#ifndef UMBRA_TESTS_SUPPORT_NEAR_H
#define UMBRA_TESTS_SUPPORT_NEAR_H

#include "tests/support/cmocka_all.h"

/* |value - expected| <= tolerance, all in one unit; NaN fails. */
static inline void check_near(const char *what, double value, double expected, double tolerance)
{
  double error = fabs(value - expected);
  if (!(error <= tolerance))
    fail_msg("%s: %.9g, expected %.9g, off by %.3g, allowed %.3g", what, value, expected, error,
             tolerance);
}

#endif
