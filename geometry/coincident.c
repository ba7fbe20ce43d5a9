/* Surfaces in one place: facets whose boxes touch (facet_tree.c), that lie in one plane, and of
 * which sides look the same way, are cut by each other in that plane. */
#include "geometry/coincident.h"

#include <math.h>
#include <string.h>

#include "base/core/sort.h"
#include "geometry/facet_tree_impl.h"
#include "geometry/geometry_impl.h"
#include "geometry/visibility_data_impl.h"

#define ALONG        0.999 /* cosine between normals of one plane, before distances are looked at */
#define LOOKS_MAX    ((size_t)1 << 29) /* at facets whose boxes touch: some seconds */
#define OVERLAPS_MAX ((size_t)1 << 21) /* of facets with each other: half a second */
#define CORNERS      9 /* of two triangles in common: 6, and 9 where rounding bends what is cut */
#define EVERY        ((size_t)1 << 16) /* looks between two looks at the stop: a millisecond */

/* What two parts have in common, so far. */
struct common {
  struct um_geometry_coincidence of;
  bool wide; /* some piece of it is no seam */
};

struct search {
  struct um_context *context;
  const struct um_geometry *geometry;
  const struct um_geometry_mesh *mesh;
  struct um_geometry_pose *pose;
  uint32_t *rigid;      /* [npart] joint that moves it, or UM_GEOMETRY_NONE */
  double near;          /* [m] */
  uint32_t facet;       /* whose neighbours are looked at */
  struct common *found; /* [nfound] */
  size_t nfound, room, looks, overlaps;
  enum um_status status;
};

static bool moves(const struct um_geometry_part *part)
{
  return part->joint_kind == UM_JOINT_SUN || part->joint_kind == UM_JOINT_SCHEDULE;
}

/* The nearest joint that moves, on the way to the body: what has the same one does not
 * move against each other. */
static enum um_status find_rigid(struct search *s)
{
  const struct um_geometry *g = s->geometry;
  UM_TRY(um_core_allocate(s->context, g->npart, sizeof *s->rigid, &s->rigid));
  for (size_t i = 0; i < g->npart; i++) {
    size_t k = g->order[i];
    const struct um_geometry_part *p = &g->part[k];
    s->rigid[k] = moves(p)                  ? (uint32_t)p->joint
                  : p->parent == (size_t)-1 ? UM_GEOMETRY_NONE
                                            : s->rigid[p->parent];
  }
  return UM_OK;
}

/* Sides that look the same way, where the fronts do or look against each other. */
static int sides_in_common(const struct um_geometry_mesh *mesh, uint32_t f, uint32_t g, bool along)
{
  const uint32_t *front = mesh->surface_of_front, *back = mesh->surface_of_back;
  const uint32_t *of_front = along ? front : back, *of_back = along ? back : front;
  return (front[f] != UM_GEOMETRY_NONE && of_front[g] != UM_GEOMETRY_NONE) +
         (back[f] != UM_GEOMETRY_NONE && of_back[g] != UM_GEOMETRY_NONE);
}

/* Do the corners of facet g lie in the plane of f? */
static bool lies_in_plane(const struct search *s, uint32_t g, uint32_t f)
{
  const struct um_vec3 *vertex = s->pose->vertex;
  struct um_vec3 base = vertex[s->mesh->corner[f][0]], n = s->pose->facet_normal[f];
  for (int k = 0; k < 3; k++) {
    struct um_vec3 p = um_vec3_sub(vertex[s->mesh->corner[g][k]], base);
    if (!(fabs(um_vec3_dot(p, n)) <= s->near)) return false;
  }
  return true;
}

/* Cut a polygon by the line through a along `edge`: what lies to the left along `inward` is kept.
 */
static size_t cut(const struct um_vec3 *p, size_t n, struct um_vec3 a, struct um_vec3 inward,
                  struct um_vec3 *out)
{
  size_t m = 0;
  for (size_t i = 0; i < n; i++) {
    struct um_vec3 from = p[i], to = p[(i + 1) % n];
    double d = um_vec3_dot(um_vec3_sub(from, a), inward);
    double e = um_vec3_dot(um_vec3_sub(to, a), inward);
    if (d >= 0.0) out[m++] = from;
    if ((d >= 0.0) != (e >= 0.0)) out[m++] = um_vec3_axpy(from, d / (d - e), um_vec3_sub(to, from));
  }
  return m;
}

/* Area that two facets have in common, seen along the normal of f (Sutherland and Hodgman 1974),
 * and whether it is wider than what rays tell apart: than seams of two facets that should only
 * touch. */
static double common_area(const struct search *s, uint32_t f, uint32_t g, bool *wide)
{
  const struct um_vec3 *vertex = s->pose->vertex;
  struct um_vec3 n = s->pose->facet_normal[f], p[2][CORNERS], sum = um_vec3(0, 0, 0);
  size_t count = 3;
  double around = 0.0;
  for (int k = 0; k < 3; k++) p[0][k] = vertex[s->mesh->corner[g][k]];
  for (int k = 0; k < 3; k++) {
    struct um_vec3 a = vertex[s->mesh->corner[f][k]], b = vertex[s->mesh->corner[f][(k + 1) % 3]];
    count = cut(p[k % 2], count, a, um_vec3_cross(n, um_vec3_sub(b, a)), p[(k + 1) % 2]);
  }
  for (size_t i = 1; i + 1 < count; i++)
    sum = um_vec3_add(
        sum, um_vec3_cross(um_vec3_sub(p[1][i], p[1][0]), um_vec3_sub(p[1][i + 1], p[1][0])));
  for (size_t i = 0; i < count; i++)
    around += um_vec3_norm(um_vec3_sub(p[1][(i + 1) % count], p[1][i]));
  double area = 0.5 * fabs(um_vec3_dot(sum, n));
  *wide = area > 0.5 * s->near * around;
  return area;
}

static void add(struct search *s, const struct common *piece)
{
  if (s->nfound > 0) { /* facets of the same two parts come one after the other */
    struct common *last = &s->found[s->nfound - 1];
    if (last->of.part[0] == piece->of.part[0] && last->of.part[1] == piece->of.part[1]) {
      last->of.area += piece->of.area;
      last->wide = last->wide || piece->wide;
      return;
    }
  }
  if (s->nfound == s->room) {
    s->room = 2 * s->room + 64;
    s->status = um_core_reallocate(s->context, s->room, sizeof *s->found, &s->found);
    if (s->status != UM_OK) return;
  }
  s->found[s->nfound++] = *piece;
}

/* A facet whose box touches that of s->facet; false: enough. */
static bool look(void *user, uint32_t g)
{
  struct search *s = user;
  if (s->looks++ % EVERY == 0)
    s->status = um_core_stop_check(s->context, "facets in one place were looked for");
  if (s->status != UM_OK || s->looks > LOOKS_MAX) return false;
  const struct um_geometry_mesh *mesh = s->mesh;
  uint32_t f = s->facet, a = mesh->facet_part[f], b = mesh->facet_part[g];
  if (g <= f || s->rigid[a] != s->rigid[b]) return true;
  double cosine = um_vec3_dot(s->pose->facet_normal[f], s->pose->facet_normal[g]);
  if (fabs(cosine) < ALONG) return true;
  int sides = sides_in_common(mesh, f, g, cosine > 0.0);
  if (sides == 0 || !lies_in_plane(s, g, f) || !lies_in_plane(s, f, g)) return true;
  struct common piece = {.of = {.part = {a < b ? a : b, a < b ? b : a}}};
  piece.of.area = sides * common_area(s, f, g, &piece.wide);
  if (!(piece.of.area > 0.0)) return true;
  add(s, &piece);
  if (piece.wide) s->overlaps++;
  return s->status == UM_OK && s->overlaps < OVERLAPS_MAX;
}

static int by_parts(const void *pa, const void *pb)
{
  const struct um_geometry_coincidence *a = &((const struct common *)pa)->of;
  const struct um_geometry_coincidence *b = &((const struct common *)pb)->of;
  if (a->part[0] != b->part[0]) return a->part[0] < b->part[0] ? -1 : 1;
  return (a->part[1] > b->part[1]) - (a->part[1] < b->part[1]);
}

static int by_area(const void *pa, const void *pb)
{
  const struct um_geometry_coincidence *a = pa, *b = pb;
  return (a->area < b->area) - (a->area > b->area);
}

/* One entry for each two parts that have more than seams in common. */
static enum um_status gather(struct search *s, struct um_geometry_coincidences *out)
{
  size_t n = 0;
  UM_TRY(um_core_sort(s->context, s->found, s->nfound, sizeof *s->found, by_parts));
  for (size_t i = 0; i < s->nfound; i++)
    if (n > 0 && by_parts(&s->found[n - 1], &s->found[i]) == 0) {
      s->found[n - 1].of.area += s->found[i].of.area;
      s->found[n - 1].wide = s->found[n - 1].wide || s->found[i].wide;
    } else {
      s->found[n++] = s->found[i];
    }
  UM_TRY(um_core_allocate(s->context, n, sizeof *out->pair, &out->pair));
  for (size_t i = 0; i < n; i++)
    if (s->found[i].wide) out->pair[out->n++] = s->found[i].of;
  return um_core_sort(s->context, out->pair, out->n, sizeof *out->pair, by_area);
}

enum um_status um_geometry_coincidences_create(struct um_context *context,
                                               const struct um_geometry *geometry,
                                               struct um_geometry_coincidences **out)
{
  enum um_status status;
  struct search s = {.context = context, .geometry = geometry, .mesh = um_geometry_mesh(geometry)};
  struct um_geometry_coincidences *own = NULL;
  struct um_geometry_facet_tree *tree = NULL;
  bool all = true;
  *out = NULL;
  UM_CHECK(um_core_allocate(context, 1, sizeof *own, &own));
  UM_CHECK(find_rigid(&s));
  UM_CHECK(um_geometry_pose_create(context, geometry, NULL, &s.pose));
  UM_CHECK(um_geometry_facet_tree_create(context, s.mesh, s.pose, &tree));
  s.near = UM_GEOMETRY_BLUR * um_geometry_facet_tree_size(tree);
  for (size_t f = 0; f < s.mesh->nfacet && all; f++) {
    s.facet = (uint32_t)f;
    all = um_geometry_facet_tree_visit(tree, s.facet, s.near, look, &s);
    UM_CHECK(s.status);
  }
  UM_CHECK(gather(&s, own));
  own->all = all;
  *out = own;
  own = NULL;
done:
  um_geometry_facet_tree_destroy(context, &tree);
  um_geometry_pose_destroy(context, &s.pose);
  UM_FREE(context, s.rigid, s.found);
  um_geometry_coincidences_destroy(context, &own);
  return status;
}

void um_geometry_coincidences_destroy(struct um_context *context,
                                      struct um_geometry_coincidences **coincidences)
{
  if (coincidences == NULL || *coincidences == NULL) return;
  UM_FREE(context, (*coincidences)->pair, *coincidences);
  *coincidences = NULL;
}
