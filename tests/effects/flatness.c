/* panel_flatness and the key `flatness`: they tilt what no blanket covers, as creases of the same
 * size would, add to one another, and are refused where all is sheet. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

#define KEY(word, tilt, patch) "parts.plate." word "={tilt_rms_deg: " tilt ", patch_m: " patch "}"

static void release(struct case_run *run, size_t n)
{
  for (size_t i = 0; i < n; i++) case_release(&run[i]);
}
#define RELEASE(runs) release(runs, sizeof(runs) / sizeof(runs)[0])

/* One optics serves both words: the same bits. Squares of tilts add: 3 deg and 7 deg^2 are 4 deg,
 * to 1e-9, as the root of 16 is rounded; 3 and -9 none. Temperatures of a part that is no mirror
 * stay. */
static void panels_tilt_as_sheet_does(void **state)
{
  (void)state;
  static const char *const creased[] = {KEY("creases", "4", "0.1"), NULL},
                           *const stated[] = {KEY("flatness", "4", "0.1"), NULL},
                           *const three[] = {KEY("flatness", "3", "0.1"), NULL},
                           *const more[] = {"panel_flatness:plate,tilt_square_deg2=7", NULL},
                           *const none[] = {"panel_flatness:plate,tilt_square_deg2=-9", NULL},
                           *const alone[] = {"panel_flatness:plate,tilt_square_deg2=16", NULL};
  struct case_run run[] = {
      case_compute(case_plate, NULL, NULL, NULL),   case_compute(case_plate, NULL, NULL, creased),
      case_compute(case_plate, NULL, NULL, stated), case_compute(case_plate, more, NULL, three),
      case_compute(case_plate, none, NULL, three),  case_compute(case_plate, alone, NULL, NULL)};
  double light[6];
  for (size_t i = 0; i < 6; i++)
    light[i] = case_intensity(&run[i], 1, "vis", "grey_panel", UM_MECHANISM_SUN);
  assert_true(fabs(light[2] / light[0] - 1.0) > 1e-3);
  assert_true(case_same(&run[1], &run[2]));
  assert_true(case_same_temperatures(&run[2], &run[0]));
  case_near("3 deg and 7 deg^2", light[3], light[2], 1e-9);
  assert_true(case_same(&run[4], &run[0]));
  /* patches too small to tell apart: not the same light as patches of 0.1 m */
  assert_true(fabs(light[5] / light[0] - 1.0) > 1e-3);
  assert_true(light[5] != light[2]);
  RELEASE(run);
}

/* The satellite with what its box has beside the material. */
static const char *with_box(const char *more)
{
  static const char mark[] = "outside: mli_kapton, ";
  static char text[4096];
  const char *at = strstr(case_satellite, mark);
  assert_non_null(at);
  at += strlen(mark);
  snprintf(text, sizeof text, "%.*s%s%s", (int)(at - case_satellite), case_satellite, more, at);
  return text;
}

/* Patches too small to tell apart are a rougher surface: Beckmann's alpha^2 + 2 tan^2(tilt), to the
 * rounding of the factor. grey_panel has alpha 0.265. */
static void small_patches_are_roughness(void **state)
{
  (void)state;
  char rough[80];
  double slope = tan(3.0 * UM_DEG) / 0.265;
  snprintf(rough, sizeof rough, "roughness:grey_panel,factor=%.17g",
           sqrt(1.0 + 2.0 * slope * slope));
  struct case_run run[] = {case_with(case_plate, "panel_flatness:plate,tilt_square_deg2=9"),
                           case_with(case_plate, rough)};
  case_near("sunlight", case_intensity(&run[0], 1, "vis", "grey_panel", UM_MECHANISM_SUN),
            case_intensity(&run[1], 1, "vis", "grey_panel", UM_MECHANISM_SUN), 1e-9);
  RELEASE(run);
}

/* What the box mirrors of Sun and Earth, in both bands, summed over the run [W/sr]. */
static double mirrored(const struct case_run *run)
{
  static const char *const bands[] = {"vis", "lwir"};
  double sum = 0.0;
  for (size_t k = 0; k < run->result->nobs; k++)
    for (size_t b = 0; b < 2; b++)
      sum += case_intensity(run, k, bands[b], "mli_kapton", UM_MECHANISM_SUN) +
             case_intensity(run, k, bands[b], "mli_kapton", UM_MECHANISM_EARTH);
  return sum;
}

/* Of a box with one side of sheet: what is said of its panels leaves that side alone, and what is
 * said of its sheet the others. By default 0.3 deg of panels and 3 deg of sheet, but for the
 * rounding of squares. */
static void sheet_and_panels_of_one_part(void **state)
{
  (void)state;
#define SIDE "groups: {+x: {creases: {tilt_rms_deg: 0}}}, "
  static const char *const sides[] = {"panel_flatness:box.-x", "panel_flatness:box.+y",
                                      "panel_flatness:box.-y", "panel_flatness:box.+z",
                                      "panel_flatness:box.-z"};
  const char *with[6] = {0};
  for (size_t i = 0; i < 5; i++) with[i] = sides[i];
  struct case_run run[] = {
      case_with(with_box(SIDE), NULL),
      case_with(with_box(SIDE), "panel_flatness:box"),
      case_compute(with_box(SIDE), with, NULL, NULL),
      case_with(with_box("flatness: {tilt_rms_deg: 0.3}, " SIDE), NULL),
      case_with(with_box("flatness: {tilt_rms_deg: 0.3}, " SIDE), "mli_creases:box"),
      case_with(with_box("flatness: {tilt_rms_deg: 0.3}, "
                         "groups: {+x: {creases: {tilt_rms_deg: 3}}}, "),
                NULL)};
  assert_true(case_same(&run[2], &run[1]));
  assert_true(fabs(mirrored(&run[1]) / mirrored(&run[0]) - 1.0) > 1e-5);
  case_near("0.09 deg^2", mirrored(&run[3]), mirrored(&run[1]), 1e-9);
  assert_true(fabs(mirrored(&run[4]) / mirrored(&run[3]) - 1.0) > 1e-5);
  case_near("9 deg^2", mirrored(&run[5]), mirrored(&run[4]), 1e-9);
  RELEASE(run);
  case_refused(with_box(SIDE), "panel_flatness:box.+x",
               "effect 'panel_flatness': the part 'box.+x' is MLI or creased; accepted: a part or "
               "group that is neither");
}

/* A group's own flatness comes before its part's. */
static void groups_before_parts(void **state)
{
  (void)state;
  static const char *const part[] = {KEY("flatness", "3", "0.1"), NULL},
                           *const group[] = {KEY("flatness", "1", "0.3"),
                                             KEY("groups.plate.flatness", "3", "0.1"), NULL};
  struct case_run run[] = {case_compute(case_plate, NULL, NULL, part),
                           case_compute(case_plate, NULL, NULL, group)};
  assert_true(case_same(&run[0], &run[1]));
  RELEASE(run);
}

static void refusals(void **state)
{
  (void)state;
  case_refused(with_box("creases: {tilt_rms_deg: 3}, "), "panel_flatness:box",
               "effect 'panel_flatness': the part 'box' is MLI or creased");
  case_refused(with_box("creases: {tilt_rms_deg: 3}, flatness: {tilt_rms_deg: 1}, "), NULL,
               "flatness: all of the part is MLI or creased; accepted: creases");
  case_refused(
      with_box("groups: {+x: {creases: {tilt_rms_deg: 3}, flatness: {tilt_rms_deg: 1}}}, "), NULL,
      "flatness: the group has MLI or creases; accepted: creases");
  case_refused(case_plate, "panel_flatness:plate,tilt_square_deg2=26", "26 is out of range");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(panels_tilt_as_sheet_does),
      cmocka_unit_test(small_patches_are_roughness),
      cmocka_unit_test(sheet_and_panels_of_one_part),
      cmocka_unit_test(groups_before_parts),
      cmocka_unit_test(refusals),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
