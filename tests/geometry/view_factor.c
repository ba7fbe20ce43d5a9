/* View factors by cosine-distributed rays and closest hits against closed forms (Howell, A Catalog
 * of Radiation Heat Transfer Configuration Factors, C-11, C-14, C-41). The points are independent
 * uniform ones, so that the standard error of a fraction is sqrt(F (1 - F) / N); accepted within 4
 * of them: 6e-5 false alarms per case. */
#include "tests/geometry/support.h"

#define NRAY  400000
#define BATCH 1000

static double uniform(uint64_t key, uint64_t index)
{
  return um_core_hash_uniform(um_core_hash(key, index));
}

/* Fraction of what leaves the front of part 0 that arrives at the front of part 1. */
static double view_factor(const struct support *s)
{
  static struct um_geometry_ray rays[BATCH];
  static struct um_geometry_hit hits[BATCH];
  double total = 0.0;
  size_t nfrom = 0, arrived = 0;
  while (nfrom < s->mesh->nfacet && s->mesh->facet_part[nfrom] == 0)
    total += s->mesh->area[nfrom++];
  for (uint64_t first = 0; first < NRAY; first += BATCH) {
    for (uint64_t k = 0; k < BATCH; k++) {
      uint64_t i = first + k;
      /* facet by area, point, direction */
      double pick = uniform(1, i) * total, w[3];
      uint32_t f = 0;
      while (f + 1 < nfrom && pick >= s->mesh->area[f]) pick -= s->mesh->area[f++];
      double point[2] = {uniform(2, i), uniform(3, i)}, turn[2] = {uniform(4, i), uniform(5, i)};
      um_core_sample_triangle(point, w);
      struct um_vec3 p = um_vec3(0, 0, 0);
      for (int j = 0; j < 3; j++) p = um_vec3_axpy(p, w[j], s->pose->vertex[s->mesh->corner[f][j]]);
      rays[k] = (struct um_geometry_ray){p, um_core_sample_cosine(turn, s->pose->facet_normal[f]),
                                         INFINITY, f};
    }
    um_geometry_visibility_closest(s->visibility, rays, BATCH, hits);
    for (size_t k = 0; k < BATCH; k++) {
      if (hits[k].facet == UM_GEOMETRY_NONE || s->mesh->facet_part[hits[k].facet] != 1) continue;
      assert_int_equal(hits[k].surface, s->mesh->surface_of_front[hits[k].facet]);
      arrived++;
    }
  }
  return (double)arrived / NRAY;
}

static void check(struct um_geometry_part_spec from, struct um_geometry_part_spec to,
                  double expected, double facet_error)
{
  struct um_geometry_part_spec parts[2] = {from, to};
  struct support s = support_create(parts, 2);
  double f = view_factor(&s), sigma = sqrt(expected * (1.0 - expected) / NRAY);
  print_message("view factor %.6f, expected %.6f: %+.2f sigma (%.1e)\n", f, expected,
                (f - expected) / sigma, sigma);
  assert_close(f, expected, 4.0 * sigma + facet_error);
  support_destroy(&s);
}

static struct um_geometry_part_spec facing(const char *name, double x, double y, double distance)
{
  struct um_geometry_part_spec spec = support_plate(name, x, y, um_vec3(0, 0, distance));
  spec.rotation = um_quat_from_axis(um_vec3(1, 0, 0), UM_PI); /* front down */
  return spec;
}

static void aligned_plates(void **state)
{
  (void)state;
  static const double expected[] = {0.199825, 0.415253, 0.068590}, distance[] = {1.0, 0.5, 2.0};
  for (int i = 0; i < 3; i++) {
    struct um_geometry_part_spec below = support_plate("below", 1, 1, um_vec3(0, 0, 0));
    if (i == 0) below.facet_size = 0.2;
    check(below, facing("above", 1, 1, distance[i]), expected[i], 0.0);
  }
  check(support_plate("below", 2, 1, um_vec3(0, 0, 0)), facing("above", 2, 1, 1.0), 0.285875, 0.0);
}

/* A wall whose lower edge is the edge x = 1/2 of the floor; its front looks to -x. */
static struct um_geometry_part_spec wall(double height)
{
  struct um_geometry_part_spec spec =
      support_plate("wall", height, 1, um_vec3(0.5, 0, 0.5 * height));
  spec.rotation = um_quat_from_axis(um_vec3(0, 1, 0), -0.5 * UM_PI);
  return spec;
}

static void perpendicular_plates(void **state)
{
  (void)state;
  struct um_geometry_part_spec floor = support_plate("floor", 1, 1, um_vec3(0, 0, 0));
  check(floor, wall(1.0), 0.200044, 0.0);
  floor.facet_size = 0.2;
  struct um_geometry_part_spec fine = wall(2.0);
  fine.facet_size = 0.2;
  check(floor, fine, 0.232853, 0.0);
}

/* Discs of equal area pi r^2 as polygons of 126 segments: the shape error is O(n^-2) = 6e-5. */
static void coaxial_discs(void **state)
{
  (void)state;
  struct um_geometry_part_spec below = {.name = "below",
                                        .shape = UM_SHAPE_DISC,
                                        .radius = 1,
                                        .facet_size = 0.0712,
                                        .skins = &support_open,
                                        .nskin = 1};
  struct um_geometry_part_spec above = below;
  above.name = "above";
  above.position = um_vec3(0, 0, 1);
  above.rotation = um_quat_from_axis(um_vec3(1, 0, 0), UM_PI);
  check(below, above, 0.381966, 6e-5);
}

/* A closed box seen from inside: every ray from a plate within ends on a side. */
static void cube_is_closed(void **state)
{
  (void)state;
  struct um_geometry_part_spec room[] = {support_box("room", 1, 1, 1),
                                         support_plate("desk", 0.5, 0.5, um_vec3(0, 0, 0))};
  struct support s = support_create(room, 2);
  static struct um_geometry_ray rays[BATCH];
  static struct um_geometry_hit hits[BATCH];
  uint32_t from = 12; /* the plate's first facet, in the middle of the room */
  size_t missed = 0;
  for (uint64_t first = 0; first < 200 * BATCH; first += BATCH) {
    for (uint64_t k = 0; k < BATCH; k++) {
      double turn[2] = {uniform(6, first + k), uniform(7, first + k)}, w[3];
      double point[2] = {uniform(8, first + k), uniform(9, first + k)};
      um_core_sample_triangle(point, w);
      struct um_vec3 p = um_vec3(0, 0, 0);
      for (int j = 0; j < 3; j++)
        p = um_vec3_axpy(p, w[j], s.pose->vertex[s.mesh->corner[from][j]]);
      rays[k] = (struct um_geometry_ray){p, um_core_sample_cosine(turn, s.pose->facet_normal[from]),
                                         INFINITY, from};
    }
    um_geometry_visibility_closest(s.visibility, rays, BATCH, hits);
    for (size_t k = 0; k < BATCH; k++) missed += hits[k].facet == UM_GEOMETRY_NONE;
  }
  /* watertight: not one of 200000 rays slips through an edge */
  assert_int_equal(missed, 0);
  support_destroy(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(aligned_plates), cmocka_unit_test(perpendicular_plates),
      cmocka_unit_test(coaxial_discs), cmocka_unit_test(cube_is_closed)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
