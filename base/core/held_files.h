/* Files that stay as they are while work on them lasts, and digests of their bytes. */
#ifndef UMBRA_CORE_HELD_FILES_H
#define UMBRA_CORE_HELD_FILES_H

#include <stdint.h>

#include "base/core/context.h"

/* Between the two, which nest, every file that um_core_file_read is asked for is read from the disk
 * once and served from memory again; a file that could not be read is tried again. Hold:
 * UM_ERR_MEMORY. Letting go does not fail. */
enum um_status um_core_files_hold(struct um_context *context);
void um_core_files_let_go(struct um_context *context);
/* A file that others read, a library or the loader of programs, is among the held from here on; it
 * is not kept in memory. Nothing where none are held. UM_ERR_IO: it cannot be read, or is noted
 * already and has changed since, or was read by um_core_file_read, which refuses one that is noted:
 * it is of another kind now. */
enum um_status um_core_file_note(struct um_context *context, const char *path);
/* One of them is held no longer: it is read from the disk the next time. Does not fail. */
void um_core_file_forget(struct um_context *context, const char *path);
/* Every file that was read or noted since the last um_core_files_hold, in the order of the first
 * time, with the digest of its bytes (base/core/digest.h). */
void um_core_files_each(struct um_context *context,
                        void (*each)(void *self, const char *path, uint64_t digest), void *self);
/* Digest of the bytes of a file. UM_ERR_IO, UM_ERR_CANCELLED. */
enum um_status um_core_file_digest(struct um_context *context, const char *path, uint64_t *out);

#endif
