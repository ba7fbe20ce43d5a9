/* Meshes and drawings of other formats, given where OBJ is expected: known by their first bytes. */
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <strings.h>

#include "base/core/text.h"
#include "geometry/foreign_mesh_impl.h"

#define LOOK 4096 /* bytes in which a word is looked for */

#define MESH_TOOL                                                                                  \
  "open it in Blender (File > Import) or MeshLab and export it as Wavefront OBJ, as docs/obj.md "  \
  "says"
#define CAD_TOOL                                                                                   \
  "open it in FreeCAD, select the bodies and export them as Wavefront OBJ, as docs/obj.md says"

static const char step[] = "STEP";

/* A file that begins with `first` and holds `word` soon after. */
struct foreign {
  const char *first, *word, *name;
  const char *hint;    /* ending by which the importer knows it; NULL: it is refused */
  const char *convert; /* how it becomes one that is read */
};

static const struct foreign formats[] = {
    {"solid", "facet", "STL", "stl", NULL},
    {"ply\n", "format", "PLY", "ply", NULL},
    {"ply\r", "format", "PLY", "ply", NULL},
    {"OFF", "", "OFF", "off", NULL},
    {"glTF", "", "glTF (.glb)", "glb", NULL},
    {"{", "\"asset\"", "glTF", "gltf", NULL},
    {"BLENDER", "", "a Blender file", NULL, MESH_TOOL},
    {"Kaydara FBX", "", "FBX", NULL, MESH_TOOL},
    {"<?xml", "<COLLADA", "COLLADA (.dae)", NULL, MESH_TOOL},
    {"PK\x03\x04", "", "a packed file (3MF, FreeCAD or ZIP)", NULL, "unpack it, or " MESH_TOOL},
    {"ISO-10303-21;", "", step, NULL, CAD_TOOL},
};

/* Does `word` stand in the first bytes? There may be NUL bytes. */
static bool holds(const char *bytes, size_t length, const char *word)
{
  size_t n = strlen(word), end = length < LOOK ? length : LOOK;
  for (size_t i = 0; i + n <= end; i++)
    if (memcmp(bytes + i, word, n) == 0) return true;
  return false;
}

/* A header of 80 bytes, a number of triangles, 50 bytes for each of them. */
static bool is_binary_stl(const char *bytes, size_t length)
{
  if (length < 134) return false;
  const unsigned char *n = (const unsigned char *)bytes + 80;
  uint64_t triangles =
      n[0] | (uint64_t)n[1] << 8 | (uint64_t)n[2] << 16 | (uint64_t)n[3] << 24; /* little-endian */
  return length == 84 + 50 * triangles && memchr(bytes, '\0', length) != NULL;
}

/* One of another length is known by its name: a text has no NUL in it. */
static enum um_status check_cut_stl(struct um_context *context, const char *path, const char *bytes,
                                    size_t length)
{
  size_t n = strlen(path);
  if (n < 5 || strcasecmp(path + n - 4, ".stl") != 0 || memchr(bytes, '\0', length) == NULL)
    return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: this binary STL is cut short, or longer than its number of triangles "
                      "says; accepted: a whole file",
                      path);
}

/* The start section of IGES: 'S' in column 73 of the first line. */
static bool is_iges(const char *bytes, size_t length)
{
  return length > 80 && memchr(bytes, '\n', 73) == NULL && bytes[72] == 'S' &&
         holds(bytes + 73, 7, "1");
}

void um_geometry_foreign_name(char *name)
{
  for (char *c = name; *c != '\0'; c++)
    if ((unsigned char)*c < 0x20 || *c == 0x7f || strchr("#`\"\\$", *c) != NULL) *c = '_';
  if (!um_core_name_is_safe_behind(name))
    for (char *c = name; *c != '\0'; c++)
      if ((unsigned char)*c >= 0x80) *c = '_';
}

enum um_status um_geometry_foreign_read(struct um_context *context, const char *path,
                                        const char *bytes, size_t length, char **obj, size_t *n)
{
  const struct foreign *found = NULL;
  static const struct foreign stl = {NULL, NULL, "STL", "stl", NULL};
  static const struct foreign iges = {NULL, NULL, "IGES", NULL, CAD_TOOL};
  size_t blank = 0;
  while (blank < length && blank < LOOK && strchr(" \t\r\n", bytes[blank]) != NULL &&
         bytes[blank] != '\0')
    blank++;
  for (size_t i = 0; i < sizeof formats / sizeof *formats && found == NULL; i++) {
    size_t first = strlen(formats[i].first);
    if (length - blank >= first && memcmp(bytes + blank, formats[i].first, first) == 0 &&
        holds(bytes + blank, length - blank, formats[i].word))
      found = &formats[i];
  }
  if (is_binary_stl(bytes, length)) found = &stl;
  if (found == NULL && is_iges(bytes, length)) found = &iges;
  *obj = NULL;
  if (found == NULL) return check_cut_stl(context, path, bytes, length);
  if (found->hint != NULL)
    return um_geometry_assimp_read(context, path, found->name, found->hint, bytes, length, obj, n);
  if (found->name == step && um_geometry_step_tas_is(bytes, length))
    return um_geometry_step_tas_read(context, path, bytes, length, obj, n);
  return um_core_fail(context, UM_ERR_INPUT,
                      "%s: this is %s; accepted: Wavefront OBJ, STL, PLY, OFF, glTF, STEP-TAS; %s",
                      path, found->name, found->convert);
}
