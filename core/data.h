/* The files that come with the program: materials, scenarios. */
#ifndef UMBRA_CORE_DATA_H
#define UMBRA_CORE_DATA_H

#include "core/context.h"

/* Folder `name` ("materials", "filters", "scenarios") of the program's own files; the caller frees.
 * The first that holds: $UMBRA_DATA/name, where that variable is set,
 *   ../share/umbra/name from the folder of the running program (as it was installed, wherever the
 *   tree was moved to),
 *   the source tree, where the program runs from its build folder.
 * UM_ERR_IO names what is missing; UM_ERR_MEMORY. */
enum um_status um_core_data_folder(struct um_context *context, const char *name, char **out);

#endif
