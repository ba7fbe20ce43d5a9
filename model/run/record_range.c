/* Do surfaces stay where the records of their materials hold? */
#include "model/run/parts_impl.h"

#include <math.h>

/* The surface and observation that leaves a material's range furthest; false: none does. */
struct leaving {
  size_t surface, observation;
  double beyond; /* [K] */
};

static void consider(struct leaving *worst, const struct um_materials_bulk *bulk, double t,
                     size_t surface, size_t observation)
{
  double beyond = fmax(bulk->coldest - t, t - bulk->hottest);
  if (!(beyond > worst->beyond)) return; /* a bound that is not stated is NaN */
  *worst = (struct leaving){surface, observation, beyond};
}

static enum um_status say(struct um_context *context, const struct um_model *model,
                          const struct um_model_tables *tables,
                          const struct um_model_result *result, uint32_t material,
                          const struct leaving *at)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  const struct um_materials_bulk bulk = um_materials_bulk(model->material[material]);
  const struct um_geometry_surface *surface = &mesh->surface[at->surface];
  const char *part = um_geometry_part_name(model->geometry, surface->part);
  const char *group = um_geometry_group(model->geometry, surface->group)->name;
  const char *name = um_materials_name(model->material[material]);
  double t = result->surface_temperature[at->observation * result->nsurface + at->surface];
  double after = tables->t_obs[at->observation] - tables->t_obs[0];
  if (model->scenario->thermal->outside_range == UM_RANGE_ERROR)
    return um_core_fail(context, UM_ERR_NUMERIC,
                        "part %s, group %s is at %.4g K %.3f s after the first observation: its "
                        "material '%s' is known from %g to %g K; accepted: temperatures in that "
                        "range, or thermal.outside_range: warning",
                        part, group, t, after, name, bulk.coldest, bulk.hottest);
  um_core_log(context, UM_LOG_WARNING,
              "part %s, group %s is at %.4g K %.3f s after the first observation: its material "
              "'%s' is known from %g to %g K",
              part, group, t, after, name, bulk.coldest, bulk.hottest);
  return UM_OK;
}

enum um_status um_model_check_record_ranges(struct um_context *context,
                                            const struct um_model *model,
                                            const struct um_model_tables *tables,
                                            const struct um_model_result *result)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  for (uint32_t m = 0; m < um_geometry_material_count(model->geometry); m++) {
    const struct um_materials_bulk bulk = um_materials_bulk(model->material[m]);
    struct leaving worst = {0, 0, 0.0};
    if (isnan(bulk.coldest)) continue;
    for (size_t k = 0; k < result->nobs; k++)
      for (size_t s = 0; s < mesh->nsurface; s++)
        if (mesh->surface[s].material == m)
          consider(&worst, &bulk, result->surface_temperature[k * result->nsurface + s], s, k);
    if (worst.beyond > 0.0) UM_TRY(say(context, model, tables, result, m, &worst));
  }
  return UM_OK;
}
