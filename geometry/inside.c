/* The inside of a closed part as a mesh of its own, which is traced like the outside of the
 * satellite: the same facets with their corners in the other order, so that fronts look inward. */
#include "geometry/inside.h"

#include <stdio.h>
#include <string.h>

#include "geometry/geometry_impl.h"
#include "geometry/view_factor_file.h"

#define PATCHES 128 /* a room of fewer has the rays of so many */

struct room_maker {
  struct um_context *context;
  const struct um_geometry_mesh *mesh;
  struct um_geometry_pose *pose;  /* of the satellite, joints at 0: a part is rigid */
  uint32_t *facet;                /* [inner.nfacet] of the satellite */
  struct um_geometry_mesh inner;  /* front of its facet i: surface i */
  struct um_geometry_pose turned; /* vertices those of pose */
  struct um_geometry_visibility *visibility;
  struct um_geometry_patches *patches;
  struct um_geometry_view_factors *factors;
  struct um_geometry_view_factor_key key;
};

static enum um_status allocate(struct room_maker *m, uint32_t part)
{
  struct um_geometry_mesh *inner = &m->inner;
  size_t n = 0;
  for (size_t f = 0; f < m->mesh->nfacet; f++) n += m->mesh->facet_part[f] == part;
  inner->nfacet = inner->nsurface = n;
  UM_TRY(um_core_allocate(m->context, n, sizeof *m->facet, &m->facet));
  UM_TRY(um_core_allocate(m->context, n, sizeof *inner->corner, &inner->corner));
  UM_TRY(um_core_allocate(m->context, n, sizeof(uint32_t), &inner->facet_part));
  UM_TRY(um_core_allocate(m->context, n, sizeof(uint32_t), &inner->facet_group));
  UM_TRY(um_core_allocate(m->context, n, sizeof(uint32_t), &inner->surface_of_front));
  UM_TRY(um_core_allocate(m->context, n, sizeof(uint32_t), &inner->surface_of_back));
  UM_TRY(um_core_allocate(m->context, n, sizeof *inner->surface, &inner->surface));
  UM_TRY(um_core_allocate(m->context, n, sizeof(double), &inner->area));
  return um_core_allocate(m->context, n, sizeof(struct um_vec3), &m->turned.facet_normal);
}

/* Vertices of a part stand together: only those, so that distances are judged by the part. */
static void turn(struct room_maker *m, uint32_t part)
{
  const struct um_geometry_mesh *mesh = m->mesh;
  struct um_geometry_mesh *inner = &m->inner;
  uint32_t low = UINT32_MAX, high = 0;
  size_t n = 0;
  for (size_t f = 0; f < mesh->nfacet; f++) {
    if (mesh->facet_part[f] != part) continue;
    for (int c = 0; c < 3; c++) {
      uint32_t v = mesh->corner[f][c];
      inner->corner[n][2 - c] = v;
      low = v < low ? v : low;
      high = v > high ? v : high;
    }
    m->facet[n] = (uint32_t)f;
    inner->facet_part[n] = part;
    inner->facet_group[n] = mesh->facet_group[f];
    inner->surface_of_front[n] = (uint32_t)n;
    inner->surface_of_back[n] = UM_GEOMETRY_NONE;
    inner->surface[n] = (struct um_geometry_surface){
        .facet = (uint32_t)n, .part = part, .group = mesh->facet_group[f]};
    inner->area[n] = mesh->area[f];
    m->turned.facet_normal[n++] = um_vec3_scale(m->pose->facet_normal[f], -1.0);
  }
  inner->nvertex = (size_t)high - low + 1;
  m->turned.vertex = m->pose->vertex + low;
  for (size_t i = 0; i < n; i++)
    for (int c = 0; c < 3; c++) inner->corner[i][c] -= low;
}

static enum um_status pose_rest(struct room_maker *m, const struct um_geometry *geometry)
{
  double *angles = NULL;
  size_t n = um_geometry_joint_count(geometry);
  if (n > 0) UM_TRY(um_core_allocate(m->context, n, sizeof *angles, &angles));
  enum um_status status = um_geometry_pose_create(m->context, geometry, angles, &m->pose);
  um_core_free(m->context, angles);
  return status;
}

static enum um_status gather(struct room_maker *m, size_t limit)
{
  double *seen = NULL;
  UM_TRY(um_core_allocate(m->context, m->inner.nsurface, sizeof *seen, &seen));
  for (size_t s = 0; s < m->inner.nsurface; s++) seen[s] = 1.0;
  enum um_status status =
      um_geometry_patches_create(m->context, &m->inner, &m->turned, seen, limit, &m->patches);
  um_core_free(m->context, seen);
  return status;
}

/* Room for inner surfaces among those of the table, once. */
static enum um_status widen(const struct room_maker *m, struct um_geometry_patches *all)
{
  size_t n = m->mesh->nsurface + m->mesh->nfacet;
  if (all->nsurface == n) return UM_OK;
  UM_TRY(um_core_reallocate(m->context, n, sizeof *all->patch, &all->patch));
  memset(all->patch + all->nsurface, 0xff, (n - all->nsurface) * sizeof *all->patch);
  all->nsurface = n;
  return UM_OK;
}

/* The room's patches behind those that the table has. */
static enum um_status append(struct room_maker *m, struct um_geometry_view_factor_table *table)
{
  struct um_geometry_patches *all = table->patches, *own = m->patches;
  size_t before = all->npatch, members = all->begin[before], n = own->npatch;
  UM_TRY(widen(m, all));
  UM_TRY(
      um_core_reallocate(m->context, members + own->begin[n], sizeof *all->surface, &all->surface));
  UM_TRY(um_core_reallocate(m->context, before + n + 1, sizeof *all->begin, &all->begin));
  UM_TRY(um_core_reallocate(m->context, before + n, sizeof *all->area, &all->area));
  UM_TRY(um_core_reallocate(m->context, table->nroom + 1, sizeof *table->room, &table->room));
  for (size_t i = 0; i < own->begin[n]; i++) {
    uint32_t s = um_geometry_inner_surface(m->mesh, m->facet[own->surface[i]]);
    all->surface[members + i] = s;
    all->patch[s] = (uint32_t)before + own->patch[own->surface[i]];
  }
  for (size_t p = 0; p < n; p++) {
    all->area[before + p] = own->area[p];
    all->begin[before + p + 1] = members + own->begin[p + 1];
  }
  all->npatch = before + n;
  table->room[table->nroom++] =
      (struct um_geometry_room){.part = own->npatch > 0 ? m->inner.facet_part[0] : 0,
                                .first = before,
                                .key = m->key,
                                .factors = m->factors};
  m->factors = NULL;
  return UM_OK;
}

static enum um_status trace(struct room_maker *m, size_t limit,
                            struct um_geometry_view_factor_options options)
{
  UM_TRY(um_geometry_visibility_create(m->context, &m->inner, &m->turned, &m->visibility));
  UM_TRY(gather(m, limit));
  if (m->patches->npatch < PATCHES) options.rays = options.rays * PATCHES / m->patches->npatch;
  return um_geometry_view_factors_create(m->context, &m->inner, &m->turned, m->visibility,
                                         m->patches, &options, &m->factors);
}

/* From a file, inside-PART.csv, or by rays. */
static enum um_status fill(struct room_maker *m, const struct um_geometry *geometry, uint32_t part,
                           size_t limit, const struct um_geometry_view_factor_options *options)
{
  char name[512];
  bool found = false;
  struct um_geometry_view_factor_set set = {
      .geometry = geometry, .mesh = &m->inner, .npose = 1, .pose = &m->factors, .closed = true};
  snprintf(name, sizeof name, "inside-%s", um_geometry_part_name(geometry, part));
  um_geometry_view_factor_key_begin(&m->inner, &m->turned, limit, options, &set.key);
  m->key = set.key;
  UM_TRY(um_geometry_view_factor_find(m->context, name, options, &set, &found));
  if (found) {
    m->patches = set.patches;
    return UM_OK;
  }
  UM_TRY(trace(m, limit, *options));
  set.patches = m->patches;
  return um_geometry_view_factor_keep(m->context, name, options, &set);
}

static void maker_free(struct room_maker *m)
{
  struct um_context *context = m->context;
  um_geometry_view_factors_destroy(context, &m->factors);
  um_geometry_patches_destroy(context, &m->patches);
  um_geometry_visibility_destroy(&m->visibility);
  um_geometry_pose_destroy(context, &m->pose);
  um_core_free(context, m->facet);
  um_geometry_mesh_free(context, &m->inner);
  um_core_free(context, m->turned.facet_normal);
}

enum um_status um_geometry_inside_add(struct um_context *context,
                                      const struct um_geometry *geometry, uint32_t part,
                                      size_t limit,
                                      const struct um_geometry_view_factor_options *options,
                                      struct um_geometry_view_factor_table *table)
{
  enum um_status status;
  struct room_maker m = {.context = context, .mesh = um_geometry_mesh(geometry)};
  struct um_geometry_view_factor_options own = *options;
  if (!um_geometry_report(geometry, part).closed)
    return um_core_fail(context, UM_ERR_INPUT, "part %s has no inside: it is not closed",
                        um_geometry_part_name(geometry, part));
  UM_CHECK(pose_rest(&m, geometry));
  UM_CHECK(allocate(&m, part));
  turn(&m, part);
  own.closed = true;
  UM_CHECK(fill(&m, geometry, part, limit, &own));
  status = append(&m, table);
done:
  maker_free(&m);
  return status;
}

/* Facets of a part in their order number its inner surfaces. */
static void number_facets(const struct room_maker *m, uint32_t *local)
{
  for (size_t i = 0; i < m->inner.nfacet; i++) local[m->facet[i]] = (uint32_t)i;
}

enum um_status um_geometry_inside_write(struct um_context *context,
                                        const struct um_geometry *geometry,
                                        const struct um_geometry_view_factor_table *table,
                                        size_t room, FILE *file)
{
  enum um_status status;
  struct room_maker m = {.context = context, .mesh = um_geometry_mesh(geometry)};
  const struct um_geometry_room *own = &table->room[room];
  const size_t *begin = table->patches->begin + own->first;
  struct um_geometry_view_factors *pose[1] = {own->factors};
  struct um_geometry_patches patches = {.npatch = own->factors->npatch};
  uint32_t *local = NULL;
  UM_CHECK(pose_rest(&m, geometry));
  UM_CHECK(allocate(&m, own->part));
  turn(&m, own->part);
  UM_CHECK(um_core_allocate(context, m.mesh->nfacet, sizeof *local, &local));
  number_facets(&m, local);
  UM_CHECK(um_core_allocate(context, m.inner.nfacet, sizeof(uint32_t), &patches.surface));
  UM_CHECK(um_core_allocate(context, patches.npatch + 1, sizeof(size_t), &patches.begin));
  for (size_t p = 0; p <= patches.npatch; p++) patches.begin[p] = begin[p] - begin[0];
  for (size_t i = 0; i < m.inner.nfacet; i++)
    patches.surface[i] = local[table->patches->surface[begin[0] + i] - m.mesh->nsurface];
  const struct um_geometry_view_factor_set set = {.geometry = geometry,
                                                  .mesh = &m.inner,
                                                  .key = own->key,
                                                  .npose = 1,
                                                  .patches = &patches,
                                                  .pose = pose};
  um_geometry_view_factor_file_write(&set, file);
done:
  UM_FREE(context, local, patches.surface, patches.begin);
  maker_free(&m);
  return status;
}
