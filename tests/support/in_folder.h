/* A context in an empty folder of its own, where the tests of one program work: CMocka's group
 * fixtures. What they leave there fails the program. */
#ifndef UMBRA_TESTS_SUPPORT_IN_FOLDER_H
#define UMBRA_TESTS_SUPPORT_IN_FOLDER_H

#include <stdio.h>
#include <unistd.h>

#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

static inline int folder_enter(void **state)
{
  char folder[UM_TEST_PATH];
  if (um_test_folder_create(folder) != 0 || chdir(folder) != 0) return -1;
  return context_set_up(state);
}

static inline int folder_leave(void **state)
{
  char folder[4096];
  context_tear_down(state);
  if (getcwd(folder, sizeof folder) == NULL || chdir("/") != 0) return -1;
  return um_test_folder_remove(folder);
}

#endif
