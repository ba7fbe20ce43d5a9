/* Files and folders of a test's own, below $TMPDIR or, without one, the system's P_tmpdir. Who
 * makes one removes it. */
#ifndef UMBRA_TESTS_SUPPORT_TEMPORARY_H
#define UMBRA_TESTS_SUPPORT_TEMPORARY_H

#include <stddef.h>

#define UM_TEST_PATH 256 /* [bytes] of a path made here, its end included */

/* A fresh, empty folder. Returns 0, or -1 when there is none: fit for a fixture of CMocka. */
int um_test_folder_create(char path[UM_TEST_PATH]);
/* Removes it. It must be empty again, so that what a program leaves behind shows. 0 or -1. */
int um_test_folder_remove(const char *path);

/* A fresh file that holds these bytes; fails the running test when it cannot be written. The caller
 * removes it. */
void um_test_file_create(char path[UM_TEST_PATH], const void *bytes, size_t length);

#endif
