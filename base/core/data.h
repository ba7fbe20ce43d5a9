/* The files that come with the program: materials, scenarios. */
#ifndef UMBRA_CORE_DATA_H
#define UMBRA_CORE_DATA_H

#include "base/core/context.h"

/* The file that this code is part of, links resolved: the program, or a shared library. The caller
 * frees. UM_ERR_IO: the system does not say; UM_ERR_MEMORY. */
enum um_status um_core_data_program(struct um_context *context, char **out);

/* Folder `name` ("materials", "filters", "sensors", "scenarios") of the program's own files; the
 * caller frees. The first that holds: the context's data folder, where it has one
 * (um_core_context_set_data),
 *   $UMBRA_DATA/name, where that variable is set,
 *   share/umbra/name beside the program, or beside the shared library that this code is part of (as
 *   they were installed, wherever the tree was moved to),
 *   the source tree, where program or library stand in their build folder.
 * UM_ERR_IO names what is missing; UM_ERR_MEMORY. */
enum um_status um_core_data_folder(struct um_context *context, const char *name, char **out);

/* Names of its files that end in `tail` (".csv"), without that end, in the order of strcmp;
 * um_core_listing_free frees. Errors as above. */
enum um_status um_core_data_names(struct um_context *context, const char *folder, const char *tail,
                                  char ***names, size_t *count);
/* Path of the one of that name; the caller frees. kind: what it is called in messages, "filter".
 * UM_ERR_INPUT "no filter 'x'", with the nearest and all names; errors as above. */
enum um_status um_core_data_find(struct um_context *context, const char *kind, const char *folder,
                                 const char *tail, const char *name, char **out);

#endif
