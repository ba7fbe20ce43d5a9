/* Light between patches in all orders, by factors and by iteration: what comes out is what it is
 * defined by, H = S (x + r A^-1 H), whatever stands beside it. */
#include "tests/thermal/network_help.h"
#include "thermal/exchange/reflections_impl.h"

#define MOST     400
#define TOGETHER UM_THERMAL_TOGETHER

static double value_of(size_t i) { return (double)(i * 7919 % 1009) / 1009.0; }

/* Patches of 1 m2, each of which sees one in `step` of the others, which take `seen` to twice that
 * of its view. */
struct body {
  struct um_geometry_view_factors factors;
  size_t begin[MOST + 1];
  uint32_t other[MOST * MOST];
  double entry[MOST * MOST], area[MOST], reflectance[MOST];
};

static void body_make(struct body *b, size_t n, size_t step, double seen, double reflectance)
{
  size_t at = 0;
  for (size_t p = 0; p < n; p++) {
    for (size_t q = 0; q < n; q++) {
      size_t low = p < q ? p : q, high = p < q ? q : p;
      if ((low + high) % step != 0) continue;
      b->other[at] = (uint32_t)q;
      b->entry[at++] = seen * (double)step / (double)n * (1.0 + value_of(low * n + high));
    }
    b->begin[p + 1] = at;
    b->area[p] = 1.0;
    b->reflectance[p] = reflectance * (0.5 + 0.5 * value_of(p + 3));
  }
  b->factors = (struct um_geometry_view_factors){
      .npatch = n, .begin = b->begin, .other = b->other, .area = b->entry};
}

/* Largest error of the definition, of the largest H. */
static double error_of(const struct body *b, const double *x, const double *h)
{
  double worst = 0.0, most = 0.0;
  for (size_t p = 0; p < b->factors.npatch; p++)
    for (size_t k = 0; k < TOGETHER; k++) {
      double sum = 0.0;
      for (size_t e = b->begin[p]; e < b->begin[p + 1]; e++) {
        size_t q = b->other[e], at = q * TOGETHER + k;
        sum += b->entry[e] * (x[at] + b->reflectance[q] / b->area[q] * h[at]);
      }
      worst = fmax(worst, fabs(sum - h[p * TOGETHER + k]));
      most = fmax(most, fabs(sum));
    }
  return worst / most;
}

static void apply(const struct body *b, const double *x, double *h)
{
  struct um_thermal_reflections *r = NULL;
  OK(um_thermal_reflections_create(help_context, &b->factors, b->area, b->reflectance, &r));
  double *scratch = NULL;
  OK(um_core_allocate(help_context, um_thermal_reflections_scratch(r), sizeof *scratch, &scratch));
  assert_true(um_thermal_reflections_apply(r, x, scratch, h));
  um_core_free(help_context, scratch);
  um_thermal_reflections_destroy(help_context, &r);
}

/* Where a patch sees a third of the others, or hardly absorbs, it goes by factors, to rounding;
 * else by iteration, which leaves 1e-11 of the right-hand side, 1e-9 where nearly all comes back.
 */
static void test_definition(void **state)
{
  (void)state;
  static struct body b;
  static double x[MOST * TOGETHER], h[MOST * TOGETHER], alone[MOST * TOGETHER];
  static const size_t count[] = {41, 100, MOST, MOST, MOST, MOST};
  static const size_t step[] = {3, 3, 100, 100, 200, 200};
  static const double reflectance[] = {0.9, 0.3, 0.0, 0.3, 0.97, 1.0};
  for (size_t c = 0; c < sizeof count / sizeof count[0]; c++) {
    body_make(&b, count[c], step[c], 0.6, reflectance[c]);
    for (size_t i = 0; i < count[c] * TOGETHER; i++)
      x[i] = i % TOGETHER == 3 ? 0.0 : value_of(5 * i + c); /* one column sends nothing */
    apply(&b, x, h);
    double error = error_of(&b, x, h);
    print_message("%zu patches that reflect %g: %.2g\n", count[c], reflectance[c], error);
    if (step[c] == 3) assert_true(error <= 1e-14);
    assert_true(error <= 1e-9);
    for (size_t i = 0; i < count[c] * TOGETHER; i++) {
      if (i % TOGETHER == 3) assert_true(h[i] == 0.0);
      if (i % TOGETHER != 5) x[i] = 0.0;
    }
    apply(&b, x, alone); /* a column has its bits alone, too */
    for (size_t p = 0; p < count[c]; p++)
      assert_true(alone[p * TOGETHER + 5] == h[p * TOGETHER + 5]);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_definition)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
