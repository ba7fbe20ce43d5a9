/* The nodes of a reflectivity map, and looking up between them. */
#include "model/products/reflectivity_map.h"

#include <string.h>

#include "base/core/constants.h"
#include "base/core/interpolation.h"
#include "model/products/map_cells_impl.h"
#include "model/products/reflectivity.h"

#define NODES_MAX 2e7

static enum um_status check(struct um_context *context, const struct um_model_map_grid *grid)
{
  double rows = 0.5 * UM_PI / grid->step;
  if (!(rows >= 1.0 && fabs(rows - round(rows)) < 1e-6))
    return um_core_fail(context, UM_ERR_INPUT, "step of %g deg; accepted: 90 deg or a part of it",
                        grid->step / UM_DEG);
  if (grid->nphase == 0 || grid->nplane == 0)
    return um_core_fail(context, UM_ERR_INPUT,
                        "%zu phase angles, %zu planes; accepted: one of each or more", grid->nphase,
                        grid->nplane);
  for (size_t i = 0; i < grid->nphase; i++) {
    double g = grid->phase_angle[i];
    if (!(g >= 0.0 && g < UM_PI && (i == 0 || g > grid->phase_angle[i - 1])))
      return um_core_fail(context, UM_ERR_INPUT,
                          "phase angle %g deg; accepted: from 0 to below 180, ascending",
                          g / UM_DEG);
  }
  double nodes = 8.0 * rows * rows * (double)grid->nphase * (double)grid->nplane;
  if (nodes <= NODES_MAX) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%g nodes of %zu phase angles, %zu planes and steps of %g deg; accepted: up "
                      "to %g",
                      nodes, grid->nphase, grid->nplane, grid->step / UM_DEG, NODES_MAX);
}

enum um_status um_model_map_allocate(struct um_context *context,
                                     const struct um_model_map_grid *grid, double turn,
                                     size_t nband, struct um_model_map **out)
{
  enum um_status status;
  size_t rows = (size_t)lround(0.5 * UM_PI / grid->step);
  struct um_model_map *map = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *map, &map));
  *map = (struct um_model_map){.step = 0.5 * UM_PI / (double)rows,
                               .turn = turn,
                               .nlatitude = 2 * rows + 1,
                               .nlongitude = 4 * rows,
                               .nphase = grid->nphase,
                               .nband = nband,
                               .tolerance = grid->tolerance};
  UM_CHECK(um_core_allocate(context, map->nphase, sizeof *map->phase_angle, &map->phase_angle));
  UM_CHECK(um_core_allocate(context, map->nphase, sizeof *map->nplane, &map->nplane));
  UM_CHECK(um_core_allocate(context, map->nphase, sizeof *map->first, &map->first));
  for (size_t i = 0; i < map->nphase; i++) {
    map->phase_angle[i] = grid->phase_angle[i];
    map->nplane[i] = grid->phase_angle[i] > 0.0 ? grid->nplane : 1;
    map->first[i] = map->planes;
    map->planes += map->nplane[i];
  }
  map->nnode = map->planes * map->nlatitude * map->nlongitude;
  size_t n = map->nnode * map->nband;
  UM_CHECK(um_core_allocate(context, n, sizeof *map->value, &map->value));
  UM_CHECK(um_core_allocate(context, n, sizeof *map->error, &map->error));
  *out = map;
  map = NULL;
done:
  um_model_map_destroy(context, &map);
  return status;
}

static size_t node_at(const struct um_model_map *map, size_t plane, size_t latitude,
                      size_t longitude)
{
  return ((plane * map->nlatitude + latitude) * map->nlongitude + longitude) * map->nband;
}

struct um_model_phase_vector um_model_map_place(const struct um_model_map *map, size_t phase,
                                                size_t plane, size_t latitude, size_t longitude)
{
  return (struct um_model_phase_vector){
      -0.5 * UM_PI + (double)latitude * map->step, -UM_PI + (double)longitude * map->step,
      map->phase_angle[phase], map->turn * (double)plane / (double)map->nplane[phase]};
}

/* Directions of every node, in the order of `value`. */
static void directions(const struct um_model_map *map, struct um_vec3 *sun,
                       struct um_vec3 *observer)
{
  size_t n = 0;
  for (size_t g = 0; g < map->nphase; g++)
    for (size_t k = 0; k < map->nplane[g]; k++)
      for (size_t i = 0; i < map->nlatitude; i++)
        for (size_t j = 0; j < map->nlongitude; j++, n++) {
          struct um_model_phase_vector at = um_model_map_place(map, g, k, i, j);
          um_model_phase_directions(&at, &sun[n], &observer[n]);
        }
}

enum um_status um_model_map_create(struct um_context *context, const struct um_model *model,
                                   const struct um_model_map_grid *grid, struct um_model_map **out)
{
  enum um_status status;
  struct um_model_map *map = NULL;
  struct um_vec3 *sun = NULL, *observer = NULL;
  *out = NULL;
  UM_TRY(check(context, grid));
  UM_CHECK(um_model_map_allocate(context, grid, UM_PI, model->nband, &map));
  size_t n = map->nnode;
  UM_CHECK(um_core_allocate(context, n, sizeof *sun, &sun));
  UM_CHECK(um_core_allocate(context, n, sizeof *observer, &observer));
  directions(map, sun, observer);
  UM_CHECK(um_model_reflectivity(context, model, "mapping reflectivity", sun, observer, n,
                                 map->value, map->error));
  if (grid->tolerance > 0.0) UM_CHECK(um_model_map_refine(context, model, map));
  *out = map;
  map = NULL;
done:
  UM_FREE(context, sun, observer);
  um_model_map_destroy(context, &map);
  return status;
}

void um_model_map_destroy(struct um_context *context, struct um_model_map **map)
{
  if (map == NULL || *map == NULL) return;
  UM_FREE(context, (*map)->phase_angle, (*map)->nplane, (*map)->first, (*map)->value, (*map)->error,
          (*map)->added, (*map)->cell, (*map)->floor, *map);
  *map = NULL;
}

struct um_model_map_node um_model_map_node(const struct um_model_map *map, size_t phase,
                                           size_t latitude, size_t longitude, size_t band)
{
  struct um_model_map_node out = {0.0, 0.0, 0.0};
  double n = (double)map->nplane[phase], squares = 0.0;
  for (size_t k = 0; k < map->nplane[phase]; k++) {
    size_t at = node_at(map, map->first[phase] + k, latitude, longitude) + band;
    out.mean += map->value[at] / n;
    out.error += map->error[at] / n;
  }
  for (size_t k = 0; k < map->nplane[phase]; k++) {
    double d =
        map->value[node_at(map, map->first[phase] + k, latitude, longitude) + band] - out.mean;
    squares += d * d;
  }
  out.spread = sqrt(squares / n);
  return out;
}

/* Add `weight` times the value of one phase angle at a node, linear in the plane angle, which is
 * counted from the north of the node's own meridian: a direction across p that stands at `plane` on
 * one meridian stands at plane + d sin(latitude) on the one d to the east. */
static void add_node(const struct um_model_map *map, size_t phase, size_t i, size_t j, double plane,
                     double weight, double *out)
{
  size_t n = map->nplane[phase], low;
  double turn = plane / map->turn, share;
  turn = (turn - floor(turn)) * (double)n;
  low = (size_t)turn;
  share = turn - (double)low;
  low %= n;
  const double *a = map->value + node_at(map, map->first[phase] + low, i, j);
  const double *b = map->value + node_at(map, map->first[phase] + (low + 1) % n, i, j);
  for (size_t k = 0; k < map->nband; k++) out[k] += weight * ((1.0 - share) * a[k] + share * b[k]);
}

/* A cell that a refined map has, in the two planes about a place; true: it was added. Within it the
 * plane counts from the place's own meridian: refined cells are small. */
static bool add_refined(const struct um_model_map *map, size_t phase, size_t i, size_t j,
                        const struct um_model_phase_vector *at, const double f[2], double weight,
                        double *out)
{
  size_t n = map->nplane[phase], low;
  double turn = at->plane / map->turn;
  if (map->cell == NULL) return false;
  turn = (turn - floor(turn)) * (double)n;
  low = (size_t)turn % n;
  double share = turn - floor(turn);
  const struct um_model_map_cell *a = um_model_map_cell_of(map, map->first[phase] + low, i, j);
  const struct um_model_map_cell *b =
      um_model_map_cell_of(map, map->first[phase] + (low + 1) % n, i, j);
  if (a->half == 0 && b->half == 0 && !a->logarithmic && !b->logarithmic) return false;
  um_model_map_cell_add(map, phase, a, f, weight * (1.0 - share), out);
  um_model_map_cell_add(map, phase, b, f, weight * share, out);
  return true;
}

/* The four nodes about a place, at one phase angle. */
static void add_phase(const struct um_model_map *map, size_t phase,
                      const struct um_model_phase_vector *at, double weight, double *out)
{
  double y = (at->latitude + 0.5 * UM_PI) / map->step, x = (at->longitude + UM_PI) / map->step;
  size_t i = (size_t)fmin(fmax(floor(y), 0.0), (double)map->nlatitude - 2.0);
  double fy = fmin(fmax(y - (double)i, 0.0), 1.0), column = floor(x), fx = x - column;
  size_t j = (size_t)(column + 4.0 * (double)map->nlongitude) % map->nlongitude;
  if (add_refined(map, phase, i, j, at, (const double[2]){fy, fx}, weight, out)) return;
  for (size_t d = 0; d < 4; d++) {
    size_t north = d / 2, east = d % 2;
    double w = weight * (north ? fy : 1.0 - fy) * (east ? fx : 1.0 - fx);
    double away = ((double)east - fx) * map->step;
    if (w == 0.0) continue;
    add_node(map, phase, i + north, (j + east) % map->nlongitude,
             at->plane + away * sin(at->latitude), w, out);
  }
}

void um_model_map_look_up(const struct um_model_map *map, const struct um_model_phase_vector *at,
                          double *out)
{
  memset(out, 0, map->nband * sizeof *out);
  if (isnan(at->latitude)) {
    for (size_t k = 0; k < map->nband; k++) out[k] = NAN;
    return;
  }
  const double *g = map->phase_angle;
  size_t n = map->nphase;
  if (n == 1 || at->phase_angle <= g[0]) {
    add_phase(map, 0, at, 1.0, out);
  } else if (at->phase_angle >= g[n - 1]) {
    add_phase(map, n - 1, at, 1.0, out);
  } else {
    size_t low = um_core_interval_find(g, n, at->phase_angle);
    double share = (at->phase_angle - g[low]) / (g[low + 1] - g[low]);
    add_phase(map, low, at, 1.0 - share, out);
    add_phase(map, low + 1, at, share, out);
  }
}
