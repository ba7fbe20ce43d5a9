/* Memory that is given back at once: many small things of one owner. */
#ifndef UMBRA_CORE_ARENA_H
#define UMBRA_CORE_ARENA_H

#include "base/core/context.h"

struct um_core_arena_block; /* opaque */

/* All zero: empty. */
struct um_core_arena {
  struct um_core_arena_block *block;
};

/* `count` zeroed objects of `size` bytes, aligned for anything; *out (any pointer type) is set to
 * NULL before an error. The arena owns them. UM_ERR_MEMORY. */
enum um_status um_core_arena_allocate(struct um_context *context, struct um_core_arena *arena,
                                      size_t count, size_t size, void *out);
/* Gives everything back; the arena is empty then. Does not fail. */
void um_core_arena_release(struct um_context *context, struct um_core_arena *arena);

#endif
