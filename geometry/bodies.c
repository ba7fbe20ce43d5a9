/* Connected pieces of a part's facets, by their corners; volume by the divergence theorem,
 * V = sum v0 . (v1 x v2) / 6 about a corner of the piece. */
#include "geometry/bodies.h"

#include "geometry/geometry_impl.h"
#include "geometry/topology_impl.h"

struct piece {
  struct um_vec3 base; /* a corner [m] */
  double area, volume; /* [m^2], [m^3] */
};

/* Number of the piece of every facet, and how many there are. */
static enum um_status number_pieces(struct um_context *context, const struct um_geometry_part *part,
                                    const uint32_t (*corner)[3], uint32_t *piece_of, size_t *n)
{
  size_t nvertex = part->vertex_end - part->vertex_begin, begin = part->vertex_begin;
  uint32_t *root = NULL, *number = NULL;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, nvertex, sizeof *root, &root));
  UM_CHECK(um_core_allocate(context, nvertex, sizeof *number, &number));
  for (uint32_t v = 0; v < nvertex; v++) {
    root[v] = v;
    number[v] = UM_GEOMETRY_NONE;
  }
  for (size_t f = part->facet_begin; f < part->facet_end; f++)
    for (int k = 1; k < 3; k++)
      um_geometry_pieces_unite(root, (uint32_t)(corner[f][0] - begin),
                               (uint32_t)(corner[f][k] - begin));
  *n = 0;
  for (size_t f = part->facet_begin; f < part->facet_end; f++) {
    uint32_t of = um_geometry_piece_root(root, (uint32_t)(corner[f][0] - begin));
    if (number[of] == UM_GEOMETRY_NONE) number[of] = (uint32_t)(*n)++;
    piece_of[f - part->facet_begin] = number[of];
  }
done:
  UM_FREE(context, root, number);
  return status;
}

enum um_status um_geometry_bodies(struct um_context *context, const struct um_geometry *geometry,
                                  size_t part, double **area, size_t *n)
{
  const struct um_geometry_part *p = &geometry->part[part];
  const uint32_t(*corner)[3] = (const uint32_t(*)[3])geometry->mesh.corner;
  uint32_t *piece_of = NULL;
  struct piece *piece = NULL;
  size_t npiece;
  enum um_status status;
  *area = NULL;
  *n = 0;
  if (!p->report.closed) return UM_OK;
  UM_CHECK(um_core_allocate(context, p->facet_end - p->facet_begin, sizeof *piece_of, &piece_of));
  UM_CHECK(number_pieces(context, p, corner, piece_of, &npiece));
  UM_CHECK(um_core_allocate(context, npiece, sizeof *piece, &piece));
  UM_CHECK(um_core_allocate(context, npiece, sizeof **area, area));
  for (size_t f = p->facet_begin; f < p->facet_end; f++) {
    struct piece *of = &piece[piece_of[f - p->facet_begin]];
    if (of->area == 0.0) of->base = geometry->vertex[corner[f][0]];
    of->area += geometry->mesh.area[f];
    of->volume += um_vec3_dot(um_vec3_sub(geometry->vertex[corner[f][0]], of->base),
                              um_geometry_cross_of(geometry->vertex, corner[f])) /
                  6.0;
  }
  for (size_t i = 0; i < npiece; i++)
    if (piece[i].volume > 0.0) (*area)[(*n)++] = piece[i].area;
done:
  UM_FREE(context, piece_of, piece);
  return status;
}
