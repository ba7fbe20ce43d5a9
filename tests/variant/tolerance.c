/* Which tolerances errors that are asked get: what is stated of them keeps a quarter of what is
 * asked, unless nothing does, and who asks less gets no tighter ones. */
#include "variant/tolerance.h"

#include <math.h>

#include "tests/support/cmocka_all.h"

static struct um_variant_tolerance choose(double lwir, double vis, double temperature,
                                          struct um_variant_error *stated)
{
  const struct um_variant_error asked = {lwir, vis, temperature};
  return um_variant_tolerance_asked(&asked, stated);
}

static void test_asked(void **state)
{
  (void)state;
  struct um_variant_tolerance last = choose(INFINITY, INFINITY, INFINITY, NULL);
  assert_true(last.factor > 1.0);
  for (double part = 1.0; part > 1e-3; part *= 0.9) {
    struct um_variant_error stated, of_light;
    struct um_variant_tolerance t = choose(INFINITY, INFINITY, part, &stated);
    struct um_variant_tolerance l = choose(1e-2 * part, 1e-2 * part, INFINITY, &of_light);
    assert_true(t.factor <= last.factor && t.periodic <= last.periodic);
    assert_true(stated.temperature <= 0.25 * part || t.factor == 1.0);
    assert_true(of_light.lwir <= 0.25e-2 * part || l.factor == 1.0);
    last = t;
  }
  assert_true(last.factor == 1.0 && last.periodic == UM_VARIANT_TIGHT.periodic);
}

/* Passes of a forecast, points of a study before its own are measured, variants of the library. */
static void test_usual(void **state)
{
  (void)state;
  struct um_variant_tolerance usual = choose(1e-3, 1e-3, 0.1, NULL);
  assert_true(usual.factor == 1.0 && usual.periodic == 0.02);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_asked), cmocka_unit_test(test_usual)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
