/* Surfaces of STEP-TAS that solids cut: facets, and what plane after plane of a solid leaves of
 * them (Sutherland & Hodgman 1974, both parts being kept). */
#include <math.h>
#include <string.h>

#include "geometry/patch_impl.h"
#include "geometry/step_tas_impl.h"

#define NEAR   1e-9 /* of the surface's size: on a plane, on an edge */
#define SLIVER 1e-7 /* twice the area over the longest edge squared: nothing */
/* Facets of a surface that is cut: every edge is held against every point of a cut. */
#define FACETS  20000
#define CORNERS 4096 /* of a face, as OBJ takes them */

/* --- pieces ---------------------------------------------------------------------------------- */

enum um_status um_geometry_tas_pieces_add(struct um_context *context,
                                          struct um_geometry_tas_pieces *pieces,
                                          const struct um_vec3 *corner, size_t n)
{
  if (pieces->ncorner + n > pieces->corner_capacity) {
    size_t capacity = 2 * pieces->corner_capacity + n + 64;
    UM_TRY(um_core_reallocate(context, capacity, sizeof *pieces->corner, &pieces->corner));
    pieces->corner_capacity = capacity;
  }
  if (pieces->n == pieces->capacity) {
    size_t capacity = 2 * pieces->capacity + 16;
    UM_TRY(um_core_reallocate(context, capacity, sizeof *pieces->end, &pieces->end));
    pieces->capacity = capacity;
  }
  memcpy(pieces->corner + pieces->ncorner, corner, n * sizeof *corner);
  pieces->ncorner += n;
  pieces->end[pieces->n++] = pieces->ncorner;
  return UM_OK;
}

void um_geometry_tas_pieces_clear(struct um_context *context, struct um_geometry_tas_pieces *pieces)
{
  UM_FREE(context, pieces->corner, pieces->end);
  *pieces = (struct um_geometry_tas_pieces){0};
}

static const struct um_vec3 *piece(const struct um_geometry_tas_pieces *pieces, size_t i, size_t *n)
{
  size_t first = i == 0 ? 0 : pieces->end[i - 1];
  *n = pieces->end[i] - first;
  return pieces->corner + first;
}

/* A cut: points that it made, room for two polygons, which a split makes one corner longer. */
struct cut {
  const struct um_geometry_tas *t;
  um_geometry_tas_item surface;       /* for messages */
  struct um_geometry_tas_pieces made; /* a point a piece */
  struct um_vec3 *in, *out;           /* [CORNERS] */
  double near;                        /* [m] */
};

static enum um_status check_corners(const struct cut *c, size_t n)
{
  if (n < CORNERS) return UM_OK;
  return um_geometry_tas_fail(c->t, c->surface,
                              "a cut piece of %zu corners; accepted: fewer than %d", n, CORNERS);
}

static bool has_area(const struct um_vec3 *p, size_t n)
{
  struct um_vec3 sum = um_vec3(0, 0, 0);
  double longest = 0.0;
  for (size_t i = 0; i < n; i++) {
    struct um_vec3 edge = um_vec3_sub(p[(i + 1) % n], p[i]);
    longest = fmax(longest, um_vec3_dot(edge, edge));
    if (i > 0 && i + 1 < n)
      sum = um_vec3_add(sum, um_vec3_cross(um_vec3_sub(p[i], p[0]), um_vec3_sub(p[i + 1], p[0])));
  }
  return n >= 3 && um_vec3_norm(sum) > SLIVER * longest;
}

static double above(const struct um_geometry_tas_plane *plane, struct um_vec3 p)
{
  return um_vec3_dot(plane->normal, p) - plane->offset;
}

/* Where a plane cuts an edge, of which both faces make the same point: from the end below it. */
static struct um_vec3 crossing(struct um_vec3 a, double high, struct um_vec3 b, double low)
{
  return um_vec3_axpy(b, low / (low - high), um_vec3_sub(a, b));
}

/* Parts of a convex polygon above and below a plane: c->out[*nout], c->in[*nin]. */
static enum um_status split(struct cut *c, const struct um_geometry_tas_plane *plane,
                            const struct um_vec3 *p, size_t n, size_t *nout, size_t *nin)
{
  *nout = *nin = 0;
  for (size_t i = 0; i < n; i++) {
    struct um_vec3 a = p[i], b = p[(i + 1) % n];
    double x = above(plane, a), y = above(plane, b);
    if (x > -c->near) c->out[(*nout)++] = a;
    if (x < c->near) c->in[(*nin)++] = a;
    if (!(fabs(x) > c->near && fabs(y) > c->near && (x > 0.0) != (y > 0.0))) continue;
    struct um_vec3 at = x > 0.0 ? crossing(a, x, b, y) : crossing(b, y, a, x);
    c->out[(*nout)++] = at;
    c->in[(*nin)++] = at;
    UM_TRY(um_geometry_tas_pieces_add(c->t->context, &c->made, &at, 1));
  }
  return UM_OK;
}

/* Is all of a polygon on the outer side of one plane? */
static bool is_apart(const struct cut *c, const struct um_geometry_tas_solid *solid,
                     const struct um_vec3 *p, size_t n)
{
  for (size_t k = 0; k < solid->n; k++) {
    size_t i = 0;
    while (i < n && above(&solid->plane[k], p[i]) > -c->near) i++;
    if (i == n) return true;
  }
  return false;
}

/* What a solid leaves of a polygon: plane by plane the part above is kept, the part below goes on.
 */
static enum um_status subtract(struct cut *c, const struct um_geometry_tas_solid *solid,
                               const struct um_vec3 *p, size_t n, struct um_geometry_tas_pieces *to)
{
  enum um_status status = UM_OK;
  struct um_vec3 *rest = NULL;
  size_t left = n, before = to->n, corners = to->ncorner, made = c->made.n;
  if (is_apart(c, solid, p, n)) return um_geometry_tas_pieces_add(c->t->context, to, p, n);
  UM_CHECK(um_core_allocate(c->t->context, n + solid->n + 2, sizeof *rest, &rest));
  memcpy(rest, p, n * sizeof *p);
  for (size_t k = 0; k < solid->n && left > 0; k++) {
    size_t nout, nin;
    UM_CHECK(check_corners(c, left));
    UM_CHECK(split(c, &solid->plane[k], rest, left, &nout, &nin));
    if (has_area(c->out, nout))
      UM_CHECK(um_geometry_tas_pieces_add(c->t->context, to, c->out, nout));
    left = has_area(c->in, nin) ? nin : 0;
    memcpy(rest, c->in, left * sizeof *rest);
  }
  if (left == 0) { /* they do not meet: the polygon stays whole */
    to->n = before;
    to->ncorner = corners;
    c->made.n = c->made.ncorner = made;
    UM_CHECK(um_geometry_tas_pieces_add(c->t->context, to, p, n));
  }
done:
  um_core_free(c->t->context, rest);
  return status;
}

/* --- what is left ----------------------------------------------------------------------------- */

/* The point that the cut made on an edge, from a along a unit vector, next behind a place: how far
 * it is from a; `to` where there is none. */
static double next_point(const struct cut *c, struct um_vec3 a, struct um_vec3 along, double from,
                         double to)
{
  for (size_t k = 0; k < c->made.n; k++) {
    struct um_vec3 m = um_vec3_sub(c->made.corner[k], a);
    double s = um_vec3_dot(m, along);
    if (!(s > from && s < to)) continue;
    struct um_vec3 beside = um_vec3_axpy(m, -s, along);
    if (um_vec3_dot(beside, beside) < c->near * c->near) to = s;
  }
  return to;
}

/* Corners of a piece with the points that the cut made on its edges: to[*n], room for CORNERS. */
static enum um_status with_points(const struct cut *c, const struct um_vec3 *p, size_t corners,
                                  struct um_vec3 *to, size_t *n)
{
  *n = 0;
  for (size_t i = 0; i < corners; i++) {
    struct um_vec3 a = p[i], edge = um_vec3_sub(p[(i + 1) % corners], a);
    double length = um_vec3_norm(edge);
    struct um_vec3 along = um_vec3_scale(edge, 1.0 / length);
    for (double at = 0.0; at < length - c->near;) {
      UM_TRY(check_corners(c, *n));
      to[(*n)++] = um_vec3_axpy(a, at, along);
      at = next_point(c, a, along, at + c->near, length - c->near);
    }
  }
  return UM_OK;
}

static enum um_status check_facets(const struct um_geometry_tas *t, um_geometry_tas_item surface,
                                   size_t n)
{
  if (n <= UM_GEOMETRY_MAX_FACETS) return UM_OK;
  return um_geometry_tas_fail(t, surface, "more than %zu facets up to here; accepted: no more",
                              UM_GEOMETRY_MAX_FACETS);
}

static enum um_status put_pieces(struct um_geometry_tas *t, const struct cut *c,
                                 const struct um_geometry_tas_pieces *pieces)
{
  struct um_vec3 *corner = c->in; /* split is done */
  for (size_t i = 0; i < pieces->n; i++) {
    size_t n, corners, first = t->nvertex + 1;
    const struct um_vec3 *p = piece(pieces, i, &corners);
    UM_TRY(um_core_stop_check(t->context, "a mesh was read"));
    UM_TRY(with_points(c, p, corners, corner, &n));
    if (n < 3) continue; /* all but a point or a line of it is nearer than can be told apart */
    for (size_t k = 0; k < n; k++) UM_TRY(um_geometry_tas_put_vertex(t, c->surface, corner[k]));
    UM_TRY(um_geometry_tas_put(t, "f"));
    for (size_t k = 0; k < n; k++) UM_TRY(um_geometry_tas_put(t, " %zu", first + k));
    UM_TRY(um_geometry_tas_put(t, "\n"));
    t->nfacet += n - 2;
  }
  return check_facets(t, c->surface, t->nfacet);
}

static double size_of(const struct um_geometry_tas_pieces *pieces)
{
  double size = 0.0;
  for (size_t i = 1; i < pieces->ncorner; i++)
    size = fmax(size, um_vec3_norm(um_vec3_sub(pieces->corner[i], pieces->corner[0])));
  return size;
}

enum um_status um_geometry_tas_put_cut(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                       const struct um_geometry_tas_pieces *whole)
{
  enum um_status status;
  struct um_geometry_tas_pieces now = {0}, then = {0};
  struct cut c = {.t = t, .surface = surface, .near = NEAR * size_of(whole)};
  if (whole->n > FACETS)
    return um_geometry_tas_fail(t, surface, "a cut surface of %zu facets; accepted: at most %d",
                                whole->n, FACETS);
  UM_CHECK(um_core_allocate(t->context, CORNERS + 2, sizeof *c.in, &c.in));
  UM_CHECK(um_core_allocate(t->context, CORNERS + 2, sizeof *c.out, &c.out));
  for (size_t s = 0; s < t->nsolid; s++) {
    const struct um_geometry_tas_pieces *from = s == 0 ? whole : &now;
    for (size_t i = 0; i < from->n; i++) {
      size_t n;
      const struct um_vec3 *p = piece(from, i, &n);
      UM_CHECK(um_core_stop_check(t->context, "a mesh was read"));
      UM_CHECK(subtract(&c, &t->solid[s], p, n, &then));
      UM_CHECK(check_facets(t, surface, then.n));
    }
    struct um_geometry_tas_pieces old = now;
    now = then;
    then = old;
    then.n = then.ncorner = 0;
  }
  UM_CHECK(put_pieces(t, &c, &now));
done:
  um_geometry_tas_pieces_clear(t->context, &now);
  um_geometry_tas_pieces_clear(t->context, &then);
  um_geometry_tas_pieces_clear(t->context, &c.made);
  UM_FREE(t->context, c.in, c.out);
  return status;
}
