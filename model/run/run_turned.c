/* What small turns of the body do to light at once, with heat and loads as they are. */
#include "model/geometry/precompute_group.h"
#include "model/run/run.h"

enum um_status um_model_run_turned(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_model_thermal_solution *heat,
                                   struct um_vec3 turn, struct um_model_result **out)
{
  enum um_status status;
  struct um_model_tables turned = *tables;
  size_t n = tables->nobs * tables->nsub;
  double angle = um_vec3_norm(turn);
  struct um_quat by = {1.0, 0.0, 0.0, 0.0};
  *out = NULL;
  if (angle > 0.0) by = um_quat_from_axis(um_vec3_scale(turn, 1.0 / angle), angle);
  turned.view = NULL;
  turned.photons = NULL;
  UM_TRY(um_core_allocate(context, n, sizeof *turned.sample, &turned.sample));
  for (size_t i = 0; i < n; i++) {
    turned.sample[i] = tables->sample[i];
    turned.sample[i].q = um_quat_then(tables->sample[i].q, by);
  }
  UM_CHECK(um_model_precompute_view(context, model, tables->sampling, &turned));
  UM_CHECK(um_model_run_observed(context, model, &turned, heat, out));
done:
  um_optics_view_destroy(context, &turned.view);
  um_core_free(context, turned.sample);
  return status;
}
