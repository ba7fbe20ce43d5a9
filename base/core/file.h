/* Files and folders that appear whole or not at all. */
#ifndef UMBRA_CORE_FILE_H
#define UMBRA_CORE_FILE_H

#include <stdbool.h>
#include <stdio.h>

#include "base/core/plain_file.h"

/* Whole plain file as bytes with a NUL behind them; the caller frees. Refuses files over `limit`
 * bytes. Errors as um_core_file_open. */
enum um_status um_core_file_read(struct um_context *context, const char *path, size_t limit,
                                 char **out, size_t *length);
/* "dir of base_file / relative", or a copy when `relative` is absolute; the caller frees. */
enum um_status um_core_path_resolve(struct um_context *context, const char *base_file,
                                    const char *relative, char **out);
/* Make every missing folder above `path`, which is as before on return; *made grows by their
 * number. UM_ERR_IO. */
enum um_status um_core_parents_make(struct um_context *context, char *path, size_t *made);
/* True for a file name that cannot lead out of a folder: no '/', not "", "." or "..". */
bool um_core_path_is_plain(const char *name);

/* An output folder in the making: written beside `path` under a temporary name, renamed at commit.
 * begin fails with UM_ERR_IO when `path` exists and is not an Umbra folder (no ".umbra" marker
 * file) unless `force`; nothing is touched then. What dead processes left beside `path` is removed.
 * abort removes what was written. */
struct um_core_folder;
enum um_status um_core_folder_begin(struct um_context *context, const char *path, bool force,
                                    struct um_core_folder **out);
/* Path of the temporary folder; borrowed. */
const char *um_core_folder_path(const struct um_core_folder *folder);
/* Open a plain file name inside for writing; the caller closes with um_core_file_close. */
enum um_status um_core_folder_open(struct um_context *context, struct um_core_folder *folder,
                                   const char *name, FILE **out);
/* Open a file for writing. UM_ERR_IO with path and reason; *out is NULL then. */
enum um_status um_core_file_create(struct um_context *context, const char *path, FILE **out);
/* Write all of it. UM_ERR_IO with the name and the reason. */
enum um_status um_core_file_write(struct um_context *context, const char *name, const void *bytes,
                                  size_t n, FILE *file);
/* fclose with its errors (disk full) turned into UM_ERR_IO; sets *file to NULL. */
enum um_status um_core_file_close(struct um_context *context, const char *name, FILE **file);
/* Bring what was written to the disk. UM_ERR_IO. */
enum um_status um_core_file_sync(struct um_context *context, const char *name, FILE *file);
/* "dir/.name.partial-<pid>" beside `path`, to be written and renamed; the caller frees. */
enum um_status um_core_file_partial(struct um_context *context, const char *path, char **out);
/* Remove ".name.partial-<pid>..." beside `path` of processes that have died. Does not fail. */
void um_core_file_stale_temporaries_remove(struct um_context *context, const char *path);

/* A file that appears whole: written beside `path` (borrowed), renamed at the end. */
struct um_core_whole_file {
  FILE *file;
  const char *path;
  char *partial;
};
/* What dead processes left beside `path` is removed. UM_ERR_IO; there is nothing to end then. */
enum um_status um_core_whole_begin(struct um_context *context, const char *path,
                                   struct um_core_whole_file *out);
/* The file takes its name, on the disk, where `status` is UM_OK, else it is removed. Returns
 * `status`, or UM_ERR_IO of what failed here. */
enum um_status um_core_whole_end(struct um_context *context, struct um_core_whole_file *whole,
                                 enum um_status status);

/* The folder takes its name, whole and on the disk; UM_ERR_CANCELLED when a stop was asked for. */
enum um_status um_core_folder_commit(struct um_context *context, struct um_core_folder **folder);
/* The same for a folder that is the user's from then on: it has no marker, so that no later run
 * replaces it. UM_ERR_IO where its name is taken, by an Umbra folder, too. */
enum um_status um_core_folder_give(struct um_context *context, struct um_core_folder **folder);
/* Accepts NULL, sets NULL. */
void um_core_folder_abort(struct um_core_folder **folder);

#endif
