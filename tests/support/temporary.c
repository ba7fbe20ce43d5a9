/* Files and folders of a test's own. */
#include "tests/support/temporary.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/support/cmocka_all.h"

/* The pattern of a name for mkdtemp and mkstemp; false when it has no room. */
static bool pattern(char path[UM_TEST_PATH])
{
  const char *folder = getenv("TMPDIR");
  if (folder == NULL || folder[0] == '\0') folder = P_tmpdir;
  int length = snprintf(path, UM_TEST_PATH, "%s/umbra-test-XXXXXX", folder);
  return length > 0 && length < UM_TEST_PATH;
}

int um_test_folder_create(char path[UM_TEST_PATH])
{
  return pattern(path) && mkdtemp(path) != NULL ? 0 : -1;
}

int um_test_folder_remove(const char *path) { return rmdir(path); }

void um_test_file_create(char path[UM_TEST_PATH], const void *bytes, size_t length)
{
  assert_true(pattern(path));
  int descriptor = mkstemp(path);
  assert_true(descriptor >= 0);
  FILE *file = fdopen(descriptor, "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(bytes, 1, length, file), length);
  assert_int_equal(fclose(file), 0);
}
