/* mli_creases in a scenario: it adds to what is stated, leaves heat alone but for mirrors, and is
 * refused where nothing hangs. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

#define CREASED(tilt, patch) "parts.plate.creases={tilt_rms_deg: " tilt ", patch_m: " patch "}"

static double light(const struct case_run *run)
{
  return case_intensity(run, 1, "vis", "grey_panel", UM_MECHANISM_SUN);
}

/* Squares of tilts add: 3 deg and 7 deg^2 are 4 deg, 3 and -9 none; with the same patches. 1e-9:
 * the square root of 16 is rounded. The plate's cells are as rough as alpha 0.265, so that patches
 * of 0.1 m change its light by some per cent. */
static void it_adds_to_what_is_stated(void **state)
{
  (void)state;
  static const char *const three[] = {CREASED("3", "0.1"), NULL},
                           *const four[] = {CREASED("4", "0.1"), NULL},
                           *const more[] = {"mli_creases:plate,tilt_square_deg2=7", NULL},
                           *const none[] = {"mli_creases:plate,tilt_square_deg2=-9", NULL},
                           *const group[] = {"mli_creases:plate.plate,tilt_square_deg2=7", NULL};
  struct case_run flat = case_compute(case_plate, NULL, NULL, NULL),
                  a = case_compute(case_plate, NULL, NULL, four),
                  b = case_compute(case_plate, more, NULL, three),
                  c = case_compute(case_plate, none, NULL, three),
                  d = case_compute(case_plate, group, NULL, three);
  assert_true(fabs(light(&a) / light(&flat) - 1.0) > 1e-3);
  case_near("3 deg and 7 deg^2", light(&b), light(&a), 1e-9);
  assert_true(case_same(&c, &flat));
  assert_true(case_same(&d, &b));
  assert_true(case_same_temperatures(&a, &flat));
  struct case_run *const all[] = {&flat, &a, &b, &c, &d};
  for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) case_release(all[i]);
}

/* patch_m 0 leaves the scenario's patches, another is taken in their place; another seed gives
 * other patches. */
static void patches_and_seeds(void **state)
{
  (void)state;
  static const char *const stated[] = {CREASED("3", "0.1"), NULL},
                           *const other[] = {CREASED("3", "0.05"), NULL},
                           *const third[] = {CREASED("3", "0.1, seed: 2"), NULL},
                           *const small[] = {CREASED("4", "0.05"), NULL},
                           *const with[] = {"mli_creases:plate,tilt_square_deg2=7,patch_m=0.05",
                                            NULL};
  struct case_run a = case_compute(case_plate, NULL, NULL, stated),
                  b = case_compute(case_plate, NULL, NULL, other),
                  c = case_compute(case_plate, NULL, NULL, third),
                  d = case_compute(case_plate, NULL, NULL, small),
                  e = case_compute(case_plate, with, NULL, stated);
  assert_true(light(&a) != light(&b) && light(&a) != light(&c));
  case_near("patch_m", light(&e), light(&d), 1e-9);
  struct case_run *const all[] = {&a, &b, &c, &d, &e};
  for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) case_release(all[i]);
}

/* A creased part is no mirror: temperatures are those without specular_exchange once alpha^2 + 2
 * s^2 is above 0.1^2 (mli_kapton, alpha 0.0296: 4 deg), and those of the flat part below. Sums over
 * mirror paths of share 0 leave rounding. */
static void creased_parts_do_not_mirror(void **state)
{
  (void)state;
  static const char *const without[] = {"specular_exchange", NULL},
                           *const little[] = {"parts.box.creases={tilt_rms_deg: 2}", NULL},
                           *const much[] = {"parts.box.creases={tilt_rms_deg: 4}", NULL};
  struct case_run flat = case_compute(case_satellite, NULL, NULL, NULL),
                  rough = case_compute(case_satellite, NULL, without, NULL),
                  a = case_compute(case_satellite, NULL, NULL, little),
                  b = case_compute(case_satellite, NULL, NULL, much);
  assert_false(case_same_temperatures(&flat, &rough));
  assert_true(case_same_temperatures(&a, &flat));
  size_t n = b.result->nsurface, count = 0;
  for (size_t i = 0; i < n * b.result->nobs; i++) {
    double x = b.result->surface_temperature[i], y = rough.result->surface_temperature[i];
    if (!(fabs(x - y) <= 1e-6))
      fail_msg("surface %zu: %.9g K, %.9g K without mirrors", i % n, x, y);
    count += fabs(flat.result->surface_temperature[i] - y) > 1e-4;
  }
  assert_true(count > 0);
  struct case_run *const all[] = {&flat, &rough, &a, &b};
  for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) case_release(all[i]);
}

/* With one side of the box alone that is said to hang. */
static void one_side_hangs(void **state)
{
  (void)state;
  static const char mark[] = "outside: mli_kapton, ";
  char text[4096];
  const char *at = strstr(case_satellite, mark);
  assert_non_null(at);
  at += strlen(mark);
  snprintf(text, sizeof text, "%.*sgroups: {+x: {creases: {tilt_rms_deg: 0}}}, %s",
           (int)(at - case_satellite), case_satellite, at);
  case_refused(text, "mli_creases:box.-x", "effect 'mli_creases': the part 'box.-x' has no MLI");
  struct case_run flat = case_with(text, NULL), part = case_with(text, "mli_creases:box"),
                  side = case_with(text, "mli_creases:box.+x");
  assert_true(case_same(&part, &side));
  assert_false(case_same_intensities(&part, &flat));
  case_release(&flat);
  case_release(&part);
  case_release(&side);
}

static void refusals(void **state)
{
  (void)state;
  case_refused(case_plate, "mli_creases:plate,tilt_square_deg2=4",
               "effect 'mli_creases': the part 'plate' has no MLI; accepted: a part with MLI, or "
               "one that states creases");
  case_refused(case_plate, "mli_creases:plate,tilt_square_deg2=1000", "1000 is out of range");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(it_adds_to_what_is_stated),
      cmocka_unit_test(patches_and_seeds),
      cmocka_unit_test(creased_parts_do_not_mirror),
      cmocka_unit_test(one_side_hangs),
      cmocka_unit_test(refusals),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
