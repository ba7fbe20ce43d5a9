/* What finer facets would change of a run, from what each surface is off by.
 *
 * Light: a surface of shown temperature T, spread v and shift e sends
 * (B(T' + sqrt v) + B(T' - sqrt v)) / 2 in place of B(T), with T' = T - e and, where the surface
 * lies on the corners of a wall, T less 3 v / (2 T) before that, since T is the temperature of its
 * mean emission. Sums over what the observer sees of a material, relative, times what the material
 * emits toward the observer. */
#include "model/run/mesh_error.h"

#include <math.h>
#include <stdio.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "geometry/neighbours.h"
#include "model/run/thermal_solution_group.h"
#include "thermal/solver/mesh_error.h"

#define INSTANTS 48

struct sums {
  double *place, *area;   /* [2 ngroup] of an instant */
  double *was, *would;    /* [nmaterial] of an instant and band */
  double temperature_sum; /* over instants and surfaces, by area */
  double area_sum;
  size_t ntaken;
  struct um_geometry_pose *pose; /* joints at 0: only lengths are asked of it */
  uint32_t (*beside)[3];         /* facets beside each other */
};

static void of_places(const struct um_model *model, const struct um_thermal_mesh_error *error,
                      struct sums *sums, struct um_model_mesh_error *out)
{
  const struct um_geometry_mesh *mesh = um_geometry_mesh(model->geometry);
  size_t n = 2 * um_geometry_group_count(model->geometry);
  for (size_t p = 0; p < n; p++) sums->place[p] = sums->area[p] = 0.0;
  for (size_t s = 0; s < mesh->nsurface; s++) {
    const struct um_geometry_surface *at = &mesh->surface[s];
    size_t p = 2 * (size_t)at->group + at->back;
    double area = mesh->area[at->facet];
    sums->place[p] += area * error->shift[s];
    sums->area[p] += area;
    out->surface[s] += error->shift[s] * error->shift[s];
    sums->temperature_sum += area * fabs(error->shift[s]);
    sums->area_sum += area;
  }
  for (size_t p = 0; p < n; p++) {
    double mean = sums->area[p] > 0.0 ? sums->place[p] / sums->area[p] : 0.0;
    if (fabs(mean) > fabs(out->side[p])) out->side[p] = mean;
    if (fabs(mean) <= fabs(out->temperature)) continue;
    out->temperature = mean;
    out->group = p / 2;
    out->back = p % 2 != 0;
  }
}

/* Relative change of a band of observation k by the surfaces of its instant i. */
static double of_band(const struct um_model *model, const struct um_model_tables *tables,
                      const struct um_model_result *result, const double *shown,
                      const struct um_thermal_mesh_error *error, size_t i, size_t band,
                      struct sums *sums)
{
  const struct um_optics_view *view = tables->view;
  double from = model->band[band].from, to = model->band[band].to, change = 0.0;
  size_t k = i / tables->nsub;
  for (size_t m = 0; m < result->nmaterial; m++) sums->was[m] = sums->would[m] = 0.0;
  for (size_t s = 0; s < view->nsurface; s++) {
    double cosine = (double)view->cos_observer[i * view->nsurface + s];
    double weight = view->area[s] * (double)view->seen[i * view->nsurface + s] * cosine;
    if (!(weight > 0.0)) continue;
    double t = shown[s], root = sqrt(error->spread[s]);
    double mean = t - error->shift[s] - (error->lone[s] ? 0.0 : 1.5 * error->spread[s] / t);
    root = fmin(root, 0.5 * mean);
    sums->was[view->material[s]] += weight * um_core_planck_band(from, to, t);
    sums->would[view->material[s]] +=
        weight * 0.5 *
        (um_core_planck_band(from, to, mean + root) + um_core_planck_band(from, to, mean - root));
  }
  for (size_t m = 0; m < result->nmaterial; m++)
    if (sums->was[m] > 0.0)
      change += (sums->would[m] / sums->was[m] - 1.0) *
                result->intensity[((k * result->nband + band) * result->nmaterial + m) *
                                      UM_MECHANISM_COUNT +
                                  UM_MECHANISM_EMITTED];
  double whole = um_model_result_intensity(result, k, band, -1);
  return whole > 0.0 ? change / whole : 0.0;
}

static enum um_status of_instant(struct um_context *context, const struct um_model *model,
                                 const struct um_model_tables *tables,
                                 const struct um_model_thermal_solution *heat,
                                 const struct um_model_result *result, size_t i, struct sums *sums,
                                 struct um_model_mesh_error *out)
{
  const struct um_thermal_history *h = heat->run.history;
  struct um_thermal_mesh_error error;
  const double *node = h->temperature + (i + (heat->run.before ? 1 : 0)) * h->nnode;
  const double *shown = heat->run.surface + i * um_geometry_mesh(model->geometry)->nsurface;
  enum um_status status = um_thermal_mesh_error_at(
      context, model->body->network, um_geometry_mesh(model->geometry),
      (const uint32_t(*)[3])sums->beside, sums->pose, tables->loads, &heat->solver.options,
      tables->seen->t[tables->load_row[i]], node, &error);
  if (status == UM_OK) {
    of_places(model, &error, sums, out);
    for (size_t b = 0; b < out->nband; b++) {
      double change = of_band(model, tables, result, shown, &error, i, b, sums);
      out->light_mean[b] += change;
      if (fabs(change) > fabs(out->light[b])) out->light[b] = change;
    }
    sums->ntaken++;
  }
  um_thermal_mesh_error_release(context, &error);
  return status;
}

enum um_status um_model_mesh_error(struct um_context *context, const struct um_model *model,
                                   const struct um_model_tables *tables,
                                   const struct um_model_thermal_solution *heat,
                                   const struct um_model_result *result,
                                   struct um_model_mesh_error *out)
{
  enum um_status status;
  struct sums sums = {0};
  double *angles = NULL;
  size_t n = tables->nobs * tables->nsub, step = (n + INSTANTS - 1) / INSTANTS;
  size_t nplace = 2 * um_geometry_group_count(model->geometry);
  size_t nsurface = um_geometry_mesh(model->geometry)->nsurface;
  *out = (struct um_model_mesh_error){.nband = result->nmaterial > 0 ? result->nband : 0};
  UM_CHECK(
      um_core_allocate(context, um_geometry_joint_count(model->geometry), sizeof *angles, &angles));
  UM_CHECK(um_geometry_pose_create(context, model->geometry, angles, &sums.pose));
  UM_CHECK(um_geometry_neighbours(context, um_geometry_mesh(model->geometry), &sums.beside));
  UM_CHECK(um_core_allocate(context, nplace, sizeof *sums.place, &sums.place));
  UM_CHECK(um_core_allocate(context, nplace, sizeof *sums.area, &sums.area));
  UM_CHECK(um_core_allocate(context, result->nmaterial, sizeof *sums.was, &sums.was));
  UM_CHECK(um_core_allocate(context, result->nmaterial, sizeof *sums.would, &sums.would));
  UM_CHECK(um_core_allocate(context, nsurface, sizeof *out->surface, &out->surface));
  UM_CHECK(um_core_allocate(context, nplace, sizeof *out->side, &out->side));
  UM_CHECK(um_core_allocate(context, out->nband, sizeof *out->light, &out->light));
  UM_CHECK(um_core_allocate(context, out->nband, sizeof *out->light_mean, &out->light_mean));
  for (size_t i = step / 2; i < n; i += step) {
    UM_CHECK(um_core_stop_check(context, "the error of the facets was estimated"));
    UM_CHECK(of_instant(context, model, tables, heat, result, i, &sums, out));
  }
  if (sums.ntaken > 0) {
    out->temperature_mean = sums.temperature_sum / sums.area_sum;
    for (size_t s = 0; s < nsurface; s++)
      out->surface[s] = sqrt(out->surface[s] / (double)sums.ntaken);
    for (size_t b = 0; b < out->nband; b++) out->light_mean[b] /= (double)sums.ntaken;
  }
done:
  UM_FREE(context, angles, sums.place, sums.area, sums.was, sums.would, sums.beside);
  um_geometry_pose_destroy(context, &sums.pose);
  return status;
}

const char *um_model_mesh_side(const struct um_model *model, size_t group, bool back,
                               char text[UM_MODEL_MESH_SIDE])
{
  const struct um_geometry_group *of = um_geometry_group(model->geometry, group);
  snprintf(text, UM_MODEL_MESH_SIDE, "%.70s.%.70s%s",
           um_geometry_part_name(model->geometry, of->part), of->name, back ? ".back" : "");
  return text;
}

const char *um_model_mesh_sentence(const struct um_model *model,
                                   const struct um_model_mesh_error *mesh,
                                   char text[UM_MODEL_MESH_SENTENCE])
{
  char light[160] = "", place[UM_MODEL_MESH_SIDE] = "no place";
  for (size_t b = mesh->nband; b-- > 0;) {
    if (model->band[b].from < UM_INFRARED_FROM) continue;
    snprintf(light, sizeof light, "; %.32s by about %+.2g %% at most, %+.2g %% in the mean",
             model->band[b].name, 100.0 * mesh->light[b], 100.0 * mesh->light_mean[b]);
    break;
  }
  if (mesh->temperature != 0.0) um_model_mesh_side(model, mesh->group, mesh->back, place);
  snprintf(text, UM_MODEL_MESH_SENTENCE,
           "finer facets would move temperatures of places by about %+.2g K at most (%s), %.2g K "
           "in the mean%s",
           -mesh->temperature, place, mesh->temperature_mean, light);
  return text;
}
