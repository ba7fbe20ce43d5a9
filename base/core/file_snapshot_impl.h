/* Contents of the files of a snapshot. Private to base/core/. */
#ifndef UMBRA_CORE_FILE_SNAPSHOT_IMPL_H
#define UMBRA_CORE_FILE_SNAPSHOT_IMPL_H

#include <stdbool.h>

#include "base/core/context_impl.h"

/* A copy of what was read before, as um_core_file_read gives it; *found: there is one. */
enum um_status um_core_snapshot_find(struct um_context *context, const char *path, char **out,
                                     size_t *length, bool *found);
/* Remember a copy while a snapshot lasts; nothing otherwise. UM_ERR_MEMORY. */
enum um_status um_core_snapshot_add(struct um_context *context, const char *path, const char *text,
                                    size_t length);

#endif
