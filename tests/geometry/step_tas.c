/* STEP-TAS as a part's mesh: each shape against its closed form, its place, its grid, its sides and
 * names; what is refused. The files are written here by hand. */
#include <unistd.h>

#include "geometry/obj_look.h"
#include "geometry/step_tas.h"
#include "tests/geometry/support.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

/* Units: #1 m, #2 mm, #3 inch, #4 deg, #5 rad; quantity types #11 to #15. Materials #6 and #7. */
#define HEAD                                                                                       \
  "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"                                        \
  "FILE_SCHEMA(('tas_arm {v6.0}'));\nENDSEC;\nDATA;\n"                                             \
  "#1=NRF_EXTENDED_SI_UNIT(*,*,$,'','metre');\n"                                                   \
  "#2=NRF_EXTENDED_SI_UNIT(*,*,$,'milli','metre');\n"                                              \
  "#3=NRF_CONVERSION_BASED_UNIT('inch','in',*,#1,39.37007874015748,0.0);\n"                        \
  "#4=NRF_CONVERSION_BASED_UNIT('degree','deg',*,#5,57.29577951308232,0.0);\n"                     \
  "#5=NRF_EXTENDED_SI_UNIT(*,*,$,'','radian');\n" TYPE("11", "#1") TYPE("12", "#2")                \
      TYPE("13", "#3") TYPE("14", "#4")                                                            \
          TYPE("15", "#5") "#6=NRF_MATERIAL('white_paint','','',$,$);\n#7=NRF_MATERIAL('cell''s'," \
                           "'','',$,$);"                                                           \
                           "\n"                                                                    \
                           "#8=NRF_PERSON('passed "                                                \
                           "over',(((1,2),'x;)'),.T.),\"0F\",LENGTH(1.5));\n" /* no                \
                                                                                 geometry          \
                                                                               */
#define TYPE(id, unit) "#" id "=NRF_REAL_QUANTITY_TYPE(*,*,*,*,*,*,$," unit ",$,$,.T.,$,.T.);\n"
#define TAIL           "ENDSEC;\nEND-ISO-10303-21;\n"
#define MODEL(items)                                                                               \
  "#10=MGM_MESHED_GEOMETRIC_MODEL('m','','',$,$,$,(" items "),(),(),(),(),(),(),(),(),(),$,$,$,"   \
  "$,());\n"
#define COMPOUND(id, place, items)                                                                 \
  "#" id "=MGM_COMPOUND_MESHED_GEOMETRIC_ITEM('all','','',$,$," place ",(" items "));\n"
#define SURFACE(id, name, place, shape, side, front, back, mesh)                                   \
  "#" id "=MGM_MESHED_PRIMITIVE_BOUNDED_SURFACE('" name "','','',$,$," place "," shape "," side    \
  ",$,$," front "," back ",$,$,$,$," mesh ",(),());\n"
#define POINT(id, x, y, z, type) "#" id "=MGM_3D_CARTESIAN_POINT($," x "," y "," z ",#" type ");\n"
#define VALUE(id, value, type)                                                                     \
  "#" id "=NRF_REAL_QUANTITY_VALUE_LITERAL(#" type ",(" value "),());\n"
/* Origin, the far end 0.4 m up, a point toward x that does not stand square; angles. */
#define FRAME                                                                                      \
  POINT("20", "0.", "0.", "0.", "11")                                                              \
  POINT("21", "0.", "0.", "400.", "12")                                                            \
  POINT("22", "2.", "0.", "1.", "11")                                                              \
  VALUE("30", "0.", "14")                                                                          \
  VALUE("31", "270.", "14")                                                                        \
  VALUE("32", "360.0", "14")                                                                       \
  VALUE("33", "0.1", "11")                                                                         \
  VALUE("34", "200.", "12")                                                                        \
  VALUE("35", "0.", "11")                                                                          \
  VALUE("36", "-0.1", "11")                                                                        \
  VALUE("37", "0.2", "11") VALUE("38", "-0.2", "11") VALUE("39", "0.78539816339744828", "15")
#define ONE(shape, side, mesh)                                                                     \
  HEAD FRAME MODEL("#40") SURFACE("40", "one", "$", "#41", side, "#6", "#7", mesh) "#41=" shape    \
                                                                                   ";\n" TAIL
#define RECTANGLE                                                                                  \
  POINT("50", "0.", "0.", "0.", "11")                                                              \
  POINT("51", "1.", "0.", "0.", "11")                                                              \
  POINT("52", "0.", "2.", "0.", "11") "#53=MGM_RECTANGLE($,#50,#51,#52);\n"

static struct um_geometry_part_spec spec_of(const char *path, bool closed)
{
  return (struct um_geometry_part_spec){.name = "part",
                                        .shape = UM_SHAPE_MESH,
                                        .mesh_path = path,
                                        .rotation = {1, 0, 0, 0},
                                        .skins = closed ? &support_closed : &support_open,
                                        .nskin = 1};
}

static struct support build(const char *text, bool closed)
{
  char path[UM_TEST_PATH];
  um_test_file_create(path, text, strlen(text));
  struct um_geometry_part_spec spec = spec_of(path, closed);
  struct support s = support_create(&spec, 1);
  unlink(path);
  return s;
}

static struct um_geometry_obj_look look_at(const char *text)
{
  char path[UM_TEST_PATH];
  struct um_geometry_obj_look look;
  um_test_file_create(path, text, strlen(text));
  if (um_geometry_obj_look(context, path, &look) != UM_OK) fail_msg("%s", um_core_message(context));
  unlink(path);
  return look;
}

static double area_of(const struct support *s) { return um_geometry_report(s->geometry, 0).area; }

/* Least of normal . outward over all facets: from the z axis, or along z where `up`. */
static double least_outward(const struct support *s, bool up)
{
  double least = 2.0;
  for (size_t f = 0; f < s->mesh->nfacet; f++) {
    struct um_vec3 c = um_vec3(0, 0, 0), n = s->pose->facet_normal[f];
    for (int k = 0; k < 3; k++) c = um_vec3_add(c, s->pose->vertex[s->mesh->corner[f][k]]);
    c = up ? um_vec3(0, 0, 1) : um_vec3_unit(um_vec3(c.x, c.y, 0));
    least = fmin(least, um_vec3_dot(n, c));
  }
  return least;
}

#define STEP (UM_PI / 180.0)

/* Polygons of the pieces that each face is cut into: 270 deg in 4 faces of 7, 45 deg in one of 5.
 * They fall short of the circle by less than 0.51 %, at steps of 10 deg. */
static void discs_and_cylinders(void **state)
{
  (void)state;
  double step = 270.0 / 28.0 * STEP, area = 0.5 * (0.2 * 0.2 - 0.1 * 0.1) * 28 * sin(step);
  struct support s =
      build(ONE("MGM_DISC($,#20,#21,#22,#33,#34,#30,#31)", ".BOTH.", "3,4,$,$,$,$"), false);
  assert_int_equal(s.mesh->nfacet, 3 * 28 * 2);
  assert_close(area_of(&s), area, 1e-15);
  assert_close(area, 0.5 * (0.04 - 0.01) * 1.5 * UM_PI, 0.0051 * area);
  assert_close(least_outward(&s, true), 1.0, 1e-12);
  support_destroy(&s);
  s = build(ONE("MGM_CYLINDER($,#20,#21,#22,#34,#30,#39)", ".BOTH.", "2,1,$,$,$,$"), false);
  step = 9.0 * STEP;
  assert_int_equal(s.mesh->nfacet, 2 * 5 * 2);
  assert_close(area_of(&s), 0.4 * 5 * 2.0 * 0.2 * sin(step / 2), 1e-15);
  assert_close(area_of(&s), 0.4 * 0.2 * UM_PI / 4, 0.0013 * area_of(&s));
  assert_true(least_outward(&s, false) > 0.99);
  support_destroy(&s);
  /* its second side: all is turned over */
  s = build(ONE("MGM_CYLINDER($,#20,#21,#22,#34,#30,#39)", ".SIDE2.", "2,1,$,$,$,$"), false);
  assert_true(least_outward(&s, false) < -0.99);
  support_destroy(&s);
}

/* n plane trapezoids of a frustum, and a cone to its point. */
static void cones(void **state)
{
  (void)state;
  double s2 = sin(5.0 * STEP), c2 = cos(5.0 * STEP);
  struct support s =
      build(ONE("MGM_CONE($,#20,#21,#22,#33,#34,#30,#32)", ".SIDE1.", "2,4,$,$,$,$"), false);
  /* 90 deg are 9 pieces */
  assert_close(area_of(&s), 36 * s2 * 0.3 * sqrt(0.16 + 0.01 * c2 * c2), 1e-14);
  assert_close(area_of(&s), UM_PI * 0.3 * sqrt(0.17), 0.0015 * area_of(&s));
  assert_true(least_outward(&s, false) > 0.9);
  assert_int_equal(um_geometry_report(s.geometry, 0).nboundary_edge, 72);
  support_destroy(&s);
  s = build(ONE("MGM_CONE($,#20,#21,#22,#34,#35,#30,#32)", ".BOTH.", "1,4,$,$,$,$"), false);
  assert_int_equal(s.mesh->nfacet, 36);
  assert_close(area_of(&s), 36 * s2 * 0.2 * sqrt(0.16 + 0.04 * c2 * c2), 1e-14);
  support_destroy(&s);
}

/* A zone: corners on the sphere, between its cuts, with the file's own parallels; whole, it closes.
 * Facets of 10 deg fall short by 0.54 % here, by 0.63 % all over. */
static void spheres(void **state)
{
  (void)state;
  struct support s =
      build(ONE("MGM_SPHERE($,#20,#21,#22,#34,#36,#33,#30,#32)", ".BOTH.", "3,4,$,$,$,$"), false);
  bool parallel = false;
  double low = 1.0, high = -1.0;
  for (size_t i = 0; i < s.mesh->nvertex; i++) {
    struct um_vec3 p = s.pose->vertex[i];
    assert_close(um_vec3_norm(p), 0.2, 1e-15);
    low = fmin(low, p.z);
    high = fmax(high, p.z);
    parallel = parallel || fabs(p.z - 0.2 * sin(10.0 * STEP)) < 1e-15; /* 60 deg in three */
  }
  assert_true(parallel);
  assert_close(low, -0.1, 1e-15);
  assert_close(high, 0.1, 1e-15);
  assert_close(area_of(&s), 2.0 * UM_PI * 0.2 * 0.2, 0.0055 * area_of(&s));
  assert_true(area_of(&s) < 2.0 * UM_PI * 0.2 * 0.2);
  assert_true(least_outward(&s, false) > 0.85);
  support_destroy(&s);
  s = build(ONE("MGM_SPHERE($,#20,#21,#22,#34,#38,#37,#30,#32)", ".BOTH.", "1,1,$,$,$,$"), true);
  assert_int_equal(s.mesh->nfacet, 36 * (16 * 2 + 2));
  assert_true(um_geometry_report(s.geometry, 0).closed);
  assert_close(um_geometry_report(s.geometry, 0).volume, 4.0 / 3.0 * UM_PI * 0.008, 0.00043);
  support_destroy(&s);
}

/* z = H r^2 / R^2, whole and above 0.1 m, where facets fall short by 0.8 % at most: A = pi / (6
 * c^2) [(1 + 4 c^2 r^2)^1.5], c = H / R^2. */
static double dish(double c, double r)
{
  return UM_PI / (6 * c * c) * pow(1 + 4 * c * c * r * r, 1.5);
}

static void paraboloids(void **state)
{
  (void)state;
  double c = 0.4 / 0.04, exact = dish(c, 0.2) - dish(c, 0.0);
  struct support s =
      build(ONE("MGM_PARABOLOID($,#20,#21,#22,#34,#35,#30,#32)", ".BOTH.", "2,1,$,$,$,$"), false);
  for (size_t i = 0; i < s.mesh->nvertex; i++) {
    struct um_vec3 p = s.pose->vertex[i];
    assert_close(p.z, c * (p.x * p.x + p.y * p.y), 1e-15);
  }
  assert_close(area_of(&s), exact, 0.008 * exact);
  assert_true(area_of(&s) < exact);
  assert_true(least_outward(&s, false) > 0.0); /* its convex side */
  support_destroy(&s);
  s = build(ONE("MGM_PARABOLOID($,#20,#21,#22,#34,#33,#30,#32)", ".BOTH.", "1,1,$,$,$,$"), false);
  exact = dish(c, 0.2) - dish(c, 0.1);
  assert_close(area_of(&s), exact, 0.008 * exact);
  assert_int_equal(um_geometry_report(s.geometry, 0).nboundary_edge, 72);
  support_destroy(&s);
}

/* Has the mesh a corner here? */
static bool has(const struct support *s, double x, double y, double z)
{
  for (size_t i = 0; i < s->mesh->nvertex; i++)
    if (um_vec3_norm(um_vec3_sub(s->pose->vertex[i], um_vec3(x, y, z))) < 1e-14) return true;
  return false;
}

/* Planes in inches and metres, cut by numbers of faces and by positions. */
static void planes(void **state)
{
  (void)state;
  static const char rectangle[] = HEAD RECTANGLE MODEL("#40")
      SURFACE("40", "r", "$", "#53", ".BOTH.", "$", "$", "2,2,$,$,(0.,0.25,1.),(0.0,0.5,1.0)") TAIL;
  static const char triangle[] =
      HEAD POINT("50", "0.", "0.", "0.", "13") POINT("51", "10.", "0.", "0.", "13")
          POINT("52", "0.", "20.", "0.", "13") "#53=MGM_TRIANGLE($,#50,#51,#52);\n" MODEL("#40")
              SURFACE("40", "t", "$", "#53", ".BOTH.", "$", "$", "3,2,$,$,$,$") TAIL;
  static const char quadrilateral[] = HEAD RECTANGLE POINT(
      "54", "2.", "4.", "0.", "11") "#55=MGM_QUADRILATERAL($,#50,#51,#54,#52);\n" MODEL("#40")
      SURFACE("40", "q", "$", "#55", "$", "$", "$", "2,2,$,$,(),()") TAIL;
  struct support s = build(rectangle, false);
  assert_int_equal(s.mesh->nfacet, 8);
  assert_true(has(&s, 0.25, 1.0, 0.0) && has(&s, 0.25, 2.0, 0.0) && !has(&s, 0.5, 1.0, 0.0));
  assert_close(area_of(&s), 2.0, 1e-15);
  assert_close(least_outward(&s, true), 1.0, 0.0);
  support_destroy(&s);
  s = build(triangle, false);
  assert_int_equal(s.mesh->nfacet, 2 + 4 + 4);
  assert_true(has(&s, 0.254 / 3, 0.0, 0.0) && has(&s, 0.127, 0.254, 0.0));
  assert_close(area_of(&s), 0.5 * 0.254 * 0.508, 1e-15);
  assert_close(least_outward(&s, true), 1.0, 0.0);
  support_destroy(&s);
  s = build(quadrilateral, false);
  assert_int_equal(s.mesh->nfacet, 8);
  assert_true(has(&s, 0.75, 1.5, 0.0));  /* the mean of its corners */
  assert_close(area_of(&s), 4.0, 1e-15); /* two triangles, of 0 2 + 2 1 */
  assert_close(least_outward(&s, true), 1.0, 0.0);
  support_destroy(&s);
}

/* What is done first stands first; a compound moves what is in it. */
static void places(void **state)
{
  (void)state;
  static const char nested[] = HEAD RECTANGLE MODEL("#40,#41") COMPOUND("41", "#60", "#40")
      SURFACE("40", "r", "#70", "#53", ".BOTH.", "$", "$", "1,1,$,$,$,$")
          POINT("61", "0.", "3.", "0.",
                "11") "#62=MGM_3D_DIRECTION(0.,0.,5.);\n"
                      "#63=MGM_3D_DIRECTION(0.,1.,0.5);\n#60=MGM_AXIS_PLACEMENT(#61,#62,#63);\n"
                      "#70=MGM_AXIS_TRANSFORMATION_SEQUENCE((#71,#72,#73));\n"
                      "#71=MGM_ROTATION_WITH_AXES_FIXED(#62,90,#14);\n"
                      "#72=MGM_TRANSLATION(10000.,0.,0.,#12);\n"
                      "#73=MGM_ROTATION_WITH_AXES_FIXED(#74,90.,#14);\n"
                      "#74=MGM_3D_DIRECTION(1.,0.,0.);\n" TAIL;
  struct support s = build(nested, false);
  /* (1, 2, 0), about z (-2, 1, 0), moved (8, 1, 0), about x (8, 0, 1); x is y and y is -x: */
  assert_true(has(&s, 0.0, 11.0, 1.0));
  assert_int_equal(s.mesh->nvertex, 4);
  assert_true(has(&s, 0.0, 13.0, 0.0));                /* (0, 0, 0) */
  assert_true(has(&s, 0.0, 13.0, 1.0));                /* (1, 0, 0) */
  assert_true(has(&s, 0.0, 11.0, 0.0));                /* (0, 2, 0) */
  assert_close(s.pose->facet_normal[0].x, 1.0, 1e-15); /* z, z, -y, x */
  support_destroy(&s);
}

/* A group is a surface, with the material of its front; of NONE there is none. */
static void names(void **state)
{
  (void)state;
  static const char text[] = HEAD RECTANGLE MODEL("#41,#40,#42,#43,#44") COMPOUND("44", "$", "#42")
      SURFACE("40", "panel", "$", "#53", ".SIDE1.", "#6", "#7", "1,1,$,$,$,$")
          SURFACE("41", "panel", "#46", "#53", ".SIDE2.", "#6", "#7", "1,1,$,$,$,$")
              SURFACE("42", "lid # ''one''", "#45", "#53", ".BOTH.", "$", "$", "$,$,$,$,$,$")
                  SURFACE("43", "gone", "$", "#53", ".NONE.", "$", "$",
                          "1,1,$,$,$,$") "#45=MGM_TRANSLATION(0.,0.,1.,#11);\n#46=MGM_TRANSLATION("
                                         "0.,0.,2.,#11);\n" TAIL;
  struct um_geometry_obj_look look = look_at(text);
  assert_int_equal(look.ngroup, 3);
  assert_string_equal(look.group[0].name, "panel");
  assert_string_equal(look.group[0].usemtl, "cell's");
  assert_string_equal(look.group[1].name, "panel_2");
  assert_string_equal(look.group[1].usemtl, "white_paint");
  assert_string_equal(look.group[2].name, "lid _ 'one'");
  assert_string_equal(look.group[0].usemtl_back, "white_paint"); /* it is turned over */
  assert_null(look.group[2].usemtl);
  assert_null(look.group[2].usemtl_back);
  assert_non_null(strstr(um_core_log_text(context), "'gone': surfaces without an active side are "
                                                    "left out, 1 of them"));
  um_geometry_obj_look_clear(context, &look);
}

/* More surfaces than a part may have groups: they go by the item that they stand in. */
static void many_surfaces(void **state)
{
  (void)state;
  char *text = NULL, path[UM_TEST_PATH];
  size_t n = 0;
  struct um_geometry_obj_look look;
  FILE *file = open_memstream(&text, &n);
  assert_non_null(file);
  fputs(HEAD RECTANGLE MODEL("#90") "#90=MGM_COMPOUND_MESHED_GEOMETRIC_ITEM('wall','','',$,$,$,(",
        file);
  for (int i = 0; i < 2001; i++) fprintf(file, "%s#%d", i > 0 ? "," : "", 1000 + 2 * i);
  fputs("));\n", file);
  for (int i = 0; i < 2001; i++)
    fprintf(file,
            "#%d=MGM_MESHED_PRIMITIVE_BOUNDED_SURFACE('s%d','','',$,$,#%d,#53,.BOTH.,$,$,#6);\n"
            "#%d=MGM_TRANSLATION(0.,0.,%d.,#11);\n",
            1000 + 2 * i, i, 1001 + 2 * i, 1001 + 2 * i, i);
  fputs(TAIL, file);
  assert_int_equal(fclose(file), 0);
  um_test_file_create(path, text, n);
  if (um_geometry_obj_look(context, path, &look) != UM_OK) fail_msg("%s", um_core_message(context));
  assert_int_equal(look.ngroup, 1);
  assert_string_equal(look.group[0].name, "wall.white_paint");
  assert_int_equal(look.group[0].nfacet, 4002);
  um_geometry_obj_look_clear(context, &look);
  unlink(path);
  free(text);
}

/* Optical properties of the first of two environments: those of #6 in full, of #7 four; a bulk
 * material without any is left out. */
#define OPTICS(rows)                                                                               \
  HEAD RECTANGLE                                                                                   \
      "#9=NRF_MATERIAL('bulk','','',$,$);\n#10=MGM_MESHED_GEOMETRIC_MODEL('m','','',$,$,$,(#40),(" \
      "),"                                                                                         \
      "(),(),(),(),(),(),(),(#6,#7,#9),$,(" rows                                                   \
      "),$,#40,());\n" SURFACE("40", "r", "$", "#53", ".BOTH.", "#6", "#7", "1,1,$,$,$,$")         \
          VALUE("80", "0.2", "11") VALUE("81", "0.05", "11") VALUE("82", "0.1", "11")              \
              VALUE("83", "0.4", "11") VALUE("84", "1.5", "11") VALUE("85", "0.88", "11")          \
                  VALUE("86", "0.0", "11") TAIL
static void materials(void **state)
{
  (void)state;
  char path[UM_TEST_PATH];
  struct um_geometry_step_tas_optical *optical;
  size_t n;
  bool is;
  static const char text[] =
      OPTICS("((#80,#81,#82,#83,#84,#85,#86,#86,#83,#84,#80),(#85,#86,#86,#86,"
             "#86,#80),(#86,#86)),((#85),(#85),(#85))");
  um_test_file_create(path, text, strlen(text));
  if (um_geometry_step_tas_materials(context, path, &optical, &n, &is) != UM_OK)
    fail_msg("%s", um_core_message(context));
  unlink(path);
  assert_true(is);
  assert_int_equal(n, 2);
  assert_string_equal(optical[0].name, "white_paint");
  assert_close(optical[0].solar_absorptance, 0.2, 0.0);
  assert_close(optical[0].solar_transmittance, 0.15, 1e-15);
  assert_close(optical[0].solar_specularity, 0.4, 0.0);
  assert_close(optical[0].emittance, 0.88, 0.0);
  assert_string_equal(optical[1].name, "cell's");
  assert_close(optical[1].solar_absorptance, 0.88, 0.0);
  assert_close(optical[1].emittance, 0.2, 0.0);
  um_core_free(context, optical);
  static const struct {
    const char *text, *says;
  } faults[] = {
      {OPTICS("((#84))"),
       "#6 NRF_MATERIAL 'white_paint': its optical properties; accepted: shares"},
      {OPTICS("((#80,#85))"), "absorbs and lets through more than arrives"},
      {OPTICS("(#80)"), "accepted: a list of its properties"},
  };
  for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
    um_test_file_create(path, faults[i].text, strlen(faults[i].text));
    assert_int_equal(um_geometry_step_tas_materials(context, path, &optical, &n, &is),
                     UM_ERR_INPUT);
    if (strstr(um_core_message(context), faults[i].says) == NULL)
      fail_msg("'%s' is not said: %s", faults[i].says, um_core_message(context));
    um_core_message_clear(context);
    unlink(path);
  }
}

/* --- cuts --------------------------------------------------------------------------------------
 */

/* A plate of 1 x 2 m in 3 x 4 faces, side 1 toward +z, cut by a tool whose solid is `solid`. */
#define CUT_OF(id, what, tool)                                                                     \
  "#" id "=MGM_MESHED_BOOLEAN_DIFFERENCE_SURFACE('cut" id "','','',$,$,$,#" what ",#" tool ");\n"
#define TOOL(id, place, solid)                                                                     \
  "#" id "=MGM_HALF_SPACE_SOLID('tool','',''," place ",#" solid ",.INSIDE.);\n"
#define PLATE(cuts)                                                                                \
  HEAD FRAME RECTANGLE MODEL("#60")                                                                \
      SURFACE("40", "plate", "$", "#53", ".BOTH.", "#6", "#7", "3,4,$,$,$,$") cuts TAIL
/* Tools: 0.4 m along z from 0.1 m below the plate's middle. */
#define CENTRE                                                                                     \
  POINT("70", "0.47", "1.03", "-0.1", "11")                                                        \
  POINT("71", "0.47", "1.03", "0.3", "11")                                                         \
  POINT("72", "0.97", "1.03", "-0.1", "11")                                                        \
  POINT("73", "0.47", "1.33", "-0.1", "11") VALUE("74", "0.3", "11") VALUE("75", "0.1", "11")

/* Length of edges that one facet alone has: the outline, and what a hanging corner would add. */
static double open_edges(const struct support *s)
{
  double length = 0.0;
  const struct um_geometry_mesh *m = s->mesh;
  for (size_t f = 0; f < m->nfacet; f++)
    for (int k = 0; k < 3; k++) {
      uint32_t a = m->corner[f][k], b = m->corner[f][(k + 1) % 3];
      bool shared = false;
      for (size_t g = 0; g < m->nfacet && !shared; g++)
        for (int i = 0; i < 3; i++)
          shared = shared || (m->corner[g][i] == b && m->corner[g][(i + 1) % 3] == a);
      if (!shared) length += um_vec3_norm(um_vec3_sub(s->pose->vertex[a], s->pose->vertex[b]));
    }
  return length;
}

/* What the cut leaves of the plate's 2 m2, and its outline of 6 m with that of the hole. */
static void expect_cut(const char *text, double hole, double around, double tolerance)
{
  struct support s = build(text, false);
  assert_close(area_of(&s), 2.0 - hole, tolerance * hole + 1e-12);
  assert_close(open_edges(&s), 6.0 + around, 3e-3 * around + 1e-9);
  assert_true(least_outward(&s, true) > 1.0 - 1e-12); /* fronts stay where they were */
  support_destroy(&s);
}

/* Holes: of planes exact; of round tools their area, as their sides are made for it (1e-12), and a
 * ball's within 1e-3. A circle's outline is that of the polygon, 0.03 % more. At z = 0 a cone of
 * radii 0.3 and 0.1 over 0.4 m has 0.25 m; the ball about (0.47, 1.03, -0.1) sqrt(0.09 - 0.01). */
static void cut_plates(void **state)
{
  (void)state;
  const double pi = 3.14159265358979323846, ball = 0.09 - 0.01;
  expect_cut(PLATE(CENTRE CUT_OF("60", "40", "61")
                       TOOL("61", "$", "62") "#62=MGM_SOLID_BOX($,#70,#72,#73,#71);\n"),
             0.15, 1.6, 0.0);
  expect_cut(PLATE(CENTRE CUT_OF("60", "40", "61") TOOL(
                 "61", "$", "62") "#62=MGM_SOLID_TRIANGULAR_PRISM($,#70,#72,#73,#71);\n"),
             0.075, 0.8 + sqrt(0.34), 0.0);
  expect_cut(PLATE(CENTRE CUT_OF("60", "40", "61") TOOL(
                 "61", "$", "62") "#62=MGM_SOLID_CYLINDER($,#70,#71,#72,#74,#30,#32);\n"),
             pi * 0.09, 2 * pi * 0.3, 1e-12);
  expect_cut(PLATE(CENTRE CUT_OF("60", "40", "61") TOOL(
                 "61", "$", "62") "#62=MGM_SOLID_CONE($,#70,#71,#72,#74,#75,#30,#32);\n"),
             pi * 0.0625, 2 * pi * 0.25, 1e-12);
  expect_cut(PLATE(CENTRE VALUE("76", "-0.3", "11") CUT_OF("60", "40", "61") TOOL(
                 "61", "$", "62") "#62=MGM_SOLID_SPHERE($,#70,#71,#72,#74,#76,#74,#30,#32);\n"),
             pi * ball, 2 * pi * sqrt(ball), 1e-3);
}

/* A tool that stands elsewhere: beyond the plate it takes nothing; over its edge a part; below one
 * of its cuts, half a ball, nothing. Two tools, one inside the other's cut. Names are the last
 * cut's. */
static void cut_places(void **state)
{
  (void)state;
#define BOX(place)                                                                                 \
  PLATE(CENTRE CUT_OF("60", "40", "61")                                                            \
            TOOL("61", place, "62") "#62=MGM_SOLID_BOX($,#70,#72,#73,"                             \
                                    "#71);\n#63=MGM_TRANSLATION(5.,0.,"                            \
                                    "0.,#11);\n#64=MGM_TRANSLATION(0.3,"                           \
                                    "0.,0.,#11);\n")
  expect_cut(BOX("#63"), 0.0, 0.0, 0.0);
  expect_cut(BOX("#64"), 0.23 * 0.3, 2 * 0.23, 1e-9); /* 0.77 to 1 of x: its edge is gone, too */
  static const char two[] =
      PLATE(CENTRE CUT_OF("60", "65", "61") TOOL(
          "61", "$", "62") "#62=MGM_SOLID_BOX($,#70,#72,#73,#71);"
                           "\n" CUT_OF("65", "40", "66")
                               TOOL("66", "#64", "62") "#64=MGM_TRANSLATION(0.2,0.,0.,#11);\n");
  expect_cut(two, 0.53 * 0.3, 2 * 0.53, 1e-9); /* 0.47 to 1 */
  struct um_geometry_obj_look look = look_at(two);
  assert_int_equal(look.ngroup, 1);
  assert_string_equal(look.group[0].name, "cut60");
  um_geometry_obj_look_clear(context, &look);
}

static void refuse(const char *text, const char *says)
{
  char path[UM_TEST_PATH], where[2 * UM_TEST_PATH];
  um_test_file_create(path, text, strlen(text));
  struct um_geometry_part_spec spec = spec_of(path, false);
  support_refused(&spec, 1, says);
  snprintf(where, sizeof where, "%s:", path);
  support_refused(&spec, 1, where);
  unlink(path);
}

#define RECTANGLES(items, more)                                                                    \
  HEAD RECTANGLE MODEL(items) SURFACE("40", "r", "$", "#53", ".BOTH.", "$", "$", "1,1,$,$,$,$")    \
      more TAIL
#define ROUND(shape)     ONE(shape, ".BOTH.", "1,1,$,$,$,$")
#define MESH(side, mesh) ONE("MGM_CYLINDER($,#20,#21,#22,#34,#30,#32)", side, mesh)

/* What is not read is said with its line and its name. */
static void refuses_geometry(void **state)
{
  (void)state;
  refuse(RECTANGLES("#40,#60", "#60=MGM_MESHED_BOOLEAN_DIFFERENCE_SURFACE('drilled','','',$,$,$,"
                               "#40,#61);\n#61=MGM_HALF_SPACE_SOLID('tool','','',$,$,.INSIDE.);\n"),
         ":27: #61 MGM_HALF_SPACE_SOLID 'tool': accepted: a solid, as #12");
  refuse(RECTANGLES("#40,#60", CUT_OF("60", "40", "61") "#61=MGM_HALF_SPACE_SOLID('tool','','',$,"
                                                        "#53,.OUTSIDE.);\n"),
         "'tool': is no tool that is read");
  refuse(RECTANGLES("#40,#60", CUT_OF("60", "40", "61") TOOL("61", "$", "53")),
         "#53 MGM_RECTANGLE: is no solid that is read");
  refuse(RECTANGLES("#40,#60", CUT_OF("60", "40", "61")
                                   TOOL("61", "$", "62") "#62=MGM_SOLID_BOX($,#50,#51,#52,#51);\n"),
         "#62 MGM_SOLID_BOX: its corners; accepted: three edges that span a volume");
  refuse(PLATE(CENTRE CUT_OF("60", "40", "61")
                   TOOL("61", "$", "62") "#62=MGM_SOLID_CYLINDER($,#70,#71,#72,#74,#30,#31);\n"),
         "#62 MGM_SOLID_CYLINDER: a solid of 270 deg; accepted: a whole turn");
  refuse(HEAD FRAME RECTANGLE MODEL("#60")
             SURFACE("40", "plate", "$", "#53", ".BOTH.", "$", "$", "101,100,$,$,$,$")
                 CENTRE CUT_OF("60", "40", "61")
                     TOOL("61", "$", "62") "#62=MGM_SOLID_BOX($,#70,#72,#73,#71);\n" TAIL,
         "'plate': a cut surface of 20200 facets; accepted: at most 20000");
  refuse(ROUND("MGM_TORUS($,#20,#21,#22)"), "#41 MGM_TORUS: is no shape that is read");
  refuse(RECTANGLES("#40,#53", ""), "#53 MGM_RECTANGLE: is no item that is read");
  refuse(RECTANGLES("#60", COMPOUND("60", "$", "#40,#40")), "'r': stands in two items");
  refuse(RECTANGLES("#60,#61", COMPOUND("60", "$", "#61") COMPOUND("61", "$", "#61")),
         "#61 MGM_COMPOUND_MESHED_GEOMETRIC_ITEM 'all': stands in two items");
  refuse(RECTANGLES("#60", COMPOUND("60", "$", "#60")), "no surface with an active side");
  refuse(HEAD TAIL, "holds no MGM_MESHED_GEOMETRIC_MODEL");
  refuse(RECTANGLES("#99", ""), "#99 is nothing of the file");
  refuse(ROUND("MGM_CYLINDER($,#20,#20,#22,#34,#30,#32)"), "stand in a line");
  refuse(ROUND("MGM_CYLINDER($,#20,#21,#22,#34,#32,#30)"), "360 to 0 deg");
  refuse(ROUND("MGM_CYLINDER($,#20,#21,#22,#34,#30,#33)"), "accepted: a unit of radian");
  refuse(ROUND("MGM_CYLINDER($,#20,#21,#22,#30,#30,#32)"), "accepted: a unit of metre");
  refuse(ROUND("MGM_CYLINDER($,#20,#21,#22,#38,#30,#32)"), "its radii or cuts (-0.2");
  refuse(ROUND("MGM_SPHERE($,#20,#21,#22,#34,#33,#36,#30,#32)"), "its radii or cuts (0.2, 0.1");
  refuse(HEAD FRAME VALUE("60", "1e-200", "11") MODEL("#40")
             SURFACE("40", "steep", "$", "#41", ".BOTH.", "$", "$",
                     "1,1,$,$,$,$") "#41=MGM_PARABOLOID($,#20,#21,#22,#60,#35,#30,#32);\n" TAIL,
         "'steep': a corner at");
  refuse(ROUND("MGM_CYLINDER($,#20,#21)"), "accepted: a point, as #12");
  refuse(ROUND("MGM_RECTANGLE($,#20,#21,#21)"), "a convex outline");
  refuse(MESH(".TOP.", "1,1,$,$,$,$"), "'one': its active side");
  refuse(MESH(".BOTH.", "0,1,$,$,$,$"), "0 faces in a direction");
  refuse(MESH(".BOTH.", "1,100000,$,$,$,$"), "100000 faces in a direction");
  refuse(MESH(".BOTH.", "10000,10000,$,$,$,$"), "more than 4000000 facets");
  refuse(MESH(".BOTH.", "2,1,$,$,(0.,0.5),$"), "its grid in direction 1; accepted: 3 numbers");
  refuse(MESH(".BOTH.", "1,2,$,$,$,(0.,1.,0.5)"), "its grid in direction 2; accepted: 3 numbers");
}

/* The exchange file itself, at its line. */
static void refuses_files(void **state)
{
  (void)state;
  refuse(HEAD "#90=A(1.5e);\n" TAIL, ":20: '1.5e);' in a STEP file; accepted: a finite number");
  refuse(HEAD "#90=A(1 2);\n" TAIL, "accepted: ',' or ')'");
  refuse(HEAD "#90=A(,);\n" TAIL, "accepted: a value");
  refuse(HEAD "#90=(A()B());\n" TAIL, "accepted: an instance of one name");
  refuse(HEAD "#90=A('text);\n" TAIL, "the end of the file in a STEP file; accepted: a quote");
  refuse(HEAD "/* text\n" TAIL, "accepted: */ behind a comment");
  refuse(HEAD "#6=NRF_MATERIAL('');\n" TAIL, ":20: #6 is given a second time, after line 17");
  refuse(HEAD "#90=A((((((((((((((((((((((((((((((((((1))))))))))))))))))))))))))))))))));\n" TAIL,
         "at most 32 lists");
  refuse(HEAD, "the end of the file in a STEP file; accepted: ENDSEC");
  refuse("ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n"
         "#1=PERSON('tas_arm');\nENDSEC;\nEND-ISO-10303-21;\n",
         "this is STEP; accepted: Wavefront OBJ");
}

/* Cut anywhere, it is refused; none ends the program. */
static void cut_short(void **state)
{
  (void)state;
  static const char text[] =
      ONE("MGM_DISC($,#20,#21,#22,#33,#34,#30,#31)", ".BOTH.", "3,4,$,$,$,$");
  struct um_geometry_obj_look look;
  char path[UM_TEST_PATH];
  for (size_t n = 0; n + 2 < sizeof text; n++) {
    um_test_file_create(path, text, n);
    enum um_status status = um_geometry_obj_look(context, path, &look);
    if (status != UM_ERR_INPUT) fail_msg("%zu bytes: status %d", n, (int)status);
    um_core_message_clear(context);
    unlink(path);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(discs_and_cylinders),
                                     cmocka_unit_test(cones),
                                     cmocka_unit_test(spheres),
                                     cmocka_unit_test(paraboloids),
                                     cmocka_unit_test(planes),
                                     cmocka_unit_test(places),
                                     cmocka_unit_test(names),
                                     cmocka_unit_test(many_surfaces),
                                     cmocka_unit_test(refuses_geometry),
                                     cmocka_unit_test(refuses_files),
                                     cmocka_unit_test(materials),
                                     cmocka_unit_test(cut_plates),
                                     cmocka_unit_test(cut_places),
                                     cmocka_unit_test(cut_short)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
