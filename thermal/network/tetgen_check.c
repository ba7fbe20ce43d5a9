/* What TetGen cannot stand, refused in the user's words: coordinates that are not numbers, indices
 * out of range, coincident vertices, facets without area, open or non-manifold edges, neighbours
 * of opposite orientation, surfaces turned inside out. Cavities (parts of the surface that face
 * inward) get a seed so that they stay empty. */

#include "base/core/sort.h"
#include "thermal/network/tetgen_check_impl.h"

#define TOLERANCE 1e-9 /* of the size of the body: below TetGen's own 1e-8 */

struct edge {
  uint32_t low, high;
  int forward; /* the facet runs from low to high */
};
struct ranked {
  double key;
  uint32_t vertex;
};

static int edge_order(const void *a, const void *b)
{
  const struct edge *x = a, *y = b;
  if (x->low != y->low) return x->low < y->low ? -1 : 1;
  if (x->high != y->high) return x->high < y->high ? -1 : 1;
  return x->forward - y->forward;
}

static int rank_order(const void *a, const void *b)
{
  const struct ranked *x = a, *y = b;
  if (x->key != y->key) return x->key < y->key ? -1 : 1;
  return x->vertex < y->vertex ? -1 : x->vertex > y->vertex;
}

static enum um_status check_numbers(struct um_context *context, struct um_thermal_tetgen_surface *s)
{
  struct um_vec3 low = um_vec3(INFINITY, INFINITY, INFINITY), high = um_vec3_scale(low, -1.0);
  if (s->nvertex < 4 || s->nfacet < 4 || s->nvertex > INT32_MAX / 3 || s->nfacet > INT32_MAX / 3)
    return um_core_fail(context, UM_ERR_INPUT,
                        "part %s: %zu vertices and %zu facets do not enclose a volume; accepted: 4 "
                        "or more of each",
                        s->name, s->nvertex, s->nfacet);
  for (size_t v = 0; v < s->nvertex; v++) {
    struct um_vec3 p = s->vertex[v];
    if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z))
      return um_core_fail(context, UM_ERR_INPUT,
                          "part %s: vertex %zu at (%g, %g, %g) m is not a point; accepted: finite "
                          "coordinates",
                          s->name, v, p.x, p.y, p.z);
    low = um_vec3(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
    high = um_vec3(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
  }
  s->size = um_vec3_norm(um_vec3_sub(high, low));
  for (size_t f = 0; f < s->nfacet; f++) {
    const uint32_t *c = s->facet[f];
    if (c[0] >= s->nvertex || c[1] >= s->nvertex || c[2] >= s->nvertex)
      return um_core_fail(context, UM_ERR_INPUT,
                          "part %s: facet %zu names vertex %u %u %u; accepted: below %zu", s->name,
                          f, (unsigned)c[0], (unsigned)c[1], (unsigned)c[2], s->nvertex);
    struct um_vec3 a = um_vec3_sub(s->vertex[c[1]], s->vertex[c[0]]);
    struct um_vec3 b = um_vec3_sub(s->vertex[c[2]], s->vertex[c[0]]);
    double longest = fmax(fmax(um_vec3_norm(a), um_vec3_norm(b)), um_vec3_norm(um_vec3_sub(a, b)));
    /* the height over the longest edge is what is left of a sliver */
    if (!(um_vec3_norm(um_vec3_cross(a, b)) > TOLERANCE * s->size * longest))
      return um_core_fail(context, UM_ERR_INPUT,
                          "part %s: facet %zu (vertices %u %u %u) has no area; accepted: triangles",
                          s->name, f, (unsigned)c[0], (unsigned)c[1], (unsigned)c[2]);
  }
  return UM_OK;
}

/* Sorted along an oblique line, so that the points of a plane face do not share a rank. */
static enum um_status check_distinct(struct um_context *context,
                                     const struct um_thermal_tetgen_surface *s)
{
  struct ranked *rank;
  UM_TRY(um_core_allocate(context, s->nvertex, sizeof *rank, &rank));
  struct um_vec3 along = um_vec3_unit(um_vec3(1.0, 0.754877666, 0.569840291));
  for (size_t v = 0; v < s->nvertex; v++)
    rank[v] = (struct ranked){um_vec3_dot(along, s->vertex[v]), (uint32_t)v};
  enum um_status status = um_core_sort(context, rank, s->nvertex, sizeof *rank, rank_order);
  double gap = TOLERANCE * s->size;
  for (size_t i = 0; i < s->nvertex && status == UM_OK; i++)
    for (size_t j = i + 1; j < s->nvertex && rank[j].key - rank[i].key <= gap; j++) {
      struct um_vec3 p = s->vertex[rank[i].vertex], q = s->vertex[rank[j].vertex];
      if (um_vec3_norm(um_vec3_sub(p, q)) > gap) continue;
      status =
          um_core_fail(context, UM_ERR_INPUT,
                       "part %s: vertices %u and %u coincide at (%g, %g, %g) m; accepted: "
                       "distinct vertices",
                       s->name, (unsigned)rank[i].vertex, (unsigned)rank[j].vertex, p.x, p.y, p.z);
      break;
    }
  um_core_free(context, rank);
  return status;
}

static enum um_status fail_edge(struct um_context *context,
                                const struct um_thermal_tetgen_surface *s, const struct edge *e,
                                size_t count)
{
  struct um_vec3 p = s->vertex[e->low], q = s->vertex[e->high];
  const char *what = count == 1   ? "is open (one facet)"
                     : count == 2 ? "joins two facets that face opposite ways"
                                  : "joins more than two facets";
  return um_core_fail(
      context, UM_ERR_INPUT,
      "part %s: the surface %s at the edge (%g, %g, %g) - (%g, %g, %g) m; accepted: "
      "a closed surface, every edge in two facets",
      s->name, what, p.x, p.y, p.z, q.x, q.y, q.z);
}

static enum um_status check_closed(struct um_context *context,
                                   const struct um_thermal_tetgen_surface *s)
{
  struct edge *edge;
  size_t n = 3 * s->nfacet;
  UM_TRY(um_core_allocate(context, n, sizeof *edge, &edge));
  for (size_t i = 0; i < n; i++) {
    uint32_t a = s->facet[i / 3][i % 3], b = s->facet[i / 3][(i + 1) % 3];
    edge[i] = a < b ? (struct edge){a, b, 1} : (struct edge){b, a, 0};
  }
  enum um_status status = um_core_sort(context, edge, n, sizeof *edge, edge_order);
  for (size_t i = 0, next; i < n && status == UM_OK; i = next) {
    size_t forward = 0;
    for (next = i; next < n && edge[next].low == edge[i].low && edge[next].high == edge[i].high;
         next++)
      forward += (size_t)edge[next].forward;
    if (next - i != 2 || forward != 1) status = fail_edge(context, s, &edge[i], next - i);
  }
  um_core_free(context, edge);
  return status;
}

static uint32_t root(uint32_t *parent, uint32_t v)
{
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

/* Enclosed volume of every connected piece (at the root of its vertices), by the divergence
 * theorem: sum of v0 . (v1 x v2) / 6, from the first vertex of the body. */
static void add_volumes(const struct um_thermal_tetgen_surface *s, uint32_t *parent, double *volume,
                        double *area, uint32_t *largest)
{
  for (uint32_t v = 0; v < s->nvertex; v++) parent[v] = v;
  for (size_t f = 0; f < s->nfacet; f++)
    for (int c = 1; c < 3; c++) parent[root(parent, s->facet[f][c])] = root(parent, s->facet[f][0]);
  for (size_t f = 0; f < s->nfacet; f++) {
    struct um_vec3 p[3];
    for (int c = 0; c < 3; c++) p[c] = um_vec3_sub(s->vertex[s->facet[f][c]], s->vertex[0]);
    uint32_t r = root(parent, s->facet[f][0]);
    volume[r] += um_vec3_dot(p[0], um_vec3_cross(p[1], p[2])) / 6.0;
    double a = um_vec3_norm(um_vec3_cross(um_vec3_sub(p[1], p[0]), um_vec3_sub(p[2], p[0])));
    if (!(a > area[r])) continue;
    area[r] = a;
    largest[r] = (uint32_t)f;
  }
}

/* A point just before the largest facet of a piece that faces inward lies in the cavity. */
static void add_hole(struct um_thermal_tetgen_surface *s, uint32_t facet)
{
  struct um_vec3 p[3], centre = um_vec3(0, 0, 0);
  for (int c = 0; c < 3; c++) {
    p[c] = s->vertex[s->facet[facet][c]];
    centre = um_vec3_axpy(centre, 1.0 / 3.0, p[c]);
  }
  struct um_vec3 n = um_vec3_cross(um_vec3_sub(p[1], p[0]), um_vec3_sub(p[2], p[0]));
  centre = um_vec3_axpy(centre, 1e-3 / sqrt(um_vec3_norm(n)), n);
  s->hole[3 * s->nhole] = centre.x;
  s->hole[3 * s->nhole + 1] = centre.y;
  s->hole[3 * s->nhole + 2] = centre.z;
  s->nhole++;
}

static enum um_status check_volume(struct um_context *context, struct um_thermal_tetgen_surface *s)
{
  uint32_t *parent = NULL, *largest = NULL;
  double *volume = NULL, *area = NULL;
  enum um_status status;
  UM_CHECK(um_core_allocate(context, s->nvertex, sizeof *parent, &parent));
  UM_CHECK(um_core_allocate(context, s->nvertex, sizeof *largest, &largest));
  UM_CHECK(um_core_allocate(context, s->nvertex, sizeof *volume, &volume));
  UM_CHECK(um_core_allocate(context, s->nvertex, sizeof *area, &area));
  add_volumes(s, parent, volume, area, largest);
  size_t nhole = 0;
  for (size_t v = 0; v < s->nvertex; v++) {
    s->volume += volume[v];
    if (volume[v] < 0.0) nhole++;
    if (parent[v] == v && area[v] == 0.0) {
      status = um_core_fail(context, UM_ERR_INPUT,
                            "part %s: vertex %zu belongs to no facet; accepted: vertices of facets",
                            s->name, v);
      goto done;
    }
  }
  if (!(s->volume > 0.0)) {
    status = um_core_fail(context, UM_ERR_INPUT,
                          "part %s: its facets enclose %g m3, they face inward; accepted: facets "
                          "counter-clockwise seen from outside",
                          s->name, s->volume);
    goto done;
  }
  UM_CHECK(um_core_allocate(context, 3 * nhole, sizeof *s->hole, &s->hole));
  for (size_t v = 0; v < s->nvertex; v++)
    if (volume[v] < 0.0) add_hole(s, largest[v]);
done:
  UM_FREE(context, parent, largest, volume, area);
  return status;
}

enum um_status um_thermal_tetgen_check(struct um_context *context,
                                       struct um_thermal_tetgen_surface *surface)
{
  UM_TRY(check_numbers(context, surface));
  UM_TRY(check_distinct(context, surface));
  UM_TRY(check_closed(context, surface));
  return check_volume(context, surface);
}

/* Does the segment pq pass through the triangle? */
static bool pierces(struct um_vec3 p, struct um_vec3 q, const struct um_vec3 t[3])
{
  struct um_vec3 n = um_vec3_cross(um_vec3_sub(t[1], t[0]), um_vec3_sub(t[2], t[0]));
  double a = um_vec3_dot(n, um_vec3_sub(p, t[0])), b = um_vec3_dot(n, um_vec3_sub(q, t[0]));
  if (!(a * b <= 0.0) || a == b) return false;
  struct um_vec3 x = um_vec3_axpy(p, a / (a - b), um_vec3_sub(q, p));
  for (int c = 0; c < 3; c++) {
    struct um_vec3 side = um_vec3_sub(t[(c + 1) % 3], t[c]);
    if (um_vec3_dot(n, um_vec3_cross(side, um_vec3_sub(x, t[c]))) < 0.0) return false;
  }
  return true;
}

static bool cross(const struct um_thermal_tetgen_surface *s, const uint32_t *f, const uint32_t *g)
{
  struct um_vec3 a[3], b[3];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      if (f[i] == g[j]) return false; /* neighbours */
  for (int i = 0; i < 3; i++) {
    a[i] = s->vertex[f[i]];
    b[i] = s->vertex[g[i]];
  }
  for (int e = 0; e < 3; e++)
    if (pierces(a[e], a[(e + 1) % 3], b) || pierces(b[e], b[(e + 1) % 3], a)) return true;
  return false;
}

void um_thermal_tetgen_crossing(const struct um_thermal_tetgen_surface *surface, const int *flagged,
                                size_t nflagged, uint32_t pair[2])
{
  pair[0] = (uint32_t)flagged[0];
  pair[1] = (uint32_t)flagged[nflagged - 1];
  for (size_t i = 0; i < nflagged; i++)
    for (size_t j = i + 1; j < nflagged; j++)
      if (cross(surface, surface->facet[flagged[i]], surface->facet[flagged[j]])) {
        pair[0] = (uint32_t)flagged[i];
        pair[1] = (uint32_t)flagged[j];
        return;
      }
}
