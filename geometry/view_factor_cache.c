/* View factors kept between runs, and such as a user gives. A file of the cache has its name from
 * all that its view factors are made of, so that a satellite that changes finds none, and none is
 * ever written over with other content. Its last line has a checksum of all bytes above, so that
 * what a disk or an editor changed is not taken; what it says of itself is checked all the same. */
#include <errno.h>
#include <inttypes.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/digest.h"
#include "base/core/file.h"
#include "base/core/file_snapshot.h"
#include "base/core/sampling.h"
#include "geometry/view_factor_file.h"

#define BYTES_MAX ((size_t)1 << 30)
#define SEAL      "# checksum (FNV-1a, 64 bits) of all bytes above: %016" PRIx64 "\n"

/* Does the text end in the checksum of what stands before it? */
static bool is_sealed(const char *text, size_t length)
{
  char seal[80];
  size_t tail = (size_t)snprintf(seal, sizeof seal, SEAL, UINT64_C(0));
  if (length < tail) return false;
  snprintf(seal, sizeof seal, SEAL, um_core_digest(UM_CORE_DIGEST_BEGIN, text, length - tail));
  return memcmp(text + length - tail, seal, tail) == 0;
}

static enum um_status path_of(struct um_context *context, const char *name, const char *folder,
                              const struct um_geometry_view_factor_key *key, char **out)
{
  uint64_t a = um_core_hash(um_core_hash(1, key->surfaces), key->positions);
  uint64_t b = um_core_hash(um_core_hash(2, key->angles), key->sampling);
  return um_core_asprintf(context, out, "%s/view-factors-%s-%016" PRIx64 "%016" PRIx64 ".csv",
                          folder, name, a, b);
}

/* A file of the cache. It is not held: it may be made anew, and is no input of the user's. */
static enum um_status read_file(struct um_context *context, const char *path,
                                struct um_geometry_view_factor_set *set)
{
  char *text = NULL;
  size_t length;
  enum um_status status = um_core_file_read(context, path, BYTES_MAX, &text, &length);
  um_core_snapshot_forget(context, path);
  UM_TRY(status);
  if (!is_sealed(text, length))
    status = um_core_fail(context, UM_ERR_INPUT,
                          "%s: its checksum is missing or of other bytes; accepted: what was "
                          "written, unchanged",
                          path);
  else
    status = um_geometry_view_factor_file_parse(context, path, text, length, set);
  um_core_free(context, text);
  return status;
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
    status = read_file(context, path, set);
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

/* The checksum of what stands in the file goes behind it. Errors are the stream's. */
static void seal(FILE *file)
{
  char bytes[4096];
  uint64_t digest = UM_CORE_DIGEST_BEGIN;
  (void)fseek(file, 0, SEEK_SET);
  for (size_t n; (n = fread(bytes, 1, sizeof bytes, file)) > 0;)
    digest = um_core_digest(digest, bytes, n);
  (void)fseek(file, 0, SEEK_END);
  fprintf(file, SEAL, digest);
}

static enum um_status write_file(struct um_context *context, const char *partial, const char *path,
                                 const struct um_geometry_view_factor_set *set)
{
  FILE *file = fopen(partial, "w+");
  if (file == NULL) return um_core_fail(context, UM_ERR_IO, "%s: %s", partial, strerror(errno));
  um_geometry_view_factor_file_write(set, file);
  seal(file);
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
  UM_FREE(context, path, partial);
  return status;
}
