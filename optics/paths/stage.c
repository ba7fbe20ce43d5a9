/* Poses and ray-tracing scenes for a block of times. */
#include "optics/paths/stage_group.h"

#include <string.h>

#include "optics/paths/exchange_impl.h"

static void set_clear(struct um_context *context, struct um_optics_set *set)
{
  um_optics_exchange_destroy(context, &set->exchange);
  um_geometry_visibility_destroy(&set->visibility);
  um_geometry_pose_destroy(context, &set->pose);
  um_core_free(context, set->angle);
  *set = (struct um_optics_set){0};
}

void um_optics_stage_clear(struct um_context *context, struct um_optics_stage *stage)
{
  for (size_t i = 0; i < UM_OPTICS_BLOCK; i++) set_clear(context, &stage->set[i]);
  stage->nset = 0;
}

/* Pose, rays and exchange of a set whose angles are given. */
static enum um_status set_create(struct um_context *context, const struct um_geometry *geometry,
                                 int exchange_samples, struct um_optics_set *set)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(geometry);
  const double *angle = um_geometry_joint_count(geometry) > 0 ? set->angle : NULL;
  UM_TRY(um_geometry_pose_create(context, geometry, angle, &set->pose));
  UM_TRY(um_geometry_visibility_create(context, mesh, set->pose, &set->visibility));
  if (exchange_samples > 0)
    UM_TRY(um_optics_exchange_create(context, mesh, set, exchange_samples, &set->exchange));
  return UM_OK;
}

enum um_status um_optics_stage_prepare(struct um_context *context,
                                       const struct um_geometry *geometry,
                                       const struct um_environment_sample *samples, size_t count,
                                       int exchange_samples, struct um_optics_stage *stage)
{
  size_t njoint = um_geometry_joint_count(geometry);
  stage->moves = um_geometry_joint_moves(geometry);
  memset(stage->of_time, 0, sizeof stage->of_time);
  if (!stage->moves && stage->nset == 1) return UM_OK;
  um_optics_stage_clear(context, stage);
  for (size_t i = 0; i < count; i++) {
    struct um_optics_set *next = &stage->set[stage->nset];
    UM_TRY(um_core_allocate(context, njoint, sizeof *next->angle, &next->angle));
    um_geometry_joint_angles(geometry, um_quat_apply(samples[i].q, samples[i].sun), next->angle);
    const struct um_optics_set *last = stage->nset > 0 ? next - 1 : NULL;
    bool same = last != NULL && memcmp(last->angle, next->angle, njoint * sizeof *next->angle) == 0;
    if (same) {
      set_clear(context, next);
    } else {
      UM_TRY(set_create(context, geometry, exchange_samples, next));
      stage->nset++;
    }
    stage->of_time[i] = stage->nset - 1;
    if (!stage->moves) break;
  }
  return UM_OK;
}
