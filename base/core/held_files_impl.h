/* Contents of files that are held. Private to base/core/. */
#ifndef UMBRA_CORE_HELD_FILES_IMPL_H
#define UMBRA_CORE_HELD_FILES_IMPL_H

#include <stdbool.h>

#include "base/core/context_impl.h"

/* A copy of what was read before, as um_core_file_read gives it; *found: there is one. */
enum um_status um_core_held_files_find(struct um_context *context, const char *path, char **out,
                                       size_t *length, bool *found);
/* Remember a copy while files are held; nothing otherwise. UM_ERR_MEMORY. */
enum um_status um_core_held_files_add(struct um_context *context, const char *path,
                                      const char *text, size_t length);

#endif
