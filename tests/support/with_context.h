/* A context for the tests of one program: `context`, their state too, with CMocka's group fixtures
 * that make and destroy it. */
#ifndef UMBRA_TESTS_SUPPORT_WITH_CONTEXT_H
#define UMBRA_TESTS_SUPPORT_WITH_CONTEXT_H

#include "base/core/context.h"

static struct um_context *context;

static inline int context_set_up(void **state)
{
  enum um_status status = um_core_context_create(NULL, &context);
  *state = context;
  return status == UM_OK ? 0 : -1;
}

static inline int context_tear_down(void **state)
{
  (void)state;
  um_core_context_destroy(&context);
  return 0;
}

#endif
