/* What is kept of a point: curves of bands and places. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/suggestions.h"
#include "model/build/bands.h"
#include "study/study_impl.h"

static void add(struct um_study *study, enum um_study_wanted kind, const char *of)
{
  study->output[study->noutput++] = (struct um_study_output){kind, of};
}

static enum um_status check_band(struct um_context *context, const struct um_study *study,
                                 const char *band)
{
  struct um_core_words_guess guess = {.written = band};
  char hint[UM_CORE_WORDS_HINT], accepted[400] = "";
  if (um_model_band_find(study->model, band) != (size_t)-1) return UM_OK;
  for (size_t b = 0; b < study->model->nband; b++) {
    um_core_words_consider(&guess, study->model->band[b].name);
    um_core_words_append(accepted, sizeof accepted, study->model->band[b].name);
  }
  return um_document_mark_fail(context, um_document_mark_key(&study->file->outputs->at, "bands"),
                               "the scenario has no band '%.60s'%s; accepted: %s", band,
                               um_core_words_hint(&guess, hint), accepted);
}

static enum um_status check_place(struct um_context *context, const struct um_study *study,
                                  const char *place)
{
  const struct um_thermal_body *body = study->model->body;
  struct um_core_words_guess guess = {.written = place};
  char hint[UM_CORE_WORDS_HINT], accepted[700] = "";
  for (size_t p = 0; p < body->nplace; p++) {
    if (strcmp(body->place[p].name, place) == 0) return UM_OK;
    um_core_words_consider(&guess, body->place[p].name);
    um_core_words_append(accepted, sizeof accepted, body->place[p].name);
  }
  for (size_t m = 0; m < um_geometry_material_count(study->model->geometry); m++)
    if (strncmp(place, "material:", 9) == 0 &&
        strcmp(um_geometry_material_name(study->model->geometry, m), place + 9) == 0)
      return UM_OK;
  return um_document_mark_fail(
      context, um_document_mark_key(&study->file->outputs->at, "places"),
      "the scenario has no place '%.60s'%s; accepted: %s, or material:NAME", place,
      um_core_words_hint(&guess, hint), accepted);
}

enum um_status um_study_outputs_make(struct um_context *context, struct um_study *study)
{
  const struct um_study_file_outputs *o = study->file->outputs;
  const struct um_model *model = study->model;
  const char *const *band = o->bands.items, *const *place = o->places.items;
  size_t nband = o->bands.count;
  bool all = nband == 0 && (o->places.count == 0 || o->magnitudes) && model->has_observer;
  if (all) nband = model->nband;
  UM_TRY(um_core_allocate(context, 2 * nband + o->places.count + 1, sizeof *study->output,
                          &study->output));
  for (size_t b = 0; b < nband; b++) {
    const char *name = all ? model->band[b].name : band[b];
    if (!model->has_observer)
      return um_document_mark_fail(context, um_document_mark_key(&o->at, "bands"),
                                   "the scenario has no observer to see it; accepted: places");
    UM_TRY(check_band(context, study, name));
    add(study, UM_STUDY_IRRADIANCE, name);
  }
  for (size_t b = 0; b < nband && o->magnitudes; b++)
    add(study, UM_STUDY_MAGNITUDE, all ? model->band[b].name : band[b]);
  for (size_t p = 0; p < o->places.count; p++) {
    UM_TRY(check_place(context, study, place[p]));
    add(study, UM_STUDY_TEMPERATURE, place[p]);
  }
  if (study->noutput == 0)
    return um_document_mark_fail(context, &o->at, "nothing is wanted; accepted: bands or places");
  return um_study_limits_check(context, study);
}

enum um_status um_study_outputs_take(struct um_context *context, const void *user,
                                     const struct um_model *model,
                                     const struct um_model_result *result, double *value)
{
  const struct um_study *study = user;
  for (size_t q = 0; q < study->noutput; q++) {
    const struct um_study_output *output = &study->output[q];
    double *to = value + q * study->ntime;
    size_t band = um_model_band_find(model, output->of), place = 0;
    while (place < result->nplace && strcmp(result->place[place].name, output->of) != 0) place++;
    bool light = output->kind != UM_STUDY_TEMPERATURE;
    if (light ? band == (size_t)-1 : place == result->nplace)
      return um_core_fail(context, UM_ERR_REFUSED, "no %s '%s' at this point",
                          light ? "band" : "place", output->of);
    if (result->nobs != study->ntime)
      return um_core_fail(context, UM_ERR_REFUSED,
                          "%zu observations in place of %zu: a parameter that changes the times "
                          "makes curves that do not compare",
                          result->nobs, study->ntime);
    for (size_t k = 0; k < study->ntime; k++) {
      if (!light)
        to[k] = result->place[place].mean[k];
      else if (output->kind == UM_STUDY_IRRADIANCE)
        to[k] = result->irradiance[k * result->nband + band];
      else
        to[k] = result->magnitude_ab[k * result->nband + band];
      if (!isfinite(to[k])) to[k] = NAN;
    }
  }
  return UM_OK;
}

static double asked(const struct um_study_file_error *error, enum um_study_wanted kind)
{
  if (kind == UM_STUDY_TEMPERATURE) return error->temperature_K;
  return kind == UM_STUDY_MAGNITUDE ? UM_POGSON * error->light : error->light;
}

enum um_status um_study_curves_make(struct um_context *context, struct um_study *study)
{
  UM_TRY(um_core_allocate(context, study->noutput, sizeof *study->curve, &study->curve));
  for (size_t q = 0; q < study->noutput; q++)
    study->curve[q] =
        (struct um_variant_curve){.count = study->ntime,
                                  .relative = study->output[q].kind == UM_STUDY_IRRADIANCE,
                                  .floor = UM_STUDY_FLOOR * study->scale[q],
                                  .asked = asked(study->file->error, study->output[q].kind)};
  study->curves = (struct um_variant_curves){.evaluator = study->evaluator,
                                             .base = &study->base,
                                             .curve = study->curve,
                                             .ncurve = study->noutput,
                                             .nvalue = study->nvalue,
                                             .nominal = study->nominal,
                                             .take = um_study_outputs_take,
                                             .user = study};
  return UM_OK;
}
