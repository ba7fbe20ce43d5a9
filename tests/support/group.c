/* How a group of tests begins and ends: in a folder of its own, and with what CTest is told. */
#include <ftw.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/support/cmocka_all.h"
#include "tests/support/temporary.h"

static bool skipped;
static char folder[UM_TEST_PATH];

void um_test_skip_note(void) { skipped = true; }

void um_test_begin(void)
{
  if (um_test_folder_create(folder) == 0 && chdir(folder) == 0) return;
  perror("no temporary folder to test in");
  exit(EXIT_FAILURE);
}

static int take_away(const char *path, const struct stat *status, int kind, struct FTW *where)
{
  (void)status;
  (void)kind;
  if (where->level > 0) fprintf(stderr, "the tests left %s\n", path);
  return remove(path);
}

int um_test_result(int failures)
{
  if (um_test_folder_remove(folder) != 0) {
    failures++;
    if (nftw(folder, take_away, 16, FTW_DEPTH | FTW_PHYS) != 0) perror(folder);
  }
  if (failures != 0) return failures < UM_TEST_SKIPPED ? failures : UM_TEST_SKIPPED - 1;
  return skipped ? UM_TEST_SKIPPED : 0;
}
