/* Private to base/batch/: the files that keep points. One file a writing process, "points.records"
 * or "points-K-of-N.records" of share K; a header (what it is of), then one record a point: what it
 * is, coordinates, then values or the reason why there are none, and a CRC-32 of all that. Bytes in
 * the order of the machine, which the header tells. A record is appended, never changed. */
#ifndef UMBRA_BATCH_RECORDS_IMPL_H
#define UMBRA_BATCH_RECORDS_IMPL_H

#include "base/batch/task.h"

struct um_batch_records;

/* Where a point's record lies. */
struct um_batch_place {
  size_t file;
  uint64_t offset; /* of its values or its reason [byte] */
  uint32_t reason; /* length of the reason, 0: it has values */
};

/* Receives every record that is found; coordinate [ncoordinate], borrowed for the call. */
typedef enum um_status um_batch_found(struct um_context *context, void *self,
                                      const double *coordinate, struct um_batch_place place);

/* Open this process's file for appending and read that and those of other shares. Errors as
 * um_batch_open. */
enum um_status um_batch_records_open(struct um_context *context, const struct um_batch_task *task,
                                     um_batch_found *found, void *self,
                                     struct um_batch_records **out);
/* Append a point: value [nvalue], or a reason (value is not read then). It is the system's after
 * this, and survives the death of this process. A file that could not take it is cut back to what
 * it held. UM_ERR_IO. */
enum um_status um_batch_records_append(struct um_context *context, struct um_batch_records *records,
                                       const double *coordinate, const double *value,
                                       const char *reason, struct um_batch_place *place);
/* Bring what was appended to the disk: it survives the end of power. UM_ERR_IO. */
enum um_status um_batch_records_sync(struct um_context *context, struct um_batch_records *records);
/* Values [nvalue] of a place that has them. UM_ERR_IO. */
enum um_status um_batch_records_value(struct um_context *context,
                                      const struct um_batch_records *records,
                                      struct um_batch_place place, double *value);
/* The reason of a place that has one; the caller frees. UM_ERR_IO, UM_ERR_MEMORY. */
enum um_status um_batch_records_reason(struct um_context *context,
                                       const struct um_batch_records *records,
                                       struct um_batch_place place, char **out);
/* Accepts NULL, sets NULL. */
void um_batch_records_close(struct um_context *context, struct um_batch_records **records);
/* Close the files, not the memory: in a worker process, which is not to hold the lock. */
void um_batch_records_drop(struct um_batch_records *records);

#endif
