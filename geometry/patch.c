/* The mesh of one part while it is being made: growing arrays, welding, degenerate facets. */
#include "geometry/patch_impl.h"

#include <string.h>

#include "base/core/digest.h"
#include "geometry/geometry_impl.h"

void um_geometry_patch_begin(struct um_geometry_patch *patch, struct um_context *context,
                             const char *source)
{
  memset(patch, 0, sizeof *patch);
  patch->context = context;
  patch->source = source;
}

void um_geometry_patch_end(struct um_geometry_patch *patch)
{
  if (patch->context == NULL) return;
  UM_FREE(patch->context, patch->vertex, patch->corner, patch->group, patch->line, patch->root);
  for (size_t i = 0; i < patch->ngroup; i++) um_core_free(patch->context, patch->group_name[i]);
  UM_FREE(patch->context, patch->group_name, patch->group_slot);
  memset(patch, 0, sizeof *patch);
}

enum um_status um_geometry_patch_vertex(struct um_geometry_patch *patch, struct um_vec3 v,
                                        uint32_t *index)
{
  if (patch->nvertex >= UM_GEOMETRY_MAX_FACETS)
    return um_core_fail(patch->context, UM_ERR_INPUT, "%s: more than %zu vertices", patch->source,
                        UM_GEOMETRY_MAX_FACETS);
  if (patch->nvertex == patch->vertex_capacity) {
    size_t capacity = 2 * patch->vertex_capacity + 64;
    UM_TRY(um_core_reallocate(patch->context, capacity, sizeof *patch->vertex,
                              (void *)&patch->vertex));
    patch->vertex_capacity = capacity;
  }
  if (index != NULL) *index = (uint32_t)patch->nvertex;
  patch->vertex[patch->nvertex++] = v;
  return UM_OK;
}

enum um_status um_geometry_patch_facet(struct um_geometry_patch *patch, uint32_t a, uint32_t b,
                                       uint32_t c, uint32_t group, int line)
{
  if (patch->nfacet >= UM_GEOMETRY_MAX_FACETS)
    return um_core_fail(patch->context, UM_ERR_INPUT, "%s: more than %zu facets", patch->source,
                        UM_GEOMETRY_MAX_FACETS);
  if (patch->nfacet == patch->facet_capacity) {
    size_t n = 2 * patch->facet_capacity + 64;
    struct um_context *context = patch->context;
    UM_TRY(um_core_reallocate(context, n, sizeof *patch->corner, (void *)&patch->corner));
    UM_TRY(um_core_reallocate(context, n, sizeof *patch->group, (void *)&patch->group));
    UM_TRY(um_core_reallocate(context, n, sizeof *patch->line, (void *)&patch->line));
    UM_TRY(um_core_reallocate(context, n, sizeof *patch->root, (void *)&patch->root));
    patch->facet_capacity = n;
  }
  size_t i = patch->nfacet++;
  patch->corner[i][0] = a;
  patch->corner[i][1] = b;
  patch->corner[i][2] = c;
  patch->group[i] = group;
  patch->line[i] = line;
  patch->root[i] = (uint32_t)i;
  return UM_OK;
}

/* Slot of a name, or the free one where it would stand: linear probing. */
static size_t group_slot(const struct um_geometry_patch *patch, const char *name)
{
  uint64_t h = um_core_digest(UM_CORE_DIGEST_BEGIN, name, strlen(name));
  size_t slot = (size_t)(h ^ (h >> 29)) & (patch->group_slots - 1);
  while (patch->group_slot[slot] != UM_GEOMETRY_NONE &&
         strcmp(patch->group_name[patch->group_slot[slot]], name) != 0)
    slot = (slot + 1) & (patch->group_slots - 1);
  return slot;
}

static void group_slots_fill(struct um_geometry_patch *patch)
{
  memset(patch->group_slot, 0xff, patch->group_slots * sizeof *patch->group_slot);
  for (size_t i = 0; i < patch->ngroup; i++)
    patch->group_slot[group_slot(patch, patch->group_name[i])] = (uint32_t)i;
}

static enum um_status groups_grow(struct um_geometry_patch *patch)
{
  size_t capacity = 2 * patch->group_capacity + 8, slots = 16;
  while (slots < 2 * capacity) slots *= 2;
  UM_TRY(um_core_reallocate(patch->context, capacity, sizeof *patch->group_name,
                            (void *)&patch->group_name));
  UM_TRY(um_core_reallocate(patch->context, slots, sizeof *patch->group_slot,
                            (void *)&patch->group_slot));
  patch->group_capacity = capacity;
  patch->group_slots = slots;
  group_slots_fill(patch);
  return UM_OK;
}

uint32_t um_geometry_patch_group_find(const struct um_geometry_patch *patch, const char *name)
{
  return patch->group_slots == 0 ? UM_GEOMETRY_NONE : patch->group_slot[group_slot(patch, name)];
}

enum um_status um_geometry_patch_group(struct um_geometry_patch *patch, const char *name,
                                       uint32_t *group)
{
  if (patch->ngroup == patch->group_capacity) UM_TRY(groups_grow(patch));
  size_t slot = group_slot(patch, name);
  if (patch->group_slot[slot] == UM_GEOMETRY_NONE) {
    if (patch->ngroup >= UM_GEOMETRY_MAX_GROUPS)
      return um_core_fail(
          patch->context, UM_ERR_INPUT,
          "%s: more than %d groups, '%.80s' is one too many; accepted: at most that "
          "many",
          patch->source, UM_GEOMETRY_MAX_GROUPS, name);
    UM_TRY(um_core_strdup(patch->context, name, &patch->group_name[patch->ngroup]));
    patch->group_slot[slot] = (uint32_t)patch->ngroup++;
  }
  *group = patch->group_slot[slot];
  return UM_OK;
}

static void bounds(const struct um_geometry_patch *patch, struct um_vec3 *low, struct um_vec3 *high)
{
  *low = *high = patch->nvertex > 0 ? patch->vertex[0] : um_vec3(0, 0, 0);
  for (size_t i = 1; i < patch->nvertex; i++) {
    struct um_vec3 v = patch->vertex[i];
    *low = um_vec3(fmin(low->x, v.x), fmin(low->y, v.y), fmin(low->z, v.z));
    *high = um_vec3(fmax(high->x, v.x), fmax(high->y, v.y), fmax(high->z, v.z));
  }
}

/* Hash grid with cells of 1000 tolerances: a point within the tolerance of a cell's wall is looked
 * up on both sides of it. */
struct grid {
  struct um_vec3 low;
  double cell, tolerance; /* [m] */
  uint32_t *head, *next;
  uint64_t mask;
};

static uint64_t cell_slot(const struct grid *grid, const int64_t cell[3])
{
  uint64_t h = (uint64_t)cell[0] * UINT64_C(0x9e3779b97f4a7c15);
  h = (h ^ (h >> 29) ^ (uint64_t)cell[1]) * UINT64_C(0xbf58476d1ce4e5b9);
  h = (h ^ (h >> 32) ^ (uint64_t)cell[2]) * UINT64_C(0x94d049bb133111eb);
  return (h ^ (h >> 31)) & grid->mask;
}

static void cell_of(const struct grid *grid, struct um_vec3 v, double shift, int64_t cell[3])
{
  cell[0] = (int64_t)floor((v.x - grid->low.x + shift) / grid->cell);
  cell[1] = (int64_t)floor((v.y - grid->low.y + shift) / grid->cell);
  cell[2] = (int64_t)floor((v.z - grid->low.z + shift) / grid->cell);
}

/* Lowest earlier vertex within the tolerance of v, or UM_GEOMETRY_NONE. */
static uint32_t find_near(const struct grid *grid, const struct um_vec3 *vertex, struct um_vec3 v)
{
  int64_t low[3], high[3], c[3];
  cell_of(grid, v, -grid->tolerance, low);
  cell_of(grid, v, grid->tolerance, high);
  uint32_t best = UM_GEOMETRY_NONE;
  for (c[0] = low[0]; c[0] <= high[0]; c[0]++)
    for (c[1] = low[1]; c[1] <= high[1]; c[1]++)
      for (c[2] = low[2]; c[2] <= high[2]; c[2]++)
        for (uint32_t i = grid->head[cell_slot(grid, c)]; i != UM_GEOMETRY_NONE; i = grid->next[i])
          if (i < best && um_vec3_norm(um_vec3_sub(vertex[i], v)) <= grid->tolerance) best = i;
  return best;
}

/* same[i]: the vertex that i is merged into (itself when it is the first). */
static enum um_status find_same(const struct um_geometry_patch *patch, uint32_t *same)
{
  enum um_status status;
  struct grid grid = {.head = NULL, .next = NULL};
  struct um_vec3 high;
  bounds(patch, &grid.low, &high);
  grid.tolerance = UM_GEOMETRY_WELD * um_vec3_norm(um_vec3_sub(high, grid.low));
  grid.cell = fmax(1e3 * grid.tolerance, 1e-300);
  size_t slots = 16;
  while (slots < 2 * patch->nvertex) slots *= 2;
  grid.mask = slots - 1;
  UM_CHECK(um_core_allocate(patch->context, slots, sizeof *grid.head, (void *)&grid.head));
  UM_CHECK(um_core_allocate(patch->context, patch->nvertex, sizeof *grid.next, (void *)&grid.next));
  memset(grid.head, 0xff, slots * sizeof *grid.head);
  for (uint32_t i = 0; i < patch->nvertex; i++) {
    if (i % 256 == 0) UM_CHECK(um_core_stop_check(patch->context, "a mesh was welded"));
    uint32_t near = find_near(&grid, patch->vertex, patch->vertex[i]);
    same[i] = near == UM_GEOMETRY_NONE ? i : near;
    if (near != UM_GEOMETRY_NONE) continue;
    int64_t cell[3];
    cell_of(&grid, patch->vertex[i], 0.0, cell);
    uint64_t slot = cell_slot(&grid, cell);
    grid.next[i] = grid.head[slot];
    grid.head[slot] = i;
  }
done:
  UM_FREE(patch->context, grid.head, grid.next);
  return status;
}

/* Renumber groups so that those without facets vanish; their order is kept. */
static enum um_status drop_empty_groups(struct um_geometry_patch *patch)
{
  uint32_t *number;
  UM_TRY(um_core_allocate(patch->context, patch->ngroup, sizeof *number, (void *)&number));
  for (size_t f = 0; f < patch->nfacet; f++) number[patch->group[f]] = 1;
  uint32_t n = 0;
  for (size_t g = 0; g < patch->ngroup; g++) {
    char *name = patch->group_name[g];
    if (number[g] == 0) {
      um_core_free(patch->context, name);
      continue;
    }
    patch->group_name[n] = name;
    number[g] = n++;
  }
  patch->ngroup = n;
  for (size_t f = 0; f < patch->nfacet; f++) patch->group[f] = number[patch->group[f]];
  if (patch->group_slots > 0) group_slots_fill(patch);
  um_core_free(patch->context, number);
  return UM_OK;
}

enum um_status um_geometry_patch_weld(struct um_geometry_patch *patch)
{
  enum um_status status;
  uint32_t *same = NULL, *number = NULL;
  UM_CHECK(um_core_allocate(patch->context, patch->nvertex, sizeof *same, (void *)&same));
  UM_CHECK(um_core_allocate(patch->context, patch->nvertex, sizeof *number, (void *)&number));
  UM_CHECK(find_same(patch, same));
  for (size_t f = 0; f < patch->nfacet; f++)
    for (int k = 0; k < 3; k++) {
      patch->corner[f][k] = same[patch->corner[f][k]];
      number[patch->corner[f][k]] = 1;
    }
  uint32_t n = 0;
  for (size_t i = 0; i < patch->nvertex; i++) {
    if (number[i] == 0) continue;
    patch->vertex[n] = patch->vertex[i];
    number[i] = n++;
  }
  patch->nvertex = n;
  for (size_t f = 0; f < patch->nfacet; f++)
    for (int k = 0; k < 3; k++) patch->corner[f][k] = number[patch->corner[f][k]];
  UM_CHECK(drop_empty_groups(patch));
done:
  UM_FREE(patch->context, same, number);
  return status;
}

enum um_status um_geometry_patch_check(const struct um_geometry_patch *patch)
{
  for (size_t f = 0; f < patch->nfacet; f++) {
    const uint32_t *c = patch->corner[f];
    double longest = 0.0;
    for (int k = 0; k < 3; k++) {
      struct um_vec3 e = um_vec3_sub(patch->vertex[c[(k + 1) % 3]], patch->vertex[c[k]]);
      longest = fmax(longest, um_vec3_dot(e, e));
    }
    double twice_area = um_vec3_norm(um_geometry_cross_of(patch->vertex, c));
    if (twice_area > UM_GEOMETRY_DEGENERATE * longest) continue;
    if (patch->line[f] > 0)
      return um_core_fail(patch->context, UM_ERR_INPUT,
                          "%s:%d: degenerate facet: its area is %g m2 with a longest edge of %g m; "
                          "its corners must not lie on one line or coincide",
                          patch->source, patch->line[f], 0.5 * twice_area, sqrt(longest));
    return um_core_fail(patch->context, UM_ERR_INPUT,
                        "%s: degenerate facet of %g m2: its sizes differ too much", patch->source,
                        0.5 * twice_area);
  }
  return UM_OK;
}
