/* Rays: occlusion and closest hit against positions known by hand; self-hits; packets. */
#include "tests/geometry/support.h"

/* Cosine-distributed directions and points, keyed by index. */
static struct um_geometry_ray random_ray(uint64_t i)
{
  double u[2], v[2];
  um_core_sample_2d(11, i, u);
  um_core_sample_2d(12, i, v);
  struct um_vec3 axis = um_vec3_unit(um_vec3(v[0] - 0.5, v[1] - 0.5, u[0] - 0.5));
  struct um_vec3 origin = um_vec3(6 * u[0] - 3, 6 * u[1] - 3, 6 * v[0] - 3);
  return (struct um_geometry_ray){origin, axis, INFINITY, UM_GEOMETRY_NONE};
}

/* Box of 2 x 2 x 2 and a plate 1 m above its top:
 *          ---------   z = 2
 *   ray ->   [   ]     -1 < z < 1                                                             */
static struct support box_and_plate(void)
{
  const struct um_geometry_part_spec parts[] = {support_box("bus", 2, 2, 2),
                                                support_plate("shade", 4, 4, um_vec3(0, 0, 2))};
  return support_create(parts, 2);
}

static void closest_known(void **state)
{
  (void)state;
  struct support s = box_and_plate();
  struct um_geometry_ray rays[4] = {
      {{5, 0.25, -0.5}, {-1, 0, 0}, INFINITY, UM_GEOMETRY_NONE}, /* +x side, 4 m away */
      {{0.3, 0.4, 7}, {0, 0, -1}, INFINITY, UM_GEOMETRY_NONE},   /* front of the shade, 5 m */
      {{0.3, 0.4, 1.5}, {0, 0, 1}, INFINITY, UM_GEOMETRY_NONE},  /* back of the shade, 0.5 m */
      {{5, 5, 5}, {0, 0, 1}, INFINITY, UM_GEOMETRY_NONE}};       /* nothing */
  struct um_geometry_hit hits[4];
  um_geometry_visibility_closest(s.visibility, rays, 4, hits);
  const double distance[3] = {4.0, 5.0, 0.5};
  for (int i = 0; i < 3; i++) {
    assert_close(hits[i].distance, distance[i], 1e-14);
    struct um_vec3 p = um_vec3(0, 0, 0);
    for (int k = 0; k < 3; k++)
      p = um_vec3_axpy(p, hits[i].weight[k], s.pose->vertex[s.mesh->corner[hits[i].facet][k]]);
    struct um_vec3 q = um_vec3_axpy(rays[i].origin, hits[i].distance, rays[i].direction);
    assert_close(um_vec3_norm(um_vec3_sub(p, q)), 0.0, 1e-14);
  }
  const struct um_geometry_group *side =
      um_geometry_group(s.geometry, s.mesh->surface[hits[0].surface].group);
  assert_string_equal(side->name, "+x");
  assert_int_equal(s.mesh->surface[hits[1].surface].back, 0);
  assert_int_equal(s.mesh->surface[hits[2].surface].back, 1);
  assert_int_equal(hits[3].facet, UM_GEOMETRY_NONE);
  assert_int_equal(hits[3].surface, UM_GEOMETRY_NONE);
  support_destroy(&s);
}

/* From inside the box the back of a side is hit, which is no surface. */
static void closest_inside(void **state)
{
  (void)state;
  struct support s = box_and_plate();
  struct um_geometry_ray ray = {{0, 0.1, 0.2}, {1, 0, 0}, INFINITY, UM_GEOMETRY_NONE};
  struct um_geometry_hit hit;
  um_geometry_visibility_closest(s.visibility, &ray, 1, &hit);
  assert_close(hit.distance, 1.0, 1e-14);
  assert_int_not_equal(hit.facet, UM_GEOMETRY_NONE);
  assert_int_equal(hit.surface, UM_GEOMETRY_NONE);
  support_destroy(&s);
}

/* The limit holds in double precision: 1 m to the shade, limits 1 ppm to either side. */
static void limit(void **state)
{
  (void)state;
  struct support s = box_and_plate();
  struct um_geometry_ray rays[3];
  for (int i = 0; i < 3; i++)
    rays[i] = (struct um_geometry_ray){{0.3, 0.1, 1}, {0, 0, 1}, 1.0, UM_GEOMETRY_NONE};
  rays[0].limit = 1.0 - 1e-9;
  rays[1].limit = 1.0 + 1e-9;
  rays[2].limit = 0.5;
  uint8_t occluded[3];
  /* the origin lies on the box's top, which is named so that it is not hit itself */
  for (uint32_t f = 0; f < s.mesh->nfacet; f++) {
    const char *group = um_geometry_group(s.geometry, s.mesh->facet_group[f])->name;
    if (strcmp(group, "+z") == 0) rays[0].from_facet = f;
  }
  rays[1].from_facet = rays[2].from_facet = rays[0].from_facet;
  um_geometry_visibility_occluded(s.visibility, rays, 3, occluded);
  assert_int_equal(occluded[0], 0);
  assert_int_equal(occluded[1], 1);
  assert_int_equal(occluded[2], 0);
  support_destroy(&s);
}

/* Rays in packets of eight, in another order, and one by one give the same answer. The rays are in
 * general position; on shared edges the two kinds of query may pick either facet. */
static void packets_equal_single_rays(void **state)
{
  (void)state;
  enum { n = 4003 };
  struct support s = box_and_plate();
  static struct um_geometry_ray rays[n], turned[n];
  static struct um_geometry_hit hits[n];
  static uint8_t occluded[n], turned_occluded[n];
  for (size_t i = 0; i < n; i++) rays[i] = turned[n - 1 - i] = random_ray(i);
  um_geometry_visibility_occluded(s.visibility, rays, n, occluded);
  um_geometry_visibility_occluded(s.visibility, turned, n, turned_occluded);
  um_geometry_visibility_closest(s.visibility, rays, n, hits);
  size_t nhit = 0;
  for (size_t i = 0; i < n; i++) {
    uint8_t one;
    struct um_geometry_hit hit;
    um_geometry_visibility_occluded(s.visibility, &rays[i], 1, &one);
    um_geometry_visibility_closest(s.visibility, &rays[i], 1, &hit);
    assert_int_equal(one, occluded[i]);
    assert_int_equal(turned_occluded[n - 1 - i], occluded[i]);
    assert_int_equal(hit.facet, hits[i].facet);
    assert_int_equal(hit.facet != UM_GEOMETRY_NONE, occluded[i]);
    if (occluded[i]) assert_true(hit.distance == hits[i].distance);
    nhit += occluded[i];
  }
  assert_true(nhit > n / 5 && nhit < 4 * n / 5);
  support_destroy(&s);
}

/* Against a double-precision search through all facets. */
static void closest_equals_brute_force(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[3] = {support_box("bus", 2, 1, 1),
                                           support_plate("wing", 3, 1, um_vec3(0, 0, 1.5)),
                                           {.name = "ball",
                                            .shape = UM_SHAPE_SPHERE,
                                            .radius = 0.6,
                                            .position = {0, 2, 0},
                                            .skins = &support_closed,
                                            .nskin = 1}};
  parts[1].rotation = um_quat_from_axis(um_vec3_unit(um_vec3(1, 2, 3)), 0.7);
  struct support s = support_create(parts, 3);
  for (uint64_t i = 0; i < 500; i++) {
    struct um_geometry_ray ray = random_ray(i);
    double best = INFINITY;
    for (size_t f = 0; f < s.mesh->nfacet; f++) {
      const uint32_t *c = s.mesh->corner[f];
      struct um_vec3 n = s.pose->facet_normal[f], a = s.pose->vertex[c[0]];
      double t = um_vec3_dot(um_vec3_sub(a, ray.origin), n) / um_vec3_dot(ray.direction, n);
      struct um_vec3 p = um_vec3_axpy(ray.origin, t, ray.direction);
      bool in = t > 0.0;
      for (int k = 0; k < 3; k++) {
        struct um_vec3 u = s.pose->vertex[c[k]], v = s.pose->vertex[c[(k + 1) % 3]];
        in = in && um_vec3_dot(um_vec3_cross(um_vec3_sub(v, u), um_vec3_sub(p, u)), n) >= 0.0;
      }
      if (in && t < best) best = t;
    }
    struct um_geometry_hit hit;
    um_geometry_visibility_closest(s.visibility, &ray, 1, &hit);
    if (isinf(best))
      assert_int_equal(hit.facet, UM_GEOMETRY_NONE);
    else
      assert_close(hit.distance, best, 1e-11);
  }
  support_destroy(&s);
}

/* The open flag: all of a convex body; of box + shade only what nothing stands before. */
static void open_flag(void **state)
{
  (void)state;
  struct um_geometry_part_spec convex[] = {support_box("bus", 2, 3, 4)};
  convex[0].facet_size = 0.5;
  convex[0].rotation = um_quat_from_axis(um_vec3_unit(um_vec3(1, 1, 0.3)), 0.4);
  struct support s = support_create(convex, 1);
  for (size_t i = 0; i < s.mesh->nsurface; i++)
    assert_true(um_geometry_visibility_is_open(s.visibility, i));
  support_destroy(&s);
  s = box_and_plate();
  for (size_t i = 0; i < s.mesh->nsurface; i++) {
    const struct um_geometry_surface *surface = &s.mesh->surface[i];
    const char *group = um_geometry_group(s.geometry, surface->group)->name;
    /* -z looks away from the shade; the shade's front looks away from the box */
    bool expected = strcmp(group, "-z") == 0 || (strcmp(group, "plate") == 0 && !surface->back);
    assert_int_equal(um_geometry_visibility_is_open(s.visibility, i), expected);
  }
  support_destroy(&s);
  struct um_geometry_part_spec ball = {.name = "ball",
                                       .shape = UM_SHAPE_SPHERE,
                                       .radius = 1.0,
                                       .skins = &support_closed,
                                       .nskin = 1,
                                       .facet_size = 0.2};
  s = support_create(&ball, 1);
  for (size_t i = 0; i < s.mesh->nsurface; i++)
    assert_true(um_geometry_visibility_is_open(s.visibility, i));
  support_destroy(&s);
}

/* A finely cut plate and box far from the origin, with a second body that makes no surface open:
 * rays from a facet at grazing angles down to 1e-6 rad never meet the facet's own plane. */
static void grazing_rays_leave_their_plane(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[3] = {support_plate("wing", 5, 2, um_vec3(900, -300, 77)),
                                           support_box("bus", 2, 1, 1),
                                           support_plate("far", 0.1, 0.1, um_vec3(900, -300, 90))};
  parts[0].rotation = um_quat_from_axis(um_vec3_unit(um_vec3(3, -1, 2)), 0.9);
  parts[0].facet_size = 0.1;
  parts[1].position = um_vec3(915, -300, 77);
  parts[1].rotation = um_quat_from_axis(um_vec3_unit(um_vec3(-1, 1, 2)), 2.1);
  parts[1].facet_size = 0.1;
  struct support s = support_create(parts, 3);
  size_t tested = 0;
  for (uint32_t f = 0; f < s.mesh->nfacet; f += 7) {
    if (s.mesh->facet_part[f] == 2) continue;
    const uint32_t *c = s.mesh->corner[f];
    struct um_vec3 n = s.pose->facet_normal[f], t, b;
    um_core_vec3_frame(n, &t, &b);
    for (uint64_t k = 0; k < 8; k++) {
      double u[2], w[3];
      um_core_sample_2d(f, k, u);
      um_core_sample_triangle(u, w);
      struct um_vec3 p = um_vec3(0, 0, 0);
      for (int j = 0; j < 3; j++) p = um_vec3_axpy(p, w[j], s.pose->vertex[c[j]]);
      double rise = pow(10.0, -(double)(k % 7)), turn = 2.0 * UM_PI * u[0];
      struct um_vec3 along = um_vec3_axpy(um_vec3_scale(t, cos(turn)), sin(turn), b);
      struct um_geometry_ray ray = {p, um_vec3_unit(um_vec3_axpy(along, rise, n)), 6.0, f};
      uint8_t occluded;
      struct um_geometry_hit hit;
      /* nothing else is within 6 m */
      um_geometry_visibility_occluded(s.visibility, &ray, 1, &occluded);
      um_geometry_visibility_closest(s.visibility, &ray, 1, &hit);
      assert_int_equal(occluded, 0);
      assert_int_equal(hit.facet, UM_GEOMETRY_NONE);
      tested++;
    }
  }
  assert_true(tested > 2000);
  support_destroy(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(closest_known),
                                     cmocka_unit_test(closest_inside),
                                     cmocka_unit_test(limit),
                                     cmocka_unit_test(packets_equal_single_rays),
                                     cmocka_unit_test(closest_equals_brute_force),
                                     cmocka_unit_test(open_flag),
                                     cmocka_unit_test(grazing_rays_leave_their_plane)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
