/* Solids of STEP-TAS that cut surfaces, as half spaces, by ESA STEP-TAS 6.0, tas_arm, as pycanha's
 * reader takes it.
 *
 * Attributes (from 0): cut surface 6 what is cut, 7 tool; tool (MGM_HALF_SPACE_SOLID) 3 where it
 * stands, 4 solid, 5 sense; box and prism 1 a corner, 2 3 4 the corners that its edges lead to, of
 * a prism 2 and 3 in its base. All that are read are convex. Round ones are prisms and pyramids of
 * 72 sides whose sections have the area of the circle, a sphere has planes every 5 deg. */
#include <math.h>

#include "base/core/constants.h"
#include "geometry/step_tas_shape_impl.h"

#define TOOL  7
#define SIDES 72
#define ROWS  36 /* of planes of a sphere */

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
    return um_geometry_tas_fail(t, item, "its corners; accepted: three edges that span a volume");
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
                                "is no solid that is read; accepted: MGM_SOLID_BOX, "
                                "_TRIANGULAR_PRISM, _CYLINDER, _CONE, _SPHERE");
  if (!(s.sweep > 2.0 * UM_PI - 1e-6))
    return um_geometry_tas_fail(t, item, "a solid of %g deg; accepted: a whole turn, 360 deg",
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
                                "is no tool that is read; accepted: MGM_HALF_SPACE_SOLID that "
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
