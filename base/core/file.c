/* Plain files, whole, and file names. */
#include "base/core/file.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/file_snapshot_impl.h"

#define PIECE ((size_t)16 << 20) /* read between two looks at the stop [bytes] */

static enum um_status fail_errno(struct um_context *context, const char *path)
{
  return um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
}

static enum um_status read_open_file(struct um_context *context, const char *path, FILE *file,
                                     size_t limit, char **out, size_t *length)
{
  struct stat st;
  if (fstat(fileno(file), &st) != 0) return fail_errno(context, path);
  /* files of the kernel's tell no size: start small and grow */
  size_t capacity = st.st_size > 0 ? (size_t)st.st_size + 1 : 4096;
  if (capacity > limit + 1) capacity = limit + 1;
  char *text;
  UM_TRY(um_core_allocate(context, capacity + 1, 1, &text));
  enum um_status status = UM_OK;
  size_t used = 0;
  for (;;) {
    size_t piece = capacity - used < PIECE ? capacity - used : PIECE;
    size_t got = fread(text + used, 1, piece, file);
    used += got;
    UM_CHECK(um_core_stop_check(context, "a file was read"));
    if (got < piece) break;
    if (used < capacity) continue;
    if (used > limit) {
      status =
          um_core_fail(context, UM_ERR_IO, "%s: larger than the %zu bytes accepted", path, limit);
      goto done;
    }
    capacity = capacity > limit / 2 ? limit + 1 : 2 * capacity;
    UM_CHECK(um_core_reallocate(context, capacity + 1, 1, &text));
  }
  if (ferror(file)) {
    status = fail_errno(context, path);
    goto done;
  }
  text[used] = '\0';
  *out = text;
  *length = used;
  text = NULL;
done:
  um_core_free(context, text);
  return status;
}

enum um_status um_core_file_read(struct um_context *context, const char *path, size_t limit,
                                 char **out, size_t *length)
{
  *out = NULL;
  *length = 0;
  bool found;
  UM_TRY(um_core_snapshot_find(context, path, out, length, &found));
  if (found) return UM_OK; /* within the limit: the same reader asks again */
  FILE *file;
  UM_TRY(um_core_file_open(context, path, &file));
  enum um_status status = read_open_file(context, path, file, limit, out, length);
  fclose(file);
  if (status == UM_OK) status = um_core_snapshot_add(context, path, *out, *length);
  if (status != UM_OK) {
    um_core_free(context, *out);
    *out = NULL;
  }
  return status;
}

enum um_status um_core_path_resolve(struct um_context *context, const char *base_file,
                                    const char *relative, char **out)
{
  const char *slash = strrchr(base_file, '/');
  if (relative[0] == '/' || slash == NULL) return um_core_strdup(context, relative, out);
  return um_core_asprintf(context, out, "%.*s/%s", (int)(slash - base_file), base_file, relative);
}

bool um_core_path_is_plain(const char *name)
{
  return name[0] != '\0' && strcmp(name, ".") != 0 && strcmp(name, "..") != 0 &&
         strchr(name, '/') == NULL;
}

enum um_status um_core_file_write(struct um_context *context, const char *name, const void *bytes,
                                  size_t n, FILE *file)
{
  errno = 0;
  if (fwrite(bytes, 1, n, file) == n && fflush(file) == 0) return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: cannot be written: %s", name,
                      errno != 0 ? strerror(errno) : "write error");
}

enum um_status um_core_file_close(struct um_context *context, const char *name, FILE **file)
{
  if (*file == NULL) return UM_OK;
  errno = 0;
  bool failed = ferror(*file) != 0;
  if (fclose(*file) != 0) failed = true;
  *file = NULL;
  if (!failed) return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: cannot be written: %s", name,
                      errno != 0 ? strerror(errno) : "write error");
}

enum um_status um_core_file_partial(struct um_context *context, const char *path, char **out)
{
  const char *slash = strrchr(path, '/');
  const char *name = slash == NULL ? path : slash + 1;
  return um_core_asprintf(context, out, "%.*s.%s.partial-%ld", (int)(name - path), path, name,
                          (long)getpid());
}

enum um_status um_core_file_create(struct um_context *context, const char *path, FILE **out)
{
  *out = fopen(path, "wb");
  if (*out != NULL) return UM_OK;
  return um_core_fail(context, UM_ERR_IO, "%s: cannot be written: %s", path, strerror(errno));
}

enum um_status um_core_whole_begin(struct um_context *context, const char *path,
                                   struct um_core_whole_file *out)
{
  *out = (struct um_core_whole_file){.path = path};
  UM_TRY(um_core_file_partial(context, path, &out->partial));
  um_core_file_stale_temporaries_remove(context, path);
  out->file = fopen(out->partial, "wb");
  if (out->file != NULL) return UM_OK;
  um_core_free(context, out->partial);
  return um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
}

enum um_status um_core_whole_end(struct um_context *context, struct um_core_whole_file *whole,
                                 enum um_status status)
{
  if (status == UM_OK) status = um_core_file_sync(context, whole->path, whole->file);
  enum um_status closed = um_core_file_close(context, whole->path, &whole->file);
  if (status == UM_OK) status = closed;
  if (status == UM_OK && rename(whole->partial, whole->path) != 0)
    status = um_core_fail(context, UM_ERR_IO, "%s: %s", whole->path, strerror(errno));
  if (status != UM_OK) (void)remove(whole->partial);
  um_core_free(context, whole->partial);
  return status;
}
