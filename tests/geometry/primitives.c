/* Areas and volumes of the primitives against closed forms, and the number of groups. */
#include "tests/geometry/support.h"

static struct um_geometry_report report_of(struct um_geometry_part_spec spec, struct support *s)
{
  *s = support_create(&spec, 1);
  struct um_geometry_report report = um_geometry_report(s->geometry, 0);
  assert_int_equal(report.ndegenerate, 0);
  return report;
}

static double longest_edge(const struct support *s)
{
  double longest = 0.0;
  for (size_t f = 0; f < s->mesh->nfacet; f++)
    for (int k = 0; k < 3; k++)
      longest =
          fmax(longest, um_vec3_norm(um_vec3_sub(s->pose->vertex[s->mesh->corner[f][(k + 1) % 3]],
                                                 s->pose->vertex[s->mesh->corner[f][k]])));
  return longest;
}

static double group_area(const struct support *s, const char *name)
{
  double area = 0.0;
  for (size_t f = 0; f < s->mesh->nfacet; f++)
    if (strcmp(um_geometry_group(s->geometry, s->mesh->facet_group[f])->name, name) == 0)
      area += s->mesh->area[f];
  return area;
}

/* 2 (2 3 + 3 5 + 2 5) = 62 m^2, 30 m^3: exact but for rounding. Every edge at most facet_size. */
static void box(void **state)
{
  (void)state;
  for (int fine = 0; fine < 2; fine++) {
    struct um_geometry_part_spec spec = support_box("bus", 2, 3, 5);
    struct support s;
    spec.facet_size = fine ? 0.37 : 0.0;
    struct um_geometry_report report = report_of(spec, &s);
    assert_true(report.closed);
    assert_close(report.area, 62.0, 1e-11);
    assert_close(report.volume, 30.0, 1e-11);
    assert_close(group_area(&s, "+x"), 15.0, 1e-12);
    assert_close(group_area(&s, "-y"), 10.0, 1e-12);
    assert_close(group_area(&s, "+z"), 6.0, 1e-12);
    assert_int_equal(um_geometry_group_count(s.geometry), 6);
    assert_int_equal(s.mesh->nsurface, s.mesh->nfacet);
    if (fine)
      assert_true(longest_edge(&s) <= 0.37 * (1.0 + 1e-9));
    else
      assert_int_equal(s.mesh->nfacet, 12);
    /* the group's name is its outward normal */
    for (size_t f = 0; f < s.mesh->nfacet; f++) {
      const char *name = um_geometry_group(s.geometry, s.mesh->facet_group[f])->name;
      struct um_vec3 n = s.pose->facet_normal[f];
      double along = name[1] == 'x' ? n.x : name[1] == 'y' ? n.y : n.z;
      assert_close(along, name[0] == '+' ? 1.0 : -1.0, 1e-15);
    }
    support_destroy(&s);
  }
}

/* The scaled icosphere has area 4 pi r^2 exactly; its volume is 4/3 pi r^3 (1 - O(h^2)). */
static void sphere(void **state)
{
  (void)state;
  double error[2];
  for (int i = 0; i < 2; i++) {
    struct um_geometry_part_spec spec = {.name = "ball",
                                         .shape = UM_SHAPE_SPHERE,
                                         .radius = 1.5,
                                         .skins = &support_closed,
                                         .nskin = 1,
                                         .facet_size = i == 0 ? 0.4 : 0.2};
    struct support s;
    struct um_geometry_report report = report_of(spec, &s);
    assert_true(report.closed);
    assert_true(report.nfacet >= 320);
    assert_close(report.area, 4.0 * UM_PI * 1.5 * 1.5, 1e-11);
    assert_true(longest_edge(&s) <= spec.facet_size);
    error[i] = 1.0 - report.volume / (4.0 / 3.0 * UM_PI * 1.5 * 1.5 * 1.5);
    support_destroy(&s);
  }
  assert_true(error[0] > 0.0 && error[0] < 0.02);
  /* half the facet size, a quarter of the error; steps of the frequency are whole numbers */
  if (!(error[0] / error[1] > 3.0 && error[0] / error[1] < 5.5))
    fail_msg("order: errors %g and %g", error[0], error[1]);
}

static void sphere_coarsest(void **state)
{
  (void)state;
  struct um_geometry_part_spec spec = {.name = "ball",
                                       .shape = UM_SHAPE_SPHERE,
                                       .radius = 1.0,
                                       .skins = &support_closed,
                                       .nskin = 1};
  struct support s;
  assert_int_equal(report_of(spec, &s).nfacet, 320);
  support_destroy(&s);
}

/* pi r^2 by construction; a plate has both sides as surfaces with opposite normals. */
static void disc_and_plate(void **state)
{
  (void)state;
  for (int fine = 0; fine < 2; fine++) {
    struct um_geometry_part_spec spec = {.name = "d",
                                         .shape = UM_SHAPE_DISC,
                                         .radius = 0.7,
                                         .skins = &support_open,
                                         .nskin = 1,
                                         .facet_size = fine ? 0.11 : 0.0};
    struct support s;
    struct um_geometry_report report = report_of(spec, &s);
    assert_close(report.area, UM_PI * 0.49, 1e-12);
    assert_false(report.closed);
    assert_true(isnan(report.volume));
    assert_int_equal(s.mesh->nsurface, 2 * s.mesh->nfacet);
    if (fine) assert_true(longest_edge(&s) <= 0.11 * (1.0 + 1e-9));
    for (size_t f = 0; f < s.mesh->nfacet; f++) assert_close(s.pose->facet_normal[f].z, 1.0, 1e-15);
    support_destroy(&s);
  }
  struct um_geometry_part_spec plate = support_plate("p", 2, 3, um_vec3(0, 0, 0));
  struct support s = support_create(&plate, 1);
  assert_int_equal(s.mesh->nfacet, 2);
  assert_int_equal(s.mesh->nsurface, 4);
  for (size_t f = 0; f < 2; f++) {
    uint32_t front = s.mesh->surface_of_front[f], back = s.mesh->surface_of_back[f];
    assert_close(um_geometry_surface_normal(s.mesh, s.pose, front).z, 1.0, 1e-15);
    assert_close(um_geometry_surface_normal(s.mesh, s.pose, back).z, -1.0, 1e-15);
    assert_string_equal(um_geometry_material_name(s.geometry, s.mesh->surface[front].material),
                        "cell");
    assert_string_equal(um_geometry_material_name(s.geometry, s.mesh->surface[back].material),
                        "cfrp");
    assert_int_equal(s.mesh->surface[back].back, 1);
  }
  support_destroy(&s);
}

/* Lateral areas 2 pi r h and pi (R + r) sqrt(h^2 + (R - r)^2), exact by construction. Volume of the
 * prism of n = 24 segments: larger than pi r^2 h, by the cap's (r'/r)^2 n sin(2 pi/n)/(2 pi) - 1.
 */
static void cylinder_and_cone(void **state)
{
  (void)state;
  for (int fine = 0; fine < 2; fine++) {
    struct um_geometry_part_spec spec = {.name = "c",
                                         .shape = UM_SHAPE_CYLINDER,
                                         .radius = 0.5,
                                         .height = 2.0,
                                         .skins = &support_closed,
                                         .nskin = 1,
                                         .facet_size = fine ? 0.09 : 0.0};
    struct support s;
    struct um_geometry_report report = report_of(spec, &s);
    assert_true(report.closed);
    assert_close(group_area(&s, "side"), 2.0 * UM_PI * 0.5 * 2.0, 1e-11);
    assert_close(group_area(&s, "top"), UM_PI * 0.25, 0.006 * UM_PI * 0.25);
    assert_close(report.volume, 2.0 * group_area(&s, "bottom"), 1e-11);
    if (fine) assert_true(longest_edge(&s) <= 0.09 * (1.0 + 1e-9));
    support_destroy(&s);
    for (int apex = 0; apex < 2; apex++) {
      double top = apex ? 0.0 : 0.3;
      spec.shape = UM_SHAPE_CONE;
      spec.radius = 1.0;
      spec.radius_top = top;
      spec.facet_size = fine ? 0.15 : 0.0;
      report = report_of(spec, &s);
      assert_true(report.closed);
      assert_true(report.volume > 0.0);
      assert_close(group_area(&s, "side"),
                   UM_PI * (1.0 + top) * sqrt(4.0 + (1.0 - top) * (1.0 - top)), 1e-11);
      assert_int_equal(um_geometry_group_count(s.geometry), apex ? 2 : 3);
      /* pi h / 3 (R^2 + R r + r^2), the scale of the radii makes it up to 0.6 % larger */
      assert_close(report.volume, UM_PI * 2.0 / 3.0 * (1.0 + top + top * top), 0.025);
      if (fine) assert_true(longest_edge(&s) <= 0.15 * (1.0 + 1e-9));
      support_destroy(&s);
    }
  }
}

/* Area of the dish 8 pi f^2 / 3 ((1 + R^2 / (4 f^2))^(3/2) - 1), inscribed facets O(h^2) below. */
static void paraboloid(void **state)
{
  (void)state;
  const double f = 0.4, r = 1.0;
  double exact = 8.0 * UM_PI * f * f / 3.0 * (pow(1.0 + r * r / (4.0 * f * f), 1.5) - 1.0);
  double error[2];
  for (int i = 0; i < 2; i++) {
    struct um_geometry_part_spec spec = {.name = "dish",
                                         .shape = UM_SHAPE_PARABOLOID,
                                         .radius = r,
                                         .focal_length = f,
                                         .skins = &support_open,
                                         .nskin = 1,
                                         .facet_size = i == 0 ? 0.2 : 0.1};
    struct support s;
    struct um_geometry_report report = report_of(spec, &s);
    error[i] = 1.0 - report.area / exact;
    assert_true(longest_edge(&s) <= spec.facet_size * (1.0 + 1e-9));
    for (size_t k = 0; k < s.mesh->nfacet; k++) assert_true(s.pose->facet_normal[k].z > 0.0);
    support_destroy(&s);
  }
  assert_true(error[0] > 0.0 && error[0] < 0.01);
  if (!(error[0] / error[1] > 3.0 && error[0] / error[1] < 5.0))
    fail_msg("order: errors %g and %g", error[0], error[1]);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(box),
                                     cmocka_unit_test(sphere),
                                     cmocka_unit_test(sphere_coarsest),
                                     cmocka_unit_test(disc_and_plate),
                                     cmocka_unit_test(cylinder_and_cone),
                                     cmocka_unit_test(paraboloid)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
