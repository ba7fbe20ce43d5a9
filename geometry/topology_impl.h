/* Edges of a mesh. Private to geometry/. */
#ifndef UMBRA_GEOMETRY_TOPOLOGY_IMPL_H
#define UMBRA_GEOMETRY_TOPOLOGY_IMPL_H

#include <stddef.h>
#include <stdint.h>

#include "base/core/context.h"

/* One undirected edge, a < b. */
struct um_geometry_edge {
  uint32_t a, b;
  uint32_t uses;    /* facets at this edge */
  uint32_t forward; /* of them, those that run from a to b */
};
struct um_geometry_edges {
  struct um_geometry_edge *edge; /* [nedge], in order of first use */
  size_t nedge;
  uint32_t (*of_facet)[3]; /* [nfacet]: edge from corner k to corner k + 1 */
};
enum um_status um_geometry_edges_create(struct um_context *context, const uint32_t (*corner)[3],
                                        size_t nfacet, struct um_geometry_edges *edges);
void um_geometry_edges_destroy(struct um_context *context, struct um_geometry_edges *edges);
/* closed[nfacet] = 1 where the connected piece that the facet belongs to is watertight and
 * consistently oriented. */
enum um_status um_geometry_edges_closed(struct um_context *context, const uint32_t (*corner)[3],
                                        size_t nfacet, size_t nvertex,
                                        const struct um_geometry_edges *edges, uint8_t *closed);

/* Pieces as a forest over vertices, piece[v] = v before any are united: the vertex that stands for
 * the piece of v, the lowest; and two of them made one. */
uint32_t um_geometry_piece_root(uint32_t *piece, uint32_t v);
void um_geometry_pieces_unite(uint32_t *piece, uint32_t u, uint32_t v);

#endif
