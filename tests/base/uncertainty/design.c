/* Designs of points: counts, shares, balance, what each is made for. */
#include "base/uncertainty/design.h"

#include <string.h>

#include "tests/support/allocator.h"
#include "tests/support/cmocka_all.h"
#include "tests/support/with_context.h"

static void test_grid(void **state)
{
  (void)state;
  struct um_context *c = context;
  double *u;
  size_t n, count[3] = {2, 1, 3};
  bool ends[3] = {true, true, false};
  assert_int_equal(um_uncertainty_grid(c, 3, count, ends, &u, &n), UM_OK);
  assert_int_equal(n, 6);
  for (size_t i = 0; i < 6; i++) {
    assert_close(u[3 * i], i < 3 ? 0.0 : 1.0, 0.0);
    assert_close(u[3 * i + 1], 0.5, 0.0);
    assert_close(u[3 * i + 2], (double)(2 * (i % 3) + 1) / 6.0, 1e-16);
  }
  um_core_free(c, u);
  size_t many[3] = {100000, 100000, 1};
  assert_int_equal(um_uncertainty_grid(c, 3, many, ends, &u, &n), UM_ERR_INPUT);
  assert_null(u);
  um_core_message_clear(c);
  size_t none[1] = {0};
  assert_int_equal(um_uncertainty_grid(c, 1, none, ends, &u, &n), UM_ERR_INPUT);
  um_core_message_clear(c);
  assert_int_equal(um_uncertainty_paired(c, 2, 4, &u), UM_OK);
  for (size_t i = 0; i < 8; i++) assert_close(u[i], (double)(i / 2) / 4.0 + 0.125, 0.0);
  um_core_free(c, u);
}

/* Every share of every axis holds one point; other seeds give other points; the same the same. */
static void test_latin_hypercube(void **state)
{
  (void)state;
  struct um_context *c = context;
  double *u, *v, *w;
  enum { N = 200, D = 4 };
  size_t differ = 0, trend = 0;
  assert_int_equal(um_uncertainty_latin_hypercube(c, D, N, 1, &u), UM_OK);
  assert_int_equal(um_uncertainty_latin_hypercube(c, D, N, 1, &v), UM_OK);
  assert_int_equal(um_uncertainty_latin_hypercube(c, D, N, 2, &w), UM_OK);
  for (size_t k = 0; k < D; k++) {
    size_t seen[N] = {0};
    for (size_t i = 0; i < N; i++) {
      assert_true(u[i * D + k] >= 0.0 && u[i * D + k] < 1.0);
      seen[(size_t)(u[i * D + k] * N)]++;
      trend += (size_t)(u[i * D + k] * N) == i;
      assert_close(u[i * D + k], v[i * D + k], 0.0);
      differ += u[i * D + k] != w[i * D + k];
    }
    for (size_t i = 0; i < N; i++) assert_int_equal(seen[i], 1);
  }
  assert_int_equal(differ, N * D);
  assert_true(trend < 20); /* shuffled: one an axis is expected to stay */
  um_core_free(c, u);
  um_core_free(c, v);
  um_core_free(c, w);
}

/* 2^m points of a Sobol' sequence: one in each of 2^m shares of every axis, shifted too, and of the
 * first two axes one in each of 4 x 4 squares for 16 points. */
static void test_sobol_sequence(void **state)
{
  (void)state;
  struct um_context *c = context;
  double *u;
  for (uint64_t seed = 0; seed < 3; seed++) {
    assert_int_equal(um_uncertainty_sobol_sequence(c, 5, 64, seed, &u), UM_OK);
    for (size_t k = 0; k < 5; k++) {
      size_t seen[64] = {0};
      double first = u[k];
      for (size_t i = 0; i < 64; i++) {
        double x = u[i * 5 + k] - first; /* back to the lattice */
        x -= floor(x);
        seen[(size_t)lround(x * 64.0) % 64]++;
      }
      for (size_t i = 0; i < 64; i++) assert_int_equal(seen[i], 1);
    }
    if (seed == 0) {
      size_t square[16] = {0};
      for (size_t i = 0; i < 16; i++)
        square[(size_t)(u[i * 5] * 4.0) * 4 + (size_t)(u[i * 5 + 1] * 4.0)]++;
      for (size_t i = 0; i < 16; i++) assert_int_equal(square[i], 1);
      assert_close(u[0], 0.0, 0.0);
      assert_close(u[5], 0.5, 0.0);
    } else {
      assert_true(u[0] > 0.0 && u[0] != u[1]);
    }
    um_core_free(c, u);
  }
}

static void test_one_at_a_time(void **state)
{
  (void)state;
  struct um_context *c = context;
  double *u, centre[2] = {0.5, 0.25};
  size_t n;
  assert_int_equal(um_uncertainty_one_at_a_time(c, 2, 3, centre, &u, &n), UM_OK);
  /* of the first axis 0 and 1, its middle being the centre; of the second 0, 1/2, 1 */
  const double expected[6][2] = {{0.5, 0.25}, {0, 0.25}, {1, 0.25}, {0.5, 0}, {0.5, 0.5}, {0.5, 1}};
  assert_int_equal(n, 6);
  for (size_t i = 0; i < 12; i++) assert_close(u[i], expected[i / 2][i % 2], 0.0);
  um_core_free(c, u);
  centre[1] = 1.5;
  assert_int_equal(um_uncertainty_one_at_a_time(c, 2, 3, centre, &u, &n), UM_ERR_INPUT);
  um_core_message_clear(c);
}

/* A_B^i differs from A in axis i alone, where it is B's. */
static void test_saltelli(void **state)
{
  (void)state;
  struct um_context *c = context;
  double *u;
  enum { D = 3, N = 32 };
  assert_int_equal(um_uncertainty_saltelli(c, D, N, 0, &u), UM_OK);
  for (size_t j = 0; j < N; j++) {
    const double *a = u + j * (D + 2) * D, *b = a + D;
    for (size_t i = 0; i < D; i++) {
      assert_true(a[i] != b[i]);
      for (size_t k = 0; k < D; k++) assert_close(b[(1 + i) * D + k], k == i ? b[k] : a[k], 0.0);
    }
  }
  um_core_free(c, u);
}

/* Each step moves one axis by levels / (2 (levels - 1)), each axis once, all inside. */
static void test_morris(void **state)
{
  (void)state;
  struct um_context *c = context;
  double *u;
  enum { D = 5, N = 40 };
  size_t first[D] = {0}, up = 0;
  assert_int_equal(um_uncertainty_morris_trajectories(c, D, N, 4, 7, &u), UM_OK);
  for (size_t t = 0; t < N; t++) {
    size_t moved[D] = {0};
    const double *row = u + t * (D + 1) * D;
    for (size_t s = 0; s < D; s++, row += D)
      for (size_t k = 0; k < D; k++) {
        double step = row[D + k] - row[k];
        assert_true(row[D + k] >= 0.0 && row[D + k] <= 1.0);
        if (step == 0.0) continue;
        assert_close(fabs(step), 2.0 / 3.0, 1e-15);
        moved[k]++;
        up += step > 0.0;
        first[k] += s == 0;
      }
    for (size_t k = 0; k < D; k++) assert_int_equal(moved[k], 1);
  }
  for (size_t k = 0; k < D; k++) assert_true(first[k] >= 1); /* 8 are expected, none: 1e-4 */
  assert_true(up > 60 && up < 140);                          /* 100 of 200, 5 sigma: 35 */
  um_core_free(c, u);
  assert_int_equal(um_uncertainty_morris_trajectories(c, D, N, 3, 7, &u), UM_ERR_INPUT);
  um_core_message_clear(c);
}

static void test_limits(void **state)
{
  (void)state;
  struct um_context *c = context;
  double *u;
  assert_int_equal(um_uncertainty_sobol_sequence(c, 0, 10, 0, &u), UM_ERR_INPUT);
  um_core_message_clear(c);
  assert_int_equal(um_uncertainty_sobol_sequence(c, 21, 10, 0, &u), UM_ERR_INPUT);
  um_core_message_clear(c);
  assert_int_equal(um_uncertainty_latin_hypercube(c, 3, 1000000000, 1, &u), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(c), "1000000000 points"));
  um_core_message_clear(c);
  assert_int_equal(um_uncertainty_saltelli(c, 3, SIZE_MAX / 4, 1, &u), UM_ERR_INPUT);
  um_core_message_clear(c);
  assert_int_equal(um_uncertainty_halton(c, 2, 2, 2, &u), UM_OK);
  const double halton[4] = {0.25, 2.0 / 3.0, 0.75, 1.0 / 9.0}; /* radical inverses of 2 and 3 */
  for (size_t i = 0; i < 4; i++) assert_close(u[i], halton[i], 1e-15);
  um_core_free(c, u);
}

static void test_memory(void **state)
{
  (void)state;
  struct um_test_memory memory = {0};
  struct um_core_allocator allocator = um_test_memory_allocator(&memory);
  for (long fail = 1; fail < 10; fail++) {
    struct um_context *c = NULL;
    double *u = NULL;
    memory = (struct um_test_memory){0};
    assert_int_equal(um_core_context_create(&allocator, &c), UM_OK);
    memory.calls = 0;
    memory.fail_call = fail;
    enum um_status status = um_uncertainty_saltelli(c, 2, 8, 1, &u);
    assert_true(status == UM_OK || status == UM_ERR_MEMORY);
    assert_true((status == UM_OK) == (u != NULL));
    memory.fail_call = 0;
    um_core_free(c, u);
    um_core_context_destroy(&c);
    assert_int_equal(memory.alive, 0);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_grid),           cmocka_unit_test(test_latin_hypercube),
      cmocka_unit_test(test_sobol_sequence), cmocka_unit_test(test_one_at_a_time),
      cmocka_unit_test(test_saltelli),       cmocka_unit_test(test_morris),
      cmocka_unit_test(test_limits),         cmocka_unit_test(test_memory)};
  return cmocka_run_group_tests(tests, context_set_up, context_tear_down);
}
