/* The OBJ reader: what it accepts, and the one line that it says when it refuses. */
#include <unistd.h>

#include "tests/geometry/support.h"
#include "tests/support/temporary.h"

struct file {
  char path[UM_TEST_PATH];
};

static struct file write_bytes(const char *text, size_t length)
{
  struct file file;
  um_test_file_create(file.path, text, length);
  return file;
}

static struct um_geometry_part_spec mesh_spec(const struct file *file)
{
  return (struct um_geometry_part_spec){.name = "asar",
                                        .shape = UM_SHAPE_MESH,
                                        .mesh_path = file->path,
                                        .rotation = {1, 0, 0, 0},
                                        .skins = &support_open,
                                        .nskin = 1};
}

static void accept(const char *text, struct support *s)
{
  struct file file = write_bytes(text, strlen(text));
  struct um_geometry_part_spec spec = mesh_spec(&file);
  *s = support_create(&spec, 1);
  unlink(file.path);
}

static void refuse_bytes(const char *text, size_t length, const char *expected)
{
  struct file file = write_bytes(text, length);
  struct um_geometry_part_spec spec = mesh_spec(&file);
  support_refused(&spec, 1, expected);
  support_refused(&spec, 1, file.path); /* the file is named */
  unlink(file.path);
}

static void refuse(const char *text, const char *expected)
{
  refuse_bytes(text, strlen(text), expected);
}

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

static double area(const struct support *s) { return um_geometry_report(s->geometry, 0).area; }

static void accepts_forms_of_face(void **state)
{
  (void)state;
  static const char *const text[] = {
      SQUARE "f 1 2 3 4\n", SQUARE "f -4 -3 -2 -1\n",
      "\xef\xbb\xbf# comment\r\n" SQUARE "vt 0 0\nvn 0 0 1\r\ns off\nf 1/1/1 2/1/1 3//1 4\r\n",
      SQUARE "f 1 2 \\\n 3 4 # corner\n", "f 1 2 3 4\n" SQUARE, /* an index may point forward */
      /* colours of vertices are passed over */
      "v 0 0 0 1\nv 1 0 0 0.5 1 1\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
      "mtllib x.mtl\no thing\n" SQUARE "  f\t1 2 3\nf 1 3 4\n"};
  for (size_t i = 0; i < sizeof text / sizeof *text; i++) {
    struct support s;
    accept(text[i], &s);
    assert_int_equal(s.mesh->nfacet, 2);
    assert_close(area(&s), 1.0, 1e-15);
    assert_close(s.pose->facet_normal[0].z, 1.0, 1e-15);
    support_destroy(&s);
  }
}

/* An L of three unit squares (area 3), a comb, and a polygon with corners on one line. */
static void accepts_polygons(void **state)
{
  (void)state;
  struct support s;
  accept("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n", &s);
  assert_close(area(&s), 3.0, 1e-14);
  assert_int_equal(s.mesh->nfacet, 4);
  for (size_t f = 0; f < 4; f++) assert_close(s.pose->facet_normal[f].z, 1.0, 1e-14);
  support_destroy(&s);
  /* the same seen from behind, in the plane x = y */
  accept("v 0 0 0\nv 0 0 2\nv 1 1 2\nv 1 1 1\nv 2 2 1\nv 2 2 0\nf 6 5 4 3 2 1\n", &s);
  assert_close(area(&s), 3.0 * sqrt(2.0), 1e-13);
  support_destroy(&s);
  /* teeth: 5 x 1 base, three 1 x 1 teeth */
  accept(
      "v 0 0 0\nv 5 0 0\nv 5 2 0\nv 4 2 0\nv 4 1 0\nv 3 1 0\nv 3 2 0\nv 2 2 0\nv 2 1 0\nv 1 1 0\n"
      "v 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n",
      &s);
  assert_close(area(&s), 8.0, 1e-13);
  support_destroy(&s);
  /* the middles of two sides are corners; a fan from the first corner would have no area there */
  accept("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n", &s);
  assert_close(area(&s), 4.0, 1e-14);
  assert_int_equal(um_geometry_report(s.geometry, 0).ndegenerate, 0);
  support_destroy(&s);
}

/* Group of a face: g before usemtl before o. Groups without faces do not exist. */
static void groups(void **state)
{
  (void)state;
  struct support s;
  accept("o body\n" SQUARE
         "f 1 2 3\nusemtl gold foil\nf 1 3 4\ng empty\ng wing\nv 3 0 0\nf 2 5 3\n",
         &s);
  assert_int_equal(um_geometry_group_count(s.geometry), 3);
  assert_string_equal(um_geometry_group(s.geometry, 0)->name, "body");
  assert_string_equal(um_geometry_group(s.geometry, 1)->name, "gold foil");
  assert_string_equal(um_geometry_group(s.geometry, 2)->name, "wing");
  support_destroy(&s);
  accept(SQUARE "f 1 2 3 4\n", &s);
  assert_string_equal(um_geometry_group(s.geometry, 0)->name, "mesh");
  support_destroy(&s);
}

#define CUBE_V "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
#define CUBE_F "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n"
#define CUBE   CUBE_V CUBE_F

/* Vertices given once per face are welded: a cube of 24 vertices is closed. Scale 0.01 m per unit.
 */
static void welds_and_scales(void **state)
{
  (void)state;
  char text[4096] = "";
  static const int face[6][4] = {{4, 3, 2, 1}, {5, 6, 7, 8}, {1, 2, 6, 5},
                                 {2, 3, 7, 6}, {3, 4, 8, 7}, {4, 1, 5, 8}};
  for (int f = 0; f < 6; f++) {
    for (int k = 0; k < 4; k++) {
      int i = face[f][k] - 1, x = (i & 3) == 1 || (i & 3) == 2, y = (i & 3) >= 2, z = i / 4;
      sprintf(text + strlen(text), "v %d %d %d\n", x, y, z);
    }
    strcat(text, "f -4 -3 -2 -1\n");
  }
  struct file file = write_bytes(text, strlen(text));
  struct um_geometry_part_spec spec = mesh_spec(&file);
  spec.skins = &support_closed;
  spec.mesh_scale = 0.01;
  spec.solid = true;
  struct support s = support_create(&spec, 1);
  struct um_geometry_report report = um_geometry_report(s.geometry, 0);
  assert_int_equal(report.nvertex, 8);
  assert_true(report.closed);
  assert_close(report.volume, 1e-6, 1e-18);
  assert_close(report.sharpest_angle, 0.25 * UM_PI, 1e-12);
  support_destroy(&s);
  unlink(file.path);
}

static void refuses_wrong_text(void **state)
{
  (void)state;
  refuse("v 0 0 0\nv 1 0\n", ":2: vertex with 2 of 3 coordinates");
  refuse("v 0 0 nan\n", ":1: vertex coordinate 'nan' is not a finite number");
  refuse("v 0 0 1e999\n", ":1: vertex coordinate '1e999'");
  refuse("v 0 0 1e160\n", ":1: vertex coordinate '1e160' is 1e+160 m; at most 1e+07 m is accepted");
  refuse("v 0 1,5 0\n", ":1: vertex coordinate '1,5'");
  refuse(SQUARE "f 1 2\n", ":5: incomplete face with 2 corners");
  refuse(SQUARE "f\n", ":5: incomplete face with 0 corners");
  refuse(SQUARE "f 1 2 5\n", ":5: vertex index 5 is out of range; the file has 4 vertices");
  refuse(SQUARE "f 1 2 -5\n", ":5: vertex index '-5'");
  refuse(SQUARE "f 0 1 2\n", ":5: vertex index 0");
  refuse(SQUARE "f 1 2 3.5\n", ":5: '3.5' is not a vertex index");
  refuse(SQUARE "f 1 2 x\n", ":5: 'x' is not a vertex index");
  refuse(SQUARE "f 1 2 99999999999999999999999\n", ":5: vertex index");
  refuse(SQUARE "f 1 2 2\n", ":5: the face uses vertex 2 twice");
  refuse(SQUARE "f 1 2 3\nhello world\n", ":6: 'hello'");
  refuse(SQUARE "usemtl_back x\nf 1 2 3\n", ":5: 'usemtl_back'"); /* a word of our own */
  refuse("", "no faces (0 vertices)");
  refuse(SQUARE, "no faces (4 vertices)");
  refuse(SQUARE "f 1 2 3\nf 1 3", ":6: the last line has no line end");
  refuse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1", ":4: the last line has no line end");
  refuse_bytes("v 0 0 0\nv 1\0 0 0\n", 18, ":2: NUL byte");
  refuse(SQUARE "v 0.5 0 0\nf 1 5 2\n", ":6: degenerate facet");
  refuse(SQUARE "f 1 2 3\nv 1 0 1e-13\nf 2 6 3\n", ":7: vertex index 6 is out of range");
  refuse(SQUARE "f 1 2 3\nv 1 0 1e-13\nf 2 5 3\n", ":7: degenerate facet");
  refuse(SQUARE "f 1 3 2 4\n", ":5: degenerate facet"); /* a bow tie */
  /* a star that winds round twice */
  refuse("v 1 0 0\nv -0.809 0.588 0\nv 0.309 -0.951 0\nv 0.309 0.951 0\nv -0.809 -0.588 0\n"
         "f 1 2 3 4 5\n",
         ":6: degenerate facet");
  struct um_geometry_part_spec spec = {.name = "asar",
                                       .shape = UM_SHAPE_MESH,
                                       .mesh_path = "/nonexistent/x.obj",
                                       .skins = &support_open,
                                       .nskin = 1};
  struct um_context *context;
  struct um_geometry *geometry;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  assert_int_equal(um_geometry_create(context, &spec, 1, &geometry), UM_ERR_IO);
  assert_non_null(strstr(um_core_message(context), "/nonexistent/x.obj"));
  um_core_context_destroy(&context);
}

/* Closed pieces need no back; an open one does; a solid must be closed and look outward. */
static void refuses_open_solids(void **state)
{
  (void)state;
  struct file open = write_bytes(CUBE, strlen(CUBE));
  struct um_geometry_part_spec spec = mesh_spec(&open);
  spec.solid = true;
  support_refused(&spec, 1, "declared solid but its mesh is not closed: 4 open edges");
  spec.solid = false;
  spec.skins = &support_closed;
  support_refused(&spec, 1, "has no back material");
  unlink(open.path);
  /* a closed cube in one part with an open square: backs belong to the square alone */
  static const char sail[] = "v 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\n";
  char text[640];
  snprintf(text, sizeof text, "%s%sg cube\n%s%sg sail\nf 9 10 11 12\n", CUBE_V, sail, CUBE_F,
           "f 4 1 5 8\n");
  struct file both = write_bytes(text, strlen(text));
  const struct um_geometry_skin skins[] = {{"cube", "paint", NULL}, {NULL, "cell", "cfrp"}};
  spec = mesh_spec(&both);
  spec.skins = skins;
  spec.nskin = 2;
  struct support s = support_create(&spec, 1);
  assert_int_equal(s.mesh->nsurface, 12 + 2 * 2);
  support_destroy(&s);
  spec.skins = &support_open;
  spec.nskin = 1;
  support_refused(&spec, 1, "group 'cube' has the back material 'cfrp', but its facets enclose");
  unlink(both.path);
  snprintf(text, sizeof text, "%s%sg all\n%s%sf 9 10 11 12\n", CUBE_V, sail, CUBE_F, "f 4 1 5 8\n");
  both = write_bytes(text, strlen(text));
  spec = mesh_spec(&both);
  spec.skins = &support_open;
  support_refused(&spec, 1, "group 'all' has the back material 'cfrp', but some of its facets");
  unlink(both.path);
  static const char inward[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\n"
                               "f 2 4 3\n";
  struct file file = write_bytes(inward, strlen(inward));
  spec = mesh_spec(&file);
  spec.solid = true;
  support_refused(&spec, 1, "encloses -0.166667 m3");
  unlink(file.path);
  static const char turned[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n"
                               "f 2 4 3\n";
  file = write_bytes(turned, strlen(turned));
  spec = mesh_spec(&file);
  spec.solid = true;
  support_refused(&spec, 1, "facets turned against each other");
  unlink(file.path);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(accepts_forms_of_face),
                                     cmocka_unit_test(accepts_polygons),
                                     cmocka_unit_test(groups),
                                     cmocka_unit_test(welds_and_scales),
                                     cmocka_unit_test(refuses_wrong_text),
                                     cmocka_unit_test(refuses_open_solids)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
