/* The satellite's outside as it is kept: what it has, by number and by name. */
#include <string.h>

#include "geometry/geometry_impl.h"

void um_geometry_mesh_free(struct um_context *context, struct um_geometry_mesh *mesh)
{
  UM_FREE(context, mesh->corner, mesh->facet_part, mesh->facet_group, mesh->surface_of_front,
          mesh->surface_of_back, mesh->surface, mesh->area);
}

void um_geometry_destroy(struct um_geometry **geometry)
{
  if (geometry == NULL || *geometry == NULL) return;
  struct um_geometry *g = *geometry;
  struct um_context *context = g->context;
  for (size_t i = 0; i < g->npart; i++)
    UM_FREE(context, g->part[i].name, (void *)(uintptr_t)g->part[i].schedule.t,
            (void *)(uintptr_t)g->part[i].schedule.angle);
  for (size_t i = 0; i < g->ngroup; i++) um_core_free(context, (void *)(uintptr_t)g->group[i].name);
  for (size_t i = 0; i < g->nmaterial; i++) um_core_free(context, g->material[i]);
  UM_FREE(context, g->part, g->order, g->group, g->material, g->vertex, g->normal);
  um_geometry_mesh_free(context, &g->mesh);
  um_core_free(context, g);
  *geometry = NULL;
}

const struct um_geometry_mesh *um_geometry_mesh(const struct um_geometry *geometry)
{
  return &geometry->mesh;
}

size_t um_geometry_part_count(const struct um_geometry *geometry) { return geometry->npart; }

const char *um_geometry_part_name(const struct um_geometry *geometry, size_t part)
{
  return geometry->part[part].name;
}

size_t um_geometry_part_find(const struct um_geometry *geometry, const char *name)
{
  for (size_t i = 0; i < geometry->npart; i++)
    if (strcmp(geometry->part[i].name, name) == 0) return i;
  return (size_t)-1;
}

size_t um_geometry_group_count(const struct um_geometry *geometry) { return geometry->ngroup; }

const struct um_geometry_group *um_geometry_group(const struct um_geometry *geometry, size_t group)
{
  return &geometry->group[group];
}

size_t um_geometry_material_count(const struct um_geometry *geometry)
{
  return geometry->nmaterial;
}

const char *um_geometry_material_name(const struct um_geometry *geometry, size_t material)
{
  return geometry->material[material];
}
