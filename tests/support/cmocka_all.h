/* CMocka, which wants these headers before its own, a comparison of numbers, and programs that tell
 * CTest of skipped tests and work in a folder of their own. */
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

/* A group of tests returns 0, UM_TEST_SKIPPED when a test called skip() and none failed, and
 * otherwise the number of those that failed: CMocka alone returns 0 for tests that were skipped.
 * um_test() of CMake names the same code to CTest. The group works in a fresh temporary folder, its
 * working folder, which has to be empty again at the end: what lies there counts as a failure. */
#define UM_TEST_SKIPPED 77

void um_test_skip_note(void);
void um_test_begin(void);
int um_test_result(int failures);

#undef skip
#define skip()                                                                                     \
  do {                                                                                             \
    um_test_skip_note();                                                                           \
    _skip(__FILE__, __LINE__);                                                                     \
  } while (0)

#undef cmocka_run_group_tests
#define cmocka_run_group_tests(tests, setup, teardown)                                             \
  (um_test_begin(), um_test_result(_cmocka_run_group_tests(                                        \
                        #tests, tests, sizeof(tests) / sizeof((tests)[0]), setup, teardown)))

#endif
