/* Poses and ray-tracing scenes for a block of times. */
#include "optics/paths/posed_scenes_group.h"

#include <string.h>

#include "optics/paths/exchange_impl.h"

static void posed_clear(struct um_context *context, struct um_optics_posed_scene *posed)
{
  um_optics_exchange_destroy(context, &posed->exchange);
  um_geometry_visibility_destroy(&posed->visibility);
  um_geometry_pose_destroy(context, &posed->pose);
  um_core_free(context, posed->angle);
  *posed = (struct um_optics_posed_scene){0};
}

void um_optics_posed_scenes_clear(struct um_context *context, struct um_optics_posed_scenes *scenes)
{
  for (size_t i = 0; i < UM_OPTICS_BLOCK; i++) posed_clear(context, &scenes->posed[i]);
  scenes->nposed = 0;
}

/* Pose, rays and exchange of a posed scene whose angles are given. */
static enum um_status set_create(struct um_context *context, const struct um_geometry *geometry,
                                 int exchange_samples, struct um_optics_posed_scene *posed)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(geometry);
  const double *angle = um_geometry_joint_count(geometry) > 0 ? posed->angle : NULL;
  UM_TRY(um_geometry_pose_create(context, geometry, angle, &posed->pose));
  UM_TRY(um_geometry_visibility_create(context, mesh, posed->pose, &posed->visibility));
  if (exchange_samples > 0)
    UM_TRY(um_optics_exchange_create(context, mesh, posed, exchange_samples, &posed->exchange));
  return UM_OK;
}

enum um_status um_optics_posed_scenes_prepare(struct um_context *context,
                                              const struct um_geometry *geometry,
                                              const struct um_environment_sample *samples,
                                              size_t count, int exchange_samples,
                                              struct um_optics_posed_scenes *scenes)
{
  size_t njoint = um_geometry_joint_count(geometry);
  scenes->moves = um_geometry_joint_moves(geometry);
  memset(scenes->of_time, 0, sizeof scenes->of_time);
  if (!scenes->moves && scenes->nposed == 1) return UM_OK;
  um_optics_posed_scenes_clear(context, scenes);
  for (size_t i = 0; i < count; i++) {
    struct um_optics_posed_scene *next = &scenes->posed[scenes->nposed];
    UM_TRY(um_core_allocate(context, njoint, sizeof *next->angle, &next->angle));
    um_geometry_joint_angles(geometry, um_quat_apply(samples[i].q, samples[i].sun),
                             samples[i].t_tai, next->angle);
    const struct um_optics_posed_scene *last = scenes->nposed > 0 ? next - 1 : NULL;
    bool same = last != NULL && memcmp(last->angle, next->angle, njoint * sizeof *next->angle) == 0;
    if (same) {
      posed_clear(context, next);
    } else {
      UM_TRY(set_create(context, geometry, exchange_samples, next));
      scenes->nposed++;
    }
    scenes->of_time[i] = scenes->nposed - 1;
    if (!scenes->moves) break;
  }
  return UM_OK;
}
