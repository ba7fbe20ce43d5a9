/* Surfaces of STEP-TAS as facets, by ESA STEP-TAS 6.0, tas_arm, as pycanha's reader takes it.
 *
 * A surface is p(u, v), u and v from 0 to 1, cut by its two grids. Planes: bilinear between
 * corners, u toward the second, v toward the last; a triangle is u = 0 at its first corner, u = 1
 * along the edge opposite. Round ones: u along the axis, or outward on a disc, or by latitude on a
 * sphere; v about the axis from the start to the end angle. Side 1 is that of (p2 - p1) x (p3 - p1)
 * of planes, a disc's along its axis, that away from the axis of others: the convex one of a
 * paraboloid.
 *
 * Attributes (from 0): 0 the surface, 1.. points. Round ones: 1 origin, 2 a point on the axis, at
 * the far end where there is one, 3 a point toward the start of angles, 4.. lengths: radii inside
 * and outside; radius; radii at both ends; radius and heights of both cuts above the centre; radius
 * at the far end and height of the lower cut above the vertex. Then start and end angle.
 * The surface: 6 shape, 16 17 numbers of faces, 20 21 grids. */
#include <math.h>
#include <string.h>

#include "base/core/constants.h"
#include "base/core/csv.h"
#include "geometry/patch_impl.h"
#include "geometry/step_tas_impl.h"

#define SHAPE 6
#define COUNT 16
#define GRID  20
#define POLE  1e-7 /* of the radius: a circle this small is a point */

enum kind { RECTANGLE, TRIANGLE, QUADRILATERAL, DISC, CYLINDER, CONE, SPHERE, PARABOLOID };

static const struct {
  const char *name;
  int npoint, nlength;
} kinds[] = {
    [RECTANGLE] = {"MGM_RECTANGLE", 3, 0},
    [TRIANGLE] = {"MGM_TRIANGLE", 3, 0},
    [QUADRILATERAL] = {"MGM_QUADRILATERAL", 4, 0},
    [DISC] = {"MGM_DISC", 3, 2},
    [CYLINDER] = {"MGM_CYLINDER", 3, 1},
    [CONE] = {"MGM_CONE", 3, 2},
    [SPHERE] = {"MGM_SPHERE", 3, 3},
    [PARABOLOID] = {"MGM_PARABOLOID", 3, 2},
};
#define NKIND (sizeof kinds / sizeof *kinds)

struct shape {
  enum kind kind;
  struct um_vec3 point[4];                /* corners; or the origin */
  struct um_vec3 x, y, axis;              /* unit vectors of round ones */
  double height, length[3], start, sweep; /* [m, m, rad, rad] */
};

/* Where a surface is cut: grid lines, and lines between them on round ones. */
struct lines {
  double *at; /* [n] */
  size_t n;
};

static double mix(double a, double b, double t) { return a + t * (b - a); }

/* Radius and height at u; a circle that is a point has radius 0. */
static void profile(const struct shape *s, double u, double *r, double *z)
{
  const double *l = s->length;
  double largest = l[0];
  *r = l[0];
  *z = s->kind == DISC ? 0.0 : u * s->height;
  if (s->kind == DISC || s->kind == CONE) {
    *r = mix(l[0], l[1], u);
    largest = fmax(l[0], l[1]);
  } else if (s->kind == SPHERE) {
    double latitude = mix(asin(l[1] / l[0]), asin(l[2] / l[0]), u);
    *r = l[0] * cos(latitude);
    *z = l[0] * sin(latitude);
  } else if (s->kind == PARABOLOID) {
    *z = mix(l[1], s->height, u);
    *r = l[0] * sqrt(*z / s->height);
  }
  if (!(*r > POLE * largest)) *r = 0.0;
}

/* Is the line of this u a point? */
static bool is_pole(const struct shape *s, double u)
{
  double r = 1.0, z;
  if (s->kind >= DISC) profile(s, u, &r, &z);
  return s->kind == TRIANGLE ? u == 0.0 : r == 0.0;
}

static struct um_vec3 point_at(const struct shape *s, double u, double v)
{
  if (s->kind < DISC) {
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
static double dish_step(const struct shape *s, double u)
{
  double r, z;
  profile(s, u, &r, &z);
  return asinh(2.0 * s->height * r / (s->length[0] * s->length[0]));
}

/* Facets that a step from a to b of u or v is cut into. */
static double pieces(const struct shape *s, bool around, double a, double b)
{
  double turned = 0.0; /* [rad] */
  if (s->kind >= DISC && around) {
    turned = (b - a) * s->sweep;
  } else if (s->kind == SPHERE) {
    turned = (b - a) * (asin(s->length[2] / s->length[0]) - asin(s->length[1] / s->length[0]));
  } else if (s->kind == PARABOLOID) {
    turned = dish_step(s, b) - dish_step(s, a);
  }
  return fmax(1.0, fmin(ceil(turned / UM_TAS_STEP - 1e-9), UM_TAS_FACES)); /* of NaN: many */
}

/* The line at a share k of the way from a to b. */
static double line_between(const struct shape *s, bool around, double a, double b, double k)
{
  if (s->kind != PARABOLOID || around) return mix(a, b, k);
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
    return um_geometry_tas_fail(t, surface, "%g faces in a direction; expected: 1 to %d", count,
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
                                "its grid in direction %d; expected: %zu numbers that rise from 0 "
                                "to 1",
                                way + 1, *ncell + 1);
  (*cut)[0] = 0.0;
  (*cut)[*ncell] = 1.0;
  return UM_OK;
}

static enum um_status make_lines(const struct um_geometry_tas *t, um_geometry_tas_item surface,
                                 const struct shape *s, int way, struct lines *out)
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

/* Corners of a plane, the last two of which may be one. */
static enum um_status check_plane(const struct um_geometry_tas *t, um_geometry_tas_item shape,
                                  struct shape *s)
{
  struct um_vec3 *p = s->point;
  if (s->kind == RECTANGLE) {
    p[3] = p[2];
    p[2] = um_vec3_add(p[1], um_vec3_sub(p[3], p[0]));
  } else if (s->kind == TRIANGLE) {
    p[3] = p[0];
  }
  struct um_vec3 across = um_vec3_cross(um_vec3_sub(p[2], p[0]), um_vec3_sub(p[3], p[1]));
  int corners = s->kind == TRIANGLE ? 3 : 4;
  for (int i = 0; i < corners; i++) {
    struct um_vec3 a = um_vec3_sub(p[(i + 1) % corners], p[i]);
    struct um_vec3 b = um_vec3_sub(p[(i + corners - 1) % corners], p[i]);
    if (!(um_vec3_dot(um_vec3_cross(a, b), across) > 1e-10 * um_vec3_dot(across, across)))
      return um_geometry_tas_fail(t, shape, "corner %d; expected: a convex outline with an area",
                                  i + 1);
  }
  return UM_OK;
}

/* Lengths that make a surface of this kind. */
static bool is_round(struct shape *s)
{
  double *l = s->length, slack = 1e-9 * l[0];
  if (s->kind == DISC) return l[0] >= 0.0 && l[1] > l[0];
  if (s->kind == CONE) return l[0] >= 0.0 && l[1] >= 0.0 && l[0] + l[1] > 0.0;
  if (!(l[0] > 0.0)) return false;
  if (s->kind == PARABOLOID) return l[1] >= 0.0 && l[1] < s->height;
  if (s->kind != SPHERE) return true;
  if (!(l[1] >= -l[0] - slack && l[2] <= l[0] + slack && l[1] < l[2])) return false;
  l[1] = fmax(l[1], -l[0]);
  l[2] = fmin(l[2], l[0]);
  return true;
}

static enum um_status read_round(const struct um_geometry_tas *t, um_geometry_tas_item shape,
                                 struct shape *s)
{
  double end;
  int at = 1 + kinds[s->kind].npoint, angles = at + kinds[s->kind].nlength;
  for (int i = at; i < angles; i++) UM_TRY(um_geometry_tas_length(t, shape, i, &s->length[i - at]));
  UM_TRY(um_geometry_tas_angle(t, shape, angles, &s->start));
  UM_TRY(um_geometry_tas_angle(t, shape, angles + 1, &end));
  struct um_vec3 axis = um_vec3_sub(s->point[1], s->point[0]);
  struct um_vec3 x = um_vec3_sub(s->point[2], s->point[0]);
  s->height = um_vec3_norm(axis);
  s->axis = um_vec3_scale(axis, 1.0 / s->height);
  double toward = um_vec3_norm(x);
  x = um_vec3_axpy(x, -um_vec3_dot(x, s->axis), s->axis);
  if (!(s->height > 0.0 && um_vec3_norm(x) > 1e-9 * toward))
    return um_geometry_tas_fail(
        t, shape, "its three points stand in a line; expected: an axis and a point beside it");
  s->x = um_vec3_unit(x);
  s->y = um_vec3_cross(s->axis, s->x);
  s->sweep = end - s->start;
  if (!(s->sweep > 1e-9 && s->sweep <= 2.0 * UM_PI + 1e-9))
    return um_geometry_tas_fail(t, shape,
                                "%g to %g deg; expected: an end angle up to 360 deg after the "
                                "start",
                                s->start / UM_DEG, end / UM_DEG);
  if (!is_round(s))
    return um_geometry_tas_fail(t, shape,
                                "its radii or cuts (%g, %g, %g m); expected: radii above "
                                "0 and cuts in order",
                                s->length[0], s->length[1], s->length[2]);
  return UM_OK;
}

static enum um_status read_shape(const struct um_geometry_tas *t, um_geometry_tas_item surface,
                                 struct shape *s)
{
  um_geometry_tas_item shape;
  size_t kind = 0;
  *s = (struct shape){0};
  UM_TRY(um_geometry_tas_item_at(t, surface, SHAPE, "a shape", false, &shape));
  while (kind < NKIND && !um_geometry_part21_is(shape->name, kinds[kind].name)) kind++;
  if (kind == NKIND)
    return um_geometry_tas_fail(t, shape,
                                "is no shape that is read; expected: MGM_RECTANGLE, _TRIANGLE, "
                                "_QUADRILATERAL, _DISC, _CYLINDER, _CONE, _SPHERE, _PARABOLOID");
  s->kind = (enum kind)kind;
  for (int i = 0; i < kinds[kind].npoint; i++)
    UM_TRY(um_geometry_tas_point(t, shape, 1 + i, &s->point[i]));
  return s->kind < DISC ? check_plane(t, shape, s) : read_round(t, shape, s);
}

static enum um_status put_vertex(struct um_geometry_tas *t, um_geometry_tas_item surface,
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
  return um_geometry_tas_put(t, "v %s %s %s\n", text[0], text[1], text[2]);
}

/* Corners a b c d go counter-clockwise about the direction u x v. */
static enum um_status put_cell(struct um_geometry_tas *t, const size_t c[4], bool turned)
{
  size_t a = c[0], b = turned ? c[3] : c[1], d = turned ? c[1] : c[3];
  if (a != b && b != c[2]) UM_TRY(um_geometry_tas_put(t, "f %zu %zu %zu\n", a, b, c[2]));
  if (c[2] != d && d != a) UM_TRY(um_geometry_tas_put(t, "f %zu %zu %zu\n", a, c[2], d));
  return UM_OK;
}

static enum um_status put_cells(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                const struct um_geometry_tas_frame *frame, const struct shape *s,
                                const struct lines *u, const struct lines *v, bool turned)
{
  size_t first = t->nvertex + 1;
  bool closed = s->kind >= DISC && s->sweep > 2.0 * UM_PI - 1e-9;
  for (size_t i = 0; i < u->n; i++)
    for (size_t j = 0; j < v->n; j++)
      UM_TRY(put_vertex(t, surface, um_geometry_tas_move(frame, point_at(s, u->at[i], v->at[j]))));
  t->nvertex += u->n * v->n;
  for (size_t i = 0; i + 1 < u->n; i++) {
    bool below = is_pole(s, u->at[i]), above = is_pole(s, u->at[i + 1]);
    UM_TRY(um_core_stop_check(t->context, "a mesh was read"));
    for (size_t j = 0; j + 1 < v->n; j++) {
      size_t k = closed && j + 2 == v->n ? 0 : j + 1, here = first + i * v->n, then = here + v->n;
      const size_t corner[4] = {below ? here : here + j, above ? then : then + j,
                                above ? then : then + k, below ? here : here + k};
      UM_TRY(put_cell(t, corner, turned));
    }
  }
  return UM_OK;
}

enum um_status um_geometry_tas_put_shape(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                         const struct um_geometry_tas_frame *frame, bool turned)
{
  enum um_status status;
  struct shape s;
  struct lines u = {NULL, 0}, v = {NULL, 0};
  UM_CHECK(read_shape(t, surface, &s));
  UM_CHECK(make_lines(t, surface, &s, 0, &u));
  UM_CHECK(make_lines(t, surface, &s, 1, &v));
  if (2.0 * (double)u.n * (double)v.n > (double)(UM_GEOMETRY_MAX_FACETS - t->nfacet)) {
    status = um_geometry_tas_fail(t, surface,
                                  "more than %zu facets up to here; at most that many "
                                  "are accepted",
                                  UM_GEOMETRY_MAX_FACETS);
    goto done;
  }
  t->nfacet += 2 * u.n * v.n;
  UM_CHECK(put_cells(t, surface, frame, &s, &u, &v, turned != (s.kind > DISC)));
done:
  UM_FREE(t->context, u.at, v.at);
  return status;
}
