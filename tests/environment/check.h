/* What the tests of this folder share: CMocka and a comparison that a NaN fails. */
#ifndef UMBRA_TESTS_ENVIRONMENT_CHECK_H
#define UMBRA_TESTS_ENVIRONMENT_CHECK_H

#include <math.h>
#include <stdio.h>

#include "tests/support/near.h"

/* value <= bound */
static inline void check_below(const char *what, double value, double bound)
{
  if (!(value <= bound)) fail_msg("%s: %.9g, allowed up to %.9g", what, value, bound);
}

#endif
