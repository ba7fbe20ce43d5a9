/* What heat does by the model itself. The linear response serves to find the heat, but a few
 * kelvins change the radiance non-linearly by per cents. */
#include "evidence/missing_heat/change_impl.h"

#include "base/inference/algebra.h"

/* Values over sigma of the observations with a source. */
static enum um_status run_with(struct um_context *context, const struct um_missing_heat_base *base,
                               const struct um_thermal_source *source, double *value)
{
  enum um_status status;
  struct um_sensitivity_forward *f = base->forward;
  const struct um_variant_heat heat = um_sensitivity_forward_heat(f);
  struct um_variant v = {0};
  struct um_model_result *result = NULL;
  const struct um_model_changes changes = {
      .addition = base->addition, .naddition = base->naddition, .source = source, .nsource = 1};
  UM_CHECK(um_variant_open(context, f->evaluator, &changes, &heat, &v));
  UM_CHECK(um_variant_observe(context, f->evaluator, &v, &result));
  UM_CHECK(um_missing_heat_predict(context, base, result, value));
  f->evaluations++;
done:
  um_model_result_destroy(context, &result);
  um_variant_close(context, &v);
  return status;
}

enum um_status um_missing_heat_change(struct um_context *context,
                                      const struct um_missing_heat_base *base,
                                      struct um_inference_projection *projection,
                                      const struct um_missing_heat_place *place,
                                      const struct um_missing_heat_fit *fit, double end,
                                      double *change)
{
  enum um_status status;
  size_t n = base->forward->observations.count;
  size_t nrow = um_thermal_course_rows(&fit->course, end, NULL, NULL);
  double *cold = NULL, *value = NULL, *t = NULL, *power = NULL;
  UM_CHECK(um_core_allocate(context, n, sizeof *cold, &cold));
  UM_CHECK(um_core_allocate(context, n, sizeof *value, &value));
  UM_CHECK(um_core_allocate(context, nrow, sizeof *t, &t));
  UM_CHECK(um_core_allocate(context, nrow, sizeof *power, &power));
  um_thermal_course_rows(&fit->course, end, t, power);
  for (size_t i = 0; i < nrow; i++) power[i] *= fit->power;
  const struct um_thermal_source source = {.node = place->node,
                                           .weight = place->weight,
                                           .nnode = place->nnode,
                                           .t = t,
                                           .power = power,
                                           .nrow = nrow};
  UM_CHECK(run_with(context, base, &source, value));
  UM_CHECK(um_missing_heat_predict(context, base, base->result, cold));
  for (size_t j = 0; j < n; j++) value[j] -= cold[j];
  um_inference_projection_apply(projection, value, change);
done:
  UM_FREE(context, cold, value, t, power);
  return status;
}
