/* Blocks that are filled one after another; what does not fit gets a block of its own size. */
#include "base/core/arena.h"

#include <stdint.h>
#include <string.h>

#define BLOCK ((size_t)16 << 10) /* [bytes] */

struct um_core_arena_block {
  struct um_core_arena_block *next;
  size_t used, size; /* [bytes] behind the header */
  max_align_t data[];
};

enum um_status um_core_arena_allocate(struct um_context *context, struct um_core_arena *arena,
                                      size_t count, size_t size, void *out)
{
  char *at = NULL;
  memcpy(out, &at, sizeof at);
  if (size != 0 && count > SIZE_MAX / 4 / size)
    return um_core_fail(context, UM_ERR_MEMORY, "out of memory: %zu objects of %zu bytes", count,
                        size);
  size_t unit = sizeof(max_align_t), bytes = (count * size + unit) / unit * unit;
  struct um_core_arena_block *block = arena->block;
  if (block == NULL || block->size - block->used < bytes) {
    size_t room = bytes > BLOCK ? bytes : BLOCK;
    UM_TRY(um_core_allocate(context, 1, sizeof *block + room, &block));
    block->size = room;
    block->next = arena->block;
    arena->block = block;
  }
  at = (char *)block->data + block->used;
  block->used += bytes;
  memcpy(out, &at, sizeof at);
  return UM_OK;
}

void um_core_arena_release(struct um_context *context, struct um_core_arena *arena)
{
  struct um_core_arena_block *block = arena->block;
  while (block != NULL) {
    struct um_core_arena_block *next = block->next;
    um_core_free(context, block);
    block = next;
  }
  arena->block = NULL;
}
