/* Commands that are refused before anything is written. */
#ifndef UMBRA_TESTS_APP_FAILURE_H
#define UMBRA_TESTS_APP_FAILURE_H

#include <stddef.h>

struct failure {
  const char *argument[20], *says;
};

/* Exit status 1, nothing on standard output, one line on standard error that holds `says`, and in
 * the working folder nothing added, removed or changed. */
void failure_expect(const char *const *arguments, const char *says);
void failures_expect(const struct failure *failures, size_t n);

#endif
