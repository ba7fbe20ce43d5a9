/* Geometry and heat that are kept serve the effects they were made for: other values, other targets
 * and other light are computed anew. From an isothermal start what is kept must not change a bit.
 */
#include "tests/evidence/sensitivity/forward_test.h"

/* Pairs that a careless key would take for each other. */
static const struct {
  const char *effect, *target[2];
  double value[2];
} pairs[] = {
    {"along_track", {NULL, NULL}, {3.0, -4.0}},
    {"area", {"panel", "bus"}, {1.2, 1.2}},
    {"heat_capacity", {"bus", "bus"}, {1.5, 0.7}},
};

static void values_and_targets_are_told_apart(void **state)
{
  (void)state;
  static const char *const isothermal[] = {"thermal.start=isothermal", "thermal.orbits_before=0.02",
                                           "optics.interreflection_samples=0"};
  const struct um_model_options options = {.overrides = isothermal, .noverride = 3};
  put_world("");
  struct um_compare_measurements *m = measured();
  struct um_sensitivity_forward *f = forward_of(&options, m);
  double value[2][48], expected[48], again[48];
  assert_int_equal(f->observations.count, 48);
  assert_int_equal(f->paths, f->paths_before); /* few paths are corrected, not the same */
  for (size_t k = 0; k < sizeof pairs / sizeof *pairs; k++) {
    for (size_t i = 0; i < 2; i++) {
      struct um_model_addition a =
          addition_of(pairs[k].effect, pairs[k].target[i], pairs[k].value[i]);
      assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, value[i]));
      assert_ok(fresh_values(&options, f, &a, 1, expected));
      if (memcmp(value[i], expected, sizeof expected) != 0)
        fail_msg("%s number %zu is that of something else", pairs[k].effect, i);
    }
    assert_memory_not_equal(value[0], value[1], sizeof value[0]);
    struct um_model_addition a =
        addition_of(pairs[k].effect, pairs[k].target[0], pairs[k].value[0]);
    assert_ok(um_sensitivity_forward_evaluate(context, f, &a, 1, again));
    assert_memory_equal(again, value[0], sizeof again);
  }
  um_sensitivity_forward_destroy(context, &f);
  um_compare_measurements_destroy(context, &m);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test_setup_teardown(
      values_and_targets_are_told_apart, model_set_up, model_tear_down)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
