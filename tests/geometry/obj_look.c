/* What an OBJ file holds before anybody says what it is made of, and groups of it that are taken
 * alone. */
#include <unistd.h>

#include "geometry/obj_look.h"
#include "tests/geometry/support.h"
#include "tests/support/temporary.h"
#include "tests/support/with_context.h"

/* A closed bus of two groups, a panel that ends at an edge of the bus, a dish that stands alone:
 * three parts. The panel's edge is a third triangle at the bus's, which leaves the bus closed. */
static const char scene[] =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "o bus\nusemtl mli_kapton\ng bus.sides\nf 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
    "g bus.lid\nusemtl white_paint\nf 5 6 7 8\n"
    "v 1 0 1\nv 1 1 1\nv 3 1 1\nv 3 0 1\no panel\ng panel\nf 9 12 11 10\n"
    "v 5 0 -2\nv 6 0 -2\nv 5 1 -2\no dish\ng dish\nf 13 14 15\n";

static struct um_geometry_obj_look look_at(const char *text)
{
  char path[UM_TEST_PATH];
  struct um_geometry_obj_look look;
  um_test_file_create(path, text, strlen(text));
  if (um_geometry_obj_look(context, path, &look) != UM_OK) fail_msg("%s", um_core_message(context));
  unlink(path);
  return look;
}

static void looks(void **state)
{
  (void)state;
  static const struct {
    const char *name, *usemtl;
    size_t part, nfacet, nclosed;
  } expected[] = {{"bus.sides", "mli_kapton", 0, 10, 10},
                  {"bus.lid", "white_paint", 0, 2, 2},
                  {"panel", "white_paint", 1, 2, 0},
                  {"dish", "white_paint", 2, 1, 0}};
  struct um_geometry_obj_look look = look_at(scene);
  assert_int_equal(look.ngroup, 4);
  assert_int_equal(look.npart, 3);
  for (size_t g = 0; g < look.ngroup; g++) {
    assert_string_equal(look.group[g].name, expected[g].name);
    assert_string_equal(look.group[g].usemtl, expected[g].usemtl);
    assert_int_equal(look.group[g].part, expected[g].part);
    assert_int_equal(look.group[g].nfacet, expected[g].nfacet);
    assert_int_equal(look.group[g].nclosed, expected[g].nclosed);
  }
  assert_close(look.low.z, -2.0, 0.0);
  assert_close(look.high.x, 6.0, 0.0);
  um_geometry_obj_look_clear(context, &look);
  look = look_at("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  assert_string_equal(look.group[0].name, "mesh");
  assert_null(look.group[0].usemtl);
  um_geometry_obj_look_clear(context, &look);
}

/* One file serves several parts, each with groups of its own; what is left out may be anything. */
static void takes_groups(void **state)
{
  (void)state;
  char path[UM_TEST_PATH];
  static const char *const bus[] = {"bus.lid", "bus.sides"}, *const panel[] = {"panel"};
  static const char *const wrong[] = {"panel", "pannel"};
  um_test_file_create(path, scene, strlen(scene));
  struct um_geometry_part_spec spec = {.name = "bus",
                                       .shape = UM_SHAPE_MESH,
                                       .mesh_path = path,
                                       .mesh_groups = bus,
                                       .nmesh_group = 2,
                                       .rotation = {1, 0, 0, 0},
                                       .skins = &support_closed,
                                       .nskin = 1};
  struct support s = support_create(&spec, 1);
  assert_true(um_geometry_report(s.geometry, 0).closed);
  assert_close(um_geometry_report(s.geometry, 0).volume, 1.0, 1e-14);
  assert_int_equal(um_geometry_group_count(s.geometry), 2);
  support_destroy(&s);
  spec.mesh_groups = panel;
  spec.nmesh_group = 1;
  spec.skins = &support_open;
  s = support_create(&spec, 1);
  assert_close(um_geometry_report(s.geometry, 0).area, 2.0, 1e-14);
  support_destroy(&s);
  spec.mesh_groups = wrong;
  spec.nmesh_group = 2;
  support_refused(&spec, 1, "no group 'pannel' with faces; the file has: bus.sides, bus.lid, dish");
  unlink(path);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(looks), cmocka_unit_test(takes_groups)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
