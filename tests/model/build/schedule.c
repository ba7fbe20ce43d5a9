/* A joint whose angle a file says: at every instant the plate shines as one that stands at the
 * angle of that instant, and the file is read as tables of a scenario are. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

#define CSV "model_schedule.csv"
#define SET "parts.wing.joint.schedule=" CSV

static double light(const struct case_run *run, size_t k)
{
  return case_intensity(run, k, "vis", "grey_panel", UM_MECHANISM_SUN);
}

/* Angles as of the file at an observation. */
static double angle_at(const struct case_run *run, size_t k)
{
  double angle;
  const struct um_environment_sample *s = &run->tables->sample[k];
  um_geometry_joint_angles(run->model->geometry, um_quat_apply(s->q, s->sun), s->t_tai, &angle);
  return angle / UM_DEG;
}

/* 5 deg of the scenario, and from the file 0 to 40 in the run; light needs no history. */
static void shines_as_it_stands(void **state)
{
  (void)state;
  static const char *const set[] = {SET, NULL};
  case_write(CSV, "time_utc,angle_deg\n2020-03-20T12:00:00Z,0\n2020-03-20T12:04:00Z,40\n");
  struct case_run moved = case_compute(case_spinner, NULL, NULL, set);
  size_t n = moved.tables->nobs, bright = 0;
  assert_true(n > 1 && angle_at(&moved, n - 1) > angle_at(&moved, 0) + 1.0);
  for (size_t k = 0; k < n; k++) {
    char text[64];
    snprintf(text, sizeof text, "parts.wing.joint.angle_deg=%.12g", angle_at(&moved, k));
    const char *const still[] = {text, NULL};
    struct case_run fixed = case_compute(case_spinner, NULL, NULL, still);
    double expected = light(&fixed, k);
    if (!(fabs(light(&moved, k) - expected) <= 1e-9 * fabs(expected)))
      fail_msg("observation %zu at %s: %.12g, standing so %.12g W/sr", k, text, light(&moved, k),
               expected);
    bright += expected > 0.0;
    case_release(&fixed);
  }
  assert_true(bright > 0);
  case_release(&moved);
}

/* A file that says one angle all the time is a fixed joint, heat and all. */
static void constant_file_is_an_angle(void **state)
{
  (void)state;
  static const char *const set[] = {SET, NULL}, *const still[] = {"parts.wing.joint.angle_deg=35",
                                                                  NULL};
  case_write(CSV, "time_utc,angle_deg\n2020-03-20T11:00:00Z,30\n2020-03-20T13:00:00Z,30\n");
  struct case_run a = case_compute(case_spinner, NULL, NULL, set),
                  b = case_compute(case_spinner, NULL, NULL, still);
  for (size_t i = 0; i < a.result->nobs * a.result->nsurface; i++)
    case_near("temperature", a.result->surface_temperature[i], b.result->surface_temperature[i],
              1e-5);
  for (size_t k = 0; k < a.result->nobs; k++) case_near("light", light(&a, k), light(&b, k), 1e-9);
  case_release(&a);
  case_release(&b);
}

static void refused(const char *csv, const char *more, const char *words)
{
  static char text[4096];
  const char *at = strstr(case_spinner, "angle_deg: 5");
  assert_non_null(at);
  case_write(CSV, csv);
  snprintf(text, sizeof text, "%.*s%s, schedule: " CSV "%s", (int)(at - case_spinner), case_spinner,
           more, at + strlen("angle_deg: 5"));
  case_refused(text, NULL, words);
}

static void what_is_refused(void **state)
{
  (void)state;
  const char *good = "time_utc,angle_deg\n2020-03-20T11:00:00Z,30\n2020-03-20T13:00:00Z,30\n";
  refused(good, "angle_deg: 5, track: sun, normal: [0, 0, 1]", "stands beside track: sun");
  refused("time_utc,angle\n2020-03-20T11:00:00Z,30\n", "angle_deg: 5", "angle_deg");
  refused("time_utc,angle_deg\n2020-03-20T11:00:00Z,30\n", "angle_deg: 5",
          "the first and the last angle hold outside");
  refused("time_utc,angle_deg\n2020-03-20T11:00:00Z,30\n2020-03-20T10:00:00Z,1\n", "angle_deg: 5",
          "ascending");
  assert_int_equal(remove(CSV), 0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(shines_as_it_stands),
      cmocka_unit_test(constant_file_is_an_angle),
      cmocka_unit_test(what_is_refused),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
