/* How the satellite is lit and seen at an observation, in its own axes. */
#include "model/run/effect_view.h"

#include "environment/airmass.h"

enum um_status um_model_material_names(struct um_context *context, const struct um_model *model,
                                       const char ***out)
{
  size_t n = um_geometry_material_count(model->geometry);
  UM_TRY(um_core_allocate(context, n, sizeof **out, (void *)out));
  for (size_t m = 0; m < n; m++)
    (*out)[m] = um_geometry_material_name(model->geometry, (uint32_t)m);
  return UM_OK;
}

struct um_effect_view um_model_effect_view(const struct um_model_tables *tables,
                                           const struct um_model_result *result,
                                           const char *const *material, size_t k, size_t band)
{
  size_t middle = k * tables->nsub + tables->nsub / 2;
  const struct um_environment_sample *s = &tables->sample[middle];
  const struct um_orbit_look *look = &tables->look[middle];
  size_t per_band = result->nmaterial * UM_MECHANISM_COUNT;
  return (struct um_effect_view){
      .sun = um_quat_apply(s->q, s->sun),
      .observer = um_quat_apply(s->q, s->to_observer),
      .nadir = um_quat_apply(s->q, um_vec3_scale(um_vec3_unit(s->r), -1.0)),
      .azimuth = look->azimuth,
      .elevation = look->elevation,
      .airmass = um_environment_airmass_toward(look->elevation),
      .sunlit = tables->sunlit[k],
      .range = s->range,
      .nmaterial = result->nmaterial,
      .nmechanism = UM_MECHANISM_COUNT,
      .material = material,
      .intensity = result->intensity + (k * result->nband + band) * per_band};
}
