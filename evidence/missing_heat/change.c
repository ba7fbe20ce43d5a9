/* The power of a pulse of heat by the model itself. The linear response serves to find the pulse,
 * but a few kelvins change the radiance non-linearly by per cents. So the model is run with the
 * pulse as a source, and the power follows from a line through 0 and the result:
 *
 *   P <- P d'r / d'd,   d the change of the observations at P, both after the nuisances,
 *
 * until it moves by less than a hundredth. These are secant steps, so the error is then far less.
 */
#include "evidence/missing_heat/change_impl.h"

#include <math.h>

#include "base/inference/algebra.h"
#include "evidence/missing_heat/policy.h"

/* Values over sigma of the observations with the pulse. */
static enum um_status run_with(struct um_context *context, const struct um_missing_heat_base *base,
                               const struct um_missing_heat_place *place, double from, double to,
                               double power, double *value)
{
  enum um_status status;
  struct um_sensitivity_forward *f = base->forward;
  const struct um_variant_heat heat = um_sensitivity_forward_heat(f);
  struct um_variant v = {0};
  struct um_model_result *result = NULL;
  double t[] = {from, from, to, to}, watts[] = {0.0, power, power, 0.0};
  const struct um_thermal_source source = {.node = place->node,
                                           .weight = place->weight,
                                           .nnode = place->nnode,
                                           .t = t,
                                           .power = watts,
                                           .nrow = 4};
  const struct um_model_changes changes = {
      .addition = base->addition, .naddition = base->naddition, .source = &source, .nsource = 1};
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
                                      const double *residual,
                                      const struct um_missing_heat_place *place, double from,
                                      double to, double *power, double *chi2)
{
  enum um_status status;
  size_t nobservation = base->forward->observations.count, nleft = projection->nleft;
  double *cold = NULL, *value = NULL, *left = NULL;
  UM_CHECK(um_core_allocate(context, nobservation, sizeof *cold, &cold));
  UM_CHECK(um_core_allocate(context, nobservation, sizeof *value, &value));
  UM_CHECK(um_core_allocate(context, nleft, sizeof *left, &left));
  UM_CHECK(um_missing_heat_predict(context, base, base->result, cold));
  for (int k = 0; k < UM_MISSING_HEAT_STEPS; k++) {
    UM_CHECK(run_with(context, base, place, from, to, *power, value));
    for (size_t j = 0; j < nobservation; j++) value[j] -= cold[j];
    um_inference_projection_apply(projection, value, left);
    double square = um_inference_dot(nleft, left, left);
    double with = um_inference_dot(nleft, left, residual);
    if (!(square > 0.0) || !(with > 0.0)) break; /* no power improves the fit */
    *power *= with / square;
    *chi2 = with * with / square;
    if (fabs(with / square - 1.0) < UM_MISSING_HEAT_SETTLED) break;
  }
done:
  UM_FREE(context, cold, value, left);
  return status;
}
