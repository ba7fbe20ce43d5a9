/* A surface that looks at the satellite itself does not radiate that way to space. Until surfaces
 * exchange radiation, what leaves toward another surface is taken to come back: emission to space
 * is scaled by the free share of the hemisphere,
 *
 *   1 - blocked = (1/pi) int V(omega) cos(theta) d omega
 *
 * by cosine-weighted directions, keyed by surface. Joints stand as at the start of the scenario. */
#include "model/build_blocked_impl.h"

#include "core/sampling.h"
#include "model/timeline.h"
#include "model/words_impl.h"

#define SKY_SAMPLES 4   /* points per facet of the sky table */
#define DIRECTIONS  256 /* per surface; standard error at most 3 % of the hemisphere */

static double free_share(const struct um_geometry_sky *sky, size_t surface, struct um_vec3 normal)
{
  double sum = 0.0;
  for (uint64_t i = 0; i < DIRECTIONS; i++) {
    double u[2];
    um_core_sample_2d(surface, i, u);
    sum += um_geometry_sky_free(sky, surface, um_core_sample_cosine(u, normal));
  }
  return sum / DIRECTIONS;
}

/* Positions at the start of the scenario. */
static enum um_status pose_at_start(struct um_context *context, const struct um_model *model,
                                    struct um_geometry_pose **out)
{
  enum um_status status;
  struct um_environment_sample sample;
  double *angles = NULL;
  UM_TRY(
      um_core_allocate(context, um_geometry_joint_count(model->geometry), sizeof *angles, &angles));
  UM_CHECK(um_model_blame_table(
      context, model, um_model_sample_at(context, model, model->scenario->time->start, &sample)));
  um_geometry_joint_angles(model->geometry, um_quat_apply(sample.q, sample.sun), angles);
  UM_CHECK(um_geometry_pose_create(context, model->geometry, angles, out));
done:
  um_core_free(context, angles);
  return status;
}

enum um_status um_model_build_blocked(struct um_context *context, struct um_model *model)
{
  enum um_status status;
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  struct um_geometry_pose *pose = NULL;
  struct um_geometry_visibility *visibility = NULL;
  struct um_geometry_sky *sky = NULL;
  if (model->points) return UM_OK; /* heat is not followed */
  UM_CHECK(pose_at_start(context, model, &pose));
  UM_CHECK(um_geometry_visibility_create(context, mesh, pose, &visibility));
  UM_CHECK(um_geometry_sky_create(context, visibility, SKY_SAMPLES, &sky));
  for (uint32_t s = 0; s < mesh->nsurface; s++) {
    if (um_geometry_visibility_is_open(visibility, s)) continue;
    double share = free_share(sky, s, um_geometry_surface_normal(mesh, pose, s));
    UM_CHECK(um_thermal_network_surface_block(model->body->network, s, 1.0 - share));
  }
done:
  um_geometry_sky_destroy(&sky);
  um_geometry_visibility_destroy(&visibility);
  um_geometry_pose_destroy(context, &pose);
  return status;
}
