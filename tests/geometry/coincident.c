/* Surfaces in one place and bodies of a part: areas in closed form for boxes and plates that lie in
 * one place, wholly and in part, and none where they touch, hide each other or move apart. */
#include "geometry/coincident.h"

#include "geometry/bodies.h"
#include "tests/geometry/support.h"
#include "tests/support/allocator.h"
#include "tests/support/temporary.h"

/* Parts 0 and 1 have `area` in one place; 0: nothing has. */
static void expect(const struct um_geometry_part_spec *part, size_t n, double area)
{
  struct support s = support_create(part, n);
  struct um_geometry_coincidences *found = NULL;
  assert_int_equal(um_geometry_coincidences_create(s.context, s.geometry, &found), UM_OK);
  assert_true(found->all);
  assert_int_equal(found->n, area > 0.0 ? 1 : 0);
  if (area > 0.0) {
    assert_int_equal(found->pair[0].part[0], 0);
    assert_int_equal(found->pair[0].part[1], n > 1 ? 1 : 0);
    assert_close(found->pair[0].area, area, 1e-9 * area);
  }
  um_geometry_coincidences_destroy(s.context, &found);
  support_destroy(&s);
}

/* A unit cube at the middle, and another box. */
static void boxes(void **state)
{
  (void)state;
  static const struct {
    double size[3], at[3], area;
  } cases[] = {
      {{1, 1, 1}, {0, 0, 0}, 6.0},           /* the same place */
      {{1, 1, 1}, {1, 0, 0}, 0.0},           /* a contact; the sides beside it go on in one plane */
      {{1, 1, 1}, {0.5, 0, 0}, 4 * 0.5},     /* four sides go on through it */
      {{1, 1, 1}, {0.9, 0.8, 0}, 2 * 0.02},  /* two sides have a corner in common */
      {{0.5, 0.5, 0.5}, {0, 0, 0}, 0.0},     /* inside */
      {{0.5, 0.5, 0.5}, {0.25, 0, 0}, 0.25}, /* inside, against a wall */
      {{0.5, 0.5, 0.5}, {0.75, 0, 0}, 0.0},  /* outside, against a wall */
      {{1, 1, 1}, {1e-4, 1e-4, 1e-4}, 0.0},  /* rays tell them apart */
      {{1, 1, 1}, {1, 1, 0}, 0.0},           /* edge on edge */
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
    for (int fine = 0; fine < 3; fine++) { /* whatever the facets are */
      struct um_geometry_part_spec part[2] = {
          support_box("a", 1, 1, 1),
          support_box("b", cases[i].size[0], cases[i].size[1], cases[i].size[2])};
      part[1].position = um_vec3(cases[i].at[0], cases[i].at[1], cases[i].at[2]);
      if (fine > 0) part[0].facet_size = 0.3;
      if (fine > 1) part[1].facet_size = 0.11;
      expect(part, 2, cases[i].area);
    }
  /* a micrometre apart rounding says what hides what */
  struct um_geometry_part_spec near[2] = {support_box("a", 1, 1, 1), support_box("b", 1, 1, 1)};
  near[1].position = um_vec3(1e-6, 1e-6, 1e-6);
  expect(near, 2, 6.0 * (1.0 - 1e-6) * (1.0 - 1e-6));
}

static void plates(void **state)
{
  (void)state;
  const struct um_vec3 z = {0, 0, 1}, x = {1, 0, 0};
  struct um_geometry_part_spec part[2] = {support_plate("a", 1, 1, um_vec3(0, 0, 0)),
                                          support_plate("b", 1, 1, um_vec3(0, 0, 0))};
  expect(part, 2, 2.0);                           /* both sides */
  part[1].rotation = um_quat_from_axis(x, UM_PI); /* front on back */
  expect(part, 2, 2.0);
  /* two unit squares at 45 deg have a regular octagon in common, 2 (sqrt 2 - 1) */
  part[1].rotation = um_quat_from_axis(z, 0.25 * UM_PI);
  expect(part, 2, 4.0 * (sqrt(2.0) - 1.0));
  part[1].rotation = um_quat_from_axis(x, 0.01); /* they cross in a line */
  expect(part, 2, 0.0);
  /* on a box: the front and the box look the same way, the back and the box at each other */
  struct um_geometry_part_spec on[2] = {support_box("box", 1, 1, 1),
                                        support_plate("radiator", 0.5, 0.4, um_vec3(0, 0, 0.5))};
  expect(on, 2, 0.2);
  on[1].position.z = -0.5;
  expect(on, 2, 0.2);
  on[1].position.z = 0.501;
  expect(on, 2, 0.0);
}

/* What follows the Sun lies in one place with what does not at one instant at most; what hangs on
 * it moves with it, and what is fixed by a joint stands. */
static void joints(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[3] = {support_plate("a", 1, 1, um_vec3(0, 0, 0)),
                                          support_plate("b", 1, 0.5, um_vec3(0, 0, 0)),
                                          support_box("bus", 0.1, 0.1, 0.1)};
  part[2].position = um_vec3(0, 0, 3);
  for (int k = 0; k < 2; k++) {
    part[k].joint_axis = um_vec3(0, 1, 0);
    part[k].joint_normal = um_vec3(0, 0, 1);
  }
  part[0].joint = UM_JOINT_SUN;
  expect(part, 3, 0.0);
  part[1].joint = UM_JOINT_SUN; /* each on its own */
  expect(part, 3, 0.0);
  part[1].joint = UM_JOINT_NONE;
  part[1].parent = "a";
  expect(part, 3, 1.0);
  part[1].parent = NULL;
  part[0].joint = part[1].joint = UM_JOINT_FIXED;
  part[0].joint_angle = part[1].joint_angle = 0.5;
  expect(part, 3, 1.0);
  part[1].joint_angle = 0.6;
  expect(part, 3, 0.0);
}

static void write_cube(FILE *file, double half, double at, bool inward, int *vertex)
{
  static const int face[6][4] = {{1, 5, 7, 3}, {0, 2, 6, 4}, {2, 3, 7, 6},
                                 {0, 4, 5, 1}, {4, 6, 7, 5}, {0, 1, 3, 2}};
  for (int v = 0; v < 8; v++)
    fprintf(file, "v %g %g %g\n", at + half * (v & 1 ? 1 : -1), half * (v & 2 ? 1 : -1),
            half * (v & 4 ? 1 : -1));
  for (int f = 0; f < 6; f++) {
    fputs("f", file);
    for (int k = 0; k < 4; k++) fprintf(file, " %d", *vertex + face[f][inward ? k : 3 - k] + 1);
    fputc('\n', file);
  }
  *vertex += 8;
}

/* Bodies of a mesh of cubes: their areas; a hollow is none. */
static void bodies(void **state)
{
  (void)state;
  static const struct {
    double half[2], at;
    bool inward;
    size_t n;
    double area[2], twice;
  } cases[] = {
      {{0.5, 0.25}, 2.0, false, 2, {6.0, 1.5}, 0.0}, /* beside each other */
      {{0.5, 0.25}, 0.0, false, 2, {6.0, 1.5}, 0.0}, /* one in the other */
      {{0.5, 0.25}, 0.0, true, 1, {6.0, 0.0}, 0.0},  /* a hollow cube */
      {{0.5, 0.0}, 0.0, false, 1, {6.0, 0.0}, 0.0},  /* one alone */
      {{0.5, 0.5}, 0.5, false, 2, {6.0, 6.0}, 2.0},  /* through each other: four half sides */
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    char path[UM_TEST_PATH];
    int vertex = 0;
    um_test_file_create(path, "\n", 1);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    write_cube(file, cases[i].half[0], 0.0, false, &vertex);
    if (cases[i].half[1] > 0.0)
      write_cube(file, cases[i].half[1], cases[i].at, cases[i].inward, &vertex);
    assert_int_equal(fclose(file), 0);
    struct um_geometry_part_spec part = support_box("cubes", 1, 1, 1);
    part.shape = UM_SHAPE_MESH;
    part.mesh_path = path;
    struct support s = support_create(&part, 1);
    double *area;
    size_t n;
    assert_int_equal(um_geometry_bodies(s.context, s.geometry, 0, &area, &n), UM_OK);
    assert_int_equal(n, cases[i].n);
    for (size_t k = 0; k < n; k++) assert_close(area[k], cases[i].area[k], 1e-12);
    um_core_free(s.context, area);
    support_destroy(&s);
    expect(&part, 1, cases[i].twice); /* a mesh that has a face twice */
    assert_int_equal(remove(path), 0);
  }
  struct um_geometry_part_spec open = support_plate("plate", 1, 1, um_vec3(0, 0, 0));
  struct support s = support_create(&open, 1);
  double *area;
  size_t n;
  assert_int_equal(um_geometry_bodies(s.context, s.geometry, 0, &area, &n), UM_OK);
  assert_int_equal(n, 0);
  um_core_free(s.context, area);
  support_destroy(&s);
}

/* Largest first; where all lie in one place the search ends and says so. */
static void many(void **state)
{
  (void)state;
  enum { N = 1500 };
  static struct um_geometry_part_spec part[N];
  static char name[N][8];
  for (int i = 0; i < N; i++) {
    snprintf(name[i], sizeof name[i], "p%d", i);
    part[i] = support_plate(name[i], 1, 1, um_vec3(0, 0, 0));
  }
  part[2].size[1] = 0.5;
  struct support s = support_create(part, 3);
  struct um_geometry_coincidences *found;
  static const uint32_t pair[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  assert_int_equal(um_geometry_coincidences_create(s.context, s.geometry, &found), UM_OK);
  assert_true(found->all);
  assert_int_equal(found->n, 3);
  for (int i = 0; i < 3; i++) {
    assert_memory_equal(found->pair[i].part, pair[i], sizeof pair[i]);
    assert_close(found->pair[i].area, i == 0 ? 2.0 : 1.0, 1e-12);
  }
  um_geometry_coincidences_destroy(s.context, &found);
  support_destroy(&s);
  s = support_create(part, N);
  assert_int_equal(um_geometry_coincidences_create(s.context, s.geometry, &found), UM_OK);
  assert_false(found->all);
  assert_true(found->n > 1000);
  um_geometry_coincidences_destroy(s.context, &found);
  support_destroy(&s);
}

static bool count(void *self)
{
  ++*(int *)self;
  return false;
}

/* Facets whose boxes all touch: 2000 of them look at each other 4 million times. The stop is asked
 * for once in 65536 looks, not in so many facets. */
static void stop(void **state)
{
  (void)state;
  enum { N = 1000 };
  static struct um_geometry_part_spec part[N];
  static char name[N][8];
  for (int i = 0; i < N; i++) {
    snprintf(name[i], sizeof name[i], "p%d", i);
    part[i] = support_plate(name[i], 1, 1, um_vec3(0, 0, 0));
    part[i].rotation = um_quat_from_axis(um_vec3(1, 0, 0), UM_PI * i / N); /* they cross */
  }
  struct support s = support_create(part, N);
  struct um_geometry_coincidences *found;
  int asked = 0;
  um_core_context_set_stop(s.context, count, &asked);
  assert_int_equal(um_geometry_coincidences_create(s.context, s.geometry, &found), UM_OK);
  size_t n = um_geometry_mesh(s.geometry)->nfacet;
  assert_true((size_t)asked >= n * n / 65536);
  um_geometry_coincidences_destroy(s.context, &found);
  support_destroy(&s);
}

static void out_of_memory(void **state)
{
  (void)state;
  struct um_geometry_part_spec part[2] = {support_box("a", 1, 1, 1), support_box("b", 1, 1, 1)};
  struct support s = support_create(part, 2);
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  struct um_context *small;
  assert_int_equal(um_core_context_create(&allocator, &small), UM_OK);
  long live = memory.alive, tries = 0;
  for (enum um_status status = UM_ERR_MEMORY; status != UM_OK;) {
    struct um_geometry_coincidences *found;
    double *area = NULL;
    size_t n;
    memory.calls = 0;
    memory.fail_call = ++tries;
    um_core_message_clear(small);
    status = um_geometry_coincidences_create(small, s.geometry, &found);
    if (status == UM_OK) status = um_geometry_bodies(small, s.geometry, 0, &area, &n);
    if (status != UM_OK) assert_int_equal(status, UM_ERR_MEMORY);
    um_geometry_coincidences_destroy(small, &found);
    um_core_free(small, area);
    assert_int_equal(memory.alive, live);
  }
  assert_true(tries > 12);
  um_core_context_destroy(&small);
  support_destroy(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(boxes),        cmocka_unit_test(plates),
                                     cmocka_unit_test(joints),       cmocka_unit_test(bodies),
                                     cmocka_unit_test(many),         cmocka_unit_test(stop),
                                     cmocka_unit_test(out_of_memory)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
