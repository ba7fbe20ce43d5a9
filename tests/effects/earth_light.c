/* Levels of what the Earth sends to the observer by way of the satellite: earthshine and reflected
 * Earth radiation. Both are light alone; no temperature may move. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

#define PANEL "grey_panel"

static double earth(const struct case_run *run, const char *band)
{
  return case_intensity(run, 1, band, PANEL, UM_MECHANISM_EARTH);
}

/* Of the two only earthshine counts in the visible: the Earth's own radiation there is 1e-30 of it.
 */
static void earthshine_level_scales_visible_earthlight(void **state)
{
  (void)state;
  struct case_run a = case_with(case_plate, NULL);
  struct case_run b = case_with(case_plate, "earthshine_level,factor=0.6");
  assert_true(earth(&a, "vis") > 0.0);
  case_near("vis", earth(&b, "vis"), 0.6 * earth(&a, "vis"), 1e-13);
  assert_true(earth(&b, "lwir") < earth(&a, "lwir")); /* a little sunlight at 8-12 um too */
  assert_true(case_same_temperatures(&a, &b));
  for (int m = 0; m < UM_MECHANISM_COUNT; m++)
    if (m != UM_MECHANISM_EARTH)
      assert_true(case_intensity(&a, 1, "vis", PANEL, m) == case_intensity(&b, 1, "vis", PANEL, m));
  case_release(&a);
  case_release(&b);
}

/* Without earthshine all earthlight at 8-12 um is the Earth's own. */
static void earth_reflection_level_scales_infrared_earthlight(void **state)
{
  (void)state;
  static const char *const with[] = {"earth_reflection_level,factor=1.5", NULL}, *const dark[] = {
                                                                                     "earthshine",
                                                                                     NULL};
  struct case_run a = case_compute(case_plate, NULL, dark, NULL);
  struct case_run b = case_compute(case_plate, with, dark, NULL);
  assert_true(earth(&a, "lwir") > 0.0);
  case_near("lwir", earth(&b, "lwir"), 1.5 * earth(&a, "lwir"), 1e-13);
  assert_true(case_same_temperatures(&a, &b));
  for (int m = 0; m < UM_MECHANISM_COUNT; m++)
    if (m != UM_MECHANISM_EARTH)
      assert_true(case_intensity(&a, 1, "lwir", PANEL, m) ==
                  case_intensity(&b, 1, "lwir", PANEL, m));
  case_release(&a);
  case_release(&b);
}

/* A level of zero is the switch turned off, between parts that mirror each other too; a level does
 * nothing to what is off. */
static void level_zero_is_off(void **state)
{
  (void)state;
  static const char *const zero[2][2] = {{"earthshine_level,factor=0", NULL},
                                         {"earth_reflection_level,factor=0", NULL}};
  static const char *const off[2][2] = {{"earthshine", NULL}, {"reflected_earth_ir", NULL}};
  static const char *const twice[2][2] = {{"earthshine_level,factor=2", NULL},
                                          {"earth_reflection_level,factor=2", NULL}};
  struct case_run plain = case_with(case_satellite, NULL);
  for (int i = 0; i < 2; i++) {
    struct case_run a = case_compute(case_satellite, zero[i], NULL, NULL);
    struct case_run b = case_compute(case_satellite, NULL, off[i], NULL);
    struct case_run c = case_compute(case_satellite, twice[i], off[i], NULL);
    assert_true(case_same(&a, &b));
    assert_true(case_same(&c, &b));
    assert_false(case_same(&plain, &a));
    case_release(&a);
    case_release(&b);
    case_release(&c);
  }
  case_release(&plain);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(earthshine_level_scales_visible_earthlight),
      cmocka_unit_test(earth_reflection_level_scales_infrared_earthlight),
      cmocka_unit_test(level_zero_is_off),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
