/* Refinement: no edge too long, area and volume kept, conforming. */
#include "tests/geometry/support.h"
#include "tests/support/temporary.h"

/* An L-shaped prism with sliver triangles, through a file, so that refine.c does the work. */
static const char prism[] =
    "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 1 1 0\nv 1 2.5 0\nv 0 2.5 0\n"
    "v 0 0 3\nv 4 0 3\nv 4 1 3\nv 1 1 3\nv 1 2.5 3\nv 0 2.5 3\n"
    "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\n"
    "f 6 1 7 12\n";

/* Floor area 4 + 1.5 = 5.5, perimeter 13: area 2 x 5.5 + 3 x 13 = 50 m^2, volume 16.5 m^3. */
static void prism_keeps_area_and_volume(void **state)
{
  (void)state;
  static const double size[] = {0.0, 2.0, 0.5, 0.13};
  double sharpest = 0.0;
  for (int i = 0; i < 4; i++) {
    char path[UM_TEST_PATH];
    um_test_file_create(path, prism, strlen(prism));
    struct um_geometry_part_spec spec = {.name = "prism",
                                         .shape = UM_SHAPE_MESH,
                                         .mesh_path = path,
                                         .skins = &support_closed,
                                         .nskin = 1,
                                         .solid = true,
                                         .facet_size = size[i]};
    struct support s = support_create(&spec, 1);
    remove(path);
    struct um_geometry_report report = um_geometry_report(s.geometry, 0);
    assert_close(report.area, 50.0, 1e-10);
    assert_close(report.volume, 16.5, 1e-10);
    assert_int_equal(report.nboundary_edge, 0);
    assert_int_equal(report.nonmanifold_edge, 0);
    /* closed surface of genus 0: V - E + F = 2 with E = 3 F / 2 (Euler): no T-junction, no spare
     * vertex */
    assert_int_equal(2 * report.nvertex, report.nfacet + 4);
    /* Rivara: angles stay above half the smallest one */
    if (i == 0)
      sharpest = report.sharpest_angle;
    else
      assert_true(report.sharpest_angle >= 0.5 * sharpest - 1e-12);
    for (size_t f = 0; i > 0 && f < s.mesh->nfacet; f++)
      for (int k = 0; k < 3; k++) {
        struct um_vec3 a = s.pose->vertex[s.mesh->corner[f][k]];
        struct um_vec3 b = s.pose->vertex[s.mesh->corner[f][(k + 1) % 3]];
        assert_true(um_vec3_norm(um_vec3_sub(b, a)) <= size[i] * (1.0 + 1e-8));
      }
    support_destroy(&s);
  }
}

static double longest2_of(const struct support *s, size_t f)
{
  double longest2 = 0.0;
  for (int k = 0; k < 3; k++) {
    struct um_vec3 d = um_vec3_sub(s->pose->vertex[s->mesh->corner[f][(k + 1) % 3]],
                                   s->pose->vertex[s->mesh->corner[f][k]]);
    longest2 = fmax(longest2, um_vec3_dot(d, d));
  }
  return longest2;
}

/* Does p lie in facet f, edges included? */
static bool holds(const struct support *s, size_t f, struct um_vec3 p)
{
  for (int k = 0; k < 3; k++) {
    struct um_vec3 a = s->pose->vertex[s->mesh->corner[f][k]];
    struct um_vec3 b = s->pose->vertex[s->mesh->corner[f][(k + 1) % 3]];
    struct um_vec3 n = um_vec3_cross(um_vec3_sub(b, a), um_vec3_sub(p, a));
    if (um_vec3_dot(n, s->pose->facet_normal[f]) < -1e-12) return false;
  }
  return fabs(um_vec3_dot(um_vec3_sub(p, s->pose->vertex[s->mesh->corner[f][0]]),
                          s->pose->facet_normal[f])) < 1e-12;
}

static struct um_vec3 centroid(const struct support *s, size_t f)
{
  const uint32_t *c = s->mesh->corner[f];
  struct um_vec3 sum = um_vec3_add(s->pose->vertex[c[0]], s->pose->vertex[c[1]]);
  return um_vec3_scale(um_vec3_add(sum, s->pose->vertex[c[2]]), 1.0 / 3.0);
}

/* Facets 3 and 40 of a box of 0.5 m, then four of that: pieces are half as long, the box stays
 * closed and conforming, most facets are left as they were. */
static void halvings_are_local(void **state)
{
  (void)state;
  static const uint32_t first[] = {3, 40}, second[] = {3, 60, 61, 100};
  struct um_geometry_halving round[2] = {{0, first, 2}, {0, second, 4}};
  struct support before = {NULL, NULL, NULL, NULL, NULL};
  for (size_t i = 0; i <= 2; i++) {
    struct um_geometry_part_spec spec = support_box("box", 2.0, 1.0, 1.5);
    spec.facet_size = 0.5;
    spec.solid = true;
    spec.halvings = (struct um_geometry_halvings){round, i};
    struct support s = support_create(&spec, 1);
    struct um_geometry_report report = um_geometry_report(s.geometry, 0);
    assert_int_equal(2 * report.nvertex, report.nfacet + 4);
    assert_close(report.area, 13.0, 1e-12);
    for (size_t k = 0; i > 0 && k < round[i - 1].nhalved; k++) {
      uint32_t halved = round[i - 1].facet[k];
      size_t pieces = 0;
      for (size_t f = 0; f < s.mesh->nfacet; f++) {
        if (!holds(&before, halved, centroid(&s, f))) continue;
        pieces++;
        assert_true(longest2_of(&s, f) <= 0.25 * longest2_of(&before, halved) * (1.0 + 1e-8));
      }
      assert_true(pieces >= 4);
    }
    if (i > 0) {
      assert_true(s.mesh->nfacet <= before.mesh->nfacet + 12 * round[i - 1].nhalved);
      support_destroy(&before);
    }
    if (i < 2) round[i].nfacet = s.mesh->nfacet;
    before = s;
  }
  support_destroy(&before);
  struct um_geometry_part_spec spec = support_box("box", 2.0, 1.0, 1.5);
  spec.halvings = (struct um_geometry_halvings){round, 1};
  support_refused(&spec, 1, "part 'box': halvings are of ");
}

/* All closed primitives stay closed, whatever the size. */
static void primitives_stay_closed(void **state)
{
  (void)state;
  for (int i = 1; i <= 6; i++) {
    struct um_geometry_part_spec parts[4] = {
        support_box("box", 1.0, 0.31, 2.2),
        {.name = "cylinder", .shape = UM_SHAPE_CYLINDER, .radius = 0.4, .height = 1.7},
        {.name = "cone", .shape = UM_SHAPE_CONE, .radius = 0.5, .radius_top = 0.05, .height = 0.3},
        {.name = "ball", .shape = UM_SHAPE_SPHERE, .radius = 0.45}};
    for (int k = 0; k < 4; k++) {
      parts[k].skins = &support_closed;
      parts[k].nskin = 1;
      parts[k].solid = true;
      parts[k].facet_size = 0.7 / (i * i);
    }
    struct support s = support_create(parts, 4);
    for (size_t k = 0; k < 4; k++) {
      struct um_geometry_report report = um_geometry_report(s.geometry, k);
      assert_true(report.closed);
      assert_int_equal(2 * report.nvertex, report.nfacet + 4);
      /* the narrow end of the cone keeps the 24 segments of the wide one: 0.013 m by 0.54 m */
      assert_true(report.sharpest_angle > (k == 2 ? 0.02 : 0.1));
    }
    support_destroy(&s);
  }
}

/* A size typed in the wrong unit is refused before memory is. */
static void tiny_size_is_refused(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[4] = {support_box("box", 1, 1, 1),
                                           support_plate("plate", 14, 5, um_vec3(0, 0, 0)),
                                           {.name = "ball", .shape = UM_SHAPE_SPHERE, .radius = 1},
                                           {.name = "disc", .shape = UM_SHAPE_DISC, .radius = 1}};
  for (int k = 0; k < 4; k++) {
    parts[k].skins = &support_open;
    parts[k].nskin = 1;
    parts[k].facet_size = 1e-6;
    support_refused(&parts[k], 1, "a facet size of 1e-06 m needs");
  }
}

struct countdown {
  int left; /* answers before the stop */
};

static bool count_down(void *self) { return ((struct countdown *)self)->left-- <= 0; }

/* What a function finds on the stack that sets nothing itself: no address. */
static __attribute__((noinline)) void leave_rubbish(void)
{
  volatile unsigned char rubbish[16384];
  for (size_t i = 0; i < sizeof rubbish; i++) rubbish[i] = 0xbf;
}

/* Wherever the stop arrives, the work ends with a word, and nothing is freed that was not made. */
static void stop_anywhere(void **state)
{
  (void)state;
  enum um_status status = UM_ERR_CANCELLED;
  int stops = 0;
  for (int k = 0; status != UM_OK; k++) {
    struct um_geometry_part_spec part = support_box("box", 1.0, 0.31, 2.2);
    struct countdown countdown = {k};
    struct um_context *context;
    struct um_geometry *geometry = NULL;
    part.facet_size = 0.2;
    assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
    um_core_context_set_stop(context, count_down, &countdown);
    leave_rubbish();
    status = um_geometry_create(context, &part, 1, &geometry);
    if (status != UM_OK) assert_int_equal(status, UM_ERR_CANCELLED);
    if (status != UM_OK) stops++;
    um_geometry_destroy(&geometry);
    um_core_context_destroy(&context);
  }
  assert_true(stops > 3); /* the part, and more than one pass of its refinement */
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(prism_keeps_area_and_volume), cmocka_unit_test(halvings_are_local),
      cmocka_unit_test(primitives_stay_closed), cmocka_unit_test(tiny_size_is_refused),
      cmocka_unit_test(stop_anywhere)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
