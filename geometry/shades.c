/* What stands before a surface toward a direction, without rays, of a body of few facets.
 *
 * Seen from the direction, facets are triangles in a plane. Those that rise above a surface's plane
 * may hide some of it; where an axis separates their triangle from the surface's own (two convex
 * figures in a plane are apart if and only if the normal of an edge of one separates them), they
 * hide nothing: a surface that is apart from all is free, exactly. Of the others, edge functions
 * say which points they hide: a point of a facet is a + w1 (b - a) + w2 (c - a), in which the
 * barycentric weights of its image in another triangle, and the height of that one above it, are
 * linear. Rays would ask the same of floats, and end at the same points but for those within
 * rounding of an edge. */
#include "geometry/shades_impl.h"

#include <math.h>
#include <string.h>

/* Of the product of two edges, below which a triangle is seen edge-on [1]. */
#define EDGE_ON 1e-9
/* Weights of a shadow's edge [1]: neighbours leave no gap between them. */
#define OUTSIDE (-1e-12)

/* A corner of `facet` stands above the plane of the surface. */
static bool rises_above(const struct um_geometry_visibility *v, uint32_t facet, size_t surface)
{
  struct um_vec3 n = um_geometry_surface_normal(v->mesh, v->pose, surface);
  struct um_vec3 base = v->pose->vertex[v->mesh->corner[v->mesh->surface[surface].facet][0]];
  for (int k = 0; k < 3; k++) {
    struct um_vec3 p = v->pose->vertex[v->mesh->corner[facet][k]];
    if (um_vec3_dot(um_vec3_sub(p, base), n) > UM_GEOMETRY_PLANE * v->size) return true;
  }
  return false;
}

enum um_status um_geometry_shades_find(struct um_geometry_visibility *visibility)
{
  struct um_geometry_visibility *v = visibility;
  const struct um_geometry_mesh *mesh = v->mesh;
  size_t n = 0;
  if (mesh->nfacet > UM_GEOMETRY_SHADES_FACETS || mesh->nvertex > UM_GEOMETRY_SHADES_VERTICES)
    return UM_OK;
  UM_TRY(um_core_allocate(v->context, mesh->nsurface + 1, sizeof *v->before_begin,
                          (void *)&v->before_begin));
  UM_TRY(um_core_allocate(v->context, mesh->nsurface * mesh->nfacet, sizeof *v->before,
                          (void *)&v->before));
  for (size_t s = 0; s < mesh->nsurface; s++) {
    v->before_begin[s] = n;
    for (uint32_t f = 0; f < mesh->nfacet && !v->open[s]; f++)
      if (f != mesh->surface[s].facet && rises_above(v, f, s)) v->before[n++] = f;
  }
  v->before_begin[mesh->nsurface] = n;
  return UM_OK;
}

bool um_geometry_shades_toward(const struct um_geometry_visibility *visibility, struct um_vec3 d,
                               struct um_geometry_shades_look *out)
{
  struct um_vec3 t, b;
  if (visibility->before == NULL) return false;
  out->visibility = visibility;
  um_core_vec3_frame(d, &t, &b);
  for (size_t i = 0; i < visibility->mesh->nvertex; i++) {
    struct um_vec3 p = um_vec3_sub(visibility->pose->vertex[i], visibility->centre);
    out->vertex[i] = um_vec3(um_vec3_dot(p, t), um_vec3_dot(p, b), um_vec3_dot(p, d));
  }
  return true;
}

struct triangle {
  const struct um_vec3 *corner[3];
};

static struct triangle triangle_of(const struct um_geometry_shades_look *look, uint32_t facet)
{
  const uint32_t *c = look->visibility->mesh->corner[facet];
  return (struct triangle){{&look->vertex[c[0]], &look->vertex[c[1]], &look->vertex[c[2]]}};
}

/* Twice the area of a, b, c as they are seen, positive counter-clockwise. */
static double turn(const struct um_vec3 *a, const struct um_vec3 *b, const struct um_vec3 *c)
{
  return (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x);
}

/* Does the normal of an edge of p have q on its other side, farther than the margin? */
static bool edges_separate(const struct triangle *p, const struct triangle *q, double margin)
{
  for (int k = 0; k < 3; k++) {
    const struct um_vec3 *a = p->corner[k], *b = p->corner[(k + 1) % 3],
                         *c = p->corner[(k + 2) % 3];
    double length = hypot(b->x - a->x, b->y - a->y), own = turn(a, b, c);
    double nearest = INFINITY; /* to the edge, on the side that p is not on */
    for (int i = 0; i < 3; i++) {
      double beyond = turn(a, b, q->corner[i]);
      nearest = fmin(nearest, own > 0.0 ? -beyond : beyond);
    }
    if (nearest > margin * length) return true;
  }
  return false;
}

/* Is a box around q apart from one around p? */
static bool boxes_separate(const struct triangle *p, const struct triangle *q, double margin)
{
  struct um_vec3 low[2], high[2];
  const struct triangle *of[2] = {p, q};
  for (int i = 0; i < 2; i++) {
    const struct um_vec3 *a = of[i]->corner[0], *b = of[i]->corner[1], *c = of[i]->corner[2];
    low[i] = um_vec3(fmin(a->x, fmin(b->x, c->x)), fmin(a->y, fmin(b->y, c->y)), 0.0);
    high[i] = um_vec3(fmax(a->x, fmax(b->x, c->x)), fmax(a->y, fmax(b->y, c->y)), 0.0);
  }
  return low[0].x > high[1].x + margin || low[1].x > high[0].x + margin ||
         low[0].y > high[1].y + margin || low[1].y > high[0].y + margin;
}

/* The four functions at a point as it is seen. */
static void functions_at(const struct triangle *q, double area, const struct um_vec3 *p,
                         double out[4])
{
  out[0] = turn(q->corner[1], q->corner[2], p) / area;
  out[1] = turn(q->corner[2], q->corner[0], p) / area;
  out[2] = turn(q->corner[0], q->corner[1], p) / area;
  out[3] = out[0] * q->corner[0]->z + out[1] * q->corner[1]->z + out[2] * q->corner[2]->z - p->z;
}

/* The shadow of q on p; false where q is seen edge-on. */
static bool shade_of(const struct triangle *p, const struct triangle *q,
                     struct um_geometry_shade *out)
{
  double at[3][4], area = turn(q->corner[0], q->corner[1], q->corner[2]), longest = 0.0;
  for (int k = 0; k < 3; k++) {
    const struct um_vec3 *a = q->corner[k], *b = q->corner[(k + 1) % 3];
    longest = fmax(longest, um_vec3_norm(um_vec3_sub(*a, *b)));
  }
  if (!(fabs(area) > EDGE_ON * longest * longest)) return false;
  for (int k = 0; k < 3; k++) functions_at(q, area, p->corner[k], at[k]);
  for (int i = 0; i < 4; i++) {
    out->c[i][0] = at[0][i];
    out->c[i][1] = at[1][i] - at[0][i];
    out->c[i][2] = at[2][i] - at[0][i];
  }
  return true;
}

size_t um_geometry_shades_before(const struct um_geometry_shades_look *look, size_t surface,
                                 double margin,
                                 struct um_geometry_shade shade[UM_GEOMETRY_SHADES_MOST])
{
  const struct um_geometry_visibility *v = look->visibility;
  const struct triangle own = triangle_of(look, v->mesh->surface[surface].facet);
  size_t n = 0;
  for (size_t i = v->before_begin[surface]; i < v->before_begin[surface + 1]; i++) {
    const struct triangle other = triangle_of(look, v->before[i]);
    if (boxes_separate(&own, &other, margin) || edges_separate(&own, &other, margin) ||
        edges_separate(&other, &own, margin))
      continue;
    if (shade != NULL && (n == UM_GEOMETRY_SHADES_MOST || !shade_of(&own, &other, &shade[n])))
      return SIZE_MAX;
    n++;
  }
  return n;
}

void um_geometry_shades_on(const struct um_geometry_visibility *visibility, uint64_t seed,
                           uint32_t facet, const struct um_geometry_shade *shade, size_t nshade,
                           size_t n, uint8_t *hidden)
{
  const double(*w)[2] = um_geometry_points_weights(visibility, seed, facet);
  memset(hidden, 0, n);
  for (size_t i = 0; i < nshade; i++) {
    const double(*c)[3] = shade[i].c;
    for (size_t k = 0; k < n; k++) {
      double a = c[0][0] + c[0][1] * w[k][0] + c[0][2] * w[k][1];
      double b = c[1][0] + c[1][1] * w[k][0] + c[1][2] * w[k][1];
      double d = c[2][0] + c[2][1] * w[k][0] + c[2][2] * w[k][1];
      double above = c[3][0] + c[3][1] * w[k][0] + c[3][2] * w[k][1];
      hidden[k] |= (a >= OUTSIDE) & (b >= OUTSIDE) & (d >= OUTSIDE) & (above >= 0.0);
    }
  }
}
