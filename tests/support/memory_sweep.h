/* Memory that runs out at each place in turn. */
#ifndef UMBRA_TESTS_SUPPORT_MEMORY_SWEEP_H
#define UMBRA_TESTS_SUPPORT_MEMORY_SWEEP_H

#include "tests/support/allocator.h"
#include "tests/support/cmocka_all.h"

/* everything() allocates more than `least` times and leaves nothing behind. Each of its allocations
 * fails once; then it returns UM_ERR_MEMORY and leaves nothing behind either. */
static inline void memory_sweep(enum um_status (*everything)(struct um_context *), long least)
{
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct um_context *c;
  assert_int_equal(um_core_context_create(&allocator, &c), UM_OK);
  um_core_context_set_threads(c, 1);
  long alive = memory.alive, first = memory.calls;
  assert_int_equal(everything(c), UM_OK);
  assert_int_equal(memory.alive, alive);
  long calls = memory.calls - first;
  assert_true(calls > least);
  for (long i = 1; i <= calls; i++) {
    um_core_message_clear(c);
    memory.calls = 0;
    memory.fail_call = i;
    assert_int_equal(everything(c), UM_ERR_MEMORY);
    memory.fail_call = 0;
    assert_int_equal(memory.alive, alive);
  }
  um_core_context_destroy(&c);
  assert_int_equal(memory.alive, 0);
}

#endif
