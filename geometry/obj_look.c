/* What an OBJ file holds: its groups, which of them are one part, and which are closed. */
#include "geometry/obj_look.h"

#include "geometry/patch_impl.h"
#include "geometry/topology_impl.h"

void um_geometry_obj_look_clear(struct um_context *context, struct um_geometry_obj_look *look)
{
  for (size_t i = 0; i < look->ngroup; i++)
    UM_FREE(context, look->group[i].name, look->group[i].usemtl, look->group[i].usemtl_back);
  um_core_free(context, look->group);
  *look = (struct um_geometry_obj_look){0};
}

/* Unite the groups of the two triangles at an edge that has no third: piece [ngroup]. */
static enum um_status unite_groups(const struct um_geometry_patch *patch,
                                   const struct um_geometry_edges *edges, uint32_t *piece)
{
  uint32_t *first; /* [nedge] group of the first triangle, UM_GEOMETRY_NONE: not met yet */
  UM_TRY(um_core_allocate(patch->context, edges->nedge, sizeof *first, &first));
  for (size_t e = 0; e < edges->nedge; e++) first[e] = UM_GEOMETRY_NONE;
  for (size_t f = 0; f < patch->nfacet; f++)
    for (int k = 0; k < 3; k++) {
      uint32_t e = edges->of_facet[f][k];
      if (edges->edge[e].uses != 2) continue;
      if (first[e] == UM_GEOMETRY_NONE)
        first[e] = patch->group[f];
      else
        um_geometry_pieces_unite(piece, first[e], patch->group[f]);
    }
  um_core_free(patch->context, first);
  return UM_OK;
}

/* Number the parts in the order of their first groups; piece [ngroup] holds the number after. */
static void number_parts(uint32_t *piece, struct um_geometry_obj_look *look)
{
  for (uint32_t g = 0; g < look->ngroup; g++) {
    uint32_t root = um_geometry_piece_root(piece, g); /* the lowest: it is numbered already */
    look->group[g].part = root == g ? look->npart++ : look->group[root].part;
  }
}

/* Triangles of closed pieces, part by part: what touches another part does not open this one. */
static enum um_status count_closed(const struct um_geometry_patch *patch,
                                   struct um_geometry_obj_look *look, size_t part)
{
  enum um_status status;
  struct um_geometry_edges edges = {NULL, 0, NULL};
  uint32_t(*corner)[3] = NULL;
  uint8_t *closed = NULL;
  size_t *of = NULL, n = 0;
  UM_CHECK(um_core_allocate(patch->context, patch->nfacet, sizeof *corner, (void *)&corner));
  UM_CHECK(um_core_allocate(patch->context, patch->nfacet, sizeof *of, &of));
  UM_CHECK(um_core_allocate(patch->context, patch->nfacet, 1, &closed));
  for (size_t f = 0; f < patch->nfacet; f++) {
    if (look->group[patch->group[f]].part != part) continue;
    for (int k = 0; k < 3; k++) corner[n][k] = patch->corner[f][k];
    of[n++] = f;
  }
  UM_CHECK(um_geometry_edges_create(patch->context, (const uint32_t(*)[3])corner, n, &edges));
  UM_CHECK(um_geometry_edges_closed(patch->context, (const uint32_t(*)[3])corner, n, patch->nvertex,
                                    &edges, closed));
  for (size_t i = 0; i < n; i++) {
    look->group[patch->group[of[i]]].nfacet++;
    look->group[patch->group[of[i]]].nclosed += closed[i];
  }
done:
  um_geometry_edges_destroy(patch->context, &edges);
  UM_FREE(patch->context, corner, of, closed);
  return status;
}

static enum um_status look_at(struct um_geometry_patch *patch, struct um_geometry_obj_look *look)
{
  enum um_status status;
  struct um_context *context = patch->context;
  struct um_geometry_edges edges = {NULL, 0, NULL};
  uint32_t *piece = NULL;
  UM_CHECK(um_core_allocate(context, look->ngroup, sizeof *piece, &piece));
  for (uint32_t g = 0; g < look->ngroup; g++) {
    piece[g] = g;
    UM_CHECK(um_core_strdup(context, patch->group_name[g], &look->group[g].name));
  }
  UM_CHECK(um_geometry_edges_create(context, (const uint32_t(*)[3])patch->corner, patch->nfacet,
                                    &edges));
  UM_CHECK(unite_groups(patch, &edges, piece));
  number_parts(piece, look);
  for (size_t part = 0; part < look->npart; part++) UM_CHECK(count_closed(patch, look, part));
  look->low = look->high = patch->vertex[0];
  for (size_t i = 1; i < patch->nvertex; i++) {
    struct um_vec3 v = patch->vertex[i];
    look->low = um_vec3(fmin(look->low.x, v.x), fmin(look->low.y, v.y), fmin(look->low.z, v.z));
    look->high = um_vec3(fmax(look->high.x, v.x), fmax(look->high.y, v.y), fmax(look->high.z, v.z));
  }
done:
  um_geometry_edges_destroy(context, &edges);
  um_core_free(context, piece);
  return status;
}

enum um_status um_geometry_obj_look(struct um_context *context, const char *path,
                                    struct um_geometry_obj_look *out)
{
  enum um_status status;
  struct um_geometry_patch patch;
  struct um_geometry_obj_material *material = NULL;
  *out = (struct um_geometry_obj_look){0};
  um_geometry_patch_begin(&patch, context, path);
  const struct um_geometry_obj_wish wish = {.scale = 1.0, .material = &material};
  UM_CHECK(um_geometry_obj_read(&patch, path, &wish));
  UM_CHECK(um_core_allocate(context, patch.ngroup, sizeof *out->group, &out->group));
  out->ngroup = patch.ngroup;
  for (size_t g = 0; g < patch.ngroup; g++) {
    out->group[g].usemtl = material[g].front;
    out->group[g].usemtl_back = material[g].back;
    material[g] = (struct um_geometry_obj_material){NULL, NULL};
  }
  UM_CHECK(um_geometry_patch_weld(&patch));
  UM_CHECK(um_geometry_patch_check(&patch));
  UM_CHECK(look_at(&patch, out));
done:
  for (size_t g = 0; material != NULL && g < patch.ngroup; g++)
    UM_FREE(context, material[g].front, material[g].back);
  um_core_free(context, material);
  um_geometry_patch_end(&patch);
  if (status != UM_OK) um_geometry_obj_look_clear(context, out);
  return status;
}
