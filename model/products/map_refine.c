/* Cells of a map are halved where what lies between their nodes is not what interpolation says. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "model/products/map_cells_impl.h"
#include "model/products/map_normals_impl.h"
#include "model/products/phase_vector.h"
#include "model/products/reflectivity.h"

#define SMALLEST (0.1 * UM_DEG) /* side of a cell */
#define GROWS    8              /* nodes in all over those of the grid, at most */
#define FREE_KEY UINT64_MAX
#define CORNERS  4
#define LEAST    4096 /* keys */

/* A cell that is looked at; its place in units of the finest grid. */
struct candidate {
  uint32_t cell, phase, plane;
  uint32_t south, west, high, wide;
};

struct work {
  const struct um_model *model;
  struct um_model_map *map;
  size_t unit;            /* of a step */
  size_t grid;            /* nodes of it */
  size_t known;           /* nodes that have values */
  size_t room, cell_room; /* nodes and cells that there is memory for */
  uint64_t *key;          /* [capacity] of added nodes, open addressing */
  uint32_t *node;         /* [capacity] */
  size_t capacity;        /* a power of two */
  struct um_model_map_normals normals;
  double *mean; /* [nphase][nband] of middles, which no node on a glint spoils */
};

/* ---- nodes ---- */

static uint64_t key_of(const struct work *w, const struct candidate *c, size_t latitude,
                       size_t longitude)
{
  size_t rows = (w->map->nlatitude - 1) * w->unit + 1, columns = w->map->nlongitude * w->unit;
  uint64_t plane = w->map->first[c->phase] + c->plane;
  return (plane * rows + latitude) * columns + longitude % columns;
}

static size_t slot_of(const struct work *w, uint64_t key)
{
  size_t at = (size_t)um_core_hash(key, 0) & (w->capacity - 1);
  while (w->key[at] != FREE_KEY && w->key[at] != key) at = (at + 1) & (w->capacity - 1);
  return at;
}

static enum um_status make_keys(struct um_context *context, struct work *w, size_t capacity)
{
  struct work old = *w;
  w->key = NULL;
  w->node = NULL;
  w->capacity = capacity;
  enum um_status status = um_core_allocate(context, capacity, sizeof *w->key, &w->key);
  if (status == UM_OK) status = um_core_allocate(context, capacity, sizeof *w->node, &w->node);
  for (size_t i = 0; i < capacity && status == UM_OK; i++) w->key[i] = FREE_KEY;
  for (size_t i = 0; i < old.capacity && status == UM_OK; i++)
    if (old.key[i] != FREE_KEY) {
      size_t at = slot_of(w, old.key[i]);
      w->key[at] = old.key[i];
      w->node[at] = old.node[i];
    }
  UM_FREE(context, old.key, old.node);
  return status;
}

static enum um_status make_room(struct um_context *context, struct work *w)
{
  struct um_model_map *map = w->map;
  if (2 * (map->nnode - w->grid) >= w->capacity) UM_TRY(make_keys(context, w, 2 * w->capacity));
  if (map->nnode < w->room) return UM_OK;
  size_t room = w->room + w->room / 2 + LEAST;
  UM_TRY(um_core_reallocate(context, room * map->nband, sizeof *map->value, &map->value));
  UM_TRY(um_core_reallocate(context, room * map->nband, sizeof *map->error, &map->error));
  UM_TRY(um_core_reallocate(context, room - w->grid, sizeof *map->added, &map->added));
  w->room = room;
  return UM_OK;
}

/* The node at a place of a candidate's plane, in units from the south pole and from longitude
 * -180; it is added where it is new, without a value. */
static enum um_status node_at(struct um_context *context, struct work *w, const struct candidate *c,
                              size_t latitude, size_t longitude, uint32_t *out)
{
  struct um_model_map *map = w->map;
  size_t columns = map->nlongitude * w->unit, plane = map->first[c->phase] + c->plane;
  longitude %= columns;
  if (latitude % w->unit == 0 && longitude % w->unit == 0) {
    *out = (uint32_t)((plane * map->nlatitude + latitude / w->unit) * map->nlongitude +
                      longitude / w->unit);
    return UM_OK;
  }
  UM_TRY(make_room(context, w));
  uint64_t key = key_of(w, c, latitude, longitude);
  size_t at = slot_of(w, key);
  if (w->key[at] == FREE_KEY) {
    double one = map->step / (double)w->unit;
    map->added[map->nnode - w->grid] =
        (struct um_model_map_added){-0.5 * UM_PI + (double)latitude * one,
                                    -UM_PI + (double)longitude * one, c->phase, c->plane};
    w->key[at] = key;
    w->node[at] = (uint32_t)map->nnode++;
  }
  *out = w->node[at];
  return UM_OK;
}

/* Values of the nodes that have none. */
static enum um_status evaluate(struct um_context *context, struct work *w)
{
  enum um_status status;
  struct um_model_map *map = w->map;
  struct um_vec3 *sun = NULL, *observer = NULL;
  size_t n = map->nnode - w->known;
  if (n == 0) return UM_OK;
  UM_CHECK(um_core_allocate(context, n, sizeof *sun, &sun));
  UM_CHECK(um_core_allocate(context, n, sizeof *observer, &observer));
  for (size_t i = 0; i < n; i++) {
    const struct um_model_map_added *a = &map->added[w->known + i - w->grid];
    struct um_model_phase_vector at = {a->latitude, a->longitude, map->phase_angle[a->phase],
                                       map->turn * (double)a->plane /
                                           (double)map->nplane[a->phase]};
    um_model_phase_directions(&at, &sun[i], &observer[i]);
  }
  UM_CHECK(um_model_reflectivity(context, w->model, "refining the map", sun, observer, n,
                                 map->value + w->known * map->nband,
                                 map->error + w->known * map->nband));
  w->known = map->nnode;
done:
  UM_FREE(context, sun, observer);
  return status;
}

/* ---- what is looked at ---- */

/* Points of a cell at which it is tested: its middle, and for every normal no farther from it than
 * half the cell the place in it that is nearest to the normal, and half-way from there to the
 * middle, which finds a lobe about a corner; units from its south-west corner. false: the k-th is
 * none. */
static bool test_point(const struct work *w, const struct candidate *c, size_t k, size_t at[2])
{
  double high = (double)c->high, wide = (double)c->wide;
  at[0] = c->high / 2;
  at[1] = c->wide / 2;
  if (k == 0) return true;
  double one = w->map->step / (double)w->unit, columns = (double)(w->map->nlongitude * w->unit);
  const struct um_model_map_normal *normal = &w->normals.normal[(k - 1) / 2];
  double y = (normal->latitude + 0.5 * UM_PI) / one - (double)c->south;
  if (y < -0.5 * high || y > 1.5 * high) return false;
  double middle = (double)c->west + 0.5 * wide;
  double x = remainder((normal->longitude + UM_PI) / one - middle, columns) + 0.5 * wide;
  if (fabs(normal->latitude) > 0.5 * UM_PI - UM_MODEL_MAP_POLE) x = 0.5 * wide;
  if (x < -0.5 * wide || x > 1.5 * wide) return false;
  y = fmin(fmax(y, 0.0), high);
  x = fmin(fmax(x, 0.0), wide);
  at[0] = (size_t)lround(k % 2 == 1 ? y : 0.5 * y + 0.25 * high);
  at[1] = (size_t)lround(k % 2 == 1 ? x : 0.5 * x + 0.25 * wide);
  return true;
}

/* How far interpolation is off at a point, over what is tolerated [1]; the worst band. */
static double off_at(const struct work *w, const struct candidate *c, uint32_t node,
                     const double f[2], bool logarithmic)
{
  const struct um_model_map *map = w->map;
  double worst = 0.0;
  for (size_t b = 0; b < map->nband; b++) {
    double value = map->value[node * map->nband + b], mean = w->mean[c->phase * map->nband + b];
    double found =
        um_model_map_between(map, c->phase, map->cell[c->cell].corner, logarithmic, f, b);
    double tolerated = map->tolerance * fmax(value, mean);
    if (tolerated > 0.0) worst = fmax(worst, fabs(found - value) / tolerated);
  }
  return worst;
}

/* Of a cell by its test points: [0] with the value, [1] with its logarithm. */
static enum um_status off_of(struct um_context *context, struct work *w, const struct candidate *c,
                             double off[2])
{
  size_t at[2];
  off[0] = off[1] = 0.0;
  for (size_t k = 0; k <= 2 * w->normals.n; k++) {
    if (!test_point(w, c, k, at)) continue;
    uint32_t node;
    double f[2] = {(double)at[0] / (double)c->high, (double)at[1] / (double)c->wide};
    UM_TRY(node_at(context, w, c, c->south + at[0], c->west + at[1], &node));
    for (int mode = 0; mode < 2; mode++) off[mode] = fmax(off[mode], off_at(w, c, node, f, mode));
  }
  return UM_OK;
}

static enum um_status ask_tests(struct um_context *context, struct work *w,
                                const struct candidate *c, size_t n)
{
  size_t at[2];
  uint32_t node;
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k <= 2 * w->normals.n; k++)
      if (test_point(w, &c[i], k, at))
        UM_TRY(node_at(context, w, &c[i], c[i].south + at[0], c[i].west + at[1], &node));
  return evaluate(context, w);
}

/* Means of the phase angles by the middles of the grid's cells, and floors of their logarithms. */
static enum um_status find_means(struct um_context *context, struct work *w,
                                 const struct candidate *c, size_t n)
{
  struct um_model_map *map = w->map;
  double *weights = NULL;
  UM_TRY(um_core_allocate(context, map->nphase, sizeof *weights, &weights));
  enum um_status status = UM_OK;
  for (size_t i = 0; i < n && status == UM_OK; i++) {
    uint32_t node;
    double latitude = -0.5 * UM_PI + ((double)c[i].south / (double)w->unit + 0.5) * map->step;
    status =
        node_at(context, w, &c[i], c[i].south + c[i].high / 2, c[i].west + c[i].wide / 2, &node);
    weights[c[i].phase] += cos(latitude);
    for (size_t b = 0; b < map->nband && status == UM_OK; b++)
      w->mean[c[i].phase * map->nband + b] += cos(latitude) * map->value[node * map->nband + b];
  }
  for (size_t g = 0; g < map->nphase; g++)
    for (size_t b = 0; b < map->nband; b++) {
      double *mean = &w->mean[g * map->nband + b];
      *mean /= weights[g];
      map->floor[g * map->nband + b] = map->tolerance * *mean;
    }
  um_core_free(context, weights);
  return status;
}

/* ---- halves ---- */

/* Across its longer side on the sphere; halves keep a middle of their own. false: it is as small as
 * it may be. */
static bool side_of(const struct work *w, const struct candidate *c, bool *along)
{
  double one = w->map->step / (double)w->unit;
  double latitude = -0.5 * UM_PI + ((double)c->south + 0.5 * (double)c->high) * one;
  *along = (double)c->wide * cos(latitude) > (double)c->high;
  if ((*along ? c->wide : c->high) >= 4) return true;
  *along = !*along;
  return (*along ? c->wide * cos(latitude) : c->high) >= 4;
}

static enum um_status split(struct um_context *context, struct work *w, const struct candidate *c,
                            bool along, struct candidate *half)
{
  struct um_model_map *map = w->map;
  uint32_t a, b, first = (uint32_t)map->ncell;
  size_t middle = (along ? c->wide : c->high) / 2;
  if (map->ncell + 2 > w->cell_room) {
    size_t room = w->cell_room + w->cell_room / 2 + 2;
    UM_TRY(um_core_reallocate(context, room, sizeof *map->cell, &map->cell));
    w->cell_room = room;
  }
  if (along) {
    UM_TRY(node_at(context, w, c, c->south, c->west + middle, &a));
    UM_TRY(node_at(context, w, c, c->south + c->high, c->west + middle, &b));
  } else {
    UM_TRY(node_at(context, w, c, c->south + middle, c->west, &a));
    UM_TRY(node_at(context, w, c, c->south + middle, c->west + c->wide, &b));
  }
  struct um_model_map_cell *whole = &map->cell[c->cell], *one = &map->cell[first], *two = one + 1;
  *one = *two = (struct um_model_map_cell){{0}, 0, false, false};
  memcpy(one->corner, whole->corner, sizeof whole->corner);
  memcpy(two->corner, whole->corner, sizeof whole->corner);
  one->corner[along ? 1 : 2] = two->corner[0] = a;
  one->corner[3] = two->corner[along ? 2 : 1] = b;
  whole->half = first;
  whole->along = along;
  map->ncell += 2;
  half[0] = half[1] = *c;
  half[0].cell = first;
  half[1].cell = first + 1;
  if (along) {
    half[0].wide = half[1].wide = c->wide / 2;
    half[1].west += half[0].wide;
  } else {
    half[0].high = half[1].high = c->high / 2;
    half[1].south += half[0].high;
  }
  return UM_OK;
}

/* Settle the cells that are tested and halve the others; next: [2 n]. */
static enum um_status judge(struct um_context *context, struct work *w, const struct candidate *c,
                            size_t n, struct candidate *next, size_t *count)
{
  struct um_model_map *map = w->map;
  *count = 0;
  for (size_t i = 0; i < n; i++) {
    double off[2];
    bool along;
    UM_TRY(off_of(context, w, &c[i], off));
    map->cell[c[i].cell].logarithmic = off[0] > 1.0 && off[1] < off[0];
    if (fmin(off[0], off[1]) <= 1.0) continue;
    if (!side_of(w, &c[i], &along) || w->known >= GROWS * w->grid) {
      map->unfinished++;
      continue;
    }
    UM_TRY(split(context, w, &c[i], along, next + *count));
    *count += 2;
  }
  return evaluate(context, w);
}

/* Cells of the grid. */
static enum um_status begin(struct um_context *context, struct work *w, struct candidate **out,
                            size_t *count)
{
  struct um_model_map *map = w->map;
  size_t n = map->planes * (map->nlatitude - 1) * map->nlongitude, i = 0;
  uint32_t unit = (uint32_t)w->unit;
  UM_TRY(um_core_allocate(context, n, sizeof *map->cell, &map->cell));
  UM_TRY(um_core_allocate(context, n, sizeof **out, out));
  for (uint32_t g = 0; g < map->nphase; g++)
    for (uint32_t k = 0; k < map->nplane[g]; k++)
      for (uint32_t y = 0; y + 1 < map->nlatitude; y++)
        for (uint32_t x = 0; x < map->nlongitude; x++, i++) {
          struct candidate c = {(uint32_t)i, g, k, y * unit, x * unit, unit, unit};
          (*out)[i] = c;
          for (size_t q = 0; q < CORNERS; q++)
            UM_TRY(node_at(context, w, &c, c.south + q / 2 * unit, c.west + q % 2 * unit,
                           &map->cell[i].corner[q]));
        }
  map->ncell = w->cell_room = *count = n;
  return UM_OK;
}

enum um_status um_model_map_refine(struct um_context *context, const struct um_model *model,
                                   struct um_model_map *map)
{
  enum um_status status;
  struct work w = {.model = model,
                   .map = map,
                   .unit = 4,
                   .grid = map->nnode,
                   .known = map->nnode,
                   .room = map->nnode};
  struct candidate *now = NULL, *next = NULL;
  size_t n = 0, more = 0;
  while (map->step / (double)w.unit > 0.5 * SMALLEST) w.unit *= 2;
  UM_CHECK(make_keys(context, &w, LEAST));
  UM_CHECK(um_model_map_normals_find(context, model, &w.normals));
  UM_CHECK(um_core_allocate(context, map->nphase * map->nband, sizeof *w.mean, &w.mean));
  UM_CHECK(um_core_allocate(context, map->nphase * map->nband, sizeof *map->floor, &map->floor));
  UM_CHECK(begin(context, &w, &now, &n));
  for (int round = 0; n > 0; round++) {
    UM_CHECK(ask_tests(context, &w, now, n));
    if (round == 0) UM_CHECK(find_means(context, &w, now, n));
    UM_CHECK(um_core_allocate(context, 2 * n, sizeof *next, &next));
    UM_CHECK(judge(context, &w, now, n, next, &more));
    um_core_free(context, now);
    now = next;
    next = NULL;
    n = more;
  }
done:
  UM_FREE(context, now, next, w.key, w.node, w.mean, w.normals.normal);
  return status;
}
