/* Surfaces of STEP-TAS that solids cut, by ESA STEP-TAS 6.0, tas_arm, as pycanha's reader takes it.
 *
 * Attributes (from 0): cut surface 6 what is cut, 7 tool; tool (MGM_HALF_SPACE_SOLID) 3 where it
 * stands, 4 solid, 5 sense; box and prism 1 a corner, 2 3 4 the corners that its edges lead to, of
 * a prism 2 and 3 in its base. All that are read are convex. Round ones are prisms and pyramids of
 * 72 sides whose sections have the area of the circle, a sphere has planes every 5 deg. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "geometry/patch_impl.h"
#include "geometry/step_tas_shape_impl.h"

#define TOOL    7
#define SIDES   72
#define ROWS    (SIDES / 2)
#define NEAR    1e-9 /* of the surface's size: on a plane, on an edge */
#define SLIVER  1e-7 /* twice the area over the longest edge squared: nothing */
#define CORNERS 4096 /* of a face, as OBJ takes them */

/* --- solids ---------------------------------------------------------------------------------- */

static enum um_status add_plane(struct um_context *context, struct um_geometry_tas_solid *solid,
                                struct um_vec3 normal, struct um_vec3 at)
{
  UM_TRY(um_core_reallocate(context, solid->n + 1, sizeof *solid->plane, &solid->plane));
  normal = um_vec3_unit(normal);
  solid->plane[solid->n++] = (struct um_geometry_tas_plane){normal, um_vec3_dot(normal, at)};
  return UM_OK;
}

/* A plane through `at` with `inner` behind it. */
static enum um_status add_face(struct um_context *context, struct um_geometry_tas_solid *solid,
                               struct um_vec3 normal, struct um_vec3 at, struct um_vec3 inner)
{
  bool faces = um_vec3_dot(normal, um_vec3_sub(inner, at)) < 0.0;
  return add_plane(context, solid, faces ? normal : um_vec3_scale(normal, -1.0), at);
}

/* Box and prism: corner p[0], edges to the other three. */
static enum um_status make_flat(struct um_geometry_tas *t, um_geometry_tas_item item, bool prism,
                                const struct um_geometry_tas_frame *frame,
                                struct um_geometry_tas_solid *solid)
{
  struct um_vec3 p[4], edge[3], middle;
  for (int i = 0; i < 4; i++) {
    UM_TRY(um_geometry_tas_point(t, item, 1 + i, &p[i]));
    p[i] = um_geometry_tas_move(frame, p[i]);
  }
  for (int i = 0; i < 3; i++) edge[i] = um_vec3_sub(p[i + 1], p[0]);
  double volume = um_vec3_dot(um_vec3_cross(edge[0], edge[1]), edge[2]);
  double size = um_vec3_norm(edge[0]) * um_vec3_norm(edge[1]) * um_vec3_norm(edge[2]);
  if (!(fabs(volume) > 1e-6 * size))
    return um_geometry_tas_fail(t, item, "its corners; expected: three edges that span a volume");
  middle = um_vec3_axpy(p[0], prism ? 0.25 : 0.5, um_vec3_add(edge[0], edge[1]));
  middle = um_vec3_axpy(middle, 0.5, edge[2]);
  for (int i = 0; i < 3; i++) {
    struct um_vec3 normal = um_vec3_cross(edge[(i + 1) % 3], edge[(i + 2) % 3]);
    UM_TRY(add_face(t->context, solid, normal, p[0], middle));
    if (!prism || i == 2) UM_TRY(add_face(t->context, solid, normal, p[i + 1], middle));
  }
  if (!prism) return UM_OK;
  return add_face(t->context, solid, um_vec3_cross(um_vec3_sub(edge[1], edge[0]), edge[2]), p[1],
                  middle);
}

/* A prism or pyramid of SIDES about the axis: radii at both ends, from the origin on. */
static enum um_status make_turned(struct um_context *context, const struct um_geometry_tas_shape *s,
                                  struct um_geometry_tas_solid *solid)
{
  /* inscribed circle of a polygon of the circle's area: n a^2 tan(pi / n) = pi r^2 */
  double equal = sqrt(UM_PI / (SIDES * tan(UM_PI / SIDES)));
  double low = equal * s->length[0], high = equal * s->length[s->kind == UM_TAS_CONE ? 1 : 0];
  struct um_vec3 top = um_vec3_axpy(s->point[0], s->height, s->axis);
  UM_TRY(add_plane(context, solid, um_vec3_scale(s->axis, -1.0), s->point[0]));
  UM_TRY(add_plane(context, solid, s->axis, top));
  for (int i = 0; i < SIDES; i++) {
    double angle = 2.0 * UM_PI * i / SIDES;
    struct um_vec3 out =
        um_vec3_add(um_vec3_scale(s->x, cos(angle)), um_vec3_scale(s->y, sin(angle)));
    struct um_vec3 normal = um_vec3_axpy(out, (low - high) / s->height, s->axis);
    UM_TRY(add_plane(context, solid, normal, um_vec3_axpy(s->point[0], low, out)));
  }
  return UM_OK;
}

/* Planes about as far apart everywhere, half a step h at most to either side: 1 / cos^2 of the
 * angle from the foot of the plane is 1 + 2 h^2 / 3 in the mean, which sections have as area. */
static enum um_status make_ball(struct um_context *context, const struct um_geometry_tas_shape *s,
                                struct um_geometry_tas_solid *solid)
{
  double half = UM_PI / SIDES, r = s->length[0] / sqrt(1.0 + 2.0 * half * half / 3.0);
  for (int cut = 1; cut <= 2; cut++)
    if (fabs(s->length[cut]) < s->length[0])
      UM_TRY(add_plane(context, solid, um_vec3_scale(s->axis, cut == 1 ? -1.0 : 1.0),
                       um_vec3_axpy(s->point[0], s->length[cut], s->axis)));
  for (int row = 0; row < ROWS; row++) {
    double latitude = UM_PI * ((row + 0.5) / ROWS - 0.5);
    int around = (int)ceil(SIDES * cos(latitude));
    for (int i = 0; i < around; i++) {
      double angle = 2.0 * UM_PI * i / around;
      struct um_vec3 out = um_vec3_scale(s->axis, sin(latitude));
      out = um_vec3_axpy(out, cos(latitude) * cos(angle), s->x);
      out = um_vec3_axpy(out, cos(latitude) * sin(angle), s->y);
      UM_TRY(add_plane(context, solid, out, um_vec3_axpy(s->point[0], r, out)));
    }
  }
  return UM_OK;
}

static enum um_status make_solid(struct um_geometry_tas *t, um_geometry_tas_item item,
                                 const struct um_geometry_tas_frame *frame,
                                 struct um_geometry_tas_solid *solid)
{
  struct um_geometry_tas_shape s;
  bool is, prism = um_geometry_part21_is(item->name, "MGM_SOLID_TRIANGULAR_PRISM");
  if (prism || um_geometry_part21_is(item->name, "MGM_SOLID_BOX"))
    return make_flat(t, item, prism, frame, solid);
  UM_TRY(um_geometry_tas_read_solid(t, item, &s, &is));
  if (!is)
    return um_geometry_tas_fail(t, item,
                                "is no solid that is read; expected: MGM_SOLID_BOX, "
                                "_TRIANGULAR_PRISM, _CYLINDER, _CONE, _SPHERE");
  if (!(s.sweep > 2.0 * UM_PI - 1e-6))
    return um_geometry_tas_fail(t, item, "a solid of %g deg; expected: a whole turn, 360 deg",
                                s.sweep / UM_DEG);
  s.point[0] = um_geometry_tas_move(frame, s.point[0]);
  s.x = um_mat3_apply(frame->turn, s.x);
  s.y = um_mat3_apply(frame->turn, s.y);
  s.axis = um_mat3_apply(frame->turn, s.axis);
  return s.kind == UM_TAS_SPHERE ? make_ball(t->context, &s, solid)
                                 : make_turned(t->context, &s, solid);
}

enum um_status um_geometry_tas_cut_begin(struct um_geometry_tas *t, um_geometry_tas_item of,
                                         const struct um_geometry_tas_frame *frame)
{
  um_geometry_tas_item tool, solid;
  struct um_geometry_tas_frame place;
  UM_TRY(um_geometry_tas_item_at(t, of, TOOL, "a tool", false, &tool));
  um_geometry_tas_value sense = um_geometry_tas_attribute(t, tool, 5);
  if (!um_geometry_part21_is(tool->name, "MGM_HALF_SPACE_SOLID") ||
      (sense != NULL &&
       !(sense->kind == UM_PART21_ENUM && um_geometry_part21_is(sense->text, "INSIDE"))))
    return um_geometry_tas_fail(t, tool,
                                "is no tool that is read; expected: MGM_HALF_SPACE_SOLID that "
                                "takes away what is .INSIDE.");
  UM_TRY(um_geometry_tas_item_at(t, tool, 4, "a solid", false, &solid));
  UM_TRY(um_geometry_tas_place(t, tool, 3, frame, &place));
  UM_TRY(um_core_reallocate(t->context, t->nsolid + 1, sizeof *t->solid, &t->solid));
  t->solid[t->nsolid++] = (struct um_geometry_tas_solid){NULL, 0};
  return make_solid(t, solid, &place, &t->solid[t->nsolid - 1]);
}

void um_geometry_tas_cut_end(struct um_geometry_tas *t, size_t nsolid)
{
  while (t->nsolid > nsolid) um_core_free(t->context, t->solid[--t->nsolid].plane);
}

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

/* A cut: what is left, points that it made, room for two polygons. */
struct cut {
  struct um_context *context;
  struct um_geometry_tas_pieces made; /* a point a piece */
  struct um_vec3 *in, *out;           /* [CORNERS] */
  double near;                        /* [m] */
};

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
    UM_TRY(um_geometry_tas_pieces_add(c->context, &c->made, &at, 1));
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
  if (is_apart(c, solid, p, n)) return um_geometry_tas_pieces_add(c->context, to, p, n);
  UM_CHECK(um_core_allocate(c->context, n + solid->n + 2, sizeof *rest, &rest));
  memcpy(rest, p, n * sizeof *p);
  for (size_t k = 0; k < solid->n && left > 0; k++) {
    size_t nout, nin;
    UM_CHECK(split(c, &solid->plane[k], rest, left, &nout, &nin));
    if (has_area(c->out, nout)) UM_CHECK(um_geometry_tas_pieces_add(c->context, to, c->out, nout));
    left = has_area(c->in, nin) ? nin : 0;
    memcpy(rest, c->in, left * sizeof *rest);
  }
  if (left == 0) { /* they do not meet: the polygon stays whole */
    to->n = before;
    to->ncorner = corners;
    c->made.n = c->made.ncorner = made;
    UM_CHECK(um_geometry_tas_pieces_add(c->context, to, p, n));
  }
done:
  um_core_free(c->context, rest);
  return status;
}

/* --- what is left ----------------------------------------------------------------------------- */

/* Corners of a piece with the points that the cut made on its edges: to[*n]. */
static enum um_status with_points(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                  const struct cut *c, const struct um_vec3 *p, size_t corners,
                                  struct um_vec3 *to, size_t *n)
{
  *n = 0;
  for (size_t i = 0; i < corners; i++) {
    struct um_vec3 a = p[i], edge = um_vec3_sub(p[(i + 1) % corners], a);
    double length = um_vec3_norm(edge), from = c->near;
    struct um_vec3 along = um_vec3_scale(edge, 1.0 / length);
    to[(*n)++] = a;
    for (bool found = true; found;) { /* the next point along the edge */
      double next = length - c->near;
      found = false;
      for (size_t k = 0; k < c->made.n; k++) {
        struct um_vec3 m = um_vec3_sub(c->made.corner[k], a);
        double s = um_vec3_dot(m, along);
        if (!(s > from && s < next)) continue;
        struct um_vec3 beside = um_vec3_axpy(m, -s, along);
        if (!(um_vec3_dot(beside, beside) < c->near * c->near)) continue;
        next = s;
        found = true;
      }
      if (!found) break;
      if (*n >= CORNERS)
        return um_geometry_tas_fail(t, surface,
                                    "a cut piece has more than %d corners; at most "
                                    "that many are accepted",
                                    CORNERS);
      to[(*n)++] = um_vec3_axpy(a, next, along);
      from = next + c->near;
    }
  }
  return UM_OK;
}

static enum um_status put_pieces(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                 const struct cut *c, const struct um_geometry_tas_pieces *pieces)
{
  struct um_vec3 *corner = c->in; /* split is done */
  for (size_t i = 0; i < pieces->n; i++) {
    size_t n, corners, first = t->nvertex + 1;
    const struct um_vec3 *p = piece(pieces, i, &corners);
    UM_TRY(um_core_stop_check(t->context, "a mesh was read"));
    UM_TRY(with_points(t, surface, c, p, corners, corner, &n));
    for (size_t k = 0; k < n; k++) UM_TRY(um_geometry_tas_put_vertex(t, surface, corner[k]));
    UM_TRY(um_geometry_tas_put(t, "f"));
    for (size_t k = 0; k < n; k++) UM_TRY(um_geometry_tas_put(t, " %zu", first + k));
    UM_TRY(um_geometry_tas_put(t, "\n"));
    t->nfacet += n - 2;
  }
  if (t->nfacet <= UM_GEOMETRY_MAX_FACETS) return UM_OK;
  return um_geometry_tas_fail(t, surface,
                              "more than %zu facets up to here; at most that many are "
                              "accepted",
                              UM_GEOMETRY_MAX_FACETS);
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
  struct cut c = {.context = t->context, .near = NEAR * size_of(whole)};
  UM_CHECK(um_core_allocate(t->context, CORNERS + 2, sizeof *c.in, &c.in));
  UM_CHECK(um_core_allocate(t->context, CORNERS + 2, sizeof *c.out, &c.out));
  for (size_t s = 0; s < t->nsolid; s++) {
    const struct um_geometry_tas_pieces *from = s == 0 ? whole : &now;
    for (size_t i = 0; i < from->n; i++) {
      size_t n;
      const struct um_vec3 *p = piece(from, i, &n);
      UM_CHECK(um_core_stop_check(t->context, "a mesh was read"));
      UM_CHECK(subtract(&c, &t->solid[s], p, n, &then));
    }
    struct um_geometry_tas_pieces old = now;
    now = then;
    then = old;
    then.n = then.ncorner = 0;
  }
  UM_CHECK(put_pieces(t, surface, &c, &now));
done:
  um_geometry_tas_pieces_clear(t->context, &now);
  um_geometry_tas_pieces_clear(t->context, &then);
  um_geometry_tas_pieces_clear(t->context, &c.made);
  UM_FREE(t->context, c.in, c.out);
  return status;
}
