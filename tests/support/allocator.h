/* Memory that counts its blocks and runs out when told to. */
#ifndef UMBRA_TESTS_SUPPORT_ALLOCATOR_H
#define UMBRA_TESTS_SUPPORT_ALLOCATOR_H

#include <stdbool.h>

#include "base/core/context.h"

/* All zero: never fails. A test sets `calls` back to 0 and `fail_call` as it likes. */
struct um_test_memory {
  long alive;     /* blocks handed out and not returned */
  long calls;     /* of allocate and reallocate so far, failed ones included */
  long fail_call; /* this call fails, counted from 1; 0: none */
  bool stays_out; /* and so do all calls after it */
};

/* The source that allocates from `memory`, which must outlive every context made with it. Not for
 * several threads at a time. */
struct um_core_allocator um_test_memory_allocator(struct um_test_memory *memory);

#endif
