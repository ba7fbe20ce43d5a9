/* View factors of the satellite as it stands: what the keys of the scenario ask. */
#include "model/build/view_factors_group.h"

struct um_geometry_view_factor_options
um_model_view_factor_options(const struct um_context *context, const struct um_model *model)
{
  struct um_geometry_view_factor_options options;
  um_geometry_view_factor_defaults(&options);
  options.rays = (size_t)model->scenario->thermal->view_factor_rays;
  options.cache = um_core_context_cache(context);
  return options;
}

enum um_status um_model_view_factors(struct um_context *context, const struct um_model *model,
                                     const double *angles, size_t ntime,
                                     struct um_geometry_view_factor_table **out)
{
  struct um_geometry_view_factor_options options = um_model_view_factor_options(context, model);
  return um_geometry_view_factor_table_create(context, model->geometry, angles, ntime,
                                              (size_t)model->scenario->thermal->exchange_patches,
                                              &options, out);
}
