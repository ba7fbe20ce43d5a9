/* Surfaces of STEP-TAS as facets, by ESA STEP-TAS 6.0, tas_arm, as pycanha's reader takes it.
 *
 * A surface is p(u, v), u and v from 0 to 1, cut by its two grids. Planes: bilinear between
 * corners, u toward the second, v toward the last; a triangle is u = 0 at its first corner, u = 1
 * along the edge opposite. Round ones: u along the axis, or outward on a disc, or by latitude on a
 * sphere; v about the axis from the start to the end angle. Side 1 is that of (p2 - p1) x (p3 - p1)
 * of planes, a disc's along its axis, that away from the axis of others: the convex one of a
 * paraboloid.
 *
 * Attributes (from 0) of the surface: 6 shape, 16 17 numbers of faces, 20 21 grids. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "geometry/patch_impl.h"
#include "geometry/step_tas_shape_impl.h"

#define SHAPE 6
#define COUNT 16
#define GRID  20
#define POLE  1e-7 /* of the radius: a circle this small is a point */

/* Where a surface is cut: grid lines, and lines between them on round ones. */
struct lines {
  double *at; /* [n] */
  size_t n;
};

static double mix(double a, double b, double t) { return a + t * (b - a); }

/* Radius and height at u; a circle that is a point has radius 0. */
static void profile(const struct um_geometry_tas_shape *s, double u, double *r, double *z)
{
  const double *l = s->length;
  double largest = l[0];
  *r = l[0];
  *z = s->kind == UM_TAS_DISC ? 0.0 : u * s->height;
  if (s->kind == UM_TAS_DISC || s->kind == UM_TAS_CONE) {
    *r = mix(l[0], l[1], u);
    largest = fmax(l[0], l[1]);
  } else if (s->kind == UM_TAS_SPHERE) {
    double latitude = mix(asin(l[1] / l[0]), asin(l[2] / l[0]), u);
    *r = l[0] * cos(latitude);
    *z = l[0] * sin(latitude);
  } else if (s->kind == UM_TAS_PARABOLOID) {
    *z = mix(l[1], s->height, u);
    *r = l[0] * sqrt(*z / s->height);
  }
  if (!(*r > POLE * largest)) *r = 0.0;
}

/* Is the line of this u a point? */
static bool is_pole(const struct um_geometry_tas_shape *s, double u)
{
  double r = 1.0, z;
  if (s->kind >= UM_TAS_DISC) profile(s, u, &r, &z);
  return s->kind == UM_TAS_TRIANGLE ? u == 0.0 : r == 0.0;
}

static struct um_vec3 point_at(const struct um_geometry_tas_shape *s, double u, double v)
{
  if (s->kind < UM_TAS_DISC) {
    const struct um_vec3 *p = s->point;
    return um_vec3_add(
        um_vec3_add(um_vec3_scale(p[0], (1 - u) * (1 - v)), um_vec3_scale(p[1], u * (1 - v))),
        um_vec3_add(um_vec3_scale(p[2], u * v), um_vec3_scale(p[3], (1 - u) * v)));
  }
  double r, z, angle = s->start + v * s->sweep;
  profile(s, u, &r, &z);
  struct um_vec3 p = um_vec3_axpy(s->point[0], r * cos(angle), s->x);
  return um_vec3_axpy(um_vec3_axpy(p, r * sin(angle), s->y), z, s->axis);
}

/* How far along a paraboloid's meridian u is, in steps that leave gaps of one share. With x = dz/dr
 * = 2 c r, c = H / R^2, a chord over dr leaves the meridian by 2 c dr^2 / (8 sqrt(1 + x^2)). The
 * radius of curvature across is sqrt(1 + x^2) / (2 c). Their ratio, dx^2 / (8 (1 + x^2)), is that
 * of a circle cut at angles of d(asinh x). */
static double dish_step(const struct um_geometry_tas_shape *s, double u)
{
  double r, z;
  profile(s, u, &r, &z);
  return asinh(2.0 * s->height * r / (s->length[0] * s->length[0]));
}

/* Facets that a step from a to b of u or v is cut into. */
static double pieces(const struct um_geometry_tas_shape *s, bool around, double a, double b)
{
  double turned = 0.0; /* [rad] */
  if (s->kind >= UM_TAS_DISC && around) {
    turned = (b - a) * s->sweep;
  } else if (s->kind == UM_TAS_SPHERE) {
    turned = (b - a) * (asin(s->length[2] / s->length[0]) - asin(s->length[1] / s->length[0]));
  } else if (s->kind == UM_TAS_PARABOLOID) {
    turned = dish_step(s, b) - dish_step(s, a);
  }
  return fmax(1.0, fmin(ceil(turned / UM_TAS_STEP - 1e-9), UM_TAS_FACES)); /* of NaN: many */
}

/* The line at a share k of the way from a to b. */
static double line_between(const struct um_geometry_tas_shape *s, bool around, double a, double b,
                           double k)
{
  if (s->kind != UM_TAS_PARABOLOID || around) return mix(a, b, k);
  double low = s->length[1], slope = sinh(mix(dish_step(s, a), dish_step(s, b), k));
  double share = slope * s->length[0] / (2.0 * s->height); /* r / R */
  return (s->height * share * share - low) / (s->height - low);
}

/* Positions of the file, from 0 to 1, or equal ones: cut [*ncell + 1]; the caller frees. */
static enum um_status read_grid(const struct um_geometry_tas *t, um_geometry_tas_item surface,
                                int way, double **cut, size_t *ncell)
{
  double count = 1.0;
  uint32_t next = 0, end = 0;
  size_t n = 0;
  if (um_geometry_tas_attribute(t, surface, COUNT + way) != NULL)
    UM_TRY(um_geometry_tas_number(t, surface, COUNT + way, &count));
  if (!(count >= 1.0 && count <= UM_TAS_FACES && count == floor(count)))
    return um_geometry_tas_fail(t, surface, "%g faces in a direction; accepted: 1 to %d", count,
                                UM_TAS_FACES);
  *ncell = (size_t)count;
  UM_TRY(um_core_allocate(t->context, *ncell + 1, sizeof **cut, cut));
  for (size_t i = 0; i <= *ncell; i++) (*cut)[i] = (double)i / count;
  if (um_geometry_tas_attribute(t, surface, GRID + way) == NULL) return UM_OK;
  UM_TRY(um_geometry_tas_list(t, surface, GRID + way, &next, &end));
  if (next == end) return UM_OK;
  for (; next < end && n <= *ncell; next = t->file.value[next].end, n++) {
    um_geometry_tas_value v = &t->file.value[next];
    if (v->kind != UM_PART21_NUMBER || (n > 0 && !(v->number > (*cut)[n - 1]))) break;
    (*cut)[n] = v->number;
  }
  if (next < end || n != *ncell + 1 || fabs((*cut)[0]) > 1e-9 || fabs((*cut)[*ncell] - 1.0) > 1e-9)
    return um_geometry_tas_fail(t, surface,
                                "its grid in direction %d; accepted: %zu numbers that rise from 0 "
                                "to 1",
                                way + 1, *ncell + 1);
  (*cut)[0] = 0.0;
  (*cut)[*ncell] = 1.0;
  return UM_OK;
}

static enum um_status make_lines(const struct um_geometry_tas *t, um_geometry_tas_item surface,
                                 const struct um_geometry_tas_shape *s, int way, struct lines *out)
{
  enum um_status status;
  double *cut = NULL, all = 0.0;
  size_t ncell = 0;
  UM_CHECK(read_grid(t, surface, way, &cut, &ncell));
  for (size_t i = 0; i < ncell; i++) all += pieces(s, way == 1, cut[i], cut[i + 1]);
  UM_CHECK(um_core_allocate(t->context, (size_t)all + 1, sizeof *out->at, &out->at));
  for (size_t i = 0; i < ncell; i++) {
    size_t n = (size_t)pieces(s, way == 1, cut[i], cut[i + 1]);
    out->at[out->n++] = cut[i];
    for (size_t k = 1; k < n; k++)
      out->at[out->n++] = line_between(s, way == 1, cut[i], cut[i + 1], (double)k / (double)n);
  }
  out->at[out->n++] = 1.0;
done:
  um_core_free(t->context, cut);
  return status;
}

enum um_status um_geometry_tas_put_vertex(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                          struct um_vec3 p)
{
  const double c[3] = {p.x, p.y, p.z};
  char text[3][32];
  for (int k = 0; k < 3; k++) {
    if (!(fabs(c[k]) <= UM_GEOMETRY_MAX_LENGTH))
      return um_geometry_tas_fail(t, surface, "a corner at %g m; at most %g m is accepted", c[k],
                                  UM_GEOMETRY_MAX_LENGTH);
    um_core_number_text(c[k], text[k]);
  }
  t->nvertex++;
  return um_geometry_tas_put(t, "v %s %s %s\n", text[0], text[1], text[2]);
}

/* Points of the crossings of two sets of lines, and where their facets go. */
struct cells {
  struct um_geometry_tas *t;
  struct um_vec3 *point;                 /* [nu][nv] */
  size_t first;                          /* number of the first in the OBJ */
  bool turned;                           /* seen from the other side */
  struct um_geometry_tas_pieces *pieces; /* where solids cut them; NULL: none does */
};

/* Corners a b c go counter-clockwise about the direction u x v. */
static enum um_status put_triangle(const struct cells *m, size_t a, size_t b, size_t c)
{
  if (a == b || b == c || c == a) return UM_OK;
  size_t second = m->turned ? c : b, third = m->turned ? b : c;
  const struct um_vec3 corner[3] = {m->point[a], m->point[second], m->point[third]};
  if (m->pieces != NULL) return um_geometry_tas_pieces_add(m->t->context, m->pieces, corner, 3);
  return um_geometry_tas_put(m->t, "f %zu %zu %zu\n", m->first + a, m->first + second,
                             m->first + third);
}

static enum um_status put_cells(const struct cells *m, const struct um_geometry_tas_shape *s,
                                const struct lines *u, const struct lines *v)
{
  bool closed = s->kind >= UM_TAS_DISC && s->sweep > 2.0 * UM_PI - 1e-9;
  for (size_t i = 0; i + 1 < u->n; i++) {
    bool below = is_pole(s, u->at[i]), above = is_pole(s, u->at[i + 1]);
    UM_TRY(um_core_stop_check(m->t->context, "a mesh was read"));
    for (size_t j = 0; j + 1 < v->n; j++) {
      size_t k = closed && j + 2 == v->n ? 0 : j + 1, here = i * v->n, then = here + v->n;
      size_t a = below ? here : here + j, b = above ? then : then + j, c = above ? then : then + k,
             d = below ? here : here + k;
      UM_TRY(put_triangle(m, a, b, c));
      UM_TRY(put_triangle(m, a, c, d));
    }
  }
  return UM_OK;
}

static enum um_status put_all(struct um_geometry_tas *t, um_geometry_tas_item surface,
                              const struct um_geometry_tas_frame *frame,
                              const struct um_geometry_tas_shape *s, const struct lines *u,
                              const struct lines *v, bool turned)
{
  enum um_status status;
  struct um_geometry_tas_pieces pieces = {0};
  struct cells m = {t, NULL, t->nvertex + 1, turned, t->nsolid > 0 ? &pieces : NULL};
  UM_CHECK(um_core_allocate(t->context, u->n * v->n, sizeof *m.point, &m.point));
  for (size_t i = 0; i < u->n * v->n; i++)
    m.point[i] = um_geometry_tas_move(frame, point_at(s, u->at[i / v->n], v->at[i % v->n]));
  for (size_t i = 0; i < u->n * v->n && m.pieces == NULL; i++)
    UM_CHECK(um_geometry_tas_put_vertex(t, surface, m.point[i]));
  UM_CHECK(put_cells(&m, s, u, v));
  if (m.pieces != NULL) UM_CHECK(um_geometry_tas_put_cut(t, surface, &pieces));
done:
  um_geometry_tas_pieces_clear(t->context, &pieces);
  um_core_free(t->context, m.point);
  return status;
}

enum um_status um_geometry_tas_put_shape(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                         const struct um_geometry_tas_frame *frame, bool turned)
{
  enum um_status status;
  struct um_geometry_tas_shape s;
  struct lines u = {NULL, 0}, v = {NULL, 0};
  um_geometry_tas_item shape;
  UM_CHECK(um_geometry_tas_item_at(t, surface, SHAPE, "a shape", false, &shape));
  UM_CHECK(um_geometry_tas_read_surface(t, shape, &s));
  UM_CHECK(make_lines(t, surface, &s, 0, &u));
  UM_CHECK(make_lines(t, surface, &s, 1, &v));
  if (2.0 * (double)u.n * (double)v.n > (double)(UM_GEOMETRY_MAX_FACETS - t->nfacet)) {
    status = um_geometry_tas_fail(t, surface,
                                  "more than %zu facets up to here; at most that many "
                                  "are accepted",
                                  UM_GEOMETRY_MAX_FACETS);
    goto done;
  }
  if (t->nsolid == 0) t->nfacet += 2 * u.n * v.n;
  UM_CHECK(put_all(t, surface, frame, &s, &u, &v, turned != (s.kind > UM_TAS_DISC)));
done:
  UM_FREE(t->context, u.at, v.at);
  return status;
}
