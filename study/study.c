/* A study from its file to where points can be computed. */
#include "study/study.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <string.h>

#include "base/core/file.h"
#include "base/core/file_snapshot.h"
#include "evidence/measurements/measurements.h"
#include "model/build/build.h"
#include "model/geometry/precompute.h"
#include "study/study_impl.h"

static enum um_status find_bindings(struct um_context *context, struct um_study *study)
{
  const struct um_study_file_parameter *p = study->file->parameters.items;
  study->nbinding = study->file->parameters.count;
  UM_TRY(um_core_allocate(context, study->nbinding, sizeof *study->binding, &study->binding));
  for (size_t i = 0; i < study->nbinding; i++) {
    UM_TRY(um_study_binding_find(context, study->model, &p[i], &study->binding[i]));
    UM_TRY(um_study_binding_check_ends(context, &study->binding[i]));
  }
  return um_study_bindings_check(context, study->model, study->binding, study->nbinding);
}

/* The scenario as it stands, with the time that it takes. */
static enum um_status solve_nominal(struct um_context *context, struct um_study *study)
{
  const struct um_variant_settings settings = {.base = UM_VARIANT_TIGHT, .photons = true};
  const struct um_variant *base = &study->base;
  struct um_model_result *result = NULL;
  double begin = omp_get_wtime();
  UM_TRY(um_variant_evaluator_create(context, study->model, &settings, &study->evaluator));
  UM_TRY(um_variant_base(context, study->evaluator, &study->base));
  UM_TRY(um_variant_observe(context, study->evaluator, base, &result));
  study->seconds_run = omp_get_wtime() - begin;
  enum um_status status =
      um_study_outputs_take(context, study, study->model, result, study->nominal);
  um_model_result_destroy(context, &result);
  return status;
}

/* Curves of the scenario as it stands, and their largest values. */
static enum um_status make_nominal(struct um_context *context, struct um_study *study)
{
  const struct um_scenario_time *time = study->model->scenario->time;
  double *times = NULL;
  UM_TRY(um_study_outputs_make(context, study));
  UM_TRY(um_model_scenario_times(context, study->model, &times, &study->ntime));
  um_core_free(context, times);
  study->nvalue = study->noutput * study->ntime;
  if (study->nvalue > UM_STUDY_VALUES_MAX)
    return um_document_mark_fail(
        context, &study->file->outputs->at,
        "%zu curves of %zu observations every %g s; accepted: %d values of "
        "a point",
        study->noutput, study->ntime, time->step_s, UM_STUDY_VALUES_MAX);
  UM_TRY(um_core_allocate(context, study->nvalue, sizeof(double), &study->nominal));
  UM_TRY(um_core_allocate(context, study->noutput, sizeof(double), &study->scale));
  UM_TRY(solve_nominal(context, study));
  for (size_t q = 0; q < study->noutput; q++)
    for (size_t k = q * study->ntime; k < (q + 1) * study->ntime; k++)
      if (!isnan(study->nominal[k]))
        study->scale[q] = fmax(study->scale[q], fabs(study->nominal[k]));
  return um_study_curves_make(context, study);
}

/* Whose measurements; what cannot be read is refused before hours of work. */
static enum um_status find_measurements(struct um_context *context, const char *path,
                                        struct um_study *study)
{
  struct um_compare_measurements *measurements = NULL;
  if (study->options.measured != NULL)
    UM_TRY(um_core_strdup(context, study->options.measured, &study->measurements));
  else if (study->file->outputs->measured != NULL)
    UM_TRY(
        um_core_path_resolve(context, path, study->file->outputs->measured, &study->measurements));
  if (study->measurements == NULL) return UM_OK;
  enum um_status status = um_compare_measurements_read(context, study->measurements, &measurements);
  if (status == UM_ERR_IO && study->options.measured == NULL) { /* with its place in study.yaml */
    char reason[256];
    snprintf(reason, sizeof reason, "%s", um_core_message(context));
    um_core_message_clear(context);
    return um_document_mark_fail(
        context, um_document_mark_key(&study->file->outputs->at, "measured"), "%s", reason);
  }
  UM_TRY(status);
  um_compare_measurements_destroy(context, &measurements);
  return UM_OK;
}

static enum um_status prepare(struct um_context *context, const char *path, struct um_study *study)
{
  UM_TRY(um_study_file_read(context, path, &study->document, &study->file));
  const struct um_study_file_error *error = study->file->error;
  const struct um_variant_error asked = {error->light, error->light, error->temperature_K};
  study->accuracy.tolerance = um_variant_tolerance_asked(&asked, NULL); /* until it is measured */
  UM_TRY(um_core_path_resolve(context, path, study->file->scenario, &study->scenario));
  UM_TRY(find_measurements(context, path, study));
  UM_TRY(um_core_snapshot_begin(context));
  study->holds_files = true;
  UM_TRY(um_model_create(context, study->scenario, &study->options.model, &study->model));
  if (study->model->points)
    return um_document_mark_fail(context, um_document_mark_key(&study->file->at, "scenario"),
                                 "its observations stand alone (orbit.points); accepted: an orbit");
  UM_TRY(um_study_identity_create(context, study->options.version, study->model,
                                  &study->options.model, &study->identity));
  if (study->options.batch.resume)
    UM_TRY(um_study_identity_check(context, study->identity, study->options.batch.folder));
  UM_TRY(find_bindings(context, study));
  UM_TRY(make_nominal(context, study));
  return um_study_dependencies_find(context, study);
}

enum um_status um_study_create(struct um_context *context, const char *path,
                               const struct um_study_run_options *options, struct um_study **out)
{
  struct um_study *study = NULL;
  *out = NULL;
  UM_TRY(um_core_allocate(context, 1, sizeof *study, &study));
  study->options = *options;
  enum um_status status = prepare(context, path, study);
  if (status != UM_OK) um_study_destroy(context, &study);
  *out = study;
  return status;
}

void um_study_destroy(struct um_context *context, struct um_study **study)
{
  if (study == NULL || *study == NULL) return;
  struct um_study *s = *study;
  um_variant_evaluator_destroy(context, &s->evaluator);
  um_model_destroy(context, &s->model);
  um_study_identity_destroy(context, &s->identity);
  if (s->holds_files) um_core_snapshot_end(context);
  UM_FREE(context, s->binding, s->moves_geometry, s->moves_heat, s->output, s->nominal, s->scale,
          s->curve, s->scenario, s->measurements);
  um_variant_accuracy_release(context, &s->accuracy);
  um_document_destroy(&s->document);
  um_core_free(context, s);
  *study = NULL;
}

const char *um_study_measurements(const struct um_study *study) { return study->measurements; }
