/* What the tests of import share: a text as a file, and what is refused. */
#ifndef UMBRA_TESTS_IMPORT_H
#define UMBRA_TESTS_IMPORT_H

#include "evidence/measurements/import.h"
#include "tests/evidence/compare_test.h"

static inline struct um_compare_measurements *import(const char *text,
                                                     const struct um_compare_columns *columns,
                                                     struct um_compare_imported *found)
{
  struct um_compare_measurements *m;
  put("t.txt", text);
  assert_ok(um_compare_import(context, "t.txt", columns, found, &m));
  return m;
}

/* A text, and what its refusal says. */
struct fault {
  const char *text, *says;
};

static inline void expect_refused(const struct fault *fault, size_t n,
                                  const struct um_compare_columns *columns)
{
  struct um_compare_measurements *m;
  struct um_compare_imported found;
  for (size_t i = 0; i < n; i++) {
    put("t.txt", fault[i].text);
    assert_refused(um_compare_import(context, "t.txt", columns, &found, &m), UM_ERR_INPUT,
                   fault[i].says);
  }
}

#endif
