/* Lists of words in the tables of the laboratory. */
#include <stdio.h>
#include <string.h>

#include "tests/lab/lab.h"

void lab_append(char *list, size_t size, const char *text)
{
  size_t n = strlen(list);
  snprintf(list + n, size - n, "%s%s", n > 0 ? "+" : "", text);
}
