/* Commands that are refused before anything is written. */
#include "tests/app/failure.h"

#include <stdlib.h>
#include <string.h>

#include "tests/app/command.h"

void failure_expect(const char *const *arguments, const char *says)
{
  char *before = command_snapshot(".");
  struct command c = command_run_list(arguments);
  char *after = command_snapshot(".");
  if (c.code != 1 || c.out[0] != '\0' || command_count_lines(c.err) != 1 ||
      strstr(c.err, says) == NULL)
    fail_msg("exit %d, expected 1 and '%s':\n%s%s", c.code, says, c.out, c.err);
  if (strcmp(before, after) != 0) fail_msg("'%s', but files are other ones", says);
  command_release(&c);
  free(before);
  free(after);
}

void failures_expect(const struct failure *failures, size_t n)
{
  for (size_t i = 0; i < n; i++) failure_expect(failures[i].argument, failures[i].says);
}
