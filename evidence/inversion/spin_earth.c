/* Light of the Earth on a coarse grid. It changes slowly with the attitude, the Earth being large,
 * and slowly along a pass, so nodes of 22.5 deg in attitude serve a search whose own steps are
 * finer; what is fitted afterwards is the whole model.
 *
 * An attitude is a place of a map: p is the frame's z in body axes, and the plane is that of its x.
 */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "environment/environment.h"
#include "evidence/inversion/spin_impl.h"
#include "model/geometry/posed.h"
#include "model/run/run_light.h"
#include "thermal/loads/loads.h"

#define STEP        (22.5 * UM_DEG)
#define PLANES      16
#define SKY_TURNS   (25.0 * UM_DEG) /* from node to node */
#define NODES_MOST  48
#define POINTS      16  /* per facet that something can hide */
#define BLOCK_BYTES 1e8 /* of scenes that are held at once */
#define ROW_BYTES   128 /* of a surface at an instant */

/* Directions whose bisector is the frame's z, with its x across. */
static const struct um_vec3 first = {0.70710678118654752, 0.0, 0.70710678118654752},
                            second = {-0.70710678118654752, 0.0, 0.70710678118654752};

static struct um_quat attitude_at(const struct um_model_phase_vector *at)
{
  struct um_model_phase_vector right = *at;
  struct um_vec3 a, b;
  right.phase_angle = 0.5 * UM_PI;
  um_model_phase_directions(&right, &a, &b);
  struct um_vec3 z = um_vec3_unit(um_vec3_add(a, b)), x = um_vec3_unit(um_vec3_sub(a, b));
  struct um_mat3 columns = um_mat3_from_axes(x, um_vec3_cross(z, x), z);
  return um_core_quat_from_matrix(um_mat3_transpose(columns));
}

double um_compare_spin_look_up(const struct um_compare_spin_data *data,
                               const struct um_compare_spin_row *row, struct um_quat q,
                               double *scratch)
{
  struct um_model_phase_vector at =
      um_model_phase_vector(um_quat_apply(q, row->sun), um_quat_apply(q, row->observer));
  um_model_map_look_up(data->map, &at, scratch);
  double value = scratch[row->band];
  if (data->earth == NULL) return value;
  at = um_model_phase_vector(um_quat_apply(q, first), um_quat_apply(q, second));
  at.phase_angle = row->node;
  um_model_map_look_up(data->earth, &at, scratch);
  return value + row->earth_scale * scratch[row->band];
}

/* ---- nodes along the observations ---- */

/* How far the sky of one observation is turned from that of another, in the frame of the axis. */
static double turned(const struct um_environment_sample *a, struct um_quat p,
                     const struct um_environment_sample *b, struct um_quat q)
{
  const struct um_vec3 own[] = {a->sun, a->to_observer, a->r},
                       other[] = {b->sun, b->to_observer, b->r};
  double most = 0.0;
  for (int k = 0; k < 3; k++)
    most = fmax(most, um_vec3_angle(um_quat_apply(p, own[k]), um_quat_apply(q, other[k])));
  return most;
}

/* Observations at nodes, ascending; those between two nodes are apart from the first by less than
 * `angle`. Returns their number, NODES_MOST + 1 for too many. */
static size_t nodes_by(const struct um_environment_sample *sample, const struct um_quat *frame,
                       size_t n, double angle, size_t *node)
{
  size_t count = 0;
  node[count++] = 0;
  for (size_t k = 1; k < n && count < NODES_MOST; k++) {
    size_t last = node[count - 1];
    if (turned(&sample[last], frame[last], &sample[k], frame[k]) < angle) continue;
    node[count++] = k - 1 > last ? k - 1 : k;
    if (node[count - 1] == k - 1) k--; /* and on from there */
  }
  if (count < NODES_MOST && node[count - 1] + 1 < n) node[count++] = n - 1;
  return node[count - 1] + 1 < n ? NODES_MOST + 1 : count;
}

static size_t nodes_find(const struct um_environment_sample *sample, const struct um_quat *frame,
                         size_t n, size_t *node)
{
  double angle = SKY_TURNS;
  size_t count;
  while ((count = nodes_by(sample, frame, n, angle, node)) > NODES_MOST) angle *= 1.5;
  return count;
}

/* Where the rows stand between the nodes, by time, and their scale. */
static void place_rows(const size_t *node, size_t nnode, struct um_compare_spin_data *d,
                       double *scratch)
{
  for (size_t i = 0; i < d->count; i++) {
    struct um_compare_spin_row *row = &d->row[i];
    size_t k = d->on_map->row[row->on_map].observation, low = 0;
    while (low + 2 < nnode && node[low + 1] < k) low++;
    const struct um_environment_sample *s = d->on_map->sample;
    double share = 0.0;
    if (nnode > 1) {
      double from = s[node[low]].t_tai, to = s[node[low + 1]].t_tai;
      if (to > from) share = fmin(fmax((s[k].t_tai - from) / (to - from), 0.0), 1.0);
    }
    row->node = 1.0 + (double)low + share;
    row->earth_scale = um_model_solar_irradiance(d->model, row->band) /
                       um_model_sunlight_band(d->model, &s[k], row->band, scratch);
  }
}

/* ---- light ---- */

/* Light of the Earth of scenes [n] over sunlight at 1 au; value [n][nband]. */
static enum um_status render(struct um_context *context, const struct um_model *model,
                             const struct um_environment_sample *sample, size_t n, double *value)
{
  enum um_status status;
  struct um_model_tables *tables = NULL;
  struct um_optics_lightcurve *curve = NULL;
  UM_CHECK(um_model_precompute_instants(context, sample, n, &tables));
  UM_CHECK(um_model_precompute_posed(context, model, (struct um_model_sampling){POINTS, 0}, true,
                                     tables));
  UM_CHECK(um_model_run_cold_light(context, model, tables, &curve));
  for (size_t i = 0; i < n; i++)
    for (size_t b = 0; b < model->nband; b++) {
      const double *own =
          curve->intensity + (i * curve->nband + b) * curve->nmaterial * UM_MECHANISM_COUNT;
      double sum = 0.0, unit = um_model_solar_irradiance(model, b);
      for (size_t m = 0; m < curve->nmaterial; m++)
        sum += own[m * UM_MECHANISM_COUNT + UM_MECHANISM_EARTH];
      value[i * model->nband + b] = sum / unit;
    }
done:
  um_optics_lightcurve_destroy(context, &curve);
  um_model_tables_destroy(context, &tables);
  return status;
}

/* A scene of every place of the map, which are those of a node of time one after the other. */
static void scenes(const struct um_model_map *map, size_t g,
                   const struct um_environment_sample *sample, struct um_quat frame,
                   struct um_environment_sample *out)
{
  size_t n = 0;
  for (size_t k = 0; k < map->nplane[g]; k++)
    for (size_t i = 0; i < map->nlatitude; i++)
      for (size_t j = 0; j < map->nlongitude; j++, n++) {
        struct um_model_phase_vector at = um_model_map_place(map, g, k, i, j);
        out[n] = *sample;
        out[n].q = um_quat_then(frame, attitude_at(&at));
      }
}

static enum um_status fill(struct um_context *context, const struct um_compare_spin_data *d,
                           const size_t *node, const struct um_quat *frame)
{
  enum um_status status = UM_OK;
  const struct um_model_map *map = d->earth;
  struct um_model model = *d->model;
  struct um_environment_sample *scene = NULL;
  size_t nsurface = um_geometry_mesh(model.geometry)->nsurface;
  size_t all = PLANES * map->nlatitude * map->nlongitude;
  size_t block = (size_t)fmax(BLOCK_BYTES / (ROW_BYTES * (double)nsurface), 32.0);
  model.environment.inter_reflection_on = false;
  UM_TRY(um_core_allocate(context, all, sizeof *scene, &scene));
  um_core_progress_begin(context, "light of the Earth by attitude", map->nphase * all);
  for (size_t g = 0; g < map->nphase; g++) {
    scenes(map, g, &d->on_map->sample[node[g]], frame[node[g]], scene);
    for (size_t from = 0; from < all; from += block) {
      size_t n = all - from < block ? all - from : block;
      um_core_quiet_begin(context);
      status = render(context, &model, scene + from, n,
                      map->value + (map->first[g] * (all / PLANES) + from) * map->nband);
      um_core_quiet_end(context);
      if (status == UM_OK) status = um_core_progress_step(context, n);
      if (status == UM_OK) status = um_core_stop_check(context, "light of the Earth was computed");
      if (status != UM_OK) goto done;
    }
  }
done:
  um_core_progress_end(context);
  um_core_free(context, scene);
  return status;
}

static bool is_lit(const struct um_environment *e)
{
  return e->earthshine_on && um_irradiation_earth_shines(e);
}

enum um_status um_compare_spin_earth(struct um_context *context, struct um_compare_spin_data *d)
{
  enum um_status status;
  size_t n = d->on_map->plan->ntime, node[NODES_MOST], nnode, bins = 1;
  struct um_quat *frame = NULL;
  double coordinate[NODES_MOST], *scratch = NULL;
  if (!is_lit(&d->model->environment)) return UM_OK;
  for (size_t b = 0; b < d->model->nband; b++)
    if ((size_t)d->model->band[b].bins > bins) bins = (size_t)d->model->band[b].bins;
  UM_CHECK(um_core_allocate(context, bins, sizeof *scratch, &scratch));
  UM_CHECK(um_core_allocate(context, n, sizeof *frame, &frame));
  UM_CHECK(um_compare_spin_frames(context, d->lvlh, d->on_map->sample, n, frame));
  nnode = nodes_find(d->on_map->sample, frame, n, node);
  for (size_t g = 0; g < nnode; g++) coordinate[g] = 1.0 + (double)g;
  struct um_model_map_grid grid = {STEP, coordinate, nnode, PLANES, 0.0};
  UM_CHECK(um_model_map_allocate(context, &grid, 2.0 * UM_PI, d->model->nband, &d->earth));
  place_rows(node, nnode, d, scratch);
  UM_CHECK(fill(context, d, node, frame));
done:
  UM_FREE(context, frame, scratch);
  return status;
}
