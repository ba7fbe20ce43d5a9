/* Memory that counts its blocks and runs out when told to: malloc, realloc and free behind it. */
#include "tests/support/allocator.h"

#include <stdlib.h>

static bool fails(struct um_test_memory *m)
{
  m->calls++;
  return m->fail_call != 0 &&
         (m->calls == m->fail_call || (m->stays_out && m->calls > m->fail_call));
}

static void *allocate(void *self, size_t bytes)
{
  struct um_test_memory *m = self;
  if (fails(m)) return NULL;
  void *block = malloc(bytes);
  if (block != NULL) m->alive++;
  return block;
}

static void *reallocate(void *self, void *block, size_t bytes)
{
  struct um_test_memory *m = self;
  if (fails(m)) return NULL;
  bool fresh = block == NULL;
  void *grown = realloc(block, bytes);
  if (fresh && grown != NULL) m->alive++;
  return grown;
}

static void release(void *self, void *block)
{
  struct um_test_memory *m = self;
  if (block != NULL) m->alive--;
  free(block);
}

struct um_core_allocator um_test_memory_allocator(struct um_test_memory *memory)
{
  return (struct um_core_allocator){memory, allocate, reallocate, release};
}
