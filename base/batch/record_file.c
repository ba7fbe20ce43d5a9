/* Bytes of a file of records. */
#define _GNU_SOURCE /* flock */
#include "base/batch/record_file_impl.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#include <zlib.h>

#include "base/core/file.h"

#define LOCK_PATIENCE 40   /* looks at a lock that a dying process may still hold */
#define LOCK_NAP      0.05 /* between two of them [s] */

enum um_status um_batch_file_fail(struct um_context *context, const char *path, const char *what)
{
  return um_core_fail(context, UM_ERR_IO, "%s: %s: %s", path, what, strerror(errno));
}

uint32_t um_batch_file_checksum(const void *data, size_t bytes)
{
  const unsigned char *at = data;
  uLong crc = crc32(0L, Z_NULL, 0);
  for (; bytes > 0;) { /* zlib counts in 32 bits */
    uInt some = bytes > 1u << 30 ? 1u << 30 : (uInt)bytes;
    crc = crc32(crc, at, some);
    at += some;
    bytes -= some;
  }
  return (uint32_t)crc;
}

size_t um_batch_file_read(int descriptor, uint64_t offset, void *out, size_t bytes)
{
  size_t done = 0;
  while (done < bytes) {
    ssize_t n = pread(descriptor, (char *)out + done, bytes - done, (off_t)(offset + done));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return SIZE_MAX;
    if (n == 0) break;
    done += (size_t)n;
  }
  return done;
}

bool um_batch_file_write(int descriptor, uint64_t offset, const void *data, size_t bytes)
{
  size_t done = 0;
  while (done < bytes) {
    ssize_t n = pwrite(descriptor, (const char *)data + done, bytes - done, (off_t)(offset + done));
    if (n < 0 && errno == EINTR) continue;
    if (n == 0) errno = ENOSPC;
    if (n <= 0) return false;
    done += (size_t)n;
  }
  return true;
}

enum um_status um_batch_file_lock(struct um_context *context, const struct um_batch_file *file)
{
  static const struct timespec nap = {0, (long)(LOCK_NAP * 1e9)};
  for (int look = 0; look < LOCK_PATIENCE; look++) {
    if (flock(file->descriptor, LOCK_EX | LOCK_NB) == 0) return UM_OK;
    if (errno != EWOULDBLOCK && errno != EINTR) return UM_OK; /* a file system without locks */
    UM_TRY(um_core_stop_check(context, "waiting for records"));
    nanosleep(&nap, NULL);
  }
  return um_core_fail(context, UM_ERR_IO, "%s: another process computes these points", file->path);
}

enum um_status um_batch_file_folder_make(struct um_context *context, const char *folder)
{
  char *path;
  size_t made = 0;
  UM_TRY(um_core_strdup(context, folder, &path));
  enum um_status status = um_core_parents_make(context, path, &made);
  if (status == UM_OK && mkdir(folder, 0777) != 0 && errno != EEXIST)
    status = um_batch_file_fail(context, folder, "cannot make the folder");
  um_core_free(context, path);
  return status;
}

void um_batch_file_folder_sync(const char *folder)
{
  int descriptor = open(folder, O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)fsync(descriptor);
  close(descriptor);
}
