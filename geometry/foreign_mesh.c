/* Meshes and drawings of other formats, given where OBJ is expected: known by their first bytes. */
#include <stdint.h>
#include <string.h>

#include "geometry/patch_impl.h"

#define LOOK 4096 /* bytes in which a word is looked for */

#define MESH_TOOL                                                                                  \
  "open it in Blender (File > Import) or MeshLab and export it as Wavefront OBJ, as docs/obj.md "  \
  "says"
#define CAD_TOOL                                                                                   \
  "open it in FreeCAD, select the bodies and export them as Wavefront OBJ, as docs/obj.md says"

/* A file that begins with `first` and holds `word` soon after. */
struct foreign {
  const char *first, *word, *name, *convert;
};

static const struct foreign formats[] = {
    {"solid", "facet", "STL", MESH_TOOL},
    {"ply\n", "format", "PLY", MESH_TOOL},
    {"ply\r", "format", "PLY", MESH_TOOL},
    {"OFF", "", "OFF", MESH_TOOL},
    {"glTF", "", "glTF (binary, .glb)", MESH_TOOL},
    {"{", "\"asset\"", "glTF", MESH_TOOL},
    {"BLENDER", "", "a Blender file", MESH_TOOL},
    {"Kaydara FBX", "", "FBX", MESH_TOOL},
    {"<?xml", "<COLLADA", "COLLADA (.dae)", MESH_TOOL},
    {"PK\x03\x04", "", "a packed file (3MF, FreeCAD or ZIP)", "unpack it, or " MESH_TOOL},
    {"ISO-10303-21;", "", "STEP", CAD_TOOL},
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

/* The start section of IGES: 'S' in column 73 of the first line. */
static bool is_iges(const char *bytes, size_t length)
{
  return length > 80 && memchr(bytes, '\n', 73) == NULL && bytes[72] == 'S' &&
         holds(bytes + 73, 7, "1");
}

enum um_status um_geometry_foreign_refuse(struct um_context *context, const char *path,
                                          const char *bytes, size_t length)
{
  const struct foreign *found = NULL;
  static const struct foreign stl = {NULL, NULL, "STL", MESH_TOOL};
  static const struct foreign iges = {NULL, NULL, "IGES", CAD_TOOL};
  size_t blank = 0;
  while (blank < length && blank < LOOK && strchr(" \t\r\n", bytes[blank]) != NULL &&
         bytes[blank] != '\0')
    blank++;
  for (size_t i = 0; i < sizeof formats / sizeof *formats && found == NULL; i++) {
    size_t n = strlen(formats[i].first);
    if (length - blank >= n && memcmp(bytes + blank, formats[i].first, n) == 0 &&
        holds(bytes + blank, length - blank, formats[i].word))
      found = &formats[i];
  }
  if (is_binary_stl(bytes, length)) found = &stl;
  if (found == NULL && is_iges(bytes, length)) found = &iges;
  if (found == NULL) return UM_OK;
  return um_core_fail(context, UM_ERR_INPUT, "%s: this is %s; accepted: Wavefront OBJ; %s", path,
                      found->name, found->convert);
}
