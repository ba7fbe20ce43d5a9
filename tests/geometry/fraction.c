/* Fractions toward directions: projected areas, exact ones and shadows of known size. */
#include "geometry/scatter.h"
#include "tests/geometry/support.h"

/* A unit cube along (1, 1, 1) shows three faces at cos = 1/sqrt 3: sqrt 3 m^2, exactly. */
static void cube_projects_sqrt3(void **state)
{
  (void)state;
  struct um_geometry_part_spec cube = support_box("cube", 1, 1, 1);
  cube.facet_size = 0.2;
  struct support s = support_create(&cube, 1);
  struct um_vec3 d = um_vec3_unit(um_vec3(1, 1, 1));
  assert_close(support_projected_area(&s, d, 1), sqrt(3.0), 1e-14);
  support_destroy(&s);
}

/* Projected area of the faceted sphere against pi r^2: too small by O(h^2). */
static void sphere_projects_circle(void **state)
{
  (void)state;
  struct um_vec3 d = um_vec3_unit(um_vec3(0.3, -0.5, 0.7));
  double error[2];
  for (int i = 0; i < 2; i++) {
    struct um_geometry_part_spec ball = {.name = "ball",
                                         .shape = UM_SHAPE_SPHERE,
                                         .radius = 1.0,
                                         .skins = &support_closed,
                                         .nskin = 1,
                                         .facet_size = i == 0 ? 0.2 : 0.1};
    struct support s = support_create(&ball, 1);
    error[i] = fabs(support_projected_area(&s, d, 1) / UM_PI - 1.0);
    support_destroy(&s);
  }
  assert_true(error[0] < 1e-3);
  if (!(error[0] / error[1] > 2.5)) fail_msg("order: errors %g and %g", error[0], error[1]);
}

/* A finely cut plate and a finely cut box that are not open (a far small body stands before each):
 * fractions toward grazing directions are exactly 1 before the plane and 0 behind it. */
static void grazing_fractions_are_exact(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[8];
  parts[0] = support_plate("wing", 6, 2, um_vec3(0, 0, 0));
  parts[0].facet_size = 0.15;
  parts[0].rotation = um_quat_from_axis(um_vec3_unit(um_vec3(0.2, 1, -0.4)), 0.6);
  parts[1] = support_box("bus", 2, 3, 4);
  parts[1].facet_size = 0.3;
  parts[1].position = um_vec3(0, 0, 40);
  parts[1].rotation = um_quat_from_axis(um_vec3_unit(um_vec3(1, 1, 0.4)), 1.1);
  static const char *const name[] = {"a", "b", "c", "d", "e", "f"};
  for (size_t i = 0; i < 6; i++) {
    double sign = i % 2 == 0 ? 300.0 : -300.0;
    struct um_vec3 at =
        um_vec3(i / 2 == 0 ? sign : 0, i / 2 == 1 ? sign : 0, i / 2 == 2 ? sign : 0);
    parts[2 + i] = support_plate(name[i], 0.01, 0.01, at);
  }
  struct support s = support_create(parts, 8);
  double *seen = calloc(s.mesh->nsurface, sizeof *seen),
         *lit = calloc(s.mesh->nsurface, sizeof *lit);
  assert_non_null(seen);
  assert_non_null(lit);
  size_t tested = 0;
  /* normals in the plane of which we look: the wing's and two of the box */
  const struct um_quat q[2] = {parts[0].rotation, parts[1].rotation};
  for (int body = 0; body < 2; body++)
    for (int k = 0; k < 12; k++) {
      double rise = pow(10.0, -1.0 - 0.5 * k), turn = 0.37 + 0.9 * k;
      struct um_vec3 d = um_vec3_unit(um_vec3(cos(turn), sin(turn), k % 2 == 0 ? rise : -rise));
      d = um_quat_apply(um_quat_conjugate(q[body]), d);
      /* the other body stays out of the way: only directions well off the line between them */
      if (fabs(d.z) > 0.9) continue;
      um_geometry_visibility_toward(s.visibility, d, 3, seen);
      um_geometry_visibility_toward_both(s.visibility, d, d, 0.00465, 3, 0, seen, lit, NULL, NULL);
      for (size_t i = 0; i < s.mesh->nsurface; i++) {
        if (s.mesh->surface[i].part != (uint32_t)body) continue;
        assert_false(um_geometry_visibility_is_open(s.visibility, i));
        bool faces = um_vec3_dot(um_geometry_surface_normal(s.mesh, s.pose, i), d) > 0.0;
        assert_true(seen[i] == (faces ? 1.0 : 0.0));
        assert_true(lit[i] == (faces ? 1.0 : 0.0));
        tested++;
      }
    }
  assert_true(tested > 10000);
  free(seen);
  free(lit);
  support_destroy(&s);
}

/* Plate of 1 x 1 m, 0.5 m above a plate of 2 x 2 m; seen along a direction tilted by 45
 * degrees in x, the small one covers the square x in [-1, 0], which lies wholly on the large one.
 */
static void plate_above_plate(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[] = {support_plate("large", 2, 2, um_vec3(0, 0, 0)),
                                          support_plate("small", 1, 1, um_vec3(0, 0, 0.5))};
  parts[0].facet_size = 0.25;
  struct support s = support_create(parts, 2);
  struct um_vec3 d = um_vec3_unit(um_vec3(1, 0, 1));
  size_t n = s.mesh->nsurface;
  double *seen = calloc(n, sizeof *seen), *lit = calloc(n, sizeof *lit);
  double *seen_error = calloc(n, sizeof *seen), *lit_error = calloc(n, sizeof *lit);
  assert_true(seen != NULL && lit != NULL && seen_error != NULL && lit_error != NULL);
  um_geometry_visibility_toward_both(s.visibility, d, um_vec3(0, 0, 1), 0.0, 64, 0, seen, lit,
                                     seen_error, lit_error);
  double seen_area = 0.0, lit_area = 0.0, seen_variance = 0.0, lit_variance = 0.0;
  for (size_t i = 0; i < n; i++) {
    const struct um_geometry_surface *surface = &s.mesh->surface[i];
    double a = s.mesh->area[surface->facet];
    if (surface->back) {
      assert_true(seen[i] == 0.0 && lit[i] == 0.0 && seen_error[i] == 0.0 && lit_error[i] == 0.0);
    } else if (surface->part == 1) {
      /* the small one is open: exact */
      assert_true(seen[i] == 1.0 && lit[i] == 1.0 && seen_error[i] == 0.0 && lit_error[i] == 0.0);
    } else {
      seen_area += a * seen[i];
      lit_area += a * lit[i];
      seen_variance += a * a * seen_error[i] * seen_error[i];
      lit_variance += a * a * lit_error[i] * lit_error[i];
    }
  }
  /* seen: all but the unit square shifted by -0.5 m in x; lit and seen: all but that square and the
   * one straight below, whose union is 1.5 m^2. 4 standard errors: 6e-5 false alarms. The edges of
   * the shadows run along facet edges here, so that the errors may be zero: then exact. */
  assert_close(seen_area, 3.0, 4.0 * sqrt(seen_variance) + 1e-12);
  assert_close(lit_area, 2.5, 4.0 * sqrt(lit_variance) + 1e-12);
  free(seen);
  free(lit);
  free(seen_error);
  free(lit_error);
  support_destroy(&s);
}

/* The same with a shadow edge across facets: height 0.5, tilt 0.3 rad about y: shift 0.5 tan 0.3,
 * the shadow stays inside, so that 3 m^2 is seen; errors are not zero now. */
static void shadow_edge_across_facets(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[] = {support_plate("large", 2, 2, um_vec3(0, 0, 0)),
                                          support_plate("small", 1, 1, um_vec3(0, 0, 0.5))};
  parts[0].facet_size = 0.17;
  struct support s = support_create(parts, 2);
  struct um_vec3 d = um_vec3(sin(0.3), 0, cos(0.3));
  size_t n = s.mesh->nsurface;
  double *seen = calloc(n, sizeof *seen), *lit = calloc(n, sizeof *lit), *e = calloc(n, sizeof *e);
  assert_true(seen != NULL && lit != NULL && e != NULL);
  um_geometry_visibility_toward_both(s.visibility, d, d, 0.0, 16, 0, seen, lit, e, NULL);
  double area = 0.0, variance = 0.0;
  for (size_t i = 0; i < n; i++) {
    const struct um_geometry_surface *surface = &s.mesh->surface[i];
    if (surface->part != 0 || surface->back) continue;
    double a = s.mesh->area[surface->facet];
    area += a * seen[i];
    variance += a * a * e[i] * e[i];
    /* the same ray twice: what sees o = s is lit */
    assert_true(seen[i] == lit[i]);
    double f = seen[i];
    assert_close(e[i], sqrt(f * (1.0 - f) * 0.4 / 15.0), 1e-15);
  }
  assert_true(variance > 0.0);
  assert_close(area, 3.0, 4.0 * sqrt(variance));
  /* points do not depend on the call */
  um_geometry_visibility_toward(s.visibility, d, 16, lit);
  assert_memory_equal(seen, lit, n * sizeof *seen);
  free(seen);
  free(lit);
  free(e);
  support_destroy(&s);
}

/* Sun of angular radius 0.1 rad, edge of a half plane overhead: a point at the edge's foot sees
 * half of the disc. The strip within h tan(0.1) of the foot is in penumbra, the lit area there is
 * half of it by symmetry: of a 2 x 2 plate under a half plane that covers x > 0 (h = 1), 2 m^2 is
 * lit. */
static void sun_disc_makes_penumbra(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[] = {support_plate("floor", 2, 2, um_vec3(0, 0, 0)),
                                          support_plate("roof", 40, 40, um_vec3(20, 0, 1))};
  parts[0].facet_size = 0.3;
  struct support s = support_create(parts, 2);
  size_t n = s.mesh->nsurface;
  double *seen = calloc(n, sizeof *seen), *lit = calloc(n, sizeof *lit), *e = calloc(n, sizeof *e);
  assert_true(seen != NULL && lit != NULL && e != NULL);
  /* seen from a direction from which all of the floor is free: low, from -x */
  struct um_vec3 o = um_vec3_unit(um_vec3(-1, 0, 0.3)), sun = um_vec3(0, 0, 1);
  um_geometry_visibility_toward_both(s.visibility, o, sun, 0.1, 256, 0, seen, lit, NULL, e);
  double area = 0.0, variance = 0.0;
  size_t partial = 0;
  for (size_t i = 0; i < n; i++) {
    const struct um_geometry_surface *surface = &s.mesh->surface[i];
    if (surface->part != 0 || surface->back) continue;
    double a = s.mesh->area[surface->facet];
    assert_true(seen[i] == 1.0);
    area += a * lit[i];
    variance += a * a * e[i] * e[i];
    const uint32_t *c = s.mesh->corner[surface->facet];
    for (int k = 0; k < 3; k++) partial += lit[i] < 1.0 && s.pose->vertex[c[k]].x < -0.02;
  }
  assert_true(partial > 0); /* the penumbra reaches past the edge's foot */
  assert_close(area, 2.0, 4.0 * sqrt(variance));
  free(seen);
  free(lit);
  free(e);
  support_destroy(&s);
}

/* Two facets only, edge of the roof above x = 0.3: 1.3 x 2 m^2 is lit. Point and disc must be
 * sampled independently of each other within one facet for this to converge. 4096 evenly spread
 * points lie within one standard error of as many independent ones. */
static void penumbra_converges_on_one_facet(void **state)
{
  (void)state;
  const struct um_geometry_part_spec parts[] = {support_plate("floor", 2, 2, um_vec3(0, 0, 0)),
                                                support_plate("roof", 40, 40, um_vec3(20.3, 0, 1))};
  struct support s = support_create(parts, 2);
  double seen[8], lit[8], e[8];
  assert_int_equal(s.mesh->nsurface, 8);
  um_geometry_visibility_toward_both(s.visibility, um_vec3_unit(um_vec3(-1, 0, 0.2)),
                                     um_vec3(0, 0, 1), 0.3, 4096, 0, seen, lit, NULL, e);
  double area = 0.0, variance = 0.0;
  for (size_t i = 0; i < 4; i++) {
    double a = s.mesh->area[s.mesh->surface[i].facet];
    area += a * lit[i];
    variance += a * a * lit[i] * (1.0 - lit[i]) / 4095.0;
    assert_close(e[i], sqrt(lit[i] * (1.0 - lit[i]) * um_geometry_scatter(4096)), 1e-15);
  }
  assert_close(area, 2.6, sqrt(variance));
  support_destroy(&s);
}

/* A single point has no known error: the largest one is stated, none for open surfaces. */
static void error_of_one_sample(void **state)
{
  (void)state;
  const struct um_geometry_part_spec parts[] = {support_plate("floor", 2, 2, um_vec3(0, 0, 0)),
                                                support_plate("roof", 1, 1, um_vec3(0, 0, 1))};
  struct support s = support_create(parts, 2);
  double seen[8], lit[8], seen_error[8], lit_error[8];
  struct um_vec3 up = um_vec3(0, 0, 1);
  um_geometry_visibility_toward_both(s.visibility, up, up, 0.0, 1, 0, seen, lit, seen_error,
                                     lit_error);
  for (size_t i = 0; i < 8; i++) {
    bool asked = s.mesh->surface[i].part == 0 && !s.mesh->surface[i].back;
    assert_close(seen_error[i], asked ? 0.5 : 0.0, 0.0);
    assert_close(lit_error[i], asked ? 0.5 : 0.0, 0.0);
  }
  support_destroy(&s);
}

/* The sky against rays toward 400 directions all over the sphere, for a body with a wing and a
 * dish. A cell is 0.22 rad wide, so that single values differ; means must not: over all the
 * difference has no bias, and its size is that of cells on shadow edges. */
static void sky_agrees_with_rays(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[3] = {support_box("bus", 2, 1, 1),
                                           support_plate("wing", 3, 1, um_vec3(0.3, 1.2, 0.4)),
                                           {.name = "dish",
                                            .shape = UM_SHAPE_PARABOLOID,
                                            .radius = 0.6,
                                            .focal_length = 0.3,
                                            .position = {0, 0, 0.6},
                                            .skins = &support_open,
                                            .nskin = 1,
                                            .facet_size = 0.3}};
  parts[0].facet_size = parts[1].facet_size = 0.5;
  parts[1].rotation = um_quat_from_axis(um_vec3_unit(um_vec3(1, 2, -1)), 0.8);
  struct support s = support_create(parts, 3);
  struct um_geometry_sky *sky;
  assert_int_equal(um_geometry_sky_create(s.context, s.visibility, 64, &sky), UM_OK);
  double *f = calloc(s.mesh->nsurface, sizeof *f);
  assert_non_null(f);
  double sum = 0.0, size = 0.0, n = 0.0, blocked = 0.0;
  for (uint64_t k = 0; k < 400; k++) {
    double u[2];
    um_core_sample_2d(9, k, u);
    double z = 2.0 * u[0] - 1.0, r = sqrt(1.0 - z * z), phi = 2.0 * UM_PI * u[1];
    struct um_vec3 d = um_vec3(r * cos(phi), r * sin(phi), z);
    um_geometry_visibility_toward(s.visibility, d, 64, f);
    for (size_t i = 0; i < s.mesh->nsurface; i++) {
      double cosine = um_vec3_dot(um_geometry_surface_normal(s.mesh, s.pose, i), d);
      if (!(cosine > 0.0) || um_geometry_visibility_is_open(s.visibility, i)) continue;
      double difference = um_geometry_sky_free(sky, i, d) - f[i];
      sum += cosine * difference;
      size += cosine * fabs(difference);
      blocked += cosine * (1.0 - f[i]);
      n += cosine;
    }
  }
  print_message("sky: blocked %.4f, bias %.5f, mean size of differences %.4f\n", blocked / n,
                sum / n, size / n);
  assert_true(blocked / n > 0.1);
  assert_close(sum / n, 0.0, 0.005);
  assert_true(size / n < 0.08);
  free(f);
  um_geometry_sky_destroy(&sky);
  support_destroy(&s);
}

/* The sky of a floor under a half plane: free toward -x, covered toward +x; open surfaces are 1. */
static void sky_cells(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[] = {support_plate("floor", 0.1, 0.1, um_vec3(0, 0, 0)),
                                          support_plate("roof", 400, 400, um_vec3(200, 0, 1))};
  struct support s = support_create(parts, 2);
  struct um_geometry_sky *sky;
  assert_int_equal(um_geometry_sky_create(s.context, s.visibility, 16, &sky), UM_OK);
  uint32_t floor_front = s.mesh->surface_of_front[0], floor_back = s.mesh->surface_of_back[0];
  double covered = 0.0, solid = 0.0;
  for (uint64_t i = 0; i < 40000; i++) {
    double u[2];
    um_core_sample_2d(5, i, u);
    /* equal solid angles of the upper half */
    double z = u[0], r = sqrt(1.0 - z * z), phi = 2.0 * UM_PI * u[1];
    struct um_vec3 d = um_vec3(r * cos(phi), r * sin(phi), z);
    double f = um_geometry_sky_free(sky, floor_front, d);
    /* cells beside the plane x = 0 reach to |x| = 0.26, those at the horizon to z = 0.44, where
     * the roof's end lies; elsewhere all free or all covered */
    if (d.x > 0.3 && z > 0.45) assert_true(f == 0.0);
    if (d.x < -0.3) assert_true(f == 1.0);
    covered += 1.0 - f;
    solid += 1.0;
    assert_true(um_geometry_sky_free(sky, floor_back, um_vec3_scale(d, -1.0)) == 1.0);
  }
  /* half of the half space is roof, to the size of a cell at the border, which averages out, and to
   * the strip below the roof's end at 400 m. Cells: 1/256 of the sphere; 16 samples each. */
  assert_close(covered / solid, 0.5, 0.02);
  um_geometry_sky_destroy(&sky);
  assert_null(sky);
  support_destroy(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(cube_projects_sqrt3),
                                     cmocka_unit_test(sphere_projects_circle),
                                     cmocka_unit_test(grazing_fractions_are_exact),
                                     cmocka_unit_test(plate_above_plate),
                                     cmocka_unit_test(shadow_edge_across_facets),
                                     cmocka_unit_test(sun_disc_makes_penumbra),
                                     cmocka_unit_test(penumbra_converges_on_one_facet),
                                     cmocka_unit_test(error_of_one_sample),
                                     cmocka_unit_test(sky_cells),
                                     cmocka_unit_test(sky_agrees_with_rays)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
