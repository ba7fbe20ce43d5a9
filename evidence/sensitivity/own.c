/* A scenario's own observations. */
#include "evidence/sensitivity/own.h"

#include <math.h>
#include <stdio.h>

#include "evidence/measurements/make.h"
#include "evidence/sensitivity/forward_impl.h"
#include "model/geometry/precompute.h"

#define UNWEIGHED 1e30 /* sigma that asks for nothing */
#define LIGHT     1e-3 /* of a curve's largest value */
#define HEAT      0.1  /* [K] */

struct rows {
  struct um_compare_row *row; /* [count] */
  size_t count;
  double exposure; /* [s]; NaN: none */
};

static void add(struct rows *rows, double t, const char *quantity, const char *of)
{
  rows->row[rows->count++] = (struct um_compare_row){.t_tai = t,
                                                     .quantity = quantity,
                                                     .of = of,
                                                     .value = 1.0,
                                                     .sigma = UNWEIGHED,
                                                     .exposure = rows->exposure,
                                                     .satellite_height = NAN,
                                                     .azimuth = NAN,
                                                     .elevation = NAN};
}

/* "material:NAME" of every material; the caller frees texts and list. */
static enum um_status name_materials(struct um_context *context, const struct um_model *model,
                                     char **name)
{
  for (size_t i = 0; i < um_geometry_material_count(model->geometry); i++)
    UM_TRY(um_core_asprintf(context, &name[i], "material:%s",
                            um_geometry_material_name(model->geometry, i)));
  return UM_OK;
}

enum um_status um_sensitivity_own_create(struct um_context *context, const struct um_model *model,
                                         struct um_compare_measurements **out)
{
  enum um_status status;
  size_t n, places = model->body->nplace, materials = um_geometry_material_count(model->geometry);
  const char *temperature = um_compare_quantity_name(UM_QUANTITY_TEMPERATURE);
  const char *light = um_compare_quantity_name(UM_QUANTITY_BAND_IRRADIANCE);
  double exposure = model->scenario->time->exposure_s, *time = NULL;
  bool *hidden = NULL;
  char **material = NULL;
  struct rows rows = {.exposure = exposure > 0.0 ? exposure : (double)NAN};
  *out = NULL;
  if (model->points)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%s: observations of orbit.points have no instants of the scenario's own; "
                        "accepted: a scenario with an orbit, or measurements",
                        model->scenario->at.file);
  UM_CHECK(um_model_scenario_times(context, model, &time, &n));
  UM_CHECK(um_model_hidden_at(context, model, time, n, &hidden));
  UM_CHECK(um_core_allocate(context, materials, sizeof *material, &material));
  UM_CHECK(name_materials(context, model, material));
  UM_CHECK(um_core_allocate(context, n * (model->nband + places + materials), sizeof *rows.row,
                            &rows.row));
  for (size_t k = 0; k < n; k++) {
    for (size_t b = 0; model->has_observer && !hidden[k] && b < model->nband; b++)
      add(&rows, time[k], light, model->band[b].name);
    for (size_t p = 0; p < places; p++)
      add(&rows, time[k], temperature, model->body->place[p].name);
    for (size_t i = 0; i < materials; i++) add(&rows, time[k], temperature, material[i]);
  }
  UM_CHECK(um_compare_measurements_make(context, "the scenario", rows.row, rows.count, out));
done:
  for (size_t i = 0; material != NULL && i < materials; i++) um_core_free(context, material[i]);
  UM_FREE(context, material, time, hidden, rows.row);
  return status;
}

void um_sensitivity_own_weigh(struct um_sensitivity_forward *f, bool own)
{
  struct um_sensitivity_observations *o = &f->observations;
  const double *base = f->cache->base;
  double share = 0.0;
  for (size_t c = 0; c < f->measurements->nchannel; c++) {
    double sigma = HEAT, most = 0.0;
    for (size_t j = 0; j < o->count; j++)
      if (o->channel[j] == c) most = fmax(most, fabs(base[j]));
    if (f->measurements->channel[c].quantity != UM_QUANTITY_TEMPERATURE)
      sigma = most > 0.0 ? LIGHT * most : 1.0;
    for (size_t j = 0; j < o->count; j++)
      if (o->channel[j] == c) o->sigma[j] = o->stated_sigma[j] = sigma;
  }
  for (size_t j = 0; j < o->count; j++) {
    if (own) o->measured[j] = base[j];
    share += o->model_sigma[j] * o->model_sigma[j] / (o->sigma[j] * o->sigma[j]);
  }
  o->model_share = o->count > 0 ? share / (double)o->count : 0.0;
}
