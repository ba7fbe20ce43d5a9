/* The Earth between two points: against points laid along the line, and at the ellipsoid's own
 * axes.
 *
 *        o----------------------o     6356.8 km above the centre over the pole: free
 *     .-----------.
 *   (    Earth      )             */
#include "check.h"

#include "base/core/constants.h"
#include "base/core/sampling.h"
#include "environment/environment.h"

#define LINES  400
#define POINTS 20000

/* Least x^2 + y^2 + (z a/b)^2 over points on the line [m^2], the ends left out; the definition. */
static double nearest_squared(struct um_vec3 r, struct um_vec3 u, double range)
{
  double least = INFINITY, b = UM_EARTH_RADIUS * (1.0 - UM_EARTH_FLATTENING);
  for (int i = 1; i < POINTS; i++) {
    struct um_vec3 p = um_vec3_axpy(r, range * i / POINTS, u);
    double z = p.z * UM_EARTH_RADIUS / b;
    least = fmin(least, p.x * p.x + p.y * p.y + z * z);
  }
  return least;
}

static struct um_vec3 direction_of(uint64_t *key)
{
  double z = 2.0 * um_core_hash_uniform(um_core_hash((*key)++, 1)) - 1.0;
  double phi = 2.0 * UM_PI * um_core_hash_uniform(um_core_hash((*key)++, 1)), s = sqrt(1.0 - z * z);
  return um_vec3(s * cos(phi), s * sin(phi), z);
}

/* Satellites 300 to 40 000 km up, observers anywhere above the ground. Points 1/20000 of the way
 * apart miss the nearest by at most half of that, which in the square is far below the margin. */
static void test_against_points(void **state)
{
  (void)state;
  uint64_t key = 1;
  size_t cut = 0, judged = 0;
  for (int i = 0; i < LINES; i++) {
    double height = 3e5 + 4e7 * pow(um_core_hash_uniform(um_core_hash(key++, 1)), 3.0);
    struct um_vec3 r = um_vec3_scale(direction_of(&key), UM_EARTH_RADIUS + height);
    struct um_vec3 u = direction_of(&key);
    double range = 1e8 * um_core_hash_uniform(um_core_hash(key++, 1));
    struct um_vec3 end = um_vec3_axpy(r, range, u);
    double least = nearest_squared(r, u, range);
    if (um_vec3_norm(end) < UM_EARTH_RADIUS + 1e4) continue;
    if (fabs(sqrt(least) - UM_EARTH_RADIUS) < 1e3) continue;
    judged++;
    bool expected = least < UM_EARTH_RADIUS * UM_EARTH_RADIUS;
    cut += expected;
    assert_true(um_environment_earth_between(r, u, range, um_vec3(0, 0, 1)) == expected);
    /* seen from the other end it is the same */
    assert_true(um_environment_earth_between(end, um_vec3_scale(u, -1.0), range,
                                             um_vec3(0, 0, 1)) == expected);
  }
  assert_true(judged > 200 && cut > 20 && judged - cut > 20);
}

/* WGS-84: a = 6378137.0 m, b = 6356752.3142 m, whichever way the pole points. */
static void test_axes(void **state)
{
  (void)state;
  const struct um_vec3 pole[3] = {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}};
  for (int i = 0; i < 3; i++) {
    struct um_vec3 p = pole[i], x = um_vec3(p.z, p.x, p.y), far = um_vec3_scale(x, -2e7);
    for (int above = 0; above < 2; above++) {
      double b = 6356752.3142 + (above ? 1.0 : -1.0), a = 6378137.0 + (above ? 1.0 : -1.0);
      struct um_vec3 over_pole = um_vec3_axpy(far, b, p);
      assert_true(um_environment_earth_between(over_pole, x, 4e7, p) == !above);
      struct um_vec3 side = um_vec3_cross(p, x);
      struct um_vec3 over_equator = um_vec3_axpy(far, a, side);
      assert_true(um_environment_earth_between(over_equator, x, 4e7, p) == !above);
    }
  }
}

/* An observer on the ground, below the ellipsoid: what is above the horizon is seen. */
static void test_ends(void **state)
{
  (void)state;
  const struct um_vec3 z = {0, 0, 1};
  struct um_vec3 satellite = um_vec3(UM_EARTH_RADIUS + 4e5, 0, 0);
  assert_false(um_environment_earth_between(satellite, um_vec3(-1, 0, 0), 4e5 + 30.0, z));
  assert_true(um_environment_earth_between(satellite, um_vec3(-1, 0, 0), 4e5 + 1100.0, z));
  assert_true(um_environment_earth_between(satellite, um_vec3(-1, 0, 0), 2e6, z));
  assert_true(um_environment_earth_between(satellite, um_vec3(-1, 0, 0), 2e7, z));
  assert_false(um_environment_earth_between(satellite, um_vec3(1, 0, 0), 1e9, z));
  assert_false(um_environment_earth_between(satellite, um_vec3(0, 1, 0), 1e9, z));
  assert_false(um_environment_earth_between(satellite, um_vec3(NAN, 1, 0), 1e9, z));
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_against_points),
                                     cmocka_unit_test(test_axes), cmocka_unit_test(test_ends)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
