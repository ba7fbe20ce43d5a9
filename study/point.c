/* A point of a study, exactly: geometry and heat are shared where they are the same number for
 * number. Heat starts from the periodic state of the scenario as it stands, never from another
 * point, so that a point has the same bits in any order and process.
 *
 * What loose tolerances do to a point they do to the scenario as it stands, nearly: errors of an
 * integration have one sign. That is known of the scenario, and taken off every point:
 *
 *   y = y_loose + (y_0 - y_0,loose) of temperatures and magnitudes, y_loose y_0/y_0,loose of light.
 */
#include <math.h>

#include "study/study_impl.h"

enum um_status um_study_open(struct um_context *context, const struct um_study *study,
                             const struct um_study_way *way, size_t nway, const double *value,
                             struct um_variant *out)
{
  struct um_study_changes changes = {0};
  *out = (struct um_variant){0};
  enum um_status status = um_study_changes_make(context, study->model, way, nway, value, &changes);
  if (status == UM_OK) status = um_variant_open(context, study->evaluator, &changes.all, NULL, out);
  um_study_changes_clear(context, &changes);
  return status;
}

/* --- heat and light -------------------------------------------------------------------------- */

/* Light and temperatures, into value. */
static enum um_status observe(struct um_context *context, const struct um_study *study,
                              const struct um_variant *v, double *value)
{
  struct um_model_result *result = NULL;
  UM_TRY(um_variant_observe(context, study->evaluator, v, &result));
  enum um_status status = um_study_outputs_take(context, study, v->model, result, value);
  um_model_result_destroy(context, &result);
  return status;
}

static struct um_variant_heat heat_of(const struct um_study *study, bool tight)
{
  return (struct um_variant_heat){
      .start = UM_VARIANT_WARM,
      .tolerance = tight ? (struct um_variant_tolerance){1.0, UM_MODEL_PERIODIC_TOLERANCE}
                         : study->tolerance};
}

enum um_status um_study_looseness(struct um_context *context, struct um_study *study)
{
  enum um_status status;
  const struct um_variant_heat how = heat_of(study, false);
  struct um_variant v = study->base;
  double *loose = NULL;
  if (study->looseness == NULL) {
    UM_TRY(um_core_allocate(context, study->noutput, sizeof *loose, &study->taken_off));
    UM_TRY(um_core_allocate(context, study->nvalue, sizeof *loose, &study->looseness));
  }
  UM_TRY(um_core_allocate(context, study->nvalue, sizeof *loose, &loose));
  UM_CHECK(um_variant_heat_again(context, study->evaluator, &how, &v));
  UM_CHECK(observe(context, study, &v, loose));
  for (size_t i = 0; i < study->nvalue; i++) {
    double exact = study->nominal[i];
    if (study->output[i / study->ntime].kind == UM_STUDY_IRRADIANCE)
      study->looseness[i] = exact > 0.0 && loose[i] > 0.0 ? exact / loose[i] : 1.0;
    else
      study->looseness[i] = isfinite(exact - loose[i]) ? exact - loose[i] : 0.0;
  }
  um_study_differences(study, loose, study->nominal, study->taken_off);
done:
  um_variant_close(context, &v);
  um_core_free(context, loose);
  return status;
}

static void looseness_take_off(const struct um_study *study, double *value)
{
  for (size_t i = 0; i < study->nvalue && study->looseness != NULL; i++) {
    if (study->output[i / study->ntime].kind == UM_STUDY_IRRADIANCE)
      value[i] *= study->looseness[i];
    else
      value[i] += study->looseness[i];
  }
}

enum um_status um_study_values(struct um_context *context, const struct um_study *study,
                               struct um_variant *variant, bool tight, double *value)
{
  const struct um_variant_heat how = heat_of(study, tight);
  if (tight)
    UM_TRY(um_variant_heat_again(context, study->evaluator, &how, variant));
  else
    UM_TRY(um_variant_find_heat(context, study->evaluator, &how, variant));
  UM_TRY(observe(context, study, variant, value));
  if (variant->fresh_heat && !tight && variant->precomputed == study->base.precomputed)
    looseness_take_off(study, value);
  return UM_OK;
}

enum um_status um_study_point(struct um_context *context, void *user, const double *parameter,
                              double *value)
{
  struct um_study *study = user;
  struct um_variant v;
  enum um_status status = um_study_open(context, study, study->way, study->nway, parameter, &v);
  if (status == UM_OK) status = um_study_values(context, study, &v, false, value);
  um_variant_close(context, &v);
  return status;
}
