/* A skipped test is counted: by the program's exit status, by CTest, and by tools/run-tests, which
 * fails and names it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

/* Exit status of a shell command. */
static int shell(const char *command)
{
  int status = system(command);
  assert_true(status != -1 && WIFEXITED(status));
  return WEXITSTATUS(status);
}

static void exit_status(void **state)
{
  (void)state;
  assert_int_equal(shell(UMBRA_SKIPPING " pass >/dev/null 2>&1"), 0);
  assert_int_equal(shell(UMBRA_SKIPPING " skip >/dev/null 2>&1"), UM_TEST_SKIPPED);
  /* beside a skipped test a failure stays a failure */
  assert_int_equal(shell(UMBRA_SKIPPING " fail >/dev/null 2>&1"), 1);
}

static void write_tests(const char *path, const char *second)
{
  FILE *file = fopen(path, "wb");
  assert_non_null(file);
  fprintf(file,
          "add_test(whole \"%s\" pass)\nadd_test(part \"%s\" %s)\n"
          "set_tests_properties(whole part PROPERTIES SKIP_RETURN_CODE %d)\n",
          UMBRA_SKIPPING, UMBRA_SKIPPING, second, UM_TEST_SKIPPED);
  assert_int_equal(fclose(file), 0);
}

static void runner(void **state)
{
  (void)state;
  char folder[UM_TEST_PATH], path[UM_TEST_PATH + 32], command[4 * UM_TEST_PATH], said[8192];
  assert_int_equal(um_test_folder_create(folder), 0);
  snprintf(path, sizeof path, "%s/CTestTestfile.cmake", folder);
  snprintf(command, sizeof command,
           "cd '%s' && { '%s/tools/run-tests' . ; echo code $?; } > said 2>&1; rm -rf Testing",
           folder, UMBRA_SOURCE_DIR);
  for (int skips = 0; skips < 2; skips++) {
    write_tests(path, skips ? "skip" : "pass");
    assert_int_equal(shell(command), 0);
    char said_path[UM_TEST_PATH + 32];
    snprintf(said_path, sizeof said_path, "%s/said", folder);
    FILE *file = fopen(said_path, "rb");
    assert_non_null(file);
    said[fread(said, 1, sizeof said - 1, file)] = '\0';
    fclose(file);
    remove(said_path);
    const char *list = strstr(said, "tests that did not run, which counts as failure:\n  part\n");
    if ((list != NULL) != (skips == 1) || strstr(said, skips ? "code 1\n" : "code 0\n") == NULL)
      fail_msg("%s", said);
  }
  remove(path);
  assert_int_equal(um_test_folder_remove(folder), 0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(exit_status), cmocka_unit_test(runner)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
