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

#include "geometry/geometry.h"
#include "model/build.h"
#include "model/precompute.h"
#include "model/precomputed_serves.h"
#include "model/run.h"
#include "study/study_impl.h"

enum um_status um_study_model(struct um_context *context, const struct um_study *study,
                              const struct um_study_way *way, size_t nway, const double *value,
                              struct um_model **out)
{
  enum um_status status;
  struct um_study_changes changes = {0};
  um_core_quiet_begin(context); /* what is to say of the scenario was said once */
  UM_CHECK(um_study_changes_make(context, study->model, way, nway, value, &changes));
  UM_CHECK(um_model_variant_create(context, study->model, &changes.all, out));
done:
  um_core_quiet_end(context);
  um_study_changes_clear(context, &changes);
  return status;
}

/* --- geometry -------------------------------------------------------------------------------- */

static void geometry_clear(struct um_context *context, struct um_study_geometry *g)
{
  um_model_precomputed_destroy(context, &g->precomputed);
  um_model_destroy(context, &g->model);
  *g = (struct um_study_geometry){0};
}

/* The geometry precomputation of the model: the scenario's own, one that is kept, or a new one,
 * which takes the model. */
static enum um_status find_geometry(struct um_context *context, struct um_study *study,
                                    struct um_model **model,
                                    const struct um_model_precomputed **out)
{
  bool serves = false;
  UM_TRY(um_model_precomputed_serves(context, study->model, study->precomputed, *model, &serves));
  *out = study->precomputed;
  struct um_study_geometry *oldest = &study->kept[0];
  for (size_t i = 0; i < UM_STUDY_GEOMETRIES && !serves; i++) {
    struct um_study_geometry *g = &study->kept[i];
    if (g->used < oldest->used) oldest = g;
    if (g->model == NULL) continue;
    UM_TRY(um_model_precomputed_serves(context, g->model, g->precomputed, *model, &serves));
    if (!serves) continue;
    g->used = study->npoint;
    *out = g->precomputed;
  }
  if (serves) return UM_OK;
  geometry_clear(context, oldest);
  UM_TRY(um_model_precompute(context, *model, &oldest->precomputed));
  oldest->model = *model;
  oldest->used = study->npoint;
  *model = NULL;
  *out = oldest->precomputed;
  return UM_OK;
}

/* --- heat and light -------------------------------------------------------------------------- */

/* May heat of the model start from the scenario's own? Same nodes on the same number of surfaces.
 */
static bool starts_warm(const struct um_study *study, const struct um_model *model)
{
  return um_geometry_mesh(study->model->geometry)->nsurface ==
             um_geometry_mesh(model->geometry)->nsurface &&
         um_thermal_network_nodes(study->model->body->network) ==
             um_thermal_network_nodes(model->body->network);
}

static enum um_status heat_make(struct um_context *context, const struct um_study *study,
                                const struct um_model *model,
                                const struct um_model_precomputed *precomputed, bool tight,
                                struct um_model_thermal_solution **out)
{
  const struct um_model_thermal_solution *warm = starts_warm(study, model) ? study->heat : NULL;
  return um_model_thermal_solution_near(context, model, precomputed, warm,
                                        tight ? 1.0 : study->tolerance_factor,
                                        tight ? UM_STUDY_PERIODIC : study->periodic_tolerance, out);
}

/* Light and temperatures of a model with heat, into value. */
static enum um_status observe(struct um_context *context, const struct um_study *study,
                              const struct um_model *model,
                              const struct um_model_precomputed *precomputed,
                              const struct um_model_thermal_solution *heat, double *value)
{
  struct um_model_result *result = NULL;
  UM_TRY(um_model_run_observed(context, model, precomputed, heat, &result));
  enum um_status status = um_study_outputs_take(context, study, model, result, value);
  um_model_result_destroy(context, &result);
  return status;
}

enum um_status um_study_looseness(struct um_context *context, struct um_study *study)
{
  enum um_status status;
  struct um_model_thermal_solution *heat = NULL;
  double *loose = NULL;
  if (study->looseness == NULL) {
    UM_TRY(um_core_allocate(context, study->noutput, sizeof *loose, &study->taken_off));
    UM_TRY(um_core_allocate(context, study->nvalue, sizeof *loose, &study->looseness));
  }
  UM_TRY(um_core_allocate(context, study->nvalue, sizeof *loose, &loose));
  UM_CHECK(heat_make(context, study, study->model, study->precomputed, false, &heat));
  UM_CHECK(observe(context, study, study->model, study->precomputed, heat, loose));
  for (size_t i = 0; i < study->nvalue; i++) {
    double exact = study->nominal[i];
    if (study->output[i / study->ntime].kind == UM_STUDY_IRRADIANCE)
      study->looseness[i] = exact > 0.0 && loose[i] > 0.0 ? exact / loose[i] : 1.0;
    else
      study->looseness[i] = isfinite(exact - loose[i]) ? exact - loose[i] : 0.0;
  }
  um_study_differences(study, loose, study->nominal, study->taken_off);
done:
  um_model_thermal_solution_destroy(context, &heat);
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
                               const struct um_model *model,
                               const struct um_model_precomputed *precomputed, bool tight,
                               double *value)
{
  enum um_status status = UM_OK;
  struct um_model_thermal_solution *heat = NULL;
  bool matches = false;
  if (!tight)
    UM_CHECK(um_model_thermal_solution_matches(context, study->heat, model, precomputed, &matches));
  if (!matches) UM_CHECK(heat_make(context, study, model, precomputed, tight, &heat));
  UM_CHECK(observe(context, study, model, precomputed, matches ? study->heat : heat, value));
  if (!matches && !tight && precomputed == study->precomputed) looseness_take_off(study, value);
done:
  um_model_thermal_solution_destroy(context, &heat);
  return status;
}

enum um_status um_study_point(struct um_context *context, void *user, const double *parameter,
                              double *value)
{
  struct um_study *study = user;
  struct um_model *model = NULL;
  const struct um_model *used = NULL;
  const struct um_model_precomputed *precomputed = NULL;
  enum um_status status;
  study->npoint++;
  UM_CHECK(um_study_model(context, study, study->way, study->nway, parameter, &model));
  used = model;
  UM_CHECK(find_geometry(context, study, &model, &precomputed));
  UM_CHECK(um_study_values(context, study, used, precomputed, false, value));
done:
  um_model_destroy(context, &model);
  return status;
}
