/* Poses and ray-tracing scenes for a block of times. A body without moving joints has one for all
 * times; with moving joints neighbouring times share one while the angles are equal. */
#ifndef UMBRA_OPTICS_POSED_SCENES_GROUP_H
#define UMBRA_OPTICS_POSED_SCENES_GROUP_H

#include "optics/radiance/posed_scene_group.h"

#define UM_OPTICS_BLOCK 32 /* times that are worked on between two reports of progress */

struct um_optics_posed_scenes {
  bool moves;
  size_t nposed;
  struct um_optics_posed_scene posed[UM_OPTICS_BLOCK];
  size_t of_time[UM_OPTICS_BLOCK]; /* posed scene of each time of the block */
};

/* Prepare `count` <= UM_OPTICS_BLOCK times. The scenes are zeroed before their first use; exchange
 * rays: exchange_samples per surface, 0 for none. */
enum um_status um_optics_posed_scenes_prepare(struct um_context *context,
                                              const struct um_geometry *geometry,
                                              const struct um_environment_sample *samples,
                                              size_t count, int exchange_samples,
                                              struct um_optics_posed_scenes *scenes);
void um_optics_posed_scenes_clear(struct um_context *context,
                                  struct um_optics_posed_scenes *scenes);

#endif
