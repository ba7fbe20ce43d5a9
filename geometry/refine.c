/* Longest-edge bisection (Rivara 1984, Int. J. Numer. Methods Eng. 20:745).
 *
 * Every edge longer than the facet size is marked; with any edge of a facet its longest one is
 * marked too: of one size for all it is longer still, of sizes by facet it is added. Every facet is
 * cut through the midpoints of its marked edges, the longest first. An edge is marked or not for
 * all facets that share it, so that no vertex ever lies inside an edge; angles stay above half the
 * smallest one of the start. Passes repeat until nothing is marked. Lengths are taken from the
 * lower vertex number to the higher, ties go by edge number: all sharers see the same. */
#include "geometry/patch_impl.h"

#include <math.h>
#include <string.h>

#include "geometry/geometry_impl.h"
#include "geometry/topology_impl.h"

struct pass {
  struct um_geometry_edges edges;
  double *length2;    /* [nedge] [m^2] */
  uint32_t *midpoint; /* [nedge] new vertex, UM_GEOMETRY_NONE where not marked */
  uint8_t *marked;    /* [nedge] */
};

static bool longer(const struct pass *pass, uint32_t e, uint32_t f)
{
  if (pass->length2[e] != pass->length2[f]) return pass->length2[e] > pass->length2[f];
  return e > f;
}

/* Which of its three edges is the longest of a facet. */
static int longest_of(const struct pass *pass, const uint32_t edge[3])
{
  int k = longer(pass, edge[1], edge[0]) ? 1 : 0;
  return longer(pass, edge[2], edge[k]) ? 2 : k;
}

/* Longest edge wanted, of all facets or of the pieces of each. */
struct wish {
  double all;            /* [m] */
  const double *of_root; /* [facets before halving] [m]; NULL: all */
};

/* One part in 1e9 of slack: a size that divides evenly is not cut once more by rounding. */
static double limit2_of(const struct wish *wish, uint32_t root)
{
  double size = wish->of_root != NULL ? wish->of_root[root] : wish->all;
  return size * size * (1.0 + 2e-9);
}

/* Marks what must be cut; false when nothing is left to do. */
static bool mark(const struct um_geometry_patch *patch, const struct wish *wish, struct pass *pass)
{
  bool any = false;
  for (size_t f = 0; f < patch->nfacet; f++)
    for (int k = 0; k < 3; k++) {
      uint32_t e = pass->edges.of_facet[f][k];
      if (!(pass->length2[e] > limit2_of(wish, patch->root[f]))) continue;
      pass->marked[e] = 1;
      any = true;
    }
  for (bool more = any && wish->of_root != NULL; more;) {
    more = false;
    for (size_t f = 0; f < patch->nfacet; f++) {
      const uint32_t *edge = pass->edges.of_facet[f];
      uint32_t longest = edge[longest_of(pass, edge)];
      if (pass->marked[longest]) continue;
      if (!pass->marked[edge[0]] && !pass->marked[edge[1]] && !pass->marked[edge[2]]) continue;
      pass->marked[longest] = 1;
      more = true;
    }
  }
  return any;
}

static enum um_status pass_create(const struct um_geometry_patch *patch, struct pass *pass)
{
  struct um_context *context = patch->context;
  memset(pass, 0, sizeof *pass);
  UM_TRY(um_geometry_edges_create(context, (const uint32_t(*)[3])patch->corner, patch->nfacet,
                                  &pass->edges));
  size_t n = pass->edges.nedge;
  UM_TRY(um_core_allocate(context, n, sizeof *pass->length2, (void *)&pass->length2));
  UM_TRY(um_core_allocate(context, n, sizeof *pass->midpoint, (void *)&pass->midpoint));
  UM_TRY(um_core_allocate(context, n, sizeof *pass->marked, (void *)&pass->marked));
  for (size_t e = 0; e < n; e++) {
    struct um_vec3 d =
        um_vec3_sub(patch->vertex[pass->edges.edge[e].b], patch->vertex[pass->edges.edge[e].a]);
    pass->length2[e] = um_vec3_dot(d, d);
    pass->midpoint[e] = UM_GEOMETRY_NONE;
  }
  return UM_OK;
}

static void pass_destroy(struct um_context *context, struct pass *pass)
{
  um_geometry_edges_destroy(context, &pass->edges);
  UM_FREE(context, pass->length2, pass->midpoint, pass->marked);
}

static enum um_status add_midpoints(struct um_geometry_patch *patch, struct pass *pass)
{
  for (size_t e = 0; e < pass->edges.nedge; e++) {
    if (!pass->marked[e]) continue;
    struct um_vec3 a = patch->vertex[pass->edges.edge[e].a];
    struct um_vec3 b = patch->vertex[pass->edges.edge[e].b];
    struct um_vec3 middle = um_vec3_scale(um_vec3_add(a, b), 0.5);
    UM_TRY(um_geometry_patch_vertex(patch, middle, &pass->midpoint[e]));
  }
  return UM_OK;
}

/* Cuts facet f in 2 to 4; the first child takes its place. */
static enum um_status cut(struct um_geometry_patch *patch, const struct pass *pass, size_t f)
{
  const uint32_t *edge = pass->edges.of_facet[f];
  int k = longest_of(pass, edge);
  uint32_t a = patch->corner[f][k], b = patch->corner[f][(k + 1) % 3],
           c = patch->corner[f][(k + 2) % 3];
  uint32_t ab = pass->midpoint[edge[k]];
  if (ab == UM_GEOMETRY_NONE) return UM_OK;
  uint32_t bc = pass->midpoint[edge[(k + 1) % 3]], ca = pass->midpoint[edge[(k + 2) % 3]];
  uint32_t group = patch->group[f];
  int line = patch->line[f];
  size_t before = patch->nfacet;
  /* the half at a, with c and the midpoint */
  uint32_t first[3] = {a, ab, ca == UM_GEOMETRY_NONE ? c : ca};
  memcpy(patch->corner[f], first, sizeof first);
  if (ca != UM_GEOMETRY_NONE) UM_TRY(um_geometry_patch_facet(patch, ca, ab, c, group, line));
  /* the half at b */
  if (bc == UM_GEOMETRY_NONE) {
    UM_TRY(um_geometry_patch_facet(patch, ab, b, c, group, line));
  } else {
    UM_TRY(um_geometry_patch_facet(patch, ab, b, bc, group, line));
    UM_TRY(um_geometry_patch_facet(patch, ab, bc, c, group, line));
  }
  for (size_t i = before; i < patch->nfacet; i++) patch->root[i] = patch->root[f];
  return UM_OK;
}

static enum um_status cut_all(struct um_geometry_patch *patch, const struct wish *wish)
{
  for (bool more = true; more;) {
    enum um_status status;
    struct pass pass;
    UM_TRY(um_core_stop_check(patch->context, "facets were refined"));
    UM_CHECK(pass_create(patch, &pass));
    size_t nfacet = patch->nfacet;
    more = mark(patch, wish, &pass);
    if (more) UM_CHECK(add_midpoints(patch, &pass));
    for (size_t f = 0; more && f < nfacet; f++) UM_CHECK(cut(patch, &pass, f));
  done:
    pass_destroy(patch->context, &pass);
    UM_TRY(status);
  }
  return UM_OK;
}

enum um_status um_geometry_refine(struct um_geometry_patch *patch, const char *part,
                                  double facet_size)
{
  if (!(facet_size > 0.0)) return UM_OK;
  double area = 0.0;
  for (size_t f = 0; f < patch->nfacet; f++)
    area += 0.5 * um_vec3_norm(um_geometry_cross_of(patch->vertex, patch->corner[f]));
  /* an equilateral facet of that size has area sqrt(3)/4 of its square: no fewer facets can do */
  double least = area / (0.25 * sqrt(3.0) * facet_size * facet_size);
  if (!(least <= (double)UM_GEOMETRY_MAX_FACETS))
    return um_core_fail(patch->context, UM_ERR_INPUT,
                        "part '%s': a facet size of %g m needs at least %.3g facets; at most %zu "
                        "are accepted",
                        part, facet_size, least, UM_GEOMETRY_MAX_FACETS);
  const struct wish wish = {.all = facet_size};
  return cut_all(patch, &wish);
}

enum um_status um_geometry_halve(struct um_geometry_patch *patch, const char *part,
                                 const struct um_geometry_halving *halving)
{
  enum um_status status;
  size_t n = patch->nfacet;
  double *size = NULL;
  if (halving->nfacet != n)
    return um_core_fail(patch->context, UM_ERR_INPUT,
                        "part '%s': halvings are of %zu facets, but it has %zu; accepted: "
                        "thermal.facets made anew at this facet_size_m, or '' for none",
                        part, halving->nfacet, n);
  UM_CHECK(um_core_allocate(patch->context, n, sizeof *size, &size));
  for (size_t f = 0; f < n; f++) {
    patch->root[f] = (uint32_t)f;
    size[f] = INFINITY;
  }
  for (size_t i = 0; i < halving->nhalved; i++) {
    uint32_t f = halving->facet[i];
    double longest2 = 0.0;
    if (f >= n) {
      status =
          um_core_fail(patch->context, UM_ERR_INPUT,
                       "part '%s': facet %lu is halved, but it has %zu", part, (unsigned long)f, n);
      goto done;
    }
    for (int k = 0; k < 3; k++) {
      struct um_vec3 d = um_vec3_sub(patch->vertex[patch->corner[f][(k + 1) % 3]],
                                     patch->vertex[patch->corner[f][k]]);
      longest2 = fmax(longest2, um_vec3_dot(d, d));
    }
    size[f] = 0.5 * sqrt(longest2);
  }
  const struct wish wish = {.of_root = size};
  UM_CHECK(cut_all(patch, &wish));
done:
  um_core_free(patch->context, size);
  return status;
}
