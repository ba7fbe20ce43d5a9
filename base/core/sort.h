/* Sorting that hears a stop. */
#ifndef UMBRA_CORE_SORT_H
#define UMBRA_CORE_SORT_H

#include "base/core/context.h"

/* qsort for long lists: stable, and stopped within a fraction of a second. base: [count] of `size`
 * bytes each. UM_ERR_MEMORY, UM_ERR_CANCELLED; the order is then any. */
enum um_status um_core_sort(struct um_context *context, void *base, size_t count, size_t size,
                            int (*compare)(const void *, const void *));

#endif
