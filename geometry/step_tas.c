/* Geometry of STEP-TAS, ESA's exchange of thermal models (schema tas_arm of ISO 10303-21), as
 * Wavefront OBJ. Items are walked from those that stand inside no other.
 *
 * Attributes (from 0), by ESA STEP-TAS 6.0, tas_arm, as pycanha's reader takes it:
 *   model      6 all its items
 *   any item   0 name, 5 where it stands; a compound: 6 items; a cut surface: 6 what is cut, 7 tool
 *   surface    6 shape, 7 active side, 10 11 optical materials of sides 1 and 2 */
#include "geometry/step_tas_impl.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "geometry/foreign_mesh_impl.h"
#include "geometry/patch_impl.h"

#define DEEPEST  64 /* compounds within compounds */
#define NAME     0
#define ITEMS    6
#define PLACE    5
#define SIDE     7
#define OPTICAL  10
#define INSIDE   1 /* of seen: it stands in a compound */
#define PLACED   2
#define MODEL    "MGM_MESHED_GEOMETRIC_MODEL"
#define SURFACE  "MGM_MESHED_PRIMITIVE_BOUNDED_SURFACE"
#define CUT      "MGM_MESHED_BOOLEAN_DIFFERENCE_SURFACE"
#define COMPOUND "MGM_COMPOUND_MESHED_GEOMETRIC_ITEM"
#define BOX      "MGM_QUALIFIED_COMPOUND_MESHED_PRIMITIVE_BOUNDED_SURFACE"

bool um_geometry_step_tas_is(const char *bytes, size_t length)
{
  bool schema = false;
  for (size_t i = 0; i < length; i++) {
    size_t left = length - i;
    if (left >= 7 && memcmp(bytes + i, "ENDSEC;", 7) == 0) return false;
    if (left >= 11 && memcmp(bytes + i, "FILE_SCHEMA", 11) == 0) schema = true;
    if (schema && left >= 7 && strncasecmp(bytes + i, "tas_arm", 7) == 0) return true;
  }
  return false;
}

void um_geometry_tas_text(const struct um_geometry_tas *t, um_geometry_tas_item of, int index,
                          char out[256])
{
  um_geometry_tas_value v = um_geometry_tas_attribute(t, of, index);
  size_t n = 0;
  if (v != NULL && v->kind == UM_PART21_STRING)
    for (size_t i = 0; i < v->text.length && n < 200; i++) {
      out[n++] = v->text.at[i] == '\0' ? '_' : v->text.at[i];
      if (v->text.at[i] == '\'') i++; /* it is doubled */
    }
  out[n] = '\0';
  um_geometry_foreign_name(out);
}

enum um_status um_geometry_tas_fail(const struct um_geometry_tas *t, um_geometry_tas_item of,
                                    const char *format, ...)
{
  char text[400], name[256];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  um_geometry_tas_text(t, of, NAME, name);
  return um_core_fail(t->context, UM_ERR_INPUT, "%s:%d: #%llu %.*s%s%s%s: %s", t->path, of->line,
                      (unsigned long long)of->id,
                      (int)(of->name.length < 60 ? of->name.length : 60), of->name.at,
                      name[0] != '\0' ? " '" : "", name, name[0] != '\0' ? "'" : "", text);
}

enum um_status um_geometry_tas_put(struct um_geometry_tas *t, const char *format, ...)
{
  char line[1024];
  va_list arguments;
  va_start(arguments, format);
  size_t n = (size_t)vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  if (t->length + n + 1 > t->capacity) {
    size_t capacity = 2 * t->capacity + sizeof line;
    UM_TRY(um_core_reallocate(t->context, capacity, 1, &t->text));
    t->capacity = capacity;
  }
  memcpy(t->text + t->length, line, n + 1);
  t->length += n;
  return UM_OK;
}

/* Of a name that is taken, NAME_2 and on. */
static enum um_status make_unique(struct um_geometry_tas *t, char name[256])
{
  char wanted[256];
  memcpy(wanted, name, sizeof wanted);
  int number = 2;
  for (size_t i = 0; i < t->nname; i++)
    if (strcmp(t->name[i], name) == 0) {
      snprintf(name, 256, "%.200s_%d", wanted, number++);
      i = (size_t)-1; /* from the beginning */
    }
  UM_TRY(um_core_reallocate(t->context, t->nname + 1, sizeof *t->name, &t->name));
  memcpy(t->name[t->nname++], name, 256);
  return UM_OK;
}

static enum um_status read_material(const struct um_geometry_tas *t, um_geometry_tas_item surface,
                                    int side, char out[256])
{
  um_geometry_tas_item optical;
  out[0] = '\0';
  UM_TRY(um_geometry_tas_item_at(t, surface, OPTICAL + side, "a material", true, &optical));
  if (optical != NULL) um_geometry_tas_text(t, optical, NAME, out);
  return UM_OK;
}

/* Lines "g", "usemtl" and, as OBJ has no word for it, "usemtl_back" of a surface in `parent`. Where
 * the file has more surfaces than a part may have groups, a group is PARENT.MATERIAL. */
static enum um_status put_names(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                um_geometry_tas_item parent, bool turned)
{
  char name[256], material[256], back[256], group[256];
  UM_TRY(read_material(t, surface, turned, material));
  UM_TRY(read_material(t, surface, !turned, back));
  um_geometry_tas_text(t,
                       t->nsurface > UM_GEOMETRY_MAX_GROUPS ? parent
                       : t->cut != NULL                     ? t->cut
                                                            : surface,
                       NAME, name);
  if (name[0] == '\0') snprintf(name, sizeof name, "surface");
  if (t->nsurface > UM_GEOMETRY_MAX_GROUPS) {
    snprintf(group, sizeof group, "%.120s%s%.120s", name, material[0] != '\0' ? "." : "", material);
    um_geometry_foreign_name(group);
  } else {
    memcpy(group, name, sizeof group);
    UM_TRY(make_unique(t, group));
  }
  return um_geometry_tas_put(t, "g %s\nusemtl %s\nusemtl_back %s\n", group, material, back);
}

static enum um_status put_surface(struct um_geometry_tas *t, um_geometry_tas_item surface,
                                  um_geometry_tas_item parent,
                                  const struct um_geometry_tas_frame *frame)
{
  static const char *const sides[] = {"BOTH", "SIDE1", "SIDE2", "NONE"};
  um_geometry_tas_value v = um_geometry_tas_attribute(t, surface, SIDE);
  size_t side = 0;
  if (v != NULL)
    while (side < 4 && !(v->kind == UM_PART21_ENUM && um_geometry_part21_is(v->text, sides[side])))
      side++;
  if (side == 4)
    return um_geometry_tas_fail(t, surface,
                                "its active side; accepted: .BOTH., .SIDE1., .SIDE2. "
                                "or .NONE.");
  if (side == 3) {
    if (t->idle++ == 0) t->first_idle = surface;
    return UM_OK;
  }
  UM_TRY(put_names(t, surface, parent, side == 2));
  return um_geometry_tas_put_shape(t, surface, frame, side == 2);
}

static bool is_compound(um_geometry_tas_item item)
{
  return um_geometry_part21_is(item->name, COMPOUND) || um_geometry_part21_is(item->name, BOX);
}

static enum um_status put_item(struct um_geometry_tas *t, um_geometry_tas_item item,
                               um_geometry_tas_item parent,
                               const struct um_geometry_tas_frame *outer, int depth);

static enum um_status put_cut(struct um_geometry_tas *t, um_geometry_tas_item item,
                              um_geometry_tas_item parent,
                              const struct um_geometry_tas_frame *frame, int depth)
{
  um_geometry_tas_item target;
  size_t before = t->nsolid;
  UM_TRY(um_geometry_tas_item_at(t, item, ITEMS, "a surface", false, &target));
  if (t->cut == NULL) t->cut = item;
  enum um_status status = um_geometry_tas_cut_begin(t, item, frame);
  if (status == UM_OK) status = put_item(t, target, parent, frame, depth + 1);
  um_geometry_tas_cut_end(t, before);
  t->cut = before > 0 ? t->cut : NULL;
  return status;
}

/* An item and all in it; each stands in one place, so that this ends. */
static enum um_status put_item(struct um_geometry_tas *t, um_geometry_tas_item item,
                               um_geometry_tas_item parent,
                               const struct um_geometry_tas_frame *outer, int depth)
{
  struct um_geometry_tas_frame frame;
  uint32_t next = 0, end = 0;
  uint8_t *seen = &t->seen[item - t->file.instance];
  if (*seen & PLACED)
    return um_geometry_tas_fail(t, item, "stands in two items; accepted: each in one");
  if (depth == DEEPEST)
    return um_geometry_tas_fail(t, item, "stands too deep; accepted: at most %d items within items",
                                DEEPEST);
  *seen |= PLACED;
  UM_TRY(um_geometry_tas_place(t, item, PLACE, outer, &frame));
  if (um_geometry_part21_is(item->name, SURFACE)) return put_surface(t, item, parent, &frame);
  if (um_geometry_part21_is(item->name, CUT)) return put_cut(t, item, parent, &frame, depth);
  if (!is_compound(item))
    return um_geometry_tas_fail(t, item,
                                "is no item that is read; accepted: a surface, a "
                                "compound of surfaces or a cut one");
  UM_TRY(um_geometry_tas_list(t, item, ITEMS, &next, &end));
  t->cut = NULL; /* surfaces of a compound that is cut keep their names */
  for (; next < end; next = t->file.value[next].end) {
    um_geometry_tas_item child;
    UM_TRY(um_geometry_tas_listed(t, item, next, &child));
    UM_TRY(put_item(t, child, item, &frame, depth + 1));
  }
  return UM_OK;
}

/* Items of compounds, and what is cut, do not stand by themselves. */
static enum um_status mark_inside(struct um_geometry_tas *t)
{
  for (size_t i = 0; i < t->file.ninstance; i++) {
    um_geometry_tas_item item = &t->file.instance[i], child;
    uint32_t next = 0, end = 0;
    t->nsurface += um_geometry_part21_is(item->name, SURFACE);
    if (is_compound(item)) UM_TRY(um_geometry_tas_list(t, item, ITEMS, &next, &end));
    for (; next < end; next = t->file.value[next].end) {
      UM_TRY(um_geometry_tas_listed(t, item, next, &child));
      t->seen[child - t->file.instance] |= INSIDE;
    }
    if (!um_geometry_part21_is(item->name, CUT)) continue;
    UM_TRY(um_geometry_tas_item_at(t, item, ITEMS, "a surface", false, &child));
    t->seen[child - t->file.instance] |= INSIDE;
  }
  return UM_OK;
}

static enum um_status put_models(struct um_geometry_tas *t)
{
  static const struct um_geometry_tas_frame here = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 0, 0}};
  uint32_t next = 0, end = 0;
  bool any = false;
  for (size_t i = 0; i < t->file.ninstance; i++) {
    um_geometry_tas_item model = &t->file.instance[i], item;
    if (!um_geometry_part21_is(model->name, MODEL)) continue;
    any = true;
    UM_TRY(um_geometry_tas_list(t, model, ITEMS, &next, &end));
    for (; next < end; next = t->file.value[next].end) {
      UM_TRY(um_geometry_tas_listed(t, model, next, &item));
      if (t->seen[item - t->file.instance] & INSIDE) continue;
      UM_TRY(put_item(t, item, model, &here, 0));
    }
  }
  if (any && t->nfacet > 0) return UM_OK;
  return um_core_fail(t->context, UM_ERR_INPUT,
                      "%s: this STEP-TAS holds no %s; accepted: a "
                      "geometric model with surfaces",
                      t->path, any ? "surface with an active side" : MODEL);
}

/* Geometry, quantities, units and materials; no faces, networks, results or missions. */
static bool is_wanted(struct um_geometry_part21_text name)
{
  static const char *const others[] = {
      "NRF_MATERIAL",         "NRF_REAL_QUANTITY_VALUE_LITERAL", "NRF_REAL_QUANTITY_TYPE",
      "NRF_EXTENDED_SI_UNIT", "NRF_CONVERSION_BASED_UNIT",       "NRF_DERIVED_UNIT"};
  if (name.length > 4 && memcmp(name.at, "MGM_", 4) == 0)
    return !um_geometry_part21_is(name, "MGM_FACE");
  for (size_t i = 0; i < sizeof others / sizeof *others; i++)
    if (um_geometry_part21_is(name, others[i])) return true;
  return false;
}

enum um_status um_geometry_step_tas_read(struct um_context *context, const char *path,
                                         const char *bytes, size_t length, char **obj, size_t *n)
{
  enum um_status status;
  struct um_geometry_tas t = {.context = context, .path = path};
  UM_CHECK(um_geometry_part21_read(context, path, bytes, length, is_wanted, &t.file));
  UM_CHECK(um_core_allocate(context, t.file.ninstance, sizeof *t.seen, &t.seen));
  UM_CHECK(mark_inside(&t));
  UM_CHECK(put_models(&t));
  if (t.idle > 0) {
    char name[256];
    um_geometry_tas_text(&t, t.first_idle, NAME, name);
    um_core_log(context, UM_LOG_WARNING,
                "%s:%d: '%s': surfaces without an active side are left out, %zu of them", path,
                t.first_idle->line, name, t.idle);
  }
  *obj = t.text;
  *n = t.length;
  t.text = NULL;
done:
  um_geometry_part21_clear(context, &t.file);
  UM_FREE(context, t.text, t.seen, t.name, t.solid);
  return status;
}
