/* Private to base/core/: what a folder in the making needs of the file system, and what dead ones
 * left.
 */
#ifndef UMBRA_CORE_STALE_TEMPORARIES_IMPL_H
#define UMBRA_CORE_STALE_TEMPORARIES_IMPL_H

#include "base/core/context.h"

#define UM_CORE_FOLDER_MARKER ".umbra"

/* Remove a folder with all that is in it; 0, or -1 with errno. */
int um_core_tree_remove(const char *path);
/* Bring every file and folder of a tree to the disk. UM_ERR_IO "path: reason". */
enum um_status um_core_tree_sync(struct um_context *context, const char *path);
/* Bring the names in the folder around `path` to the disk, as far as the file system can. */
void um_core_folder_sync_parent(const char *path);
/* Remove what processes that have died left beside `target`: ".name.partial-<pid>...", folder or
 * file, and ".name.old-<pid>...", which is put back where `target` is missing. Those of living
 * processes stay. What cannot be removed stays too. */
void um_core_stale_temporaries_remove(struct um_context *context, const char *target);

#endif
