/* Sampling. Statistical bounds: 5 standard errors, i.e. a false alarm once in 1.7e6 comparisons;
 * the sequences are fixed, so a test that passes passes always. The R2 sequence itself must beat
 * random points by its order: its integration error falls nearly as 1/N. */
#include "base/core/sampling.h"

#include "base/core/constants.h"
#include "tests/support/cmocka_all.h"

#define N 20000

/* Steps of the sequence modulo 1 are 1/g and 1/g^2 with g^3 = g + 1 (Roberts 2018); rounding of
 * the 64-bit steps and of the 53-bit outputs is below 3e-16. */
static void test_r2_steps(void **state)
{
  (void)state;
  double g = 1.3;
  for (int i = 0; i < 50; i++) g = cbrt(g + 1.0);
  assert_close(g * g * g - g - 1.0, 0.0, 4e-15);
  double p[2], q[2];
  for (uint64_t i = 0; i < 1000; i++) {
    um_core_sample_2d(42, i, p);
    um_core_sample_2d(42, i + 1, q);
    double dx = q[0] - p[0], dy = q[1] - p[1];
    assert_close(dx - floor(dx), 1.0 / g, 3e-16);
    assert_close(dy - floor(dy), 1.0 / (g * g), 3e-16);
  }
}

/* Root mean square over 20 keys of the error of the mean of x y, which is 1/4. */
static double r2_error(uint64_t n)
{
  double square = 0.0;
  for (uint64_t key = 0; key < 20; key++) {
    double sum = 0.0;
    for (uint64_t i = 0; i < n; i++) {
      double u[2];
      um_core_sample_2d(key, i, u);
      assert_true(u[0] >= 0.0 && u[0] < 1.0 && u[1] >= 0.0 && u[1] < 1.0);
      sum += u[0] * u[1];
    }
    double error = sum / (double)n - 0.25;
    square += error * error / 20.0;
  }
  return sqrt(square);
}

/* Random points err by sqrt(1/9 - 1/16)/sqrt(n), order 1/2. The sequence must be of an order above
 * 0.8 over a factor of 64 in n, and eight times better than random points at 4000. */
static void test_r2_integrates(void **state)
{
  (void)state;
  double few = r2_error(250), middle = r2_error(4000), many = r2_error(16000);
  double order = log(few / many) / log(64.0);
  if (!(order >= 0.8)) fail_msg("order %g", order);
  if (!(middle <= sqrt((1.0 / 9.0 - 1.0 / 16.0) / 4000.0) / 8.0)) fail_msg("error %g", middle);
}

/* Points belong to their index: order and number of calls do not matter; keys differ. */
static void test_indexed(void **state)
{
  (void)state;
  double a[2], b[2], c[2];
  um_core_sample_2d(7, 123456789, a);
  um_core_sample_2d(7, 0, b);
  um_core_sample_2d(7, 123456789, b);
  um_core_sample_2d(8, 123456789, c);
  assert_true(a[0] == b[0] && a[1] == b[1]);
  assert_true(a[0] != c[0] && a[1] != c[1]);
}

/* Flipping any input bit flips each output bit with probability 1/2: with 1000 independent pairs a
 * share of flips lies within 5 standard errors, 5 x 0.5/sqrt(1000). */
static void test_hash_avalanche(void **state)
{
  (void)state;
  for (int bit = 0; bit < 64; bit++) {
    int flips[64] = {0}, other_flips[64] = {0};
    for (uint64_t i = 0; i < 1000; i++) {
      /* spread inputs: neighbours i and i + 1 would be each other's flipped partner */
      uint64_t a = i * UINT64_C(0x9e3779b97f4a7c15), b = a ^ (UINT64_C(1) << bit);
      uint64_t difference = um_core_hash(a, 5) ^ um_core_hash(b, 5);
      uint64_t other = um_core_hash(5, a) ^ um_core_hash(5, b);
      assert_true(difference != 0 && other != 0);
      for (int k = 0; k < 64; k++) {
        flips[k] += (int)((difference >> k) & 1);
        other_flips[k] += (int)((other >> k) & 1);
      }
    }
    for (int k = 0; k < 64; k++) {
      assert_close(flips[k] / 1000.0, 0.5, 5.0 * 0.5 / sqrt(1000.0));
      assert_close(other_flips[k] / 1000.0, 0.5, 5.0 * 0.5 / sqrt(1000.0));
    }
  }
}

static void test_uniform(void **state)
{
  (void)state;
  assert_true(um_core_hash_uniform(0) == 0.0);
  assert_true(um_core_hash_uniform(UINT64_MAX) < 1.0);
  double sum = 0.0;
  for (uint64_t i = 0; i < N; i++) sum += um_core_hash_uniform(um_core_hash(i, 1));
  /* standard deviation of a uniform variate is 1/sqrt(12) */
  assert_close(sum / N, 0.5, 5.0 / sqrt(12.0 * N));
}

/* Uniform over a triangle: each weight has mean 1/3 and variance 1/18. */
static void test_triangle(void **state)
{
  (void)state;
  double mean[3] = {0.0}, square = 0.0;
  for (uint64_t i = 0; i < N; i++) {
    double u[2] = {um_core_hash_uniform(um_core_hash(i, 2)),
                   um_core_hash_uniform(um_core_hash(i, 3))};
    double w[3];
    um_core_sample_triangle(u, w);
    assert_close(w[0] + w[1] + w[2], 1.0, 4e-16);
    for (int k = 0; k < 3; k++) {
      assert_true(w[k] >= 0.0);
      mean[k] += w[k] / N;
    }
    square += w[0] * w[0] / N;
  }
  for (int k = 0; k < 3; k++) assert_close(mean[k], 1.0 / 3.0, 5.0 * sqrt(1.0 / 18.0 / N));
  /* E w^2 = 1/6, var w^2 = 1/15 - 1/36 */
  assert_close(square, 1.0 / 6.0, 5.0 * sqrt((1.0 / 15.0 - 1.0 / 36.0) / N));
}

/* Uniform on the unit disc: E r^2 = 1/2 (variance 1/12), E x = 0 (variance 1/4), E x^4 = 1/8 (bound
 * by variance below 1/8), and quarters hold equal shares. */
static void test_disc(void **state)
{
  (void)state;
  double r2 = 0.0, x = 0.0, x4 = 0.0, quarter = 0.0;
  for (uint64_t i = 0; i < N; i++) {
    double u[2] = {um_core_hash_uniform(um_core_hash(i, 4)),
                   um_core_hash_uniform(um_core_hash(i, 5))};
    double p[2];
    um_core_sample_disc(u, p);
    double s = p[0] * p[0] + p[1] * p[1];
    assert_true(s <= 1.0 + 1e-15);
    r2 += s / N;
    x += p[0] / N;
    x4 += p[0] * p[0] * p[0] * p[0] / N;
    if (p[0] > 0.0 && p[1] > 0.0) quarter += 1.0 / N;
  }
  assert_close(r2, 0.5, 5.0 * sqrt(1.0 / 12.0 / N));
  assert_close(x, 0.0, 5.0 * sqrt(0.25 / N));
  assert_close(x4, 0.125, 5.0 * sqrt(0.125 / N));
  assert_close(quarter, 0.25, 5.0 * sqrt(0.25 * 0.75 / N));
  double centre[2] = {0.5, 0.5}, p[2];
  um_core_sample_disc(centre, p);
  assert_true(p[0] == 0.0 && p[1] == 0.0);
}

/* Density cos/pi: E cos = 2/3 (variance 1/2 - 4/9), E cos^2 = 1/2 (variance 1/12); unit length and
 * above the surface, about any normal. */
static void test_cosine(void **state)
{
  (void)state;
  static const struct um_vec3 normals[] = {{0, 0, 1}, {0, 0, -1}, {0.6, 0, 0.8}, {0, 1, 0}};
  for (size_t k = 0; k < 4; k++) {
    double c1 = 0.0, c2 = 0.0;
    for (uint64_t i = 0; i < N; i++) {
      double u[2] = {um_core_hash_uniform(um_core_hash(i, 6 + k)),
                     um_core_hash_uniform(um_core_hash(i, 60 + k))};
      struct um_vec3 d = um_core_sample_cosine(u, normals[k]);
      double c = um_vec3_dot(d, normals[k]);
      assert_close(um_vec3_norm(d), 1.0, 4e-15);
      assert_true(c >= -1e-15);
      c1 += c / N;
      c2 += c * c / N;
    }
    assert_close(c1, 2.0 / 3.0, 5.0 * sqrt((0.5 - 4.0 / 9.0) / N));
    assert_close(c2, 0.5, 5.0 * sqrt(1.0 / 12.0 / N));
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_r2_steps), cmocka_unit_test(test_r2_integrates),
      cmocka_unit_test(test_indexed),  cmocka_unit_test(test_hash_avalanche),
      cmocka_unit_test(test_uniform),  cmocka_unit_test(test_triangle),
      cmocka_unit_test(test_disc),     cmocka_unit_test(test_cosine),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
