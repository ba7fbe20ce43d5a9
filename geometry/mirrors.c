/* Rays from mirror to mirror, and what they met. */
#include "geometry/mirrors.h"

#include <math.h>
#include <string.h>

#include "base/core/sampling.h"

enum um_status um_geometry_mirrors_create(struct um_context *context, size_t nsurface,
                                          struct um_geometry_mirrors **out)
{
  enum um_status status;
  struct um_geometry_mirrors *mirrors = NULL;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *mirrors, &mirrors));
  mirrors->nsurface = nsurface;
  UM_CHECK(um_core_allocate(context, nsurface, sizeof *mirrors->of, &mirrors->of));
  if (nsurface > 0) memset(mirrors->of, 0xff, nsurface * sizeof *mirrors->of);
  *out = mirrors;
  mirrors = NULL;
done:
  um_geometry_mirrors_destroy(context, &mirrors);
  return status;
}

void um_geometry_mirrors_destroy(struct um_context *context, struct um_geometry_mirrors **mirrors)
{
  if (mirrors == NULL || *mirrors == NULL) return;
  UM_FREE(context, (*mirrors)->of, *mirrors);
  *mirrors = NULL;
}

uint16_t um_geometry_mirrors_patch(const struct um_geometry_mirrors *mirrors,
                                   const struct um_geometry_patches *patches, size_t p)
{
  if (mirrors == NULL || patches->begin[p] == patches->begin[p + 1]) return UM_GEOMETRY_NO_MIRROR;
  uint32_t s = patches->surface[patches->begin[p]];
  return s < mirrors->nsurface ? mirrors->of[s] : UM_GEOMETRY_NO_MIRROR;
}

bool um_geometry_mirror_set_add(struct um_geometry_mirror_set *set, uint16_t mirror)
{
  if (set->n == UM_GEOMETRY_MIRRORS_DEEPEST) return false;
  uint16_t at = set->n++;
  for (; at > 0 && set->mirror[at - 1] > mirror; at--) set->mirror[at] = set->mirror[at - 1];
  set->mirror[at] = mirror;
  return true;
}

double um_geometry_mirror_set_weight(const struct um_geometry_mirror_set *set,
                                     const double *reflectance)
{
  double weight = 1.0;
  for (uint16_t k = 0; k < set->n; k++) weight *= reflectance[set->mirror[k]];
  return weight;
}

static uint64_t hash_of(const struct um_geometry_mirror_set *set)
{
  uint64_t hash = set->n;
  for (uint16_t k = 0; k < set->n; k++) hash = um_core_hash(hash, set->mirror[k]);
  return hash;
}

/* Slot of a set, or the free one that is its place. */
static size_t slot_of(const struct um_geometry_mirror_sets *sets,
                      const struct um_geometry_mirror_set *set)
{
  size_t i = hash_of(set) & (sets->nslot - 1);
  while (sets->slot[i] != UINT32_MAX && memcmp(&sets->set[sets->slot[i]], set, sizeof *set) != 0)
    i = (i + 1) & (sets->nslot - 1);
  return i;
}

static enum um_status grow(struct um_context *context, struct um_geometry_mirror_sets *sets)
{
  size_t room = sets->room == 0 ? 64 : 2 * sets->room, nslot = 4 * room;
  UM_TRY(um_core_reallocate(context, room, sizeof *sets->set, &sets->set));
  sets->room = room;
  UM_TRY(um_core_reallocate(context, nslot, sizeof *sets->slot, &sets->slot));
  sets->nslot = nslot;
  memset(sets->slot, 0xff, nslot * sizeof *sets->slot);
  for (size_t k = 0; k < sets->n; k++) sets->slot[slot_of(sets, &sets->set[k])] = (uint32_t)k;
  return UM_OK;
}

enum um_status um_geometry_mirror_sets_find(struct um_context *context,
                                            struct um_geometry_mirror_sets *sets,
                                            const struct um_geometry_mirror_set *set, uint32_t *out)
{
  if (sets->n == sets->room) UM_TRY(grow(context, sets));
  size_t slot = slot_of(sets, set);
  if (sets->slot[slot] == UINT32_MAX) {
    sets->slot[slot] = (uint32_t)sets->n;
    sets->set[sets->n++] = *set;
  }
  *out = sets->slot[slot];
  return UM_OK;
}

void um_geometry_mirror_sets_clear(struct um_context *context, struct um_geometry_mirror_sets *sets)
{
  UM_FREE(context, sets->set, sets->slot);
  *sets = (struct um_geometry_mirror_sets){0};
}

static struct um_vec3 point_of(const struct um_geometry_mesh *mesh,
                               const struct um_geometry_pose *pose,
                               const struct um_geometry_hit *hit)
{
  const uint32_t *c = mesh->corner[hit->facet];
  struct um_vec3 a = pose->vertex[c[0]];
  struct um_vec3 ab = um_vec3_sub(pose->vertex[c[1]], a), ac = um_vec3_sub(pose->vertex[c[2]], a);
  return um_vec3_axpy(um_vec3_axpy(a, hit->weight[1], ab), hit->weight[2], ac);
}

size_t um_geometry_mirrored_turn(const struct um_geometry_mesh *mesh,
                                 const struct um_geometry_pose *pose,
                                 const struct um_geometry_mirrors *mirrors,
                                 struct um_geometry_ray *ray,
                                 struct um_geometry_mirrored_path *path,
                                 const struct um_geometry_hit *hit, size_t n)
{
  size_t left = 0;
  for (size_t k = 0; k < n; k++) {
    if (hit[k].facet == UM_GEOMETRY_NONE || hit[k].surface == UM_GEOMETRY_NONE) continue;
    uint16_t mirror = mirrors->of[hit[k].surface];
    struct um_geometry_mirrored_path own = path[k];
    if (mirror == UM_GEOMETRY_NO_MIRROR || !um_geometry_mirror_set_add(&own.met, mirror)) continue;
    struct um_vec3 normal = um_geometry_surface_normal(mesh, pose, hit[k].surface);
    struct um_vec3 d = ray[k].direction;
    d = um_vec3_unit(um_vec3_axpy(d, -2.0 * um_vec3_dot(d, normal), normal));
    ray[left] = (struct um_geometry_ray){point_of(mesh, pose, &hit[k]), d, INFINITY, hit[k].facet};
    path[left++] = own;
  }
  return left;
}
