#include "geometry/neighbours.h"

#include <string.h>

#include "geometry/topology_impl.h"

enum um_status um_geometry_neighbours(struct um_context *context,
                                      const struct um_geometry_mesh *mesh, uint32_t (**out)[3])
{
  enum um_status status;
  struct um_geometry_edges edges = {NULL, 0, NULL};
  uint32_t(*at)[2] = NULL; /* [nedge] its first two facets */
  *out = NULL;
  UM_CHECK(
      um_geometry_edges_create(context, (const uint32_t(*)[3])mesh->corner, mesh->nfacet, &edges));
  UM_CHECK(um_core_allocate(context, edges.nedge, sizeof *at, (void *)&at));
  UM_CHECK(um_core_allocate(context, mesh->nfacet, sizeof **out, (void *)out));
  memset(at, 0xff, edges.nedge * sizeof *at);
  for (uint32_t f = 0; f < mesh->nfacet; f++)
    for (int k = 0; k < 3; k++) {
      uint32_t *two = at[edges.of_facet[f][k]];
      two[two[0] == UM_GEOMETRY_NONE ? 0 : 1] = f;
    }
  for (uint32_t f = 0; f < mesh->nfacet; f++)
    for (int k = 0; k < 3; k++) {
      uint32_t e = edges.of_facet[f][k];
      (*out)[f][k] = edges.edge[e].uses != 2 ? UM_GEOMETRY_NONE : at[e][at[e][0] == f ? 1 : 0];
    }
done:
  um_core_free(context, at);
  um_geometry_edges_destroy(context, &edges);
  return status;
}
