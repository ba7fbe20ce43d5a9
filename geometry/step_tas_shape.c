/* Shapes of STEP-TAS: surfaces, and the solids that cut them, by ESA STEP-TAS 6.0, tas_arm, as
 * pycanha's reader takes them.
 *
 * Attributes (from 0): 0 the surface, 1.. points. Round ones: 1 origin, 2 a point on the axis, at
 * the far end where there is one, 3 a point toward the start of angles, 4.. lengths: radii inside
 * and outside; radius; radii at both ends; radius and heights of both cuts above the centre; radius
 * at the far end and height of the lower cut above the vertex. Then start and end angle. */
#include <math.h>

#include "base/core/constants.h"
#include "geometry/step_tas_shape_impl.h"

static const struct {
  const char *surface;
  int npoint, nlength;
  const char *solid; /* NULL: none is read */
} kinds[] = {
    [UM_TAS_RECTANGLE] = {"MGM_RECTANGLE", 3, 0, NULL},
    [UM_TAS_TRIANGLE] = {"MGM_TRIANGLE", 3, 0, NULL},
    [UM_TAS_QUADRILATERAL] = {"MGM_QUADRILATERAL", 4, 0, NULL},
    [UM_TAS_DISC] = {"MGM_DISC", 3, 2, NULL},
    [UM_TAS_CYLINDER] = {"MGM_CYLINDER", 3, 1, "MGM_SOLID_CYLINDER"},
    [UM_TAS_CONE] = {"MGM_CONE", 3, 2, "MGM_SOLID_CONE"},
    [UM_TAS_SPHERE] = {"MGM_SPHERE", 3, 3, "MGM_SOLID_SPHERE"},
    [UM_TAS_PARABOLOID] = {"MGM_PARABOLOID", 3, 2, NULL},
};

/* Corners of a plane, the last two of which may be one. */
static enum um_status check_plane(const struct um_geometry_tas *t, um_geometry_tas_item shape,
                                  struct um_geometry_tas_shape *s)
{
  struct um_vec3 *p = s->point;
  if (s->kind == UM_TAS_RECTANGLE) {
    p[3] = p[2];
    p[2] = um_vec3_add(p[1], um_vec3_sub(p[3], p[0]));
  } else if (s->kind == UM_TAS_TRIANGLE) {
    p[3] = p[0];
  }
  struct um_vec3 across = um_vec3_cross(um_vec3_sub(p[2], p[0]), um_vec3_sub(p[3], p[1]));
  int corners = s->kind == UM_TAS_TRIANGLE ? 3 : 4;
  for (int i = 0; i < corners; i++) {
    struct um_vec3 a = um_vec3_sub(p[(i + 1) % corners], p[i]);
    struct um_vec3 b = um_vec3_sub(p[(i + corners - 1) % corners], p[i]);
    if (!(um_vec3_dot(um_vec3_cross(a, b), across) > 1e-10 * um_vec3_dot(across, across)))
      return um_geometry_tas_fail(t, shape, "corner %d; accepted: a convex outline with an area",
                                  i + 1);
  }
  return UM_OK;
}

/* Lengths that make a surface of this kind. */
static bool is_round(struct um_geometry_tas_shape *s)
{
  double *l = s->length, slack = 1e-9 * l[0];
  if (s->kind == UM_TAS_DISC) return l[0] >= 0.0 && l[1] > l[0];
  if (s->kind == UM_TAS_CONE) return l[0] >= 0.0 && l[1] >= 0.0 && l[0] + l[1] > 0.0;
  if (!(l[0] > 0.0)) return false;
  if (s->kind == UM_TAS_PARABOLOID) return l[1] >= 0.0 && l[1] < s->height;
  if (s->kind != UM_TAS_SPHERE) return true;
  if (!(l[1] >= -l[0] - slack && l[2] <= l[0] + slack && l[1] < l[2])) return false;
  l[1] = fmax(l[1], -l[0]);
  l[2] = fmin(l[2], l[0]);
  return true;
}

static enum um_status read_round(const struct um_geometry_tas *t, um_geometry_tas_item shape,
                                 struct um_geometry_tas_shape *s)
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
        t, shape, "its three points stand in a line; accepted: an axis and a point beside it");
  s->x = um_vec3_unit(x);
  s->y = um_vec3_cross(s->axis, s->x);
  s->sweep = end - s->start;
  if (!(s->sweep > 1e-9 && s->sweep <= 2.0 * UM_PI + 1e-9))
    return um_geometry_tas_fail(t, shape,
                                "%g to %g deg; accepted: an end angle up to 360 deg after the "
                                "start",
                                s->start / UM_DEG, end / UM_DEG);
  if (!is_round(s))
    return um_geometry_tas_fail(t, shape,
                                "its radii or cuts (%g, %g, %g m); accepted: radii above "
                                "0 and cuts in order",
                                s->length[0], s->length[1], s->length[2]);
  return UM_OK;
}

static enum um_status read_kind(const struct um_geometry_tas *t, um_geometry_tas_item shape,
                                enum um_geometry_tas_kind kind, struct um_geometry_tas_shape *s)
{
  *s = (struct um_geometry_tas_shape){.kind = kind};
  for (int i = 0; i < kinds[kind].npoint; i++)
    UM_TRY(um_geometry_tas_point(t, shape, 1 + i, &s->point[i]));
  return kind < UM_TAS_DISC ? check_plane(t, shape, s) : read_round(t, shape, s);
}

enum um_status um_geometry_tas_read_surface(const struct um_geometry_tas *t,
                                            um_geometry_tas_item shape,
                                            struct um_geometry_tas_shape *out)
{
  for (int k = 0; k < UM_TAS_KINDS; k++)
    if (um_geometry_part21_is(shape->name, kinds[k].surface))
      return read_kind(t, shape, (enum um_geometry_tas_kind)k, out);
  return um_geometry_tas_fail(t, shape,
                              "is no shape that is read; accepted: MGM_RECTANGLE, _TRIANGLE, "
                              "_QUADRILATERAL, _DISC, _CYLINDER, _CONE, _SPHERE, _PARABOLOID");
}

enum um_status um_geometry_tas_read_solid(const struct um_geometry_tas *t,
                                          um_geometry_tas_item solid,
                                          struct um_geometry_tas_shape *out, bool *is)
{
  *is = true;
  for (int k = UM_TAS_CYLINDER; k <= UM_TAS_SPHERE; k++)
    if (um_geometry_part21_is(solid->name, kinds[k].solid))
      return read_kind(t, solid, (enum um_geometry_tas_kind)k, out);
  *is = false;
  return UM_OK;
}
