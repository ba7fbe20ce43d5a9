/* Private to base/batch/: the points of a batch by the bits of their coordinates. */
#ifndef UMBRA_BATCH_INDEX_IMPL_H
#define UMBRA_BATCH_INDEX_IMPL_H

#include "base/batch/records_impl.h"

enum um_batch_state {
  UM_BATCH_NEW,    /* asked for the first time */
  UM_BATCH_WANTED, /* to be computed */
  UM_BATCH_RECORD, /* on record */
  UM_BATCH_LOST    /* failed, not on record: a later process may try again */
};

struct um_batch_index_point {
  enum um_batch_state state;
  int deaths;                  /* of workers that computed it */
  struct um_batch_place place; /* of UM_BATCH_RECORD */
  bool foreign;                /* that was there before this process, and was not looked at yet */
  char *reason;                /* of UM_BATCH_LOST; owned */
};

struct um_batch_index;

enum um_status um_batch_index_create(struct um_context *context, size_t ncoordinate,
                                     struct um_batch_index **out);
void um_batch_index_destroy(struct um_context *context, struct um_batch_index **index);
/* Number of the point with these coordinates, a new one where there is none. UM_ERR_MEMORY. */
enum um_status um_batch_index_number(struct um_context *context, struct um_batch_index *index,
                                     const double *coordinate, size_t *number);
/* The number of one that is there, else SIZE_MAX. */
size_t um_batch_index_find(const struct um_batch_index *index, const double *coordinate);
/* Borrowed until the next um_batch_index_number. */
struct um_batch_index_point *um_batch_index_point(struct um_batch_index *index, size_t number);
const double *um_batch_index_coordinate(const struct um_batch_index *index, size_t number);
size_t um_batch_index_count(const struct um_batch_index *index);

#endif
