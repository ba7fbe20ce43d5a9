/* What the temperatures say place by place: parts, sides, groups, interiors and materials. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/run/parts_impl.h"

static size_t instants(const struct um_model_tables *tables) { return tables->nobs * tables->nsub; }

static enum um_status history_new(struct um_context *context, const struct um_model_tables *tables,
                                  const char *prefix, const char *name,
                                  struct um_model_place_history *out)
{
  UM_TRY(um_core_asprintf(context, &out->name, "%s%s", prefix, name));
  UM_TRY(um_core_allocate(context, tables->nobs, sizeof(double), &out->mean));
  UM_TRY(um_core_allocate(context, tables->nobs, sizeof(double), &out->minimum));
  UM_TRY(um_core_allocate(context, tables->nobs, sizeof(double), &out->maximum));
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
static void store(struct um_model_place_history *to, const struct um_model_tables *tables,
                  size_t instant, double mean, double low, double high)
{
  size_t k = instant / tables->nsub;
  bool first = instant % tables->nsub == 0;
  to->mean[k] += mean / (double)tables->nsub;
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
                                    const struct um_model_tables *tables,
                                    const struct um_model_thermal_solution *heat,
                                    const struct um_thermal_place *place,
                                    struct um_model_place_history *out)
{
  const struct um_thermal_history *h = heat->run.history;
  size_t shift = heat->run.before ? 1 : 0;
  UM_TRY(history_new(context, tables, "", place->name, out));
  for (size_t i = 0; i < instants(tables); i++) {
    const double *t = h->temperature + (i + shift) * h->nnode;
    if (i % 64 == 0) UM_TRY(um_core_stop_check(context, "temperatures were averaged"));
    double mean = 0.0, low = INFINITY, high = -INFINITY;
    for (size_t j = 0; j < place->nnode; j++)
      take(t[place->node[j]], place->weight[j], &mean, &low, &high);
    store(out, tables, i, mean, low, high);
  }
  if (!heat->run.before && heat->drift != NULL) out->drift = place_mean(place, heat->drift);
  if (heat->run.before)
    out->drift = place_mean(place, h->temperature + h->nnode) - place_mean(place, h->temperature);
  return UM_OK;
}

static enum um_status material_history(struct um_context *context, const struct um_model *model,
                                       const struct um_model_tables *tables,
                                       const struct um_model_heat_run *run, uint32_t material,
                                       struct um_model_place_history *out)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  UM_TRY(history_new(context, tables,
                     "material:", um_geometry_material_name(model->geometry, material), out));
  for (size_t i = 0; i < instants(tables); i++) {
    const double *t = run->surface + i * mesh->nsurface;
    if (i % 16 == 0) UM_TRY(um_core_stop_check(context, "temperatures were averaged"));
    double mean = 0.0, low = INFINITY, high = -INFINITY, area = 0.0;
    for (size_t s = 0; s < mesh->nsurface; s++) {
      if (mesh->surface[s].material != material) continue;
      double a = mesh->area[mesh->surface[s].facet];
      take(t[s], a, &mean, &low, &high);
      area += a;
    }
    store(out, tables, i, mean / area, low, high);
  }
  return UM_OK;
}

/* The share that a place has of each of its nodes, in the order of places and their nodes. Parts,
 * walls and interiors have theirs alone; a node between groups belongs to them by area, so that
 * groups add up to their part. The caller frees. */
static enum um_status shares_of(struct um_context *context, const struct um_thermal_body *body,
                                double **out)
{
  size_t n = um_thermal_network_nodes(body->network), all = 0, at = 0;
  double *area = NULL; /* [node] of groups, then of their walls */
  for (size_t p = 0; p < body->nplace; p++) all += body->place[p].nnode;
  UM_TRY(um_core_allocate(context, all, sizeof **out, out));
  UM_TRY(um_core_allocate(context, 2 * n, sizeof *area, &area));
  for (int pass = 0; pass < 2; pass++)
    for (size_t p = 0; p < body->nplace; p++) {
      const struct um_thermal_place *place = &body->place[p];
      bool wall = place->kind == UM_PLACE_GROUP_WALL, group = place->kind == UM_PLACE_GROUP;
      bool side = place->kind == UM_PLACE_SIDE;
      for (size_t j = 0; j < place->nnode; j++) {
        double *sum = &area[place->node[j] + (wall ? n : 0)], own = place->weight[j] * place->area;
        if (pass == 0 && (wall || group)) *sum += own;
        if (pass == 1) (*out)[at++] = wall || group || side ? own / *sum : 1.0;
      }
    }
  um_core_free(context, area);
  return UM_OK;
}

enum um_status um_model_run_heat(struct um_context *context, const struct um_model *model,
                                 const struct um_model_tables *tables,
                                 const struct um_model_thermal_solution *heat,
                                 struct um_model_result *result)
{
  enum um_status status;
  const struct um_model_heat_run *run = &heat->run;
  const struct um_thermal_history *h = run->history;
  const struct um_thermal_body *body = model->body;
  struct um_thermal_heat *node = NULL;
  double *share = NULL;
  if (heat->moved)
    return um_core_fail(context, UM_ERR_INPUT,
                        "heats of temperatures that a sensitivity has moved; accepted: of a run");
  UM_CHECK(um_core_allocate(context, h->nnode, sizeof *node, &node));
  UM_CHECK(shares_of(context, body, &share));
  UM_CHECK(um_core_allocate(context, tables->nobs * result->nplace, sizeof *result->heat,
                            &result->heat));
  for (size_t i = 0; i < instants(tables); i++) {
    const double *t = h->temperature + (i + (run->before ? 1 : 0)) * h->nnode;
    UM_CHECK(um_core_stop_check(context, "heats were summed"));
    UM_CHECK(um_thermal_heat_of_nodes(context, body->network, tables->loads, &heat->solver.options,
                                      tables->seen->t[tables->load_row[i]], t, node));
    if (h->heating != NULL)
      um_thermal_heat_of_thermostats(
          body->network, h->heating + (i + (run->before ? 1 : 0)) * h->nthermostat, node);
    for (size_t p = 0, s = 0; p < body->nplace; p++) {
      struct um_thermal_heat *to = &result->heat[i / tables->nsub * result->nplace + p];
      for (size_t j = 0; j < body->place[p].nnode; j++, s++) {
        double w = share[s] / (double)tables->nsub;
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
  UM_FREE(context, share, node);
  return status;
}

enum um_status um_model_run_histories(struct um_context *context, const struct um_model *model,
                                      const struct um_model_tables *tables,
                                      const struct um_model_thermal_solution *heat,
                                      struct um_model_result *result)
{
  const struct um_model_heat_run *run = &heat->run;
  size_t nplace = model->body->nplace;
  size_t nmaterial = um_geometry_material_count(model->geometry);
  result->nplace = nplace + nmaterial;
  UM_TRY(um_core_allocate(context, result->nplace, sizeof *result->place, &result->place));
  for (size_t p = 0; p < nplace; p++)
    UM_TRY(place_history(context, tables, heat, &model->body->place[p], &result->place[p]));
  for (size_t m = 0; m < nmaterial; m++)
    UM_TRY(material_history(context, model, tables, run, (uint32_t)m, &result->place[nplace + m]));
  return UM_OK;
}
