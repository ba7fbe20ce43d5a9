/* Descriptions of parts: names, materials, what is refused and how; running out of memory. */
#include "tests/geometry/support.h"
#include "tests/support/allocator.h"

static void materials_of_groups(void **state)
{
  (void)state;
  const struct um_geometry_skin skins[] = {{NULL, "mli", NULL}, {"+x", "radiator", NULL}};
  struct um_geometry_part_spec parts[] = {support_plate("wing", 1, 1, um_vec3(0, 0, 3)),
                                          support_box("bus", 1, 1, 1)};
  parts[1].skins = skins;
  parts[1].nskin = 2;
  struct support s = support_create(parts, 2);
  assert_int_equal(um_geometry_part_count(s.geometry), 2);
  assert_int_equal(um_geometry_part_find(s.geometry, "bus"), 1);
  assert_int_equal(um_geometry_part_find(s.geometry, "no"), (size_t)-1);
  assert_string_equal(um_geometry_part_name(s.geometry, 0), "wing");
  assert_int_equal(um_geometry_group_count(s.geometry), 7);
  static const char *const names[] = {"cell", "cfrp", "radiator", "mli"};
  assert_int_equal(um_geometry_material_count(s.geometry), 4);
  for (size_t i = 0; i < 4; i++)
    assert_string_equal(um_geometry_material_name(s.geometry, i), names[i]);
  /* surfaces in order of part, facet, side, and the maps back to them */
  assert_int_equal(s.mesh->nsurface, 2 * 2 + 12);
  for (uint32_t i = 0; i < s.mesh->nsurface; i++) {
    const struct um_geometry_surface *a = &s.mesh->surface[i];
    const uint32_t *map = a->back ? s.mesh->surface_of_back : s.mesh->surface_of_front;
    assert_int_equal(map[a->facet], i);
    assert_int_equal(a->part, s.mesh->facet_part[a->facet]);
    assert_int_equal(a->group, s.mesh->facet_group[a->facet]);
    if (i > 0) assert_true(a->facet > a[-1].facet || (a->facet == a[-1].facet && a->back));
  }
  const struct um_geometry_group *first = um_geometry_group(s.geometry, 1);
  assert_string_equal(first->name, "+x");
  assert_string_equal(um_geometry_material_name(s.geometry, first->front_material), "radiator");
  assert_int_equal(first->back_material, UM_GEOMETRY_NONE);
  assert_int_equal(s.mesh->surface_of_back[2], UM_GEOMETRY_NONE);
  support_destroy(&s);
}

static void refused(void **state)
{
  (void)state;
  struct um_geometry_part_spec p[2] = {support_box("bus", 1, 1, 1), support_box("bus", 1, 1, 1)};
  support_refused(p, 0, "no parts");
  support_refused(p, 2, "two parts are called 'bus'");
  p[1].name = "";
  support_refused(p, 2, "part 2 has no name");
  p[1].name = "yoke";
  p[1].parent = "buss";
  support_refused(p, 2, "part 'yoke': its parent 'buss' is not a part");
  p[1].parent = "bus";
  p[0].parent = "yoke";
  support_refused(p, 2, "part 'bus': its parents form a circle");
  p[0].parent = "bus";
  support_refused(p, 1, "part 'bus': its parents form a circle");

  p[0] = support_box("bus", 1, 0, 1);
  support_refused(p, 1, "part 'bus': size y is 0 m; a value above 0 and up to 1e+07 is accepted");
  p[0] = support_box("bus", 1, 1, NAN);
  support_refused(p, 1, "part 'bus': size z is nan m");
  p[0] = support_box("bus", 1, 1, 1);
  p[0].size[0] = 1e200;
  support_refused(p, 1, "part 'bus': size x is 1e+200 m");
  p[0] = support_box("bus", 1, 1, 1);
  p[0].facet_size = -1;
  support_refused(p, 1, "facet size is -1 m");
  p[0] = support_box("bus", 1, 1, 1);
  p[0].position.y = INFINITY;
  support_refused(p, 1, "its position (0, inf, 0) m is not finite");
  p[0] = support_box("bus", 1, 1, 1);
  p[0].rotation.w = 0.5;
  support_refused(p, 1, "the norm of its rotation is 0.5");
  p[0] = support_box("bus", 1, 1, 1);
  p[0].joint = UM_JOINT_SUN;
  support_refused(p, 1, "the length of its joint axis is 0");
  p[0].joint_axis = p[0].joint_normal = um_vec3(0, 0, 1);
  support_refused(p, 1, "its Sun-tracking normal lies along the joint axis");
  p[0] = support_box("thin", 1, 1e-16, 1);
  support_refused(p, 1, "degenerate");

  p[0] = support_box("bus", 1, 1, 1);
  p[0].nskin = 0;
  support_refused(p, 1, "part 'bus': group '+x' has no material");
  const struct um_geometry_skin wrong[] = {{NULL, "mli", NULL}, {"side", "mli", NULL}};
  p[0].skins = wrong;
  p[0].nskin = 2;
  support_refused(p, 1, "there is no group 'side'; its groups are: +x, -x, +y, -y, +z, -z");
  const struct um_geometry_skin twice[] = {{"+x", "mli", NULL}, {"+x", "foil", NULL}};
  p[0].skins = twice;
  support_refused(p, 1, "materials of +x given twice");
  p[0] = support_plate("wing", 1, 1, um_vec3(0, 0, 0));
  p[0].skins = &support_closed;
  support_refused(p, 1, "part 'wing': group 'plate' has no back material");
  p[0].skins = &support_open;
  p[0].solid = true;
  support_refused(p, 1, "part 'wing' is declared solid but its mesh is not closed: 4 open edges");

  static const enum um_geometry_shape round[] = {UM_SHAPE_DISC, UM_SHAPE_CYLINDER, UM_SHAPE_CONE,
                                                 UM_SHAPE_SPHERE, UM_SHAPE_PARABOLOID};
  for (size_t i = 0; i < 5; i++) {
    p[0] = (struct um_geometry_part_spec){
        .name = "r", .shape = round[i], .skins = &support_open, .nskin = 1};
    support_refused(p, 1, "part 'r': radius is 0 m");
    p[0].radius = 1.0;
    p[0].radius_top = -1.0;
    p[0].height = round[i] == UM_SHAPE_CONE ? 1.0 : 0.0;
    if (round[i] == UM_SHAPE_CYLINDER) support_refused(p, 1, "height is 0 m");
    if (round[i] == UM_SHAPE_CONE) support_refused(p, 1, "top radius is -1 m");
    if (round[i] == UM_SHAPE_PARABOLOID) support_refused(p, 1, "focal length is 0 m");
  }
}

static enum um_status build_all(struct um_context *context)
{
  enum um_status status;
  struct um_geometry_part_spec parts[] = {support_box("bus", 1, 1, 1),
                                          support_plate("wing", 1, 1, um_vec3(0, 0, 3))};
  struct um_geometry *geometry = NULL;
  struct um_geometry_pose *pose = NULL;
  struct um_geometry_visibility *visibility = NULL;
  struct um_geometry_sky *sky = NULL;
  parts[0].facet_size = 1.2;
  UM_CHECK(um_geometry_create(context, parts, 2, &geometry));
  UM_CHECK(um_geometry_pose_create(context, geometry, NULL, &pose));
  UM_CHECK(um_geometry_visibility_create(context, um_geometry_mesh(geometry), pose, &visibility));
  UM_CHECK(um_geometry_sky_create(context, visibility, 1, &sky));
done:
  um_geometry_sky_destroy(&sky);
  um_geometry_visibility_destroy(&visibility);
  um_geometry_pose_destroy(context, &pose);
  um_geometry_destroy(&geometry);
  return status;
}

/* Whichever allocation fails, the status says so and nothing is leaked. */
static void out_of_memory(void **state)
{
  (void)state;
  long n = 0;
  for (enum um_status status = UM_ERR_MEMORY; status != UM_OK; n++) {
    struct um_test_memory memory = {.fail_call = n + 2, .stays_out = true}; /* 1: the context */
    struct um_core_allocator allocator = um_test_memory_allocator(&memory);
    struct um_context *context;
    assert_int_equal(um_core_context_create(&allocator, &context), UM_OK);
    um_core_context_set_threads(context, 1);
    status = build_all(context);
    assert_true(status == UM_OK || status == UM_ERR_MEMORY);
    um_core_context_destroy(&context);
    assert_int_equal(memory.alive, 0);
    assert_true(n < 10000);
  }
  assert_true(n > 50);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(materials_of_groups),
                                     cmocka_unit_test(refused), cmocka_unit_test(out_of_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
