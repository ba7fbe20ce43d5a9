/* Files of a folder by the end of their names. */
#ifndef UMBRA_CORE_LISTING_H
#define UMBRA_CORE_LISTING_H

#include <stddef.h>

#include "base/core/context.h"

/* Names in `folder` that end in `tail` (".yaml") and do not begin with a dot, with that end, in the
 * order of strcmp. what: "material records", for the message where there is no such folder
 * (UM_ERR_IO). UM_ERR_MEMORY. The caller frees with um_core_listing_free. */
enum um_status um_core_listing(struct um_context *context, const char *folder, const char *tail,
                               const char *what, char ***names, size_t *count);
void um_core_listing_free(struct um_context *context, char **names, size_t count);

#endif
