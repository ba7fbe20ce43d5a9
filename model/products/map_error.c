/* Looking up at places that are no nodes, beside the renderer. */
#include "model/products/map_error.h"

#include <math.h>

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "model/products/map_normals_impl.h"
#include "model/products/reflectivity.h"

#define PLACES 800 /* of each kind */
#define ABOUT  (5.0 * UM_DEG)

const char *um_model_map_where_name(enum um_model_map_where where)
{
  static const char *const name[UM_MAP_WHERES] = {"everywhere", "at_normals"};
  return name[where];
}

void um_model_map_error_destroy(struct um_context *context, struct um_model_map_error **error)
{
  if (error == NULL || *error == NULL) return;
  UM_FREE(context, (*error)->off, *error);
  *error = NULL;
}

/* A direction within ABOUT of the normal that stands at a share of all area. */
static struct um_vec3 about(const struct um_model_map_normals *normals, double share,
                            const double u[2])
{
  double all = 0.0, sum = 0.0, xy[2];
  struct um_vec3 across[2];
  size_t i = 0;
  for (size_t k = 0; k < normals->n; k++) all += normals->normal[k].area;
  while (i + 1 < normals->n && (sum += normals->normal[i].area) < share * all) i++;
  um_core_sample_disc(u, xy);
  um_core_vec3_frame(normals->normal[i].unit, &across[0], &across[1]);
  struct um_vec3 p = um_vec3_axpy(normals->normal[i].unit, tan(ABOUT) * xy[0], across[0]);
  return um_vec3_unit(um_vec3_axpy(p, tan(ABOUT) * xy[1], across[1]));
}

static struct um_model_phase_vector place(const struct um_model_map *map,
                                          const struct um_model_map_normals *normals,
                                          enum um_model_map_where where, size_t i)
{
  double u[2], v[2], least = map->phase_angle[0], most = map->phase_angle[map->nphase - 1];
  um_core_sample_2d(1 + 2 * (uint64_t)where, i, u);
  um_core_sample_2d(2 + 2 * (uint64_t)where, i, v);
  double z = 2.0 * u[0] - 1.0, across = sqrt(1.0 - z * z), turn = 2.0 * UM_PI * u[1];
  struct um_vec3 p = um_vec3(across * cos(turn), across * sin(turn), z);
  double share = um_core_hash_uniform(um_core_hash(i, 3));
  if (where == UM_MAP_AT_NORMALS) p = about(normals, share, u);
  return (struct um_model_phase_vector){atan2(p.z, hypot(p.x, p.y)), atan2(p.y, p.x),
                                        least + (most - least) * v[0], 2.0 * UM_PI * v[1]};
}

static void add(const struct um_model_phase_vector *at, double computed, double found,
                struct um_model_map_off *off)
{
  double d = found - computed;
  off->mean += computed;
  off->rms += d * d;
  if (!(fabs(d) > off->largest)) return;
  off->largest = fabs(d);
  off->at = *at;
}

static enum um_status measure(struct um_context *context, const struct um_model *model,
                              const struct um_model_map *map, const struct um_model_map_normals *by,
                              enum um_model_map_where where, struct um_model_map_off *off)
{
  enum um_status status;
  struct um_vec3 *sun = NULL, *observer = NULL;
  double *computed = NULL, *found = NULL;
  UM_CHECK(um_core_allocate(context, PLACES, sizeof *sun, &sun));
  UM_CHECK(um_core_allocate(context, PLACES, sizeof *observer, &observer));
  UM_CHECK(um_core_allocate(context, PLACES * map->nband, sizeof *computed, &computed));
  UM_CHECK(um_core_allocate(context, map->nband, sizeof *found, &found));
  for (size_t i = 0; i < PLACES; i++) {
    struct um_model_phase_vector at = place(map, by, where, i);
    um_model_phase_directions(&at, &sun[i], &observer[i]);
  }
  UM_CHECK(um_model_reflectivity(context, model, "the map's own error", sun, observer, PLACES,
                                 computed, NULL));
  for (size_t i = 0; i < PLACES; i++) {
    struct um_model_phase_vector at = place(map, by, where, i);
    um_model_map_look_up(map, &at, found);
    for (size_t b = 0; b < map->nband; b++)
      add(&at, computed[i * map->nband + b], found[b], &off[b]);
  }
  for (size_t b = 0; b < map->nband; b++) {
    off[b].mean /= PLACES;
    off[b].rms = sqrt(off[b].rms / PLACES);
  }
done:
  UM_FREE(context, sun, observer, computed, found);
  return status;
}

enum um_status um_model_map_error_measure(struct um_context *context, const struct um_model *model,
                                          const struct um_model_map *map,
                                          struct um_model_map_error **out)
{
  enum um_status status;
  struct um_model_map_error *error = NULL;
  struct um_model_map_normals normals = {0};
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *error, &error));
  UM_CHECK(um_core_allocate(context, UM_MAP_WHERES * map->nband, sizeof *error->off, &error->off));
  UM_CHECK(um_model_map_normals_find(context, model, &normals));
  for (int where = 0; where < UM_MAP_WHERES; where++) {
    if (where == UM_MAP_AT_NORMALS && normals.n == 0) continue;
    error->n[where] = PLACES;
    UM_CHECK(measure(context, model, map, &normals, (enum um_model_map_where)where,
                     error->off + (size_t)where * map->nband));
  }
  *out = error;
  error = NULL;
done:
  um_core_free(context, normals.normal);
  um_model_map_error_destroy(context, &error);
  return status;
}
