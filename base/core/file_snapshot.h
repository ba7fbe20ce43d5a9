/* A snapshot of files: they stay as they are while work on them lasts. Digests of their bytes. */
#ifndef UMBRA_CORE_FILE_SNAPSHOT_H
#define UMBRA_CORE_FILE_SNAPSHOT_H

#include <stdint.h>

#include "base/core/context.h"

/* Between the two, which nest, every file that um_core_file_read is asked for is read from the disk
 * once and served from memory again; a file that could not be read is tried again.
 * Begin: UM_ERR_MEMORY. The end does not fail. */
enum um_status um_core_snapshot_begin(struct um_context *context);
void um_core_snapshot_end(struct um_context *context);
/* A file that others read, a library or the loader of programs, is in the snapshot from here on; it
 * is not kept in memory. Nothing where there is none. UM_ERR_IO: it cannot be read, or is noted
 * already and has changed since, or was read by um_core_file_read, which refuses one that is noted:
 * it is of another kind now. */
enum um_status um_core_snapshot_note(struct um_context *context, const char *path);
/* A file leaves the snapshot, and the record of what a command read (base/core/replay.h): it is no
 * input of the user's, and is read from the disk the next time. Does not fail. */
void um_core_snapshot_forget(struct um_context *context, const char *path);
/* Every file that was read or noted since the last um_core_snapshot_begin, in the order of the
 * first time, with the digest of its bytes (base/core/digest.h). */
void um_core_snapshot_each(struct um_context *context,
                           void (*each)(void *self, const char *path, uint64_t digest), void *self);
/* Digest of the bytes of a file. UM_ERR_IO, UM_ERR_CANCELLED. */
enum um_status um_core_file_digest(struct um_context *context, const char *path, uint64_t *out);

#endif
