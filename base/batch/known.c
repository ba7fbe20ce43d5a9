/* Points by the bits of their coordinates: a table of open addressing over a growing list. */
#include "base/batch/known_impl.h"

#include <string.h>

#include "base/core/digest.h"

#define FREE SIZE_MAX

struct um_batch_known {
  size_t ncoordinate, count, room, nslot; /* nslot: a power of two, at least 2 * room */
  double *coordinate;                     /* [room][ncoordinate] */
  struct um_batch_known_point *point;     /* [room] */
  size_t *slot;                           /* [nslot] number of a point, or FREE */
};

enum um_status um_batch_known_create(struct um_context *context, size_t ncoordinate,
                                     struct um_batch_known **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  (*out)->ncoordinate = ncoordinate;
  return UM_OK;
}

void um_batch_known_destroy(struct um_context *context, struct um_batch_known **known)
{
  if (known == NULL || *known == NULL) return;
  for (size_t i = 0; i < (*known)->count; i++) um_core_free(context, (*known)->point[i].reason);
  um_core_free(context, (*known)->coordinate);
  um_core_free(context, (*known)->point);
  um_core_free(context, (*known)->slot);
  um_core_free(context, *known);
  *known = NULL;
}

/* The upper half folded in: neighbouring doubles differ in few bits. */
static uint64_t hash(const double *coordinate, size_t n)
{
  uint64_t h = um_core_digest(UM_CORE_DIGEST_BEGIN, coordinate, n * sizeof *coordinate);
  return h ^ (h >> 32);
}

/* The slot where these coordinates stand, or the free one where they would. */
static size_t find_slot(const struct um_batch_known *known, const double *coordinate)
{
  size_t n = known->ncoordinate, s = (size_t)hash(coordinate, n) & (known->nslot - 1);
  while (known->slot[s] != FREE &&
         memcmp(known->coordinate + known->slot[s] * n, coordinate, n * sizeof *coordinate) != 0)
    s = (s + 1) & (known->nslot - 1);
  return s;
}

static enum um_status grow(struct um_context *context, struct um_batch_known *known)
{
  size_t room = known->room == 0 ? 64 : 2 * known->room, nslot = 2 * room, *slot;
  UM_TRY(
      um_core_reallocate(context, room, known->ncoordinate * sizeof(double), &known->coordinate));
  UM_TRY(um_core_reallocate(context, room, sizeof *known->point, &known->point));
  UM_TRY(um_core_allocate(context, nslot, sizeof *slot, &slot));
  um_core_free(context, known->slot);
  known->slot = slot;
  known->nslot = nslot;
  known->room = room;
  for (size_t s = 0; s < nslot; s++) slot[s] = FREE;
  for (size_t i = 0; i < known->count; i++)
    slot[find_slot(known, known->coordinate + i * known->ncoordinate)] = i;
  return UM_OK;
}

enum um_status um_batch_known_number(struct um_context *context, struct um_batch_known *known,
                                     const double *coordinate, size_t *number)
{
  if (known->count == known->room) UM_TRY(grow(context, known));
  size_t s = find_slot(known, coordinate);
  if (known->slot[s] == FREE) {
    size_t i = known->count++;
    memcpy(known->coordinate + i * known->ncoordinate, coordinate,
           known->ncoordinate * sizeof *coordinate);
    known->point[i] = (struct um_batch_known_point){.state = UM_BATCH_NEW};
    known->slot[s] = i;
  }
  *number = known->slot[s];
  return UM_OK;
}

size_t um_batch_known_find(const struct um_batch_known *known, const double *coordinate)
{
  return known->nslot == 0 ? FREE : known->slot[find_slot(known, coordinate)];
}

struct um_batch_known_point *um_batch_known_point(struct um_batch_known *known, size_t number)
{
  return &known->point[number];
}

const double *um_batch_known_coordinate(const struct um_batch_known *known, size_t number)
{
  return known->coordinate + number * known->ncoordinate;
}

size_t um_batch_known_count(const struct um_batch_known *known) { return known->count; }
