/* Shadows of a body of few facets against rays from the same points. */
#include "geometry/shades_impl.h"
#include "geometry/visibility_impl.h"
#include "tests/geometry/support.h"

#define POINTS     256
#define DIRECTIONS 400

/* Rays from the points of a surface toward d. */
static void rays_say(const struct support *s, size_t surface, struct um_vec3 d,
                     uint8_t hidden[POINTS])
{
  struct um_geometry_ray ray[POINTS];
  uint32_t facet = s->mesh->surface[surface].facet;
  for (uint64_t k = 0; k < POINTS; k++)
    ray[k] = (struct um_geometry_ray){um_geometry_points_facet(s->visibility, 0, facet, k), d,
                                      INFINITY, facet};
  um_geometry_visibility_occluded_coherent(s->visibility, ray, POINTS, hidden);
}

static struct um_vec3 direction(uint64_t i)
{
  double u[2];
  um_core_sample_2d(7, i, u);
  double z = 2.0 * u[0] - 1.0, r = sqrt(1.0 - z * z);
  return um_vec3(r * cos(2.0 * UM_PI * u[1]), r * sin(2.0 * UM_PI * u[1]), z);
}

static struct support two_parts(void)
{
  struct um_geometry_part_spec parts[] = {support_box("bus", 1, 1, 1.2),
                                          support_plate("array", 1.2, 1.4, um_vec3(0, 1.5, 0))};
  parts[0].facet_size = 0.7;
  parts[1].facet_size = 1.2;
  parts[1].rotation = um_quat_from_axis(um_vec3(0, 1, 0), 0.5);
  return support_create(parts, 2);
}

/* Every point of every surface is hidden where its ray is, but for one in a hundred thousand, which
 * lies within rounding of an edge; fractions are those of the points. */
static void points_are_hidden_as_rays_say(void **state)
{
  (void)state;
  struct support s = two_parts();
  double *fraction = calloc(s.mesh->nsurface, sizeof *fraction);
  size_t asked = 0, differ = 0, partly = 0;
  assert_non_null(fraction);
  for (uint64_t i = 0; i < DIRECTIONS; i++) {
    struct um_vec3 d = direction(i);
    struct um_geometry_shades_look look;
    assert_true(um_geometry_shades_toward(s.visibility, d, &look));
    um_geometry_visibility_toward(s.visibility, d, POINTS, fraction);
    for (size_t f = 0; f < s.mesh->nsurface; f++) {
      struct um_geometry_shade shade[UM_GEOMETRY_SHADES_MOST];
      uint8_t hidden[POINTS], by_rays[POINTS];
      if (um_geometry_visibility_is_open(s.visibility, f) ||
          !(um_vec3_dot(um_geometry_surface_normal(s.mesh, s.pose, f), d) > 0.0))
        continue;
      size_t n = um_geometry_shades_before(&look, f, 0.0, shade), free_points = 0;
      assert_true(n != SIZE_MAX);
      um_geometry_shades_on(s.visibility, 0, s.mesh->surface[f].facet, shade, n, POINTS, hidden);
      rays_say(&s, f, d, by_rays);
      for (size_t k = 0; k < POINTS; k++) {
        asked++;
        differ += (hidden[k] != 0) != (by_rays[k] != 0);
        free_points += hidden[k] == 0;
      }
      assert_true(fraction[f] == (double)free_points / POINTS);
      partly += free_points > 0 && free_points < POINTS;
    }
  }
  assert_true(asked > 100000 && partly > 100);
  if ((double)differ > 1e-5 * (double)asked) fail_msg("%zu of %zu points differ", differ, asked);
  free(fraction);
  support_destroy(&s);
}

/* What stands behind, or aside, hides nothing; a margin counts what is near. */
static void what_is_apart_does_not_stand_before(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[] = {support_plate("floor", 1, 1, um_vec3(0, 0, 0)),
                                          support_plate("roof", 1, 1, um_vec3(1.1, 0, 1))};
  struct support s = support_create(parts, 2);
  struct um_geometry_shades_look look;
  assert_true(um_geometry_shades_toward(s.visibility, um_vec3(0, 0, 1), &look));
  for (size_t f = 0; f < s.mesh->nsurface; f++) {
    if (s.mesh->surface[f].part != 0 || s.mesh->surface[f].back) continue;
    assert_int_equal(um_geometry_shades_before(&look, f, 1e-6, NULL), 0);
  }
  size_t near = 0;
  for (size_t f = 0; f < s.mesh->nsurface; f++)
    if (s.mesh->surface[f].part == 0 && !s.mesh->surface[f].back)
      near += um_geometry_shades_before(&look, f, 0.11, NULL);
  assert_true(near > 0);
  support_destroy(&s);
}

/* A body of many facets is left to rays. */
static void many_facets_are_left_to_rays(void **state)
{
  (void)state;
  struct um_geometry_part_spec parts[] = {support_box("bus", 1, 1, 1),
                                          support_plate("array", 1, 1, um_vec3(0, 1.5, 0))};
  parts[0].facet_size = 0.1;
  struct support s = support_create(parts, 2);
  struct um_geometry_shades_look look;
  assert_true(s.mesh->nfacet > UM_GEOMETRY_SHADES_FACETS);
  assert_false(um_geometry_shades_toward(s.visibility, um_vec3(0, 0, 1), &look));
  support_destroy(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(points_are_hidden_as_rays_say),
                                     cmocka_unit_test(what_is_apart_does_not_stand_before),
                                     cmocka_unit_test(many_facets_are_left_to_rays)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
