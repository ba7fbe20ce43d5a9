/* What the tests of orbit share: a context, a bound that NaN fails, messages of failures. */
#ifndef UMBRA_TESTS_ORBIT_H
#define UMBRA_TESTS_ORBIT_H

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/context.h"
#include "base/core/vec.h"
#include "orbit/time.h"
#include "tests/support/cmocka_all.h"

/* A call that must succeed; its message is shown when it does not. */
#define assert_ok(context, call)                                                                   \
  do {                                                                                             \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(context));                      \
  } while (0)

static inline int context_setup(void **state)
{
  struct um_context *context = NULL;
  if (um_core_context_create(NULL, &context) != UM_OK) return -1;
  *state = context;
  return 0;
}

static inline int context_teardown(void **state)
{
  struct um_context *context = *state;
  um_core_context_destroy(&context);
  return 0;
}

static inline double utc(struct um_context *context, const char *text)
{
  double t = NAN;
  assert_ok(context, um_orbit_time_parse(context, text, &t));
  return t;
}

static inline void assert_vec_near(struct um_vec3 got, struct um_vec3 want, double tolerance)
{
  double distance = um_vec3_norm(um_vec3_sub(got, want));
  if (!(distance <= tolerance))
    fail_msg("(%.12g %.12g %.12g), expected (%.12g %.12g %.12g), off by %.3g, tolerance %.3g",
             got.x, got.y, got.z, want.x, want.y, want.z, distance, tolerance);
}

/* A file of the test's own in the working folder; its name is written to path. */
static inline void scratch_write(const char *name, const char *text, char path[256])
{
  snprintf(path, 256, "orbit_%ld_%s", (long)rand(), name);
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  fputs(text, file);
  fclose(file);
}

#endif
