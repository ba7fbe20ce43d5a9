/* One scene asked from several threads, several scenes made at once, and the sky with one and four
 * threads: the same bytes. */
#include "tests/geometry/support.h"

#define NTHREAD 4

static struct support satellite(void)
{
  struct um_geometry_part_spec parts[3] = {support_box("bus", 2, 1, 1),
                                           support_plate("wing", 3, 1, um_vec3(0, 1.2, 0.4)),
                                           {.name = "dish",
                                            .shape = UM_SHAPE_PARABOLOID,
                                            .radius = 0.6,
                                            .focal_length = 0.3,
                                            .position = {0, 0, 0.6},
                                            .skins = &support_open,
                                            .nskin = 1,
                                            .facet_size = 0.2}};
  parts[0].facet_size = parts[1].facet_size = 0.4;
  return support_create(parts, 3);
}

static void one_scene_many_threads(void **state)
{
  (void)state;
  struct support s = satellite();
  size_t n = s.mesh->nsurface;
  double *result = calloc(4 * NTHREAD * n, sizeof *result);
  assert_non_null(result);
#pragma omp parallel for num_threads(NTHREAD) schedule(static, 1)
  for (size_t t = 0; t < NTHREAD; t++) {
    double *own = result + 4 * n * t;
    for (int k = 0; k < 5; k++)
      um_geometry_visibility_toward_both(s.visibility, um_vec3_unit(um_vec3(1, 2, 3)),
                                         um_vec3_unit(um_vec3(-1, 2, 1)), 0.00465, 16, 0, own,
                                         own + n, own + 2 * n, own + 3 * n);
  }
  for (size_t t = 1; t < NTHREAD; t++)
    assert_memory_equal(result, result + 4 * n * t, 4 * n * sizeof *result);
  double partial = 0.0;
  for (size_t i = 0; i < n; i++) partial += result[i] > 0.0 && result[i] < 1.0;
  assert_true(partial > 10.0);
  free(result);
  support_destroy(&s);
}

static void many_scenes_at_once(void **state)
{
  (void)state;
  struct support s = satellite();
  struct um_vec3 d = um_vec3_unit(um_vec3(1, 2, 3));
  size_t n = s.mesh->nsurface;
  double *result = calloc((NTHREAD + 1) * n, sizeof *result);
  assert_non_null(result);
  um_geometry_visibility_toward(s.visibility, d, 8, result);
  int failed = 0;
#pragma omp parallel for num_threads(NTHREAD) schedule(static, 1) reduction(+ : failed)
  for (size_t t = 0; t < NTHREAD; t++) {
    double *own = result + n * (1 + t);
    for (int k = 0; k < 3; k++) {
      struct um_context *context = NULL;
      struct um_geometry_visibility *v = NULL;
      failed += um_core_context_create(NULL, &context) != UM_OK;
      failed += um_geometry_visibility_create(context, s.mesh, s.pose, &v) != UM_OK;
      if (v != NULL) um_geometry_visibility_toward(v, d, 8, own);
      um_geometry_visibility_destroy(&v);
      um_core_context_destroy(&context);
    }
  }
  assert_int_equal(failed, 0);
  for (size_t t = 1; t <= NTHREAD; t++)
    assert_memory_equal(result, result + n * t, n * sizeof *result);
  free(result);
  support_destroy(&s);
}

static void sky_does_not_depend_on_threads(void **state)
{
  (void)state;
  struct support s = satellite();
  struct um_geometry_sky *sky[2];
  for (int i = 0; i < 2; i++) {
    um_core_context_set_threads(s.context, i == 0 ? 1 : NTHREAD);
    assert_int_equal(um_geometry_sky_create(s.context, s.visibility, 4, &sky[i]), UM_OK);
  }
  for (uint64_t k = 0; k < 200; k++) {
    double u[2];
    um_core_sample_2d(1, k, u);
    struct um_vec3 d = um_core_sample_cosine(u, um_vec3(0, 0, k % 2 == 0 ? 1 : -1));
    for (size_t i = 0; i < s.mesh->nsurface; i++)
      assert_true(um_geometry_sky_free(sky[0], i, d) == um_geometry_sky_free(sky[1], i, d));
  }
  for (int i = 0; i < 2; i++) um_geometry_sky_destroy(&sky[i]);
  support_destroy(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(one_scene_many_threads),
                                     cmocka_unit_test(many_scenes_at_once),
                                     cmocka_unit_test(sky_does_not_depend_on_threads)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
