/* View factors kept between runs, and such as a user gives. A file of the cache has its name from
 * all that its view factors are made of, so that a satellite that changes finds none, and none is
 * ever written over with other content; what an old one says of itself is checked all the same. */
#include <errno.h>
#include <inttypes.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/file.h"
#include "core/sampling.h"
#include "geometry/view_factor_file.h"

static enum um_status path_of(struct um_context *context, const char *name, const char *folder,
                              const struct um_geometry_view_factor_key *key, char **out)
{
  uint64_t a = um_core_hash(um_core_hash(1, key->surfaces), key->positions);
  uint64_t b = um_core_hash(um_core_hash(2, key->angles), key->sampling);
  return um_core_asprintf(context, out, "%s/view-factors-%s-%016" PRIx64 "%016" PRIx64 ".csv",
                          folder, name, a, b);
}

enum um_status um_geometry_view_factor_find(struct um_context *context, const char *name,
                                            const struct um_geometry_view_factor_options *options,
                                            struct um_geometry_view_factor_set *set, bool *found)
{
  char *path = NULL;
  enum um_status status;
  *found = false;
  if (options->import != NULL) {
    UM_TRY(um_core_asprintf(context, &path, "%s/%s.csv", options->import, name));
    status = um_geometry_view_factor_file_read(context, path, false, set);
    *found = status == UM_OK;
    um_core_free(context, path);
    return status;
  }
  if (options->cache == NULL) return UM_OK;
  UM_TRY(path_of(context, name, options->cache, &set->key, &path));
  status = UM_OK;
  if (access(path, F_OK) == 0) {
    status = um_geometry_view_factor_file_read(context, path, true, set);
    *found = status == UM_OK;
    if (status == UM_ERR_INPUT || status == UM_ERR_IO) {
      um_core_log(context, UM_LOG_WARNING, "view factors of the cache are made anew: %s",
                  um_core_message(context));
      um_core_message_clear(context);
      status = UM_OK;
    }
  }
  um_core_free(context, path);
  return status;
}

static enum um_status write_file(struct um_context *context, const char *partial, const char *path,
                                 const struct um_geometry_view_factor_set *set)
{
  FILE *file = fopen(partial, "w");
  if (file == NULL) return um_core_fail(context, UM_ERR_IO, "%s: %s", partial, strerror(errno));
  um_geometry_view_factor_file_write(set, file);
  UM_TRY(um_core_file_close(context, partial, &file));
  if (rename(partial, path) == 0) return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
}

enum um_status um_geometry_view_factor_keep(struct um_context *context, const char *name,
                                            const struct um_geometry_view_factor_options *options,
                                            const struct um_geometry_view_factor_set *set)
{
  char *path = NULL, *partial = NULL;
  enum um_status status;
  if (options->cache == NULL || options->import != NULL) return UM_OK;
  UM_CHECK(path_of(context, name, options->cache, &set->key, &path));
  UM_CHECK(um_core_asprintf(context, &partial, "%s.partial-%ld", path, (long)getpid()));
  (void)mkdir(options->cache, 0777); /* where it fails, so does what follows */
  status = write_file(context, partial, path, set);
  if (status == UM_ERR_IO) {
    (void)unlink(partial);
    um_core_log(context, UM_LOG_WARNING, "view factors are not kept: %s", um_core_message(context));
    um_core_message_clear(context);
    status = UM_OK;
  }
done:
  um_core_free(context, path);
  um_core_free(context, partial);
  return status;
}
