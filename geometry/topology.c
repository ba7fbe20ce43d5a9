/* Edges of a triangle mesh: who shares them, and which pieces are closed. */
#include "geometry/topology_impl.h"

#include <string.h>

#include "geometry/geometry.h"

static uint64_t edge_slot(uint32_t a, uint32_t b, uint64_t mask)
{
  uint64_t h = (((uint64_t)a << 32) | b) * UINT64_C(0x9e3779b97f4a7c15);
  h = (h ^ (h >> 32)) * UINT64_C(0xd6e8feb86659fd93);
  return (h ^ (h >> 32)) & mask;
}

enum um_status um_geometry_edges_create(struct um_context *context, const uint32_t (*corner)[3],
                                        size_t nfacet, struct um_geometry_edges *edges)
{
  enum um_status status;
  uint32_t *table = NULL; /* edge index by open addressing, UM_GEOMETRY_NONE where empty */
  size_t slots = 16;
  while (slots < 6 * nfacet) slots *= 2;
  memset(edges, 0, sizeof *edges);
  UM_CHECK(um_core_allocate(context, slots, sizeof *table, (void *)&table));
  UM_CHECK(um_core_allocate(context, 3 * nfacet, sizeof *edges->edge, (void *)&edges->edge));
  UM_CHECK(um_core_allocate(context, nfacet, sizeof *edges->of_facet, (void *)&edges->of_facet));
  memset(table, 0xff, slots * sizeof *table);
  for (size_t f = 0; f < nfacet; f++)
    for (int k = 0; k < 3; k++) {
      uint32_t from = corner[f][k], to = corner[f][(k + 1) % 3];
      uint32_t a = from < to ? from : to, b = from < to ? to : from;
      uint64_t slot = edge_slot(a, b, slots - 1);
      while (table[slot] != UM_GEOMETRY_NONE &&
             (edges->edge[table[slot]].a != a || edges->edge[table[slot]].b != b))
        slot = (slot + 1) & (slots - 1);
      if (table[slot] == UM_GEOMETRY_NONE) {
        table[slot] = (uint32_t)edges->nedge;
        edges->edge[edges->nedge++] = (struct um_geometry_edge){a, b, 0, 0};
      }
      struct um_geometry_edge *e = &edges->edge[table[slot]];
      e->uses++;
      if (from == a) e->forward++;
      edges->of_facet[f][k] = table[slot];
    }
done:
  um_core_free(context, table);
  if (status != UM_OK) um_geometry_edges_destroy(context, edges);
  return status;
}

void um_geometry_edges_destroy(struct um_context *context, struct um_geometry_edges *edges)
{
  UM_FREE(context, edges->edge, edges->of_facet);
  memset(edges, 0, sizeof *edges);
}

/* Halves the path. */
uint32_t um_geometry_piece_root(uint32_t *piece, uint32_t v)
{
  while (piece[v] != v) {
    piece[v] = piece[piece[v]];
    v = piece[v];
  }
  return v;
}

void um_geometry_pieces_unite(uint32_t *piece, uint32_t u, uint32_t v)
{
  u = um_geometry_piece_root(piece, u);
  v = um_geometry_piece_root(piece, v);
  if (u < v)
    piece[v] = u;
  else
    piece[u] = v;
}

enum um_status um_geometry_edges_closed(struct um_context *context, const uint32_t (*corner)[3],
                                        size_t nfacet, size_t nvertex,
                                        const struct um_geometry_edges *edges, uint8_t *closed)
{
  enum um_status status;
  uint32_t *piece = NULL;
  uint8_t *open = NULL; /* [nvertex], of roots */
  UM_CHECK(um_core_allocate(context, nvertex, sizeof *piece, (void *)&piece));
  UM_CHECK(um_core_allocate(context, nvertex, 1, (void *)&open));
  for (uint32_t v = 0; v < nvertex; v++) piece[v] = v;
  for (size_t e = 0; e < edges->nedge; e++)
    um_geometry_pieces_unite(piece, edges->edge[e].a, edges->edge[e].b);
  for (size_t e = 0; e < edges->nedge; e++)
    if (edges->edge[e].uses != 2 || edges->edge[e].forward != 1)
      open[um_geometry_piece_root(piece, edges->edge[e].a)] = 1;
  for (size_t f = 0; f < nfacet; f++)
    closed[f] = !open[um_geometry_piece_root(piece, corner[f][0])];
done:
  UM_FREE(context, piece, open);
  return status;
}
