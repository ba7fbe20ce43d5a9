/* Surfaces that share a normal, found by a table of hashes. */
#include "thermal/loads/normals_impl.h"

#include <math.h>

#define DIGITS 1e12 /* normals that round to the same here are one */

struct key {
  int64_t x, y, z;
  uint32_t part;
};

static struct key key_of(const struct um_geometry_mesh *mesh, const struct um_geometry_pose *pose,
                         size_t surface)
{
  struct um_vec3 n = um_geometry_surface_normal(mesh, pose, surface);
  return (struct key){llround(n.x * DIGITS), llround(n.y * DIGITS), llround(n.z * DIGITS),
                      mesh->surface[surface].part};
}

static uint64_t hash_of(struct key k)
{
  uint64_t hash = k.part;
  const int64_t along[3] = {k.x, k.y, k.z};
  for (int c = 0; c < 3; c++) hash = (hash ^ (uint64_t)along[c]) * 0x9e3779b97f4a7c15u;
  return hash >> 20;
}

/* slot: open-addressing table of classes [nslot], empty. */
static void classify(const struct um_geometry_mesh *mesh, const struct um_geometry_pose *pose,
                     uint32_t *slot, size_t nslot, struct um_irradiation_normals *out)
{
  for (size_t s = 0; s < mesh->nsurface; s++) {
    struct key own = key_of(mesh, pose, s);
    for (size_t i = hash_of(own) & (nslot - 1);; i = (i + 1) & (nslot - 1)) {
      if (slot[i] == UINT32_MAX) {
        slot[i] = (uint32_t)out->n;
        out->example[out->n++] = (uint32_t)s;
      }
      struct key k = key_of(mesh, pose, out->example[slot[i]]);
      out->of[s] = slot[i];
      if (k.part == own.part && k.x == own.x && k.y == own.y && k.z == own.z) break;
    }
  }
}

/* Surfaces by class. */
static enum um_status sort(struct um_context *context, size_t nsurface,
                           struct um_irradiation_normals *out)
{
  size_t *next = NULL;
  UM_TRY(um_core_allocate(context, out->n + 1, sizeof *out->begin, &out->begin));
  UM_TRY(um_core_allocate(context, out->n, sizeof *next, &next));
  for (size_t s = 0; s < nsurface; s++) out->begin[out->of[s] + 1]++;
  for (size_t i = 0; i < out->n; i++) {
    next[i] = out->begin[i];
    out->begin[i + 1] += out->begin[i];
  }
  for (size_t s = 0; s < nsurface; s++) out->order[next[out->of[s]]++] = (uint32_t)s;
  um_core_free(context, next);
  return UM_OK;
}

enum um_status um_irradiation_normals_find(struct um_context *context,
                                           const struct um_geometry_mesh *mesh,
                                           const struct um_geometry_pose *pose,
                                           struct um_irradiation_normals *out)
{
  size_t nsurface = mesh->nsurface, nslot = 16;
  uint32_t *slot = NULL;
  *out = (struct um_irradiation_normals){0};
  while (nslot < 2 * nsurface) nslot *= 2;
  UM_TRY(um_core_allocate(context, nsurface, sizeof *out->of, &out->of));
  UM_TRY(um_core_allocate(context, nsurface, sizeof *out->example, &out->example));
  UM_TRY(um_core_allocate(context, nsurface, sizeof *out->order, &out->order));
  UM_TRY(um_core_allocate(context, nslot, sizeof *slot, &slot));
  for (size_t i = 0; i < nslot; i++) slot[i] = UINT32_MAX;
  classify(mesh, pose, slot, nslot, out);
  um_core_free(context, slot);
  return sort(context, nsurface, out);
}

void um_irradiation_normals_clear(struct um_context *context,
                                  struct um_irradiation_normals *normals)
{
  UM_FREE(context, normals->of, normals->example, normals->order, normals->begin);
  *normals = (struct um_irradiation_normals){0};
}
