/* What the tests of compare share: a context in a folder of its own, so that messages name files by
 * their plain names; repeatable Gaussian noise. */
#ifndef UMBRA_TESTS_COMPARE_H
#define UMBRA_TESTS_COMPARE_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/core/constants.h"
#include "base/core/context.h"
#include "base/core/sampling.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/in_folder.h"

/* The state of the tests is theirs. */
static inline int compare_set_up(void **state)
{
  void *own;
  (void)state;
  return folder_enter(&own);
}

/* The folder goes with what the tests left in it, which is plain files of known names. */
static inline int compare_tear_down(void **state)
{
  remove("m.csv");
  remove("w.csv");
  remove("t.txt");
  return folder_leave(state);
}

static inline void put(const char *path, const char *text)
{
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(text, 1, strlen(text), file), strlen(text));
  assert_int_equal(fclose(file), 0);
}

/* A call that must succeed; its message is shown when it does not. */
#define assert_ok(call)                                                                            \
  do {                                                                                             \
    um_core_message_clear(context);                                                                \
    if ((call) != UM_OK) fail_msg("%s: %s", #call, um_core_message(context));                      \
  } while (0)

/* A call that must fail with a status and exactly this message. */
#define assert_refused(call, status, message)                                                      \
  do {                                                                                             \
    um_core_message_clear(context);                                                                \
    assert_int_equal((call), (status));                                                            \
    assert_string_equal(um_core_message(context), (message));                                      \
  } while (0)

/* Unit normal number `index` of a stream (Box & Muller 1958). */
static inline double gaussian(uint64_t stream, uint64_t index)
{
  double u = um_core_hash_uniform(um_core_hash(stream, 2 * index));
  double v = um_core_hash_uniform(um_core_hash(stream, 2 * index + 1));
  return sqrt(-2.0 * log(1.0 - u)) * cos(2.0 * UM_PI * v);
}

#endif
