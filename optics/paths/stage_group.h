/* Poses and ray-tracing scenes for a block of times. A body without moving joints has one for all
 * times; with moving joints neighbouring times share one while the angles are equal. */
#ifndef UMBRA_OPTICS_STAGE_GROUP_H
#define UMBRA_OPTICS_STAGE_GROUP_H

#include "optics/radiance/set_group.h"

#define UM_OPTICS_BLOCK 32 /* times that are worked on between two reports of progress */

struct um_optics_stage {
  bool moves;
  size_t nset;
  struct um_optics_set set[UM_OPTICS_BLOCK];
  size_t of_time[UM_OPTICS_BLOCK]; /* set of each time of the block */
};

/* Prepare `count` <= UM_OPTICS_BLOCK times. The stage is zeroed before its first use; exchange
 * rays: exchange_samples per surface, 0 for none. */
enum um_status um_optics_stage_prepare(struct um_context *context,
                                       const struct um_geometry *geometry,
                                       const struct um_environment_sample *samples, size_t count,
                                       int exchange_samples, struct um_optics_stage *stage);
void um_optics_stage_clear(struct um_context *context, struct um_optics_stage *stage);

#endif
