/* Wavefront OBJ: v, f, g, o, usemtl; vt, vn, vp, s, l, p, mtllib are read over; anything else, and
 * anything that is cut short, is refused with its line.
 *
 * Group of a face: the name of the last `g`; without one the last `usemtl`; without that the last
 * `o`; else "mesh". Names are the rest of their line. A backslash at the end joins two lines. */
#include "geometry/patch_impl.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "base/core/csv.h"
#include "base/core/file.h"
#include "base/core/suggestions.h"
#include "geometry/foreign_mesh_impl.h"
#include "geometry/polygon_impl.h"

#define MAX_FILE_BYTES ((size_t)1 << 30)
#define MAX_CORNERS    4096 /* of a face; each is compared with each */
#define BLANK          " \t"

struct reader {
  struct um_context *context;
  struct um_geometry_patch *patch;
  const char *path;
  int line;
  double scale;
  const struct um_geometry_obj_wish *wish;
  bool *found;                /* [wish->ngroup] has the file faces of it? */
  char others[400];           /* groups of the file that are not wished, for a message */
  const char *other;          /* the last of them */
  const char *g, *usemtl, *o; /* names in force, or NULL */
  const char *back;           /* material of the back, of a mesh that was not OBJ */
  bool made;                  /* it is one */
  /* faces are kept until all vertices are known: an index may point forward */
  int64_t *index; /* all faces one after the other, 0-based */
  size_t nindex, index_capacity;
  struct face {
    size_t begin, end;
    uint32_t group;
    int line;
  } * faces;
  size_t nface, faces_capacity;
};

#define FAIL(reader, ...) fail_at((reader), (reader)->line, __VA_ARGS__)

static enum um_status fail_at(struct reader *r, int line, const char *format, ...) UM_PRINTF(3, 4);
static enum um_status fail_at(struct reader *r, int line, const char *format, ...)
{
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return um_core_fail(r->context, UM_ERR_INPUT, "%s:%d: %s", r->path, line, text);
}

static enum um_status read_vertex(struct reader *r, char *rest)
{
  double x[3];
  char *save = NULL;
  for (int k = 0; k < 3; k++) {
    const char *token = strtok_r(k == 0 ? rest : NULL, BLANK, &save);
    if (token == NULL) return FAIL(r, "vertex with %d of 3 coordinates", k);
    if (!um_core_number_parse(token, &x[k]))
      return FAIL(r, "vertex coordinate '%.40s' is not a finite number", token);
    x[k] *= r->scale;
    if (!(fabs(x[k]) <= UM_GEOMETRY_MAX_LENGTH))
      return FAIL(r, "vertex coordinate '%.40s' is %g m; at most %g m is accepted", token, x[k],
                  UM_GEOMETRY_MAX_LENGTH);
  }
  return um_geometry_patch_vertex(r->patch, um_vec3(x[0], x[1], x[2]), NULL);
}

/* "7", "7/1", "7//3", "7/1/3", "-1//-1": the first number, 0-based. */
static enum um_status read_index(struct reader *r, const char *token, int64_t *index)
{
  char *end;
  long long value = strtoll(token, &end, 10);
  const char *tail = end;
  if (end == token || !(isdigit((unsigned char)*token) || *token == '-'))
    return FAIL(r, "'%.40s' is not a vertex index; accepted are 7, 7/1, 7//3, 7/1/3, -1", token);
  for (; *tail != '\0'; tail++)
    if (strchr("/-0123456789", *tail) == NULL)
      return FAIL(r, "'%.40s' is not a vertex index; accepted are 7, 7/1, 7//3, 7/1/3, -1", token);
  if (value == 0) return FAIL(r, "vertex index 0; indices begin at 1");
  if (value < 0)
    value += (long long)r->patch->nvertex; /* -1 is the latest */
  else
    value -= 1;
  if (value < 0)
    return FAIL(r, "vertex index '%.40s' goes back before the first of %zu vertices", token,
                r->patch->nvertex);
  *index = (int64_t)value;
  return UM_OK;
}

/* Is a face of this group taken? All are where none is wished. */
static bool is_wished(struct reader *r, const char *group)
{
  const struct um_geometry_obj_wish *wish = r->wish;
  bool wished = wish->ngroup == 0;
  for (size_t i = 0; i < wish->ngroup; i++) {
    if (strcmp(wish->groups[i], group) != 0) continue;
    wished = r->found[i] = true;
  }
  if (!wished && (r->other == NULL || strcmp(r->other, group) != 0)) {
    um_core_words_append(r->others, sizeof r->others, group);
    r->other = group;
  }
  return wished;
}

/* The group and, where that is asked for, what materials its first face names. */
static enum um_status take_group(struct reader *r, const char *group, uint32_t *index)
{
  size_t n = r->patch->ngroup;
  struct um_geometry_obj_material **material = r->wish->material;
  if (material != NULL && um_geometry_patch_group_find(r->patch, group) == UM_GEOMETRY_NONE) {
    UM_TRY(um_core_reallocate(r->context, n + 1, sizeof **material, material));
    (*material)[n] = (struct um_geometry_obj_material){NULL, NULL};
  }
  UM_TRY(um_geometry_patch_group(r->patch, group, index));
  if (material == NULL || r->patch->ngroup == n) return UM_OK;
  if (r->usemtl != NULL) UM_TRY(um_core_strdup(r->context, r->usemtl, &(*material)[n].front));
  return r->back == NULL ? UM_OK : um_core_strdup(r->context, r->back, &(*material)[n].back);
}

static enum um_status read_face(struct reader *r, char *rest)
{
  if (r->nface == r->faces_capacity) {
    size_t capacity = 2 * r->faces_capacity + 256;
    UM_TRY(um_core_reallocate(r->context, capacity, sizeof *r->faces, (void *)&r->faces));
    r->faces_capacity = capacity;
  }
  struct face *face = &r->faces[r->nface];
  *face = (struct face){r->nindex, r->nindex, 0, r->line};
  char *save = NULL;
  for (const char *token = strtok_r(rest, BLANK, &save); token != NULL;
       token = strtok_r(NULL, BLANK, &save)) {
    if (r->nindex == r->index_capacity) {
      size_t capacity = 2 * r->index_capacity + 1024;
      UM_TRY(um_core_reallocate(r->context, capacity, sizeof *r->index, (void *)&r->index));
      r->index_capacity = capacity;
    }
    int64_t index = 0;
    UM_TRY(read_index(r, token, &index));
    if (r->nindex - face->begin == MAX_CORNERS)
      return FAIL(r, "a face of more than %d corners; at most that many are accepted", MAX_CORNERS);
    for (size_t k = face->begin; k < r->nindex; k++)
      if (r->index[k] == index)
        return FAIL(r, "the face uses vertex %lld twice: '%.40s'", (long long)index + 1, token);
    r->index[r->nindex++] = index;
  }
  face->end = r->nindex;
  if (face->end - face->begin < 3)
    return FAIL(r, "incomplete face with %zu corners; at least 3 are needed",
                face->end - face->begin);
  const char *group = r->g != NULL ? r->g : r->usemtl != NULL ? r->usemtl : r->o;
  if (group == NULL) group = "mesh";
  if (!is_wished(r, group)) {
    r->nindex = face->begin;
    return UM_OK;
  }
  UM_TRY(take_group(r, group, &face->group));
  r->nface++;
  return UM_OK;
}

static enum um_status read_line(struct reader *r, char *line)
{
  static const char *const passed_over[] = {"vt", "vn", "vp", "s", "l", "p", "mtllib"};
  line += strspn(line, BLANK);
  char *comment = strchr(line, '#');
  if (comment != NULL) *comment = '\0';
  size_t length = strlen(line);
  while (length > 0 && strchr(BLANK "\r", line[length - 1]) != NULL) line[--length] = '\0';
  if (length == 0) return UM_OK;
  size_t n = strcspn(line, BLANK);
  char *rest = line + n;
  if (*rest != '\0') *rest++ = '\0';
  rest += strspn(rest, BLANK);
  if (strcmp(line, "v") == 0) return read_vertex(r, rest);
  if (strcmp(line, "f") == 0) return read_face(r, rest);
  const char *name = *rest != '\0' ? rest : NULL;
  bool back = r->made && strcmp(line, "usemtl_back") == 0;
  bool naming =
      strcmp(line, "g") == 0 || strcmp(line, "o") == 0 || strcmp(line, "usemtl") == 0 || back;
  if (naming && name != NULL && !um_core_name_is_safe_behind(name))
    return FAIL(r, "'%.100s' is not accepted; accepted: " UM_CORE_NAME_ACCEPTED_BEHIND, name);
  if (strcmp(line, "g") == 0)
    r->g = name;
  else if (strcmp(line, "o") == 0)
    r->o = name;
  else if (strcmp(line, "usemtl") == 0)
    r->usemtl = name;
  else if (back)
    r->back = name;
  else {
    for (size_t i = 0; i < sizeof passed_over / sizeof *passed_over; i++)
      if (strcmp(line, passed_over[i]) == 0) return UM_OK;
    return FAIL(r,
                "'%.40s' is not a statement that is understood; accepted are v f g o usemtl "
                "(vt vn vp s l p mtllib are passed over)",
                line);
  }
  return UM_OK;
}

/* Splits the text in place and reads each logical line. */
static enum um_status read_lines(struct reader *r, char *text, size_t length)
{
  char *at = text, *stop = text + length;
  if (length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) at += 3; /* UTF-8 mark */
  int physical = 0;
  while (at < stop) {
    char *line = at;
    r->line = physical + 1;
    for (;;) {
      char *end = memchr(at, '\n', (size_t)(stop - at));
      physical++;
      if (end == NULL) {
        char first = line[strspn(line, BLANK)];
        if (first == 'v' || first == 'f')
          return FAIL(r, "the last line has no line end: the file may be truncated; "
                         "append one when it is whole");
        at = stop;
        break;
      }
      char *last = end;
      if (last > line && last[-1] == '\r') last--;
      at = end + 1;
      if (last == line || last[-1] != '\\' || at == stop) {
        *end = '\0';
        break;
      }
      for (char *c = last - 1; c <= end; c++) *c = ' '; /* continued on the next line */
    }
    if (physical % 4096 == 0) UM_TRY(um_core_stop_check(r->context, "a mesh was read"));
    UM_TRY(read_line(r, line));
  }
  return UM_OK;
}

/* Triangles of one face into the patch. */
static enum um_status add_face(struct reader *r, const struct face *face, struct um_vec3 *p,
                               uint32_t *work, uint32_t (*triangle)[3])
{
  size_t n = face->end - face->begin;
  const int64_t *index = r->index + face->begin;
  for (size_t k = 0; k < n; k++) {
    if (index[k] >= (int64_t)r->patch->nvertex)
      return fail_at(r, face->line, "vertex index %lld is out of range; the file has %zu vertices",
                     (long long)index[k] + 1, r->patch->nvertex);
    p[k] = r->patch->vertex[index[k]];
  }
  if (!um_geometry_polygon_triangulate(p, n, work, triangle))
    return fail_at(r, face->line,
                   "degenerate facet: a face of %zu corners that has no area, crosses itself or "
                   "is too long and concave",
                   n);
  for (size_t t = 0; t + 2 < n; t++)
    UM_TRY(um_geometry_patch_facet(r->patch, (uint32_t)index[triangle[t][0]],
                                   (uint32_t)index[triangle[t][1]], (uint32_t)index[triangle[t][2]],
                                   face->group, face->line));
  return UM_OK;
}

static enum um_status add_faces(struct reader *r)
{
  enum um_status status;
  struct um_vec3 *p = NULL;
  uint32_t *work = NULL, (*triangle)[3] = NULL;
  size_t most = 3;
  for (size_t i = 0; i < r->nface; i++) {
    size_t n = r->faces[i].end - r->faces[i].begin;
    if (n > most) most = n;
  }
  UM_CHECK(um_core_allocate(r->context, most, sizeof *p, (void *)&p));
  UM_CHECK(um_core_allocate(r->context, most, sizeof *work, (void *)&work));
  UM_CHECK(um_core_allocate(r->context, most, sizeof *triangle, (void *)&triangle));
  for (size_t i = 0; i < r->nface; i++) {
    if (i % 1024 == 0) UM_CHECK(um_core_stop_check(r->context, "a mesh was read"));
    UM_CHECK(add_face(r, &r->faces[i], p, work, triangle));
  }
done:
  UM_FREE(r->context, p, work, triangle);
  return status;
}

/* Every wished group has faces. */
static enum um_status check_found(struct reader *r)
{
  for (size_t i = 0; i < r->wish->ngroup; i++)
    if (!r->found[i])
      return um_core_fail(r->context, UM_ERR_INPUT,
                          "%s: no group '%.80s' with faces; the file has: %s", r->path,
                          r->wish->groups[i], r->others);
  return UM_OK;
}

enum um_status um_geometry_obj_read(struct um_geometry_patch *patch, const char *path,
                                    const struct um_geometry_obj_wish *wish)
{
  enum um_status status;
  char *text = NULL, *made = NULL, *as_obj = NULL;
  size_t length = 0, nmade = 0;
  struct reader r = {
      .context = patch->context, .patch = patch, .path = path, .scale = wish->scale, .wish = wish};
  UM_CHECK(um_core_file_read(r.context, path, MAX_FILE_BYTES, &text, &length));
  /* of a file of several parts, warnings come once: with the part that takes all, or a look */
  if (wish->ngroup > 0) um_core_quiet_begin(r.context);
  status = um_geometry_foreign_read(r.context, path, text, length, &made, &nmade);
  if (wish->ngroup > 0) um_core_quiet_end(r.context);
  UM_CHECK(status);
  if (made != NULL) { /* lines are those of the OBJ that it became */
    um_core_free(r.context, text);
    text = made;
    length = nmade;
    UM_CHECK(um_core_asprintf(r.context, &as_obj, "%s (as OBJ)", path));
    r.path = as_obj;
    r.made = true;
  }
  const char *nul = memchr(text, '\0', length);
  if (nul != NULL) {
    int line = 1;
    for (const char *c = text; c < nul; c++) line += *c == '\n';
    UM_CHECK(fail_at(&r, line, "NUL byte: this is not a text file; an OBJ file is accepted"));
  }
  UM_CHECK(um_core_allocate(r.context, wish->ngroup + 1, sizeof *r.found, &r.found));
  UM_CHECK(read_lines(&r, text, length));
  if (r.nface == 0 && r.other == NULL) {
    status = um_core_fail(r.context, UM_ERR_INPUT,
                          "%s: no faces (%zu vertices): the file is empty or truncated", r.path,
                          patch->nvertex);
    goto done;
  }
  UM_CHECK(check_found(&r));
  UM_CHECK(add_faces(&r));
done:
  UM_FREE(r.context, text, as_obj, r.index, r.faces, r.found);
  return status;
}
