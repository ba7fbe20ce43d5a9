/* The inside of closed parts: their facets turned inward see each other. */
#ifndef UMBRA_GEOMETRY_INSIDE_H
#define UMBRA_GEOMETRY_INSIDE_H

#include "geometry/view_factor_table.h"

/* Number of the inner surface of a facet: behind the surfaces of the outside. */
static inline uint32_t um_geometry_inner_surface(const struct um_geometry_mesh *mesh, size_t facet)
{
  return (uint32_t)(mesh->nsurface + facet);
}

/* Add a room to the table: patches of the inner surfaces of `part`, gathered as those of the
 * outside (limit 0: one a group), and their view factors, of which none is to space. Other parts
 * that stand inside are not seen. Rays: options->rays of each patch, and of 128 in all at least.
 * UM_ERR_INPUT: the part is not closed; else as um_geometry_view_factors_create. On failure the
 * table stays good for destruction alone. Test: geometry/inside. */
enum um_status um_geometry_inside_add(struct um_context *context,
                                      const struct um_geometry *geometry, uint32_t part,
                                      size_t limit,
                                      const struct um_geometry_view_factor_options *options,
                                      struct um_geometry_view_factor_table *table);

/* Those of a room as a file (view_factor_file.h), which numbers the facets of its part from 0;
 * errors of writing are the stream's. UM_ERR_MEMORY. */
enum um_status um_geometry_inside_write(struct um_context *context,
                                        const struct um_geometry *geometry,
                                        const struct um_geometry_view_factor_table *table,
                                        size_t room, FILE *file);

#endif
