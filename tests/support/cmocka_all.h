/* CMocka, which wants these headers before its own, and a comparison of numbers. */
#ifndef UMBRA_TESTS_SUPPORT_CMOCKA_ALL_H
#define UMBRA_TESTS_SUPPORT_CMOCKA_ALL_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* |value - expected| <= tolerance; NaN fails. */
#define assert_close(value, expected, tolerance)                                                   \
  do {                                                                                             \
    double assert_v_ = (value), assert_e_ = (expected), assert_t_ = (tolerance);                   \
    if (!(fabs(assert_v_ - assert_e_) <= assert_t_))                                               \
      fail_msg("%s = %.17g, expected %.17g within %g", #value, assert_v_, assert_e_, assert_t_);   \
  } while (0)

#endif
