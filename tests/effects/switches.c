/* Core switches that keys of the scenario hold off are turned on by name, and what comes out is
 * what the scenario gives that had them on, to the bit. */
#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

/* Behind the pole at the equinox, half a penumbra above the limb of the ellipsoid (6357 km): the
 * sphere still shades it. */
#define EDGE  "orbit={fixed: {position_gcrs_km: [-2918, 0, 6362]}}"
#define ROUND "environment.shadow=sphere"
#define POINT "environment.disc=point"

static bool is_off(const struct case_run *run, const char *name)
{
  for (size_t i = 0; i < run->model->neffect; i++)
    if (strcmp(run->model->effect[i].effect->name, name) == 0) return run->model->effect[i].off;
  fail_msg("no use of %s", name);
  return false;
}

static void keys_hold_switches_off(void **state)
{
  (void)state;
  static const char *const set[] = {EDGE, ROUND, POINT, NULL};
  static const char *const edge[] = {EDGE, NULL};
  static const char *const without[] = {"oblateness", "penumbra", NULL};
  struct case_run plain = case_compute(case_spinner, NULL, NULL, edge);
  struct case_run keys = case_compute(case_spinner, NULL, NULL, set);
  struct case_run off = case_compute(case_spinner, NULL, without, edge);
  assert_true(!is_off(&plain, "oblateness") && !is_off(&plain, "penumbra"));
  assert_true(is_off(&keys, "oblateness") && is_off(&keys, "penumbra"));
  assert_true(is_off(&off, "oblateness") && is_off(&off, "penumbra"));
  assert_true(case_same(&keys, &off));
  assert_true(keys.tables->sunlit[0] == 0.0);
  assert_true(plain.tables->sunlit[0] > 0.05 && plain.tables->sunlit[0] < 0.95);
  case_release(&plain);
  case_release(&keys);
  case_release(&off);
}

static void named_switches_turn_on(void **state)
{
  (void)state;
  static const char *const set[] = {EDGE, ROUND, POINT, NULL};
  static const char *const edge[] = {EDGE, NULL};
  static const char *const with[] = {"oblateness", "penumbra", NULL};
  struct case_run plain = case_compute(case_spinner, NULL, NULL, edge);
  struct case_run named = case_compute(case_spinner, with, NULL, set);
  struct case_run again = case_compute(case_spinner, with, NULL, edge);
  assert_true(!is_off(&named, "oblateness") && !is_off(&named, "penumbra"));
  assert_true(case_same(&named, &plain));
  assert_true(case_same(&again, &plain));
  case_release(&plain);
  case_release(&named);
  case_release(&again);
}

/* A disc without limb darkening is the uniform one. */
static void penumbra_has_two_discs(void **state)
{
  (void)state;
  static const char *const set[] = {EDGE, POINT, NULL};
  static const char *const uniform[] = {EDGE, "environment.disc=uniform", NULL};
  static const char *const with[] = {"penumbra,limb_darkening=0", NULL};
  static const char *const dark[] = {"penumbra", NULL};
  struct case_run stated = case_compute(case_spinner, NULL, NULL, uniform);
  struct case_run named = case_compute(case_spinner, with, NULL, set);
  struct case_run darkened = case_compute(case_spinner, dark, NULL, set);
  assert_true(case_same(&named, &stated));
  assert_false(case_same(&darkened, &stated));
  case_release(&stated);
  case_release(&named);
  case_release(&darkened);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(keys_hold_switches_off),
      cmocka_unit_test(named_switches_turn_on),
      cmocka_unit_test(penumbra_has_two_discs),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
