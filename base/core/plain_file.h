/* Files that Umbra did not make are opened here alone. */
#ifndef UMBRA_CORE_PLAIN_FILE_H
#define UMBRA_CORE_PLAIN_FILE_H

#include <stdio.h>

#include "base/core/context.h"

/* Open a plain file, the only way in which Umbra opens what it did not make: a folder, a pipe, a
 * device or a socket is refused, and none is waited for. UM_ERR_IO "path: reason", UM_ERR_MEMORY.
 * For reading; the caller closes. */
enum um_status um_core_file_open(struct um_context *context, const char *path, FILE **out);
/* For a library that opens by name: can it be read, and is it plain? */
enum um_status um_core_file_check(struct um_context *context, const char *path);
/* With the flags of open(2); closed by an exec. *out: -1 on an error. */
enum um_status um_core_descriptor_open(struct um_context *context, const char *path, int flags,
                                       int *out);

#endif
