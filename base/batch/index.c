/* Points by the bits of their coordinates: a table of open addressing over a growing list. */
#include "base/batch/index_impl.h"

#include <string.h>

#include "base/core/digest.h"

#define FREE SIZE_MAX

struct um_batch_index {
  size_t ncoordinate, count, room, nslot; /* nslot: a power of two, at least 2 * room */
  double *coordinate;                     /* [room][ncoordinate] */
  struct um_batch_index_point *point;     /* [room] */
  size_t *slot;                           /* [nslot] number of a point, or FREE */
};

enum um_status um_batch_index_create(struct um_context *context, size_t ncoordinate,
                                     struct um_batch_index **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  (*out)->ncoordinate = ncoordinate;
  return UM_OK;
}

void um_batch_index_destroy(struct um_context *context, struct um_batch_index **index)
{
  if (index == NULL || *index == NULL) return;
  for (size_t i = 0; i < (*index)->count; i++) um_core_free(context, (*index)->point[i].reason);
  um_core_free(context, (*index)->coordinate);
  um_core_free(context, (*index)->point);
  um_core_free(context, (*index)->slot);
  um_core_free(context, *index);
  *index = NULL;
}

/* The upper half folded in: neighbouring doubles differ in few bits. */
static uint64_t hash(const double *coordinate, size_t n)
{
  uint64_t h = um_core_digest(UM_CORE_DIGEST_BEGIN, coordinate, n * sizeof *coordinate);
  return h ^ (h >> 32);
}

/* The slot where these coordinates stand, or the free one where they would. */
static size_t find_slot(const struct um_batch_index *index, const double *coordinate)
{
  size_t n = index->ncoordinate, s = (size_t)hash(coordinate, n) & (index->nslot - 1);
  while (index->slot[s] != FREE &&
         memcmp(index->coordinate + index->slot[s] * n, coordinate, n * sizeof *coordinate) != 0)
    s = (s + 1) & (index->nslot - 1);
  return s;
}

static enum um_status grow(struct um_context *context, struct um_batch_index *index)
{
  size_t room = index->room == 0 ? 64 : 2 * index->room, nslot = 2 * room, *slot;
  UM_TRY(
      um_core_reallocate(context, room, index->ncoordinate * sizeof(double), &index->coordinate));
  UM_TRY(um_core_reallocate(context, room, sizeof *index->point, &index->point));
  UM_TRY(um_core_allocate(context, nslot, sizeof *slot, &slot));
  um_core_free(context, index->slot);
  index->slot = slot;
  index->nslot = nslot;
  index->room = room;
  for (size_t s = 0; s < nslot; s++) slot[s] = FREE;
  for (size_t i = 0; i < index->count; i++)
    slot[find_slot(index, index->coordinate + i * index->ncoordinate)] = i;
  return UM_OK;
}

enum um_status um_batch_index_number(struct um_context *context, struct um_batch_index *index,
                                     const double *coordinate, size_t *number)
{
  if (index->count == index->room) UM_TRY(grow(context, index));
  size_t s = find_slot(index, coordinate);
  if (index->slot[s] == FREE) {
    size_t i = index->count++;
    memcpy(index->coordinate + i * index->ncoordinate, coordinate,
           index->ncoordinate * sizeof *coordinate);
    index->point[i] = (struct um_batch_index_point){.state = UM_BATCH_NEW};
    index->slot[s] = i;
  }
  *number = index->slot[s];
  return UM_OK;
}

size_t um_batch_index_find(const struct um_batch_index *index, const double *coordinate)
{
  return index->nslot == 0 ? FREE : index->slot[find_slot(index, coordinate)];
}

struct um_batch_index_point *um_batch_index_point(struct um_batch_index *index, size_t number)
{
  return &index->point[number];
}

const double *um_batch_index_coordinate(const struct um_batch_index *index, size_t number)
{
  return index->coordinate + number * index->ncoordinate;
}

size_t um_batch_index_count(const struct um_batch_index *index) { return index->count; }
