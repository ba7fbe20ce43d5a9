/* Opening what Umbra did not make. */
#include "base/core/plain_file.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/core/replay.h"

static enum um_status fail_errno(struct um_context *context, const char *path)
{
  return um_core_fail(context, UM_ERR_IO, "%s: %s", path, strerror(errno));
}

static enum um_status check_plain(struct um_context *context, const char *path, mode_t mode)
{
  if (S_ISREG(mode)) return UM_OK;
  const char *kind = S_ISDIR(mode)    ? "folder"
                     : S_ISFIFO(mode) ? "pipe"
                     : S_ISSOCK(mode) ? "socket"
                                      : "device";
  return um_core_fail(context, UM_ERR_IO, "%s: is not a plain file but a %s", path, kind);
}

/* Looked at before, since opening may wait for a pipe's other end or wake a device; without waiting
 * and looked at again, since the name may have changed hands in between. */
enum um_status um_core_descriptor_open(struct um_context *context, const char *path, int flags,
                                       int *out)
{
  struct stat st;
  *out = -1;
  if (stat(path, &st) == 0)
    UM_TRY(check_plain(context, path, st.st_mode));
  else if (errno != ENOENT || (flags & O_CREAT) == 0)
    return fail_errno(context, path);
  int descriptor = open(path, flags | O_CLOEXEC | O_NONBLOCK | O_NOCTTY, 0666);
  if (descriptor < 0) return fail_errno(context, path);
  enum um_status status = fstat(descriptor, &st) != 0 ? fail_errno(context, path)
                                                      : check_plain(context, path, st.st_mode);
  if (status == UM_OK)
    *out = descriptor;
  else
    close(descriptor);
  return status;
}

/* To read: on record as an input of the command. */
static enum um_status open_input(struct um_context *context, const char *path, int *out)
{
  UM_TRY(um_core_descriptor_open(context, path, O_RDONLY, out));
  enum um_status status = um_core_replay_note(context, path, *out);
  if (status == UM_OK) return UM_OK;
  close(*out);
  *out = -1;
  return status;
}

enum um_status um_core_file_open(struct um_context *context, const char *path, FILE **out)
{
  int descriptor;
  *out = NULL;
  UM_TRY(open_input(context, path, &descriptor));
  *out = fdopen(descriptor, "rb");
  if (*out != NULL) return UM_OK;
  close(descriptor);
  return um_core_fail(context, UM_ERR_MEMORY, "%s: out of memory", path);
}

enum um_status um_core_file_check(struct um_context *context, const char *path)
{
  int descriptor;
  UM_TRY(open_input(context, path, &descriptor));
  close(descriptor);
  return UM_OK;
}
