/* MEASURED... of a command line. */
#include "app/measured.h"

enum um_status um_app_measured_read(struct um_context *context,
                                    const struct um_app_options *options,
                                    struct um_compare_measurements **out)
{
  size_t n = 1 + options->nmore;
  const char **path = NULL;
  *out = NULL;
  UM_TRY(um_core_allocate(context, n, sizeof *path, (void *)&path));
  path[0] = options->positional[1];
  for (size_t i = 1; i < n; i++) path[i] = options->more[i - 1];
  enum um_status status = um_compare_measurements_read_all(context, path, n, out);
  um_core_free(context, (void *)path);
  return status;
}
