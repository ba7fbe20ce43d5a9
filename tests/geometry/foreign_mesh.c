/* Meshes of other formats: one tetrahedron of 2, 3 and 4 m in each of them, and what is refused:
 * drawings that are named, files that are cut short, files that name others. */
#include <unistd.h>

#include "geometry/obj_look.h"
#include "tests/geometry/support.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

#define CORNERS                                                                                    \
  "AAAAAAAAAAAAAAAAAAAAQAAAAAAAAAAAAAAAAAAAQEAAAAAAAAAAAAAAAAAAAIBAAAACAAEAAAABAAMAAAADAAIAAQACAA" \
  "MA"
/* glTF of two nodes, `bus` 10 m along x and `other` mirrored, of a mesh whose 72 bytes lie at uri.
 */
#define GLTF(uri)                                                                                  \
  "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0, \"scenes\": [{\"nodes\": [0, 1]}],"           \
  "\"nodes\": [{\"name\": \"bus\", \"mesh\": 0, \"translation\": [10, 0, 0]},"                     \
  "{\"name\": \"other # one\", \"mesh\": 0, \"scale\": [-1, 1, 1]}],"                              \
  "\"materials\": [{\"name\": \"gold\"}],"                                                         \
  "\"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"indices\": 1, "            \
  "\"material\": 0}]}], \"accessors\": ["                                                          \
  "{\"bufferView\": 0, \"componentType\": 5126, \"count\": 4, \"type\": \"VEC3\", "                \
  "\"min\": [0, 0, 0], \"max\": [2, 3, 4]},"                                                       \
  "{\"bufferView\": 1, \"componentType\": 5123, \"count\": 12, \"type\": \"SCALAR\"}],"            \
  "\"bufferViews\": [{\"buffer\": 0, \"byteOffset\": 0, \"byteLength\": 48},"                      \
  "{\"buffer\": 0, \"byteOffset\": 48, \"byteLength\": 24}],"                                      \
  "\"buffers\": [{\"byteLength\": 72, \"uri\": \"" uri "\"}]}\n"

#define FACET(a, b, c)                                                                             \
  "facet normal 0 0 0\nouter loop\nvertex " a "\nvertex " b "\nvertex " c "\nendloop\nendfacet\n"
#define O "0 0 0"
#define X "2 0 0"
#define Y "0 3 0"
#define Z "0 0 4"

static const char stl[] = "solid part one\n" FACET(O, Y, X) FACET(O, X, Z) FACET(O, Z, Y)
    FACET(X, Y, Z) "endsolid part one\n";
static const char ply[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n2 0 0\n0 3 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
static const char off[] = "OFF\n4 4 0\n0 0 0\n2 0 0\n0 3 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n"
                          "3 1 2 3\n";

static struct um_geometry_part_spec spec_of(const char *path)
{
  return (struct um_geometry_part_spec){.name = "part",
                                        .shape = UM_SHAPE_MESH,
                                        .mesh_path = path,
                                        .mesh_scale = 0.5,
                                        .rotation = {1, 0, 0, 0},
                                        .skins = &support_closed,
                                        .nskin = 1};
}

/* Closed, outward, half as large as drawn: 6 m2 and more, 0.5 m3, `bodies` times. */
static void expect(const char *bytes, size_t length, int bodies)
{
  char path[UM_TEST_PATH];
  um_test_file_create(path, bytes, length);
  struct um_geometry_part_spec spec = spec_of(path);
  struct support s = support_create(&spec, 1);
  struct um_geometry_report report = um_geometry_report(s.geometry, 0);
  assert_true(report.closed);
  assert_close(report.volume, bodies * 0.5, 1e-6);
  assert_close(report.area, bodies * (3.0 + 4.0 + 6.0 + sqrt(61.0)) / 4.0, 1e-6);
  support_destroy(&s);
  unlink(path);
}

static size_t binary_stl(unsigned char *out)
{
  static const float corner[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}};
  static const int face[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  memset(out, 0, 84 + 4 * 50);
  memcpy(out, "solid in its header, too", 24);
  out[80] = 4;
  for (int f = 0; f < 4; f++)
    for (int k = 0; k < 3; k++) memcpy(out + 84 + 50 * f + 12 + 12 * k, corner[face[f][k]], 12);
  return 84 + 4 * 50;
}

static void reads_formats(void **state)
{
  (void)state;
  unsigned char binary[84 + 4 * 50];
  static const char gltf[] = GLTF("data:application/octet-stream;base64," CORNERS);
  size_t n = binary_stl(binary);
  expect(stl, strlen(stl), 1);
  expect((const char *)binary, n, 1);
  expect(ply, strlen(ply), 1);
  expect(off, strlen(off), 1);
  expect(gltf, strlen(gltf), 2);
}

/* Nodes are groups, where they stand; a name that OBJ would take for a comment is changed. */
static void nodes_are_groups(void **state)
{
  (void)state;
  static const char gltf[] = GLTF("data:application/octet-stream;base64," CORNERS);
  char path[UM_TEST_PATH];
  struct um_geometry_obj_look look;
  um_test_file_create(path, gltf, strlen(gltf));
  if (um_geometry_obj_look(context, path, &look) != UM_OK) fail_msg("%s", um_core_message(context));
  assert_int_equal(look.ngroup, 2);
  assert_string_equal(look.group[0].name, "bus");
  assert_string_equal(look.group[0].usemtl, "gold");
  assert_string_equal(look.group[1].name, "other _ one");
  assert_int_equal(look.npart, 2);
  assert_int_equal(look.group[1].nclosed, 4);
  assert_close(look.low.x, -2.0, 0.0);
  assert_close(look.high.x, 12.0, 0.0);
  um_geometry_obj_look_clear(context, &look);
  unlink(path);
}

static void refuse(const char *bytes, size_t length, const char *says)
{
  char path[UM_TEST_PATH];
  um_test_file_create(path, bytes, length);
  struct um_geometry_part_spec spec = spec_of(path);
  support_refused(&spec, 1, says);
  support_refused(&spec, 1, path);
  unlink(path);
}

/* What is no mesh that is read is named, with the way out. */
static void names_drawings(void **state)
{
  (void)state;
  char iges[200];
  memset(iges, ' ', sizeof iges);
  memcpy(iges + 72, "S      1\n", 9);
  refuse(
      "ISO-10303-21;\nHEADER;\n", 22,
      "this is STEP; accepted: Wavefront OBJ, STL, PLY, OFF, glTF, STEP-TAS; open it in FreeCAD");
  refuse(iges, sizeof iges, "this is IGES;");
  refuse("PK\3\4\24\0", 6, "this is a packed file");
  refuse("<?xml version=\"1.0\"?>\n<COLLADA>\n", 32, "this is COLLADA");
  refuse("BLENDER-v300", 12,
         "this is a Blender file; accepted: Wavefront OBJ, STL, PLY, OFF, "
         "glTF, STEP-TAS; open it in Blender");
}

/* Files that are cut short. */
static void cut_short(void **state)
{
  (void)state;
  unsigned char binary[84 + 4 * 50];
  size_t n = binary_stl(binary);
  struct um_geometry_part_spec spec = spec_of("cut.STL");
  FILE *file = fopen("cut.STL", "wb");
  assert_non_null(file);
  assert_int_equal(fwrite(binary, 1, n - 30, file), n - 30);
  assert_int_equal(fclose(file), 0);
  support_refused(&spec, 1, "cut.STL: this binary STL is cut short");
  remove("cut.STL");
  refuse(ply, strlen(ply) - 30, "this PLY is not read");
  refuse(GLTF("data:application/octet-stream;base64,AAAA"),
         strlen(GLTF("data:application/octet-stream;base64,AAAA")), "this glTF is not read: ");
  refuse("glTF\2\0\0\0\1\0\0\0", 12, "this glTF (.glb) is not read: ");
  refuse("solid part\n facet normal 0 0 1\n", 31, "");
}

/* A file that is there is not opened for a mesh that names it. */
static void leads_nowhere(void **state)
{
  (void)state;
  char corners[UM_TEST_PATH], text[4096];
  static const unsigned char bytes[72] = {1};
  um_test_file_create(corners, bytes, sizeof bytes);
  snprintf(text, sizeof text, GLTF("%s"), corners);
  refuse(text, strlen(text), "this glTF is not read: ");
  snprintf(text, sizeof text, GLTF("%s"), strrchr(corners, '/') + 1);
  refuse(text, strlen(text), "this glTF is not read: ");
  unlink(corners);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(reads_formats),
                                     cmocka_unit_test(nodes_are_groups),
                                     cmocka_unit_test(names_drawings), cmocka_unit_test(cut_short),
                                     cmocka_unit_test(leads_nowhere)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
