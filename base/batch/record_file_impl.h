/* Private to base/batch/: bytes of a file of records. */
#ifndef UMBRA_BATCH_RECORD_FILE_IMPL_H
#define UMBRA_BATCH_RECORD_FILE_IMPL_H

#include <stdbool.h>
#include <stdint.h>

#include "base/core/context.h"

struct um_batch_file {
  char *path;
  int descriptor; /* -1: closed */
};

/* UM_ERR_IO "path: what: reason of errno". */
enum um_status um_batch_file_fail(struct um_context *context, const char *path, const char *what);
/* CRC-32 (of zlib). */
uint32_t um_batch_file_checksum(const void *data, size_t bytes);
/* Bytes read at offset: fewer than asked at the end of the file, SIZE_MAX on an error (errno). */
size_t um_batch_file_read(int descriptor, uint64_t offset, void *out, size_t bytes);
/* All bytes at offset; false with errno. */
bool um_batch_file_write(int descriptor, uint64_t offset, const void *data, size_t bytes);
/* For this process alone; a process that is dying is waited for. UM_ERR_IO, UM_ERR_CANCELLED. */
enum um_status um_batch_file_lock(struct um_context *context, const struct um_batch_file *file);
/* The folder and those above it, where they are missing. UM_ERR_IO. */
enum um_status um_batch_file_folder_make(struct um_context *context, const char *folder);
/* Bring the names in a folder to the disk, as far as the file system can. */
void um_batch_file_folder_sync(const char *folder);

#endif
