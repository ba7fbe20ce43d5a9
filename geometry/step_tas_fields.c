/* Attributes of STEP-TAS: numbers, quantities with their units, points, places.
 *
 * What stands where (from 0), by ESA STEP-TAS 6.0, tas_arm, as pycanha's reader takes it:
 *   quantity literal     0 quantity type, 1 list of one number
 *   quantity type        7 unit
 *   extended SI unit     3 prefix, 4 name
 *   conversion unit      3 unit it is made from, 4 factor, 5 offset: SI = value / factor + offset
 *   cartesian point      1 2 3 coordinates, 4 quantity type
 *   direction            0 1 2 components
 *   axis placement       0 point, 1 z axis, 2 x axis
 *   translation          0 1 2 steps, 3 quantity type
 *   rotation             0 direction, 1 angle, 2 quantity type
 *   sequence             0 list of the above, the first is done first */
#include <math.h>
#include <string.h>

#include "geometry/step_tas_impl.h"

#define DEEPEST_UNIT 4

um_geometry_tas_value um_geometry_tas_attribute(const struct um_geometry_tas *t,
                                                um_geometry_tas_item of, int index)
{
  um_geometry_tas_value v = um_geometry_part21_attribute(&t->file, of, index);
  return v == NULL || v->kind == UM_PART21_UNSET || v->kind == UM_PART21_DERIVED ? NULL : v;
}

/* The item a value refers to. */
static enum um_status refer(const struct um_geometry_tas *t, um_geometry_tas_item of,
                            um_geometry_tas_value v, const char *what, um_geometry_tas_item *out)
{
  *out = NULL;
  if (v == NULL || v->kind != UM_PART21_REFERENCE)
    return um_geometry_tas_fail(t, of, "accepted: %s, as #12", what);
  *out = um_geometry_part21_find(&t->file, v->id);
  if (*out != NULL) return UM_OK;
  return um_geometry_tas_fail(t, of, "#%llu is nothing of the file that it may be; accepted: %s",
                              (unsigned long long)v->id, what);
}

enum um_status um_geometry_tas_item_at(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                       int index, const char *what, bool optional,
                                       um_geometry_tas_item *out)
{
  um_geometry_tas_value v = um_geometry_tas_attribute(t, of, index);
  *out = NULL;
  if (v == NULL && optional) return UM_OK;
  return refer(t, of, v, what, out);
}

enum um_status um_geometry_tas_number(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                      int index, double *out)
{
  um_geometry_tas_value v = um_geometry_tas_attribute(t, of, index);
  if (v == NULL || v->kind != UM_PART21_NUMBER)
    return um_geometry_tas_fail(t, of, "attribute %d is no number", index + 1);
  *out = v->number;
  return UM_OK;
}

enum um_status um_geometry_tas_list(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                    int index, uint32_t *next, uint32_t *end)
{
  um_geometry_tas_value v = um_geometry_tas_attribute(t, of, index);
  if (v == NULL || v->kind != UM_PART21_LIST)
    return um_geometry_tas_fail(t, of, "attribute %d is no list", index + 1);
  *next = (uint32_t)(v - t->file.value) + 1;
  *end = v->end;
  return UM_OK;
}

enum um_status um_geometry_tas_listed(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                      uint32_t at, um_geometry_tas_item *out)
{
  return refer(t, of, &t->file.value[at], "a list of items", out);
}

static bool is_text(um_geometry_tas_value v, const char *word)
{
  return v != NULL && v->kind == UM_PART21_STRING && um_geometry_part21_is(v->text, word);
}

/* Powers of ten before "metre" and "radian". */
static bool read_prefix(um_geometry_tas_value v, double *factor)
{
  static const struct {
    const char *name;
    double factor;
  } prefixes[] = {{"", 1.0},      {"deci", 1e-1}, {"centi", 1e-2}, {"milli", 1e-3}, {"micro", 1e-6},
                  {"nano", 1e-9}, {"deca", 1e1},  {"hecto", 1e2},  {"kilo", 1e3},   {"mega", 1e6}};
  *factor = 1.0;
  if (v == NULL) return true;
  for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; i++)
    if (is_text(v, prefixes[i].name)) {
      *factor = prefixes[i].factor;
      return true;
    }
  return false;
}

/* SI units in one of the unit that a quantity type has: of `si`, "metre" or "radian". */
static enum um_status read_unit(const struct um_geometry_tas *t, um_geometry_tas_item of, int index,
                                const char *si, double *factor)
{
  um_geometry_tas_item unit;
  *factor = 1.0;
  UM_TRY(um_geometry_tas_item_at(t, of, index, "a quantity type", false, &of));
  UM_TRY(um_geometry_tas_item_at(t, of, 7, "a unit", false, &unit));
  for (int depth = 0; depth < DEEPEST_UNIT; depth++) {
    double number = 0.0;
    if (um_geometry_part21_is(unit->name, "NRF_EXTENDED_SI_UNIT")) {
      if (!read_prefix(um_geometry_tas_attribute(t, unit, 3), &number) ||
          !is_text(um_geometry_tas_attribute(t, unit, 4), si))
        return um_geometry_tas_fail(t, unit, "accepted: a unit of %s", si);
      *factor *= number;
      return UM_OK;
    }
    if (!um_geometry_part21_is(unit->name, "NRF_CONVERSION_BASED_UNIT")) break;
    UM_TRY(um_geometry_tas_number(t, unit, 4, &number));
    um_geometry_tas_value offset = um_geometry_tas_attribute(t, unit, 5);
    if (!(number > 0.0) ||
        (offset != NULL && !(offset->kind == UM_PART21_NUMBER && offset->number == 0.0)))
      return um_geometry_tas_fail(t, unit, "accepted: a factor above 0 and no offset");
    *factor /= number;
    UM_TRY(um_geometry_tas_item_at(t, unit, 3, "a unit", false, &unit));
  }
  return um_geometry_tas_fail(t, unit, "accepted: a unit of %s", si);
}

/* The number of a literal in SI units. */
static enum um_status read_literal(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                   int index, const char *si, double *out)
{
  um_geometry_tas_item literal;
  uint32_t next = 0, end = 0;
  double factor;
  UM_TRY(um_geometry_tas_item_at(t, of, index, "a quantity", false, &literal));
  if (!um_geometry_part21_is(literal->name, "NRF_REAL_QUANTITY_VALUE_LITERAL"))
    return um_geometry_tas_fail(t, of, "attribute %d is no quantity with a real value", index + 1);
  UM_TRY(um_geometry_tas_list(t, literal, 1, &next, &end));
  if (end != next + 1 || t->file.value[next].kind != UM_PART21_NUMBER)
    return um_geometry_tas_fail(t, literal, "accepted: a list of one number");
  UM_TRY(read_unit(t, literal, 0, si, &factor));
  *out = factor * t->file.value[next].number;
  return UM_OK;
}

enum um_status um_geometry_tas_length(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                      int index, double *out)
{
  return read_literal(t, of, index, "metre", out);
}

enum um_status um_geometry_tas_angle(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                     int index, double *out)
{
  return read_literal(t, of, index, "radian", out);
}

/* Three numbers from attribute `index` on. */
static enum um_status read_three(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                 int index, struct um_vec3 *out)
{
  UM_TRY(um_geometry_tas_number(t, of, index, &out->x));
  UM_TRY(um_geometry_tas_number(t, of, index + 1, &out->y));
  return um_geometry_tas_number(t, of, index + 2, &out->z);
}

enum um_status um_geometry_tas_point(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                     int index, struct um_vec3 *out)
{
  um_geometry_tas_item point;
  double factor;
  UM_TRY(um_geometry_tas_item_at(t, of, index, "a point", false, &point));
  if (!um_geometry_part21_is(point->name, "MGM_3D_CARTESIAN_POINT"))
    return um_geometry_tas_fail(t, of, "attribute %d is no MGM_3D_CARTESIAN_POINT", index + 1);
  UM_TRY(read_three(t, point, 1, out));
  UM_TRY(read_unit(t, point, 4, "metre", &factor));
  *out = um_vec3_scale(*out, factor);
  return UM_OK;
}

/* A unit vector. */
static enum um_status read_direction(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                     int index, struct um_vec3 *out)
{
  um_geometry_tas_item direction;
  UM_TRY(um_geometry_tas_item_at(t, of, index, "a direction", false, &direction));
  if (!um_geometry_part21_is(direction->name, "MGM_3D_DIRECTION"))
    return um_geometry_tas_fail(t, of, "attribute %d is no MGM_3D_DIRECTION", index + 1);
  UM_TRY(read_three(t, direction, 0, out));
  double length = um_vec3_norm(*out);
  if (!(length > 1e-100 && length < 1e100))
    return um_geometry_tas_fail(t, direction, "has no length; accepted: a direction");
  *out = um_vec3_scale(*out, 1.0 / length);
  return UM_OK;
}

/* Columns x, z x x and z, x squared up against z. */
static enum um_status read_axes(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                struct um_geometry_tas_frame *out)
{
  struct um_vec3 x, z;
  UM_TRY(um_geometry_tas_point(t, of, 0, &out->move));
  UM_TRY(read_direction(t, of, 1, &z));
  UM_TRY(read_direction(t, of, 2, &x));
  x = um_vec3_axpy(x, -um_vec3_dot(x, z), z);
  if (!(um_vec3_norm(x) > 1e-6))
    return um_geometry_tas_fail(t, of, "its two axes are parallel; accepted: two directions");
  x = um_vec3_unit(x);
  out->turn = um_mat3_transpose(um_mat3_from_axes(x, um_vec3_cross(z, x), z));
  return UM_OK;
}

/* A step of a place; a sequence is none. */
static enum um_status read_step(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                struct um_geometry_tas_frame *out)
{
  double factor = 1.0, angle = 0.0;
  struct um_vec3 axis;
  *out = (struct um_geometry_tas_frame){{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 0, 0}};
  if (um_geometry_part21_is(of->name, "MGM_AXIS_PLACEMENT")) return read_axes(t, of, out);
  if (um_geometry_part21_is(of->name, "MGM_TRANSLATION")) {
    UM_TRY(read_three(t, of, 0, &out->move));
    UM_TRY(read_unit(t, of, 3, "metre", &factor));
    out->move = um_vec3_scale(out->move, factor);
    return UM_OK;
  }
  if (!um_geometry_part21_is(of->name, "MGM_ROTATION_WITH_AXES_FIXED"))
    return um_geometry_tas_fail(
        t, of,
        "is no place that is read; accepted: MGM_AXIS_PLACEMENT, MGM_TRANSLATION, "
        "MGM_ROTATION_WITH_AXES_FIXED or MGM_AXIS_TRANSFORMATION_SEQUENCE of them");
  UM_TRY(read_direction(t, of, 0, &axis));
  UM_TRY(um_geometry_tas_number(t, of, 1, &angle));
  UM_TRY(read_unit(t, of, 2, "radian", &factor));
  out->turn = um_mat3_transpose(um_quat_matrix(um_quat_from_axis(axis, factor * angle)));
  return UM_OK;
}

/* outer after inner. */
static struct um_geometry_tas_frame compose(const struct um_geometry_tas_frame *outer,
                                            const struct um_geometry_tas_frame *inner)
{
  return (struct um_geometry_tas_frame){um_mat3_multiply(outer->turn, inner->turn),
                                        um_geometry_tas_move(outer, inner->move)};
}

enum um_status um_geometry_tas_place(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                     int index, const struct um_geometry_tas_frame *outer,
                                     struct um_geometry_tas_frame *out)
{
  um_geometry_tas_item place, item;
  struct um_geometry_tas_frame step, all;
  uint32_t next = 0, end = 0;
  *out = *outer;
  UM_TRY(um_geometry_tas_item_at(t, of, index, "a place", true, &place));
  if (place == NULL) return UM_OK;
  if (!um_geometry_part21_is(place->name, "MGM_AXIS_TRANSFORMATION_SEQUENCE")) {
    UM_TRY(read_step(t, place, &all));
  } else {
    all = (struct um_geometry_tas_frame){{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 0, 0}};
    UM_TRY(um_geometry_tas_list(t, place, 0, &next, &end));
    for (; next < end; next = t->file.value[next].end) {
      UM_TRY(um_geometry_tas_listed(t, place, next, &item));
      UM_TRY(read_step(t, item, &step));
      all = compose(&step, &all);
    }
  }
  *out = compose(outer, &all);
  return UM_OK;
}

struct um_vec3 um_geometry_tas_move(const struct um_geometry_tas_frame *frame, struct um_vec3 p)
{
  return um_vec3_add(um_mat3_apply(frame->turn, p), frame->move);
}
