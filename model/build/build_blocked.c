/* A surface that looks at the satellite itself does not radiate that way to space. Where
 * mutual_radiation is off, what leaves toward another surface is taken to come back: emission to
 * space is scaled by the free share of the hemisphere,
 *
 *   1 - blocked = S_p,space / A_p,
 *
 * of the patch that the surface belongs to (geometry/view_factors.h). Joints stand as at the start
 * of the scenario. */
#include "model/build/steps_impl.h"

#include <math.h>

#include "geometry/inside.h"
#include "model/build/messages_group.h"
#include "model/build/timeline.h"
#include "model/build/view_factors_group.h"

/* Angles of the joints at the start of the scenario. */
static enum um_status angles_at_start(struct um_context *context, const struct um_model *model,
                                      double **out)
{
  struct um_environment_sample sample;
  UM_TRY(um_core_allocate(context, um_geometry_joint_count(model->geometry), sizeof **out, out));
  UM_TRY(um_model_blame_table(
      context, model, um_model_sample_at(context, model, model->scenario->time->start, &sample)));
  um_geometry_joint_angles(model->geometry, um_quat_apply(sample.q, sample.sun), *out);
  return UM_OK;
}

static enum um_status unblock_inside(struct um_context *context, struct um_model *model)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  struct um_thermal_network *network = model->body->network;
  for (size_t f = 0; f < mesh->nfacet; f++) {
    uint32_t s = um_geometry_inner_surface(mesh, f);
    if (um_thermal_network_surface(network, s) != NULL)
      UM_TRY(um_thermal_network_surface_block(network, s, 0.0));
  }
  return um_core_stop_check(context, "the heat network was built");
}

enum um_status um_model_build_blocked(struct um_context *context, struct um_model *model)
{
  enum um_status status;
  struct um_geometry_view_factor_table *table = NULL;
  double *angles = NULL;
  if (model->points) return UM_OK; /* heat is not followed */
  /* surfaces exchange it; inside, where they come blocked, as well */
  if (model->environment.mutual_radiation_on) return unblock_inside(context, model);
  UM_CHECK(angles_at_start(context, model, &angles));
  UM_CHECK(um_model_view_factors(context, model, angles, 1, &table));
  for (uint32_t s = 0; s < table->patches->nsurface; s++) {
    uint32_t p = table->patches->patch[s];
    if (p == UM_GEOMETRY_NONE) continue;
    double share = table->pose[0]->space[p] / table->patches->area[p];
    /* rounding alone may take it above 1 */
    UM_CHECK(um_thermal_network_surface_block(model->body->network, s, fmax(0.0, 1.0 - share)));
  }
done:
  um_geometry_view_factor_table_destroy(context, &table);
  um_core_free(context, angles);
  return status;
}
