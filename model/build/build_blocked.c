/* A surface that looks at the satellite itself does not radiate that way to space. Where
 * mutual_radiation is off, what leaves toward another surface is taken to come back: emission to
 * space is scaled by the free share of the hemisphere,
 *
 *   1 - blocked = S_p,space / A_p,
 *
 * of the patch that the surface belongs to (geometry/view_factors.h). Joints stand as at the start
 * of the scenario. A variant of the same body has the shares of its origin, whose rays are traced
 * once. */
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
  um_geometry_joint_angles(model->geometry, um_quat_apply(sample.q, sample.sun), sample.t_tai,
                           *out);
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

/* Are the shares of the origin this variant's: the same body, joints as they stand, and rays? */
static enum um_status has_same(struct um_context *context, const struct um_model *model,
                               const double *angles, bool *out)
{
  const struct um_model *from = model->origin;
  *out = false;
  if (from == NULL || from->blocked == NULL) return UM_OK;
  const struct um_scenario_thermal *x = model->scenario->thermal, *y = from->scenario->thermal;
  *out = x->view_factor_rays == y->view_factor_rays && x->exchange_patches == y->exchange_patches &&
         um_geometry_equal(from->geometry, model->geometry);
  size_t njoint = um_geometry_joint_count(model->geometry);
  double *own = NULL;
  if (!*out || njoint == 0) return UM_OK;
  enum um_status status = angles_at_start(context, from, &own);
  for (size_t i = 0; i < njoint && status == UM_OK; i++) *out = *out && own[i] == angles[i];
  um_core_free(context, own);
  return status;
}

static enum um_status find_blocked(struct um_context *context, struct um_model *model)
{
  enum um_status status;
  struct um_geometry_view_factor_table *table = NULL;
  double *angles = NULL;
  bool same;
  UM_CHECK(angles_at_start(context, model, &angles));
  UM_CHECK(has_same(context, model, angles, &same));
  if (same) {
    model->blocked = model->origin->blocked;
    model->nblocked = model->origin->nblocked;
    goto done;
  }
  UM_CHECK(um_model_view_factors(context, model, angles, 1, &table));
  UM_CHECK(
      um_core_allocate(context, table->patches->nsurface, sizeof *model->blocked, &model->blocked));
  model->nblocked = table->patches->nsurface;
  for (uint32_t s = 0; s < table->patches->nsurface; s++) {
    uint32_t p = table->patches->patch[s];
    model->blocked[s] = NAN;
    if (p == UM_GEOMETRY_NONE) continue;
    double share = table->pose[0]->space[p] / table->patches->area[p];
    /* rounding alone may take it above 1 */
    model->blocked[s] = fmax(0.0, 1.0 - share);
  }
done:
  um_geometry_view_factor_table_destroy(context, &table);
  um_core_free(context, angles);
  return status;
}

enum um_status um_model_build_blocked(struct um_context *context, struct um_model *model)
{
  if (model->points) return UM_OK; /* heat is not followed */
  /* surfaces exchange it; inside, where they come blocked, as well */
  if (model->environment.mutual_radiation_on) return unblock_inside(context, model);
  UM_TRY(find_blocked(context, model));
  for (uint32_t s = 0; s < model->nblocked; s++)
    if (!isnan(model->blocked[s]))
      UM_TRY(um_thermal_network_surface_block(model->body->network, s, model->blocked[s]));
  return UM_OK;
}
