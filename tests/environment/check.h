/* What the tests of this folder share: CMocka and a comparison that a NaN fails. */
#ifndef UMBRA_TESTS_ENVIRONMENT_CHECK_H
#define UMBRA_TESTS_ENVIRONMENT_CHECK_H

#include <math.h>
#include <stdio.h>

#include "tests/support/cmocka_all.h"

/* |value - expected| <= tolerance, all in one unit. */
static inline void check_close(const char *what, double value, double expected, double tolerance)
{
  double error = fabs(value - expected);
  if (!(error <= tolerance))
    fail_msg("%s: %.9g, expected %.9g, off by %.3g, allowed %.3g", what, value, expected, error,
             tolerance);
}

/* value <= bound */
static inline void check_below(const char *what, double value, double bound)
{
  if (!(value <= bound)) fail_msg("%s: %.9g, allowed up to %.9g", what, value, bound);
}

#endif
