/* Reading of folders. */
#include "base/core/listing.h"

#include <dirent.h>
#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static int compare_names(const void *a, const void *b)
{
  const char *const *x = a, *const *y = b;
  return strcmp(*x, *y);
}

void um_core_listing_free(struct um_context *context, char **names, size_t count)
{
  for (size_t i = 0; names != NULL && i < count; i++) um_core_free(context, names[i]);
  um_core_free(context, names);
}

static bool is_meant(const char *name, const char *tail)
{
  size_t n = strlen(name), end = strlen(tail);
  return n > end && name[0] != '.' && strcmp(name + n - end, tail) == 0;
}

enum um_status um_core_listing(struct um_context *context, const char *folder, const char *tail,
                               const char *what, char ***names, size_t *count)
{
  enum um_status status = UM_OK;
  char **list = NULL;
  size_t n = 0;
  *names = NULL;
  *count = 0;
  DIR *directory = opendir(folder);
  if (directory == NULL)
    return um_core_fail(context, UM_ERR_IO, "%s: %s; accepted: a folder of %s", folder,
                        strerror(errno), what);
  for (struct dirent *entry = readdir(directory); entry != NULL; entry = readdir(directory)) {
    if (!is_meant(entry->d_name, tail)) continue;
    UM_CHECK(um_core_reallocate(context, n + 1, sizeof *list, &list));
    UM_CHECK(um_core_strdup(context, entry->d_name, &list[n]));
    n++;
  }
  if (n > 1) qsort(list, n, sizeof *list, compare_names);
  *names = list;
  *count = n;
  list = NULL;
done:
  closedir(directory);
  if (status != UM_OK) um_core_listing_free(context, list, n);
  return status;
}
