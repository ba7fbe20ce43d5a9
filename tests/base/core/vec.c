/* Vectors, rotations. Expected values from the definitions: a passive rotation by +90 deg about z
 * turns the axes, so that the x axis of A reads (0, -1, 0) in B. Tolerances are a few units of the
 * last place of numbers of order one. */
#include "base/core/vec.h"

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "tests/support/cmocka_all.h"

#define ULPS 4e-15

static void assert_vec(struct um_vec3 v, double x, double y, double z, double tolerance)
{
  assert_close(v.x, x, tolerance);
  assert_close(v.y, y, tolerance);
  assert_close(v.z, z, tolerance);
}

/* Uniform in (-1, 1). */
static double random_value(uint64_t key, uint64_t index)
{
  return 2.0 * um_core_hash_uniform(um_core_hash(key, index)) - 1.0;
}

static struct um_quat random_quat(uint64_t i)
{
  return um_quat_normalize((struct um_quat){random_value(1, i), random_value(2, i),
                                            random_value(3, i), random_value(4, i)});
}

/* Equal as rotations: q and -q are the same. */
static void assert_same_rotation(struct um_quat a, struct um_quat b, double tolerance)
{
  double dot = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  double sign = dot < 0.0 ? -1.0 : 1.0;
  assert_close(a.w, sign * b.w, tolerance);
  assert_close(a.x, sign * b.x, tolerance);
  assert_close(a.y, sign * b.y, tolerance);
  assert_close(a.z, sign * b.z, tolerance);
}

static void test_vectors(void **state)
{
  (void)state;
  struct um_vec3 a = um_vec3(1, 2, 3), b = um_vec3(-4, 5, 6);
  assert_true(um_vec3_dot(a, b) == 24.0);
  assert_vec(um_vec3_cross(a, b), -3.0, -18.0, 13.0, 0.0);
  assert_vec(um_vec3_axpy(a, 2.0, b), -7.0, 12.0, 15.0, 0.0);
  assert_close(um_vec3_norm(um_vec3(3, 4, 12)), 13.0, 0.0);
  assert_close(um_vec3_norm(um_vec3_unit(b)), 1.0, ULPS);
  assert_true(isnan(um_vec3_unit(um_vec3(0, 0, 0)).x));
}

/* The arc cosine would lose eight digits at 1e-8 rad. */
static void test_small_angles(void **state)
{
  (void)state;
  struct um_vec3 x = um_vec3(1, 0, 0);
  assert_close(um_vec3_angle(x, um_vec3(cos(1e-8), sin(1e-8), 0)), 1e-8, 1e-22);
  assert_close(um_vec3_angle(x, um_vec3(-1, 1e-8, 0)), UM_PI - 1e-8, ULPS);
  assert_close(um_vec3_angle(x, um_vec3(0, 0, 5)), 0.5 * UM_PI, ULPS);
}

static void test_passive_sense(void **state)
{
  (void)state;
  struct um_quat q = um_quat_from_axis(um_vec3(0, 0, 1), 0.5 * UM_PI);
  assert_vec(um_quat_apply(q, um_vec3(1, 0, 0)), 0, -1, 0, ULPS);
  assert_vec(um_quat_apply(q, um_vec3(0, 1, 0)), 1, 0, 0, ULPS);
  assert_vec(um_quat_apply(q, um_vec3(0, 0, 1)), 0, 0, 1, ULPS);
  /* the matrix of axes of B in A does the same */
  struct um_mat3 m = um_mat3_from_axes(um_vec3(0, 1, 0), um_vec3(-1, 0, 0), um_vec3(0, 0, 1));
  assert_vec(um_mat3_apply(m, um_vec3(1, 0, 0)), 0, -1, 0, 0.0);
}

/* First A to B, then B to C, by quaternions and by matrices. */
static void test_composition(void **state)
{
  (void)state;
  for (uint64_t i = 0; i < 200; i++) {
    struct um_quat p = random_quat(i), q = random_quat(i + 1000);
    struct um_vec3 v = um_vec3(random_value(5, i), random_value(6, i), random_value(7, i));
    struct um_vec3 stepwise = um_quat_apply(q, um_quat_apply(p, v));
    assert_close(um_vec3_norm(stepwise), um_vec3_norm(v), ULPS);
    struct um_vec3 once = um_quat_apply(um_quat_then(p, q), v);
    assert_vec(once, stepwise.x, stepwise.y, stepwise.z, ULPS);
    struct um_mat3 m = um_mat3_multiply(um_quat_matrix(q), um_quat_matrix(p));
    once = um_mat3_apply(m, v);
    assert_vec(once, stepwise.x, stepwise.y, stepwise.z, ULPS);
    struct um_vec3 back = um_quat_apply(um_quat_conjugate(p), um_quat_apply(p, v));
    assert_vec(back, v.x, v.y, v.z, ULPS);
    back = um_mat3_apply(um_mat3_transpose(um_quat_matrix(p)), um_quat_apply(p, v));
    assert_vec(back, v.x, v.y, v.z, ULPS);
  }
}

/* Every branch of Shepperd's method, half turns included, and random rotations. */
static void test_quat_from_matrix(void **state)
{
  (void)state;
  static const struct um_vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0.0, 0.8}};
  static const double angles[] = {0.0, 1e-9, 0.3, 2.0, UM_PI - 1e-9, UM_PI, 5.0};
  for (size_t i = 0; i < 4; i++)
    for (size_t j = 0; j < 7; j++) {
      struct um_quat q = um_quat_from_axis(axes[i], angles[j]);
      assert_same_rotation(um_core_quat_from_matrix(um_quat_matrix(q)), q, ULPS);
    }
  for (uint64_t i = 0; i < 500; i++) {
    struct um_quat q = random_quat(i);
    assert_same_rotation(um_core_quat_from_matrix(um_quat_matrix(q)), q, ULPS);
  }
}

static void test_slerp(void **state)
{
  (void)state;
  struct um_vec3 axis = um_vec3_unit(um_vec3(1, 2, -2));
  struct um_quat a = um_quat_from_axis(axis, 0.2), b = um_quat_from_axis(axis, 2.2);
  for (int i = 0; i <= 10; i++) {
    double u = 0.1 * i;
    assert_same_rotation(um_core_quat_slerp(a, b, u), um_quat_from_axis(axis, 0.2 + 2.0 * u), ULPS);
    /* -b is the same attitude: the shorter arc is taken */
    struct um_quat minus = {-b.w, -b.x, -b.y, -b.z};
    assert_same_rotation(um_core_quat_slerp(a, minus, u), um_quat_from_axis(axis, 0.2 + 2.0 * u),
                         ULPS);
  }
  assert_same_rotation(um_core_quat_slerp(a, a, 0.3), a, ULPS);
  struct um_quat near = um_quat_from_axis(axis, 0.2 + 1e-10);
  assert_same_rotation(um_core_quat_slerp(a, near, 0.5), um_quat_from_axis(axis, 0.2 + 5e-11),
                       ULPS);
}

/* (t, b, n) is orthonormal and right-handed for every n, the poles included. */
static void check_frame(struct um_vec3 n)
{
  struct um_vec3 t, b;
  um_core_vec3_frame(n, &t, &b);
  assert_close(um_vec3_norm(t), 1.0, ULPS);
  assert_close(um_vec3_norm(b), 1.0, ULPS);
  assert_close(um_vec3_dot(t, b), 0.0, ULPS);
  assert_close(um_vec3_dot(t, n), 0.0, ULPS);
  assert_close(um_vec3_dot(b, n), 0.0, ULPS);
  struct um_vec3 c = um_vec3_cross(t, b);
  assert_vec(c, n.x, n.y, n.z, ULPS);
}

static void test_frame(void **state)
{
  (void)state;
  check_frame(um_vec3(0, 0, 1));
  check_frame(um_vec3(0, 0, -1));
  check_frame(um_vec3(1, 0, 0));
  check_frame(um_vec3(0, -1, 0));
  check_frame(um_vec3(1, 0, -0.0));
  check_frame(um_vec3_unit(um_vec3(1e-9, -1e-9, -1)));
  for (uint64_t i = 0; i < 500; i++)
    check_frame(um_vec3_unit(um_vec3(random_value(8, i), random_value(9, i), random_value(10, i))));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_vectors),
      cmocka_unit_test(test_small_angles),
      cmocka_unit_test(test_passive_sense),
      cmocka_unit_test(test_composition),
      cmocka_unit_test(test_quat_from_matrix),
      cmocka_unit_test(test_slerp),
      cmocka_unit_test(test_frame),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
