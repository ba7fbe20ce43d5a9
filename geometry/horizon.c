/* Open surfaces: those whose plane has every vertex of the model on it or behind it. Nothing can
 * stand before them, so their fractions are exact without rays.
 *
 * Each test would cost all vertices. Three things make it cheap: facets of one plane share the
 * answer, boxes around runs of vertices, and around runs of such boxes, are skipped where they lie
 * behind the plane, and the vertex that closed the last surface is tried first. */
#include "geometry/visibility_data_impl.h"

struct box {
  struct um_vec3 low, high; /* [m] */
  size_t begin, end;        /* its vertices, or boxes */
};

struct search {
  const struct um_geometry_visibility *visibility;
  struct box *box; /* runs of vertices */
  size_t nbox;
  struct box *block; /* runs of boxes */
  size_t nblock;
  size_t last; /* vertex that stood before the last surface that is not open */
};

/* Vertices per bounding box, and boxes per block of them. */
#define RUN 16

static void fill_boxes(struct search *search)
{
  const struct um_vec3 *vertex = search->visibility->pose->vertex;
  size_t nvertex = search->visibility->mesh->nvertex;
  search->nbox = 0;
  for (size_t begin = 0; begin < nvertex; begin += RUN) {
    size_t end = begin + RUN < nvertex ? begin + RUN : nvertex;
    struct box box = {vertex[begin], vertex[begin], begin, end};
    for (size_t i = begin + 1; i < end; i++) {
      struct um_vec3 p = vertex[i];
      box.low = um_vec3(fmin(box.low.x, p.x), fmin(box.low.y, p.y), fmin(box.low.z, p.z));
      box.high = um_vec3(fmax(box.high.x, p.x), fmax(box.high.y, p.y), fmax(box.high.z, p.z));
    }
    search->box[search->nbox++] = box;
  }
  search->nblock = 0;
  for (size_t begin = 0; begin < search->nbox; begin += RUN) {
    size_t end = begin + RUN < search->nbox ? begin + RUN : search->nbox;
    struct box block = {search->box[begin].low, search->box[begin].high, begin, end};
    for (size_t i = begin + 1; i < end; i++) {
      const struct box *box = &search->box[i];
      block.low = um_vec3(fmin(block.low.x, box->low.x), fmin(block.low.y, box->low.y),
                          fmin(block.low.z, box->low.z));
      block.high = um_vec3(fmax(block.high.x, box->high.x), fmax(block.high.y, box->high.y),
                           fmax(block.high.z, box->high.z));
    }
    search->block[search->nblock++] = block;
  }
}

/* Does the corner of a box that is farthest along n lie beyond the height? Products and sums of
 * rounded numbers keep their order, so that no vertex inside is beyond where this is not. */
static bool reaches(const struct box *box, struct um_vec3 n, double height)
{
  struct um_vec3 farthest =
      um_vec3(n.x > 0.0 ? box->high.x : box->low.x, n.y > 0.0 ? box->high.y : box->low.y,
              n.z > 0.0 ? box->high.z : box->low.z);
  return um_vec3_dot(n, farthest) > height;
}

/* The first vertex of a box that has n . p > height; SIZE_MAX: none. */
static size_t vertex_beyond(const struct box *box, const struct um_vec3 *vertex, struct um_vec3 n,
                            double height)
{
  for (size_t i = box->begin; i < box->end; i++)
    if (um_vec3_dot(n, vertex[i]) > height) return i;
  return SIZE_MAX;
}

/* True when no vertex p has n . p > height. */
static bool plane_is_open(struct search *search, struct um_vec3 n, double height)
{
  const struct um_vec3 *vertex = search->visibility->pose->vertex;
  if (um_vec3_dot(n, vertex[search->last]) > height) return false;
  for (size_t k = 0; k < search->nblock; k++) {
    const struct box *block = &search->block[k];
    if (!reaches(block, n, height)) continue;
    for (size_t b = block->begin; b < block->end; b++) {
      if (!reaches(&search->box[b], n, height)) continue;
      size_t found = vertex_beyond(&search->box[b], vertex, n, height);
      if (found == SIZE_MAX) continue;
      search->last = found;
      return false;
    }
  }
  return true;
}

enum um_status um_geometry_horizon_find(struct um_geometry_visibility *visibility)
{
  const struct um_geometry_mesh *mesh = visibility->mesh;
  struct search search = {.visibility = visibility};
  size_t nbox = mesh->nvertex / RUN + 1;
  UM_TRY(um_core_allocate(visibility->context, nbox + nbox / RUN + 1, sizeof *search.box,
                          (void *)&search.box));
  search.block = search.box + nbox;
  fill_boxes(&search);
  /* last plane tested, for each side */
  struct um_vec3 last_normal[2] = {{0, 0, 0}, {0, 0, 0}};
  double last_height[2] = {0.0, 0.0};
  uint8_t last_open[2] = {0, 0};
  for (size_t s = 0; s < mesh->nsurface; s++) {
    struct um_vec3 n = um_geometry_surface_normal(mesh, visibility->pose, s);
    struct um_vec3 p = visibility->pose->vertex[mesh->corner[mesh->surface[s].facet][0]];
    double height = um_vec3_dot(n, p) + UM_GEOMETRY_PLANE * visibility->size;
    uint8_t side = mesh->surface[s].back;
    struct um_vec3 turn = um_vec3_sub(n, last_normal[side]);
    if (s % 256 == 0 && um_core_stopped(visibility->context)) break;
    bool same = um_vec3_dot(turn, turn) < 1e-28 &&
                fabs(height - last_height[side]) < 1e-13 * visibility->size;
    if (!same) {
      last_normal[side] = n;
      last_height[side] = height;
      last_open[side] = plane_is_open(&search, n, height);
    }
    visibility->open[s] = last_open[side];
  }
  um_core_free(visibility->context, search.box);
  return um_core_stop_check(visibility->context, "open surfaces were looked for");
}
