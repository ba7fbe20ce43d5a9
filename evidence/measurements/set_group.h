/* A measurement set in the making: rows are added in file order; order in time and uniqueness
 * within a track are checked as they come. Private to the rooms of evidence/. */
#ifndef UMBRA_COMPARE_SET_GROUP_H
#define UMBRA_COMPARE_SET_GROUP_H

#include "evidence/measurements/names_impl.h"
#include "evidence/measurements/set.h"

struct um_compare_set {
  struct um_compare_measurements *made;
  struct um_compare_names channels, tracks, stations;
  size_t row_capacity, last_capacity;
  size_t *last;   /* [track] row that was added last; SIZE_MAX: none */
  size_t *before; /* [row] the row of the same track before it; SIZE_MAX: none */
};

/* Begin; `path` is copied. After a failure of any call the caller abandons. */
enum um_status um_compare_set_begin(struct um_context *context, const char *path,
                                    const char *time_column, struct um_compare_set *set);
/* Another file, whose rows follow; its set is the index of the last. */
enum um_status um_compare_set_file(struct um_context *context, struct um_compare_set *set,
                                   const char *path, const char *time_column);
/* A channel, a track of the last file. */
enum um_status um_compare_set_channel(struct um_context *context, struct um_compare_set *set,
                                      enum um_compare_quantity quantity, const char *of,
                                      size_t *channel);
enum um_status um_compare_set_track(struct um_context *context, struct um_compare_set *set,
                                    const char *name, size_t *track);
enum um_status um_compare_set_station(struct um_context *context, struct um_compare_set *set,
                                      const char *name, size_t *station);
/* Add a row. UM_ERR_INPUT: out of order, or a second row of its channel and track at its time. */
enum um_status um_compare_set_add(struct um_context *context, struct um_compare_set *set,
                                  const struct um_compare_measurement *row);
/* Hand the set over; UM_ERR_INPUT when it has no rows. */
enum um_status um_compare_set_finish(struct um_context *context, struct um_compare_set *set,
                                     struct um_compare_measurements **out);
/* Free what was not handed over. */
void um_compare_set_abandon(struct um_context *context, struct um_compare_set *set);

#endif
