/* For the tests of one program: `context` and `library`, the library of the source tree under E490,
 * with CMocka's group fixtures that make and destroy both. */
#ifndef UMBRA_TESTS_MATERIALS_WITH_LIBRARY_H
#define UMBRA_TESTS_MATERIALS_WITH_LIBRARY_H

#include "check.h"
#include "tests/support/with_context.h"

static struct um_materials_library *library;

static inline int library_set_up(void **state)
{
  if (context_set_up(state) != 0) return -1;
  if (library_under_e490(context, &library) == UM_OK &&
      um_materials_library_read_folder(context, library, UM_TEST_LIBRARY) == UM_OK)
    return 0;
  print_error("%s\n", um_core_message(context));
  return -1;
}

static inline int library_tear_down(void **state)
{
  um_materials_library_destroy(&library);
  return context_tear_down(state);
}

#endif
