/* A session of the library for the tests of one program: `umbra`, with CMocka's group fixtures that
 * open and close it. */
#ifndef UMBRA_TESTS_SUPPORT_WITH_SESSION_H
#define UMBRA_TESTS_SUPPORT_WITH_SESSION_H

#include "library/umbra.h"

static struct umbra *umbra;

static inline int session_set_up(void **state)
{
  *state = NULL;
  return umbra_open(NULL, &umbra) == UMBRA_OK ? 0 : -1;
}

static inline int session_tear_down(void **state)
{
  (void)state;
  umbra_close(&umbra);
  return 0;
}

#endif
