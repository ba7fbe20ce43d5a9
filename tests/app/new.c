/* umbra new: a folder with a scenario that runs, from the template, a mesh, elements, a station. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "tests/app/command.h"
#include "tests/app/failure.h"
#include "tests/app/table.h"

static void expect_in(const char *text, const char *holds)
{
  if (strstr(text, holds) == NULL) fail_msg("no '%s' in:\n%s", holds, text);
}

/* The template runs, in shadow and in sunlight, in both bands: dark and seen in V, always in LWIR.
 * Nothing but its name differs from the scenario that comes with the program. */
static void test_template(void **state)
{
  (void)state;
  struct command c = command_run("new", "mine", NULL);
  assert_int_equal(c.code, 0);
  expect_in(c.out, "umbra check mine");
  expect_in(c.out, "umbra run mine");
  command_release(&c);
  assert_false(command_exists("mine/.umbra")); /* the user's: no run replaces it */
  char *made = command_read("mine/scenario.yaml");
  size_t n;
  char *came =
      command_edit(command_read_bytes(UMBRA_SOURCE_DIR "/scenarios/cubesat-3u/scenario.yaml", &n),
                   "name: cubesat-3u", "name: \"mine\"");
  assert_string_equal(made, came);
  free(made);
  free(came);
  command_expect(0, "run", "mine", "--no-plots", "--set", "time.step_s=20", "--set",
                 "optics.relative_error=0.05", "--out", "out", NULL);
  struct table t = table_read("out/lightcurve.csv");
  double dark = 0.0, bright = 0.0, coldest = INFINITY;
  for (size_t i = 0; i < t.nrow; i++) {
    double v = table_number(&t, i, "V_intensity_W_sr"),
           lwir = table_number(&t, i, "lwir_intensity_W_sr");
    double sunlit = table_number(&t, i, "sunlit_fraction");
    if (sunlit == 0.0) dark = fmax(dark, v);
    bright = fmax(bright, v);
    coldest = fmin(coldest, lwir);
  }
  assert_true(dark < 1e-3 && bright > 0.3 && coldest > 0.4);
  table_release(&t);
}

#define BOX                                                                                        \
  "o bus\nv 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\nv 0 0 100\nv 100 0 100\nv 100 100 100\n"     \
  "v 0 100 100\ng bus.sides\nf 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"              \
  "g bus.lid\nusemtl white_paint\nf 5 6 7 8\n"                                                     \
  "o panel\nv 110 0 50\nv 310 0 50\nv 310 100 50\nv 110 100 50\n"                                  \
  "g panel\nusemtl nobody_knows\nf 9 10 11 12\n"

/* The example of docs/obj.md: two parts, millimetres by the size, materials by usemtl where there
 * is such a record; areas in m2. */
static void test_mesh(void **state)
{
  (void)state;
  size_t n;
  char *page = command_read_bytes(UMBRA_SOURCE_DIR "/docs/obj.md", &n);
  expect_in(page, "f 9 10 11 12");
  free(page);
  command_write("box.obj", BOX);
  struct command c = command_run("new", "small", "--from", "box.obj", NULL);
  assert_int_equal(c.code, 0);
  expect_in(c.out, "2 parts from box.obj, taken to be drawn in millimetres");
  command_release(&c);
  char *text = command_read("small/scenario.yaml");
  expect_in(text, "groups: [\"bus.sides\", \"bus.lid\"]");
  expect_in(text, "\"bus.sides\": aluminium_anodised\n");
  expect_in(text, "\"bus.lid\": white_paint\n");
  expect_in(text, "\"panel\": {front: aluminium_anodised, back: aluminium_anodised}");
  assert_null(strstr(text, "\ncontacts:"));
  free(text);
  char *mesh = command_read("small/box.obj");
  assert_string_equal(mesh, BOX);
  free(mesh);
  c = command_run("check", "small", "--json", NULL);
  assert_int_equal(c.code, 0);
  expect_in(c.out, "\"name\": \"bus\", \"facets\": 384, \"vertices\": 194, \"area_m2\": 0.06");
  expect_in(c.out, "\"name\": \"panel\"");
  command_release(&c);
}

/* A thermal model brings its optical properties: a record each, but of what the library has. It has
 * units, so that 200 m are no millimetres. */
static void test_thermal_model(void **state)
{
  (void)state;
  command_write(
      "model.stp",
      "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('tas_arm'));\nENDSEC;\nDATA;\n"
      "#1=NRF_EXTENDED_SI_UNIT(*,*,$,'','metre');\n"
      "#2=NRF_REAL_QUANTITY_TYPE(*,*,*,*,*,*,$,#1,$,$,.T.,$,.T.);\n"
      "#3=NRF_MATERIAL('Low e','','',$,$);\n#4=NRF_MATERIAL('white_paint','','',$,$);\n"
      "#5=NRF_REAL_QUANTITY_VALUE_LITERAL(#2,(0.25),());\n"
      "#6=NRF_REAL_QUANTITY_VALUE_LITERAL(#2,(0.),());\n"
      "#7=NRF_REAL_QUANTITY_VALUE_LITERAL(#2,(0.8),());\n"
      "#10=MGM_MESHED_GEOMETRIC_MODEL('m','','',$,$,$,(#20),(),(),(),(),(),(),(),(),(#3,#4),"
      "$,(((#5,#6,#6,#7,#6,#5),(#5,#6,#6,#6,#6,#7))),$,#20,());\n"
      "#20=MGM_MESHED_PRIMITIVE_BOUNDED_SURFACE('wall','','',$,$,$,#21,.BOTH.,$,$,#3,#4,$,$,"
      "$,$,1,1,$,$,$,$,(),());\n"
      "#21=MGM_RECTANGLE(#20,#22,#23,#24);\n#22=MGM_3D_CARTESIAN_POINT($,0.,0.,0.,#2);\n"
      "#23=MGM_3D_CARTESIAN_POINT($,200.,0.,0.,#2);\n#24=MGM_3D_CARTESIAN_POINT($,0.,1.,0.,#2)"
      ";\nENDSEC;\nEND-ISO-10303-21;\n");
  command_expect(0, "new", "thermal", "--from", "model.stp", NULL);
  char *text = command_read("thermal/scenario.yaml");
  expect_in(text, "\"wall\": {front: Low_e, back: white_paint}");
  expect_in(text, "\nmaterial_files:\n  - material_Low_e.yaml\n");
  assert_null(strstr(text, "white_paint.yaml"));
  free(text);
  text = command_read("thermal/material_Low_e.yaml");
  expect_in(text, "grey:\n  solar_absorptance: 0.25\n  emittance: 0.25\n  "
                  "vis_reflectance_diffuse: 0.15\n  specular_reflectance: 0.6\n");
  free(text);
  struct command c = command_run("check", "thermal", NULL);
  assert_int_equal(c.code, 0);
  expect_in(c.out, "Low_e                         200.0000      0.250      0.250");
  command_release(&c);
}

/* ENVISAT's elements of its scenario: a pass at night that crosses the shadow's edge, as a scenario
 * of that time says; the station's name is free. */
static void test_elements(void **state)
{
  (void)state;
  command_write("envisat.tle",
                "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
                "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n");
  struct command c = command_run("new", "a/envisat/", "--tle", "envisat.tle", "--station",
                                 "Zimmerwald, CH,46.877,7.465,951", NULL);
  assert_int_equal(c.code, 0);
  expect_in(c.out,
            "its pass begins at 2016-09-06T19:48:29.000Z: up to 89 deg high, dark sky, across the "
            "edge of the shadow");
  command_release(&c);
  char *text = command_read("a/envisat/scenario.yaml");
  expect_in(text, "\n  elements: elements.tle\n");
  expect_in(text, "station: {name: \"Zimmerwald, CH\", latitude_deg: 46.877,");
  expect_in(text, "\nname: \"envisat\"\n");
  free(text);
  c = command_run("passes", "a/envisat", "--json", NULL);
  assert_int_equal(c.code, 0);
  expect_in(c.out, "\"rise_utc\": \"2016-09-06T19:48:29.");
  command_release(&c);
}

/* The same elements as a message of a catalogue, to its digits: the pass begins in that second. */
static void test_message(void **state)
{
  (void)state;
  command_write("envisat.json",
                "[{\"OBJECT_NAME\": \"ENVISAT\", \"NORAD_CAT_ID\": 127386, \"EPOCH\": "
                "\"2016-09-06T18:00:10.965024\", \"MEAN_MOTION\": 14.3787479, \"ECCENTRICITY\": "
                "0.0001254, \"INCLINATION\": 98.2753, \"RA_OF_ASC_NODE\": 301.2152, "
                "\"ARG_OF_PERICENTER\": 82.1013, \"MEAN_ANOMALY\": 278.0311, \"BSTAR\": "
                "1.9645e-05}]\n");
  struct command c = command_run("new", "omm", "--tle", "envisat.json", "--station",
                                 "Zimmerwald,46.877,7.465,951", NULL);
  assert_int_equal(c.code, 0);
  expect_in(c.out, "its pass begins at 2016-09-06T19:48:2");
  command_release(&c);
  char *text = command_read("omm/scenario.yaml");
  expect_in(text, "\n  elements: elements.json\n");
  free(text);
}

static void test_refusals(void **state)
{
  (void)state;
  command_write("box.obj", BOX);
  command_write("part.stl", "solid part\nfacet normal 0 0 1\n");
  command_write("mixed.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 1\nv 3 0 0\nv 4 0 0\nv 3 1 0\n"
                             "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 5 6 7\n");
  command_write("bad.tle",
                "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9990\n"
                "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n");
  assert_int_equal(mkdir("there", 0777), 0);
  command_expect(0, "run", UMBRA_SOURCE_DIR "/scenarios/sphere", "--no-plots", "--set",
                 "time.step_s=600", "--out", "ours", NULL);
  static const struct failure failures[] = {
      {{"new", "there"}, "there: exists, and umbra new writes over nothing; accepted: a new name"},
      {{"new", "ours"}, "ours: exists, and umbra new writes over nothing"}, /* Umbra's own, too */
      {{"new", ".."}, "'..' cannot name a scenario"},
      {{"new", "x", "--from", "part.stl"}, "part.stl: this STL is not read: "},
      {{"new", "x", "--from", "mixed.obj"},
       "mixed.obj: group 'mesh' holds 4 triangles of closed bodies and 1 of open surfaces"},
      {{"new", "x", "--from", "none.obj"}, "none.obj: No such file"},
      {{"new", "x", "--tle", "bad.tle"}, "bad.tle: TLE line 1: checksum is 9, the line says 0"},
      {{"new", "x", "--station", "Graz,47"}, "accepted: NAME,LATITUDE,LONGITUDE,HEIGHT"},
      {{"new", "deep/x", "--station", "Graz,97,15,0"}, "accepted: NAME,LATITUDE,LONGITUDE,HEIGHT"},
  };
  failures_expect(failures, sizeof failures / sizeof failures[0]);
  command_expect(2, "new", NULL);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(test_template, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_mesh, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_thermal_model, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_elements, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_message, command_enter, command_leave),
      cmocka_unit_test_setup_teardown(test_refusals, command_enter, command_leave)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
