/* What the temperatures say place by place: parts, sides, groups, interiors and materials. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/run_places_impl.h"

static size_t instants(const struct um_model_precomputed *precomputed)
{
  return precomputed->nobs * precomputed->nsub;
}

static enum um_status history_new(struct um_context *context,
                                  const struct um_model_precomputed *precomputed,
                                  const char *prefix, const char *name,
                                  struct um_model_place_history *out)
{
  UM_TRY(um_core_asprintf(context, &out->name, "%s%s", prefix, name));
  UM_TRY(um_core_allocate(context, precomputed->nobs, sizeof(double), &out->mean));
  UM_TRY(um_core_allocate(context, precomputed->nobs, sizeof(double), &out->minimum));
  UM_TRY(um_core_allocate(context, precomputed->nobs, sizeof(double), &out->maximum));
  out->drift = NAN;
  return UM_OK;
}

/* Add one weighted temperature to mean, minimum and maximum of an instant. */
static void take(double t, double weight, double *mean, double *low, double *high)
{
  *mean += weight * t;
  *low = fmin(*low, t);
  *high = fmax(*high, t);
}

/* Mean over the exposure of each instant's mean; extremes over all instants. */
static void store(struct um_model_place_history *to, const struct um_model_precomputed *precomputed,
                  size_t instant, double mean, double low, double high)
{
  size_t k = instant / precomputed->nsub;
  bool first = instant % precomputed->nsub == 0;
  to->mean[k] += mean / (double)precomputed->nsub;
  to->minimum[k] = first ? low : fmin(to->minimum[k], low);
  to->maximum[k] = first ? high : fmax(to->maximum[k], high);
}

static double place_mean(const struct um_thermal_place *place, const double *temperature)
{
  double mean = 0.0;
  for (size_t j = 0; j < place->nnode; j++) mean += place->weight[j] * temperature[place->node[j]];
  return mean;
}

static enum um_status place_history(struct um_context *context,
                                    const struct um_model_precomputed *precomputed,
                                    const struct um_model_heat_run *run,
                                    const struct um_thermal_place *place,
                                    struct um_model_place_history *out)
{
  const struct um_thermal_history *h = run->history;
  size_t shift = run->before ? 1 : 0;
  UM_TRY(history_new(context, precomputed, "", place->name, out));
  for (size_t i = 0; i < instants(precomputed); i++) {
    const double *t = h->temperature + (i + shift) * h->nnode;
    if (i % 64 == 0) UM_TRY(um_core_stop_check(context, "temperatures were averaged"));
    double mean = 0.0, low = INFINITY, high = -INFINITY;
    for (size_t j = 0; j < place->nnode; j++)
      take(t[place->node[j]], place->weight[j], &mean, &low, &high);
    store(out, precomputed, i, mean, low, high);
  }
  if (run->before)
    out->drift = place_mean(place, h->temperature + h->nnode) - place_mean(place, h->temperature);
  return UM_OK;
}

static enum um_status material_history(struct um_context *context, const struct um_model *model,
                                       const struct um_model_precomputed *precomputed,
                                       const struct um_model_heat_run *run, uint32_t material,
                                       struct um_model_place_history *out)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  UM_TRY(history_new(context, precomputed,
                     "material:", um_geometry_material_name(model->geometry, material), out));
  for (size_t i = 0; i < instants(precomputed); i++) {
    const double *t = run->surface + i * mesh->nsurface;
    if (i % 16 == 0) UM_TRY(um_core_stop_check(context, "temperatures were averaged"));
    double mean = 0.0, low = INFINITY, high = -INFINITY, area = 0.0;
    for (size_t s = 0; s < mesh->nsurface; s++) {
      if (mesh->surface[s].material != material) continue;
      double a = mesh->area[mesh->surface[s].facet];
      take(t[s], a, &mean, &low, &high);
      area += a;
    }
    store(out, precomputed, i, mean / area, low, high);
  }
  return UM_OK;
}

/* Heat of all nodes of a place; meaningful for whole parts and interiors, whose nodes are theirs
 * alone. Mean over the exposure. */
static enum um_status heat_of_places(struct um_context *context, const struct um_model *model,
                                     const struct um_model_precomputed *precomputed,
                                     const struct um_model_thermal_solution *heat,
                                     struct um_model_result *result)
{
  enum um_status status;
  const struct um_model_heat_run *run = &heat->run;
  const struct um_thermal_history *h = run->history;
  const struct um_thermal_body *body = model->body;
  struct um_thermal_heat *node = NULL;
  UM_TRY(um_core_allocate(context, h->nnode, sizeof *node, &node));
  UM_CHECK(um_core_allocate(context, precomputed->nobs * result->nplace, sizeof *result->heat,
                            &result->heat));
  for (size_t i = 0; i < instants(precomputed); i++) {
    const double *t = h->temperature + (i + (run->before ? 1 : 0)) * h->nnode;
    UM_CHECK(um_core_stop_check(context, "heats were summed"));
    UM_CHECK(um_thermal_heat_of_nodes(context, body->network, precomputed->loads,
                                      &heat->setting.options,
                                      precomputed->loads->t[precomputed->load_row[i]], t, node));
    if (h->heating != NULL)
      um_thermal_heat_of_thermostats(
          body->network, h->heating + (i + (run->before ? 1 : 0)) * h->nthermostat, node);
    for (size_t p = 0; p < body->nplace; p++) {
      struct um_thermal_heat *to = &result->heat[i / precomputed->nsub * result->nplace + p];
      double w = 1.0 / (double)precomputed->nsub;
      for (size_t j = 0; j < body->place[p].nnode; j++) {
        const struct um_thermal_heat *from = &node[body->place[p].node[j]];
        to->solar += w * from->solar;
        to->albedo += w * from->albedo;
        to->planet += w * from->planet;
        to->internal += w * from->internal;
        to->conducted += w * from->conducted;
        to->radiated += w * from->radiated;
        to->exchanged += w * from->exchanged;
        to->stored += w * from->stored;
      }
    }
  }
done:
  um_core_free(context, node);
  return status;
}

enum um_status um_model_run_places(struct um_context *context, const struct um_model *model,
                                   const struct um_model_precomputed *precomputed,
                                   const struct um_model_thermal_solution *heat,
                                   struct um_model_result *result)
{
  const struct um_model_heat_run *run = &heat->run;
  size_t nplace = model->body->nplace;
  size_t nmaterial = um_geometry_material_count(model->geometry);
  result->nplace = nplace + nmaterial;
  UM_TRY(um_core_allocate(context, result->nplace, sizeof *result->place, &result->place));
  for (size_t p = 0; p < nplace; p++)
    UM_TRY(place_history(context, precomputed, run, &model->body->place[p], &result->place[p]));
  for (size_t m = 0; m < nmaterial; m++)
    UM_TRY(material_history(context, model, precomputed, run, (uint32_t)m,
                            &result->place[nplace + m]));
  return heat_of_places(context, model, precomputed, heat, result);
}
