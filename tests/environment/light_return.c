/* ENVISAT comes out of the Earth's shadow over Graz on 2016-09-21: orbit and environment together.
 *
 * Expected times: the same TLE through another SGP4 (python-sgp4), IERS-B Earth orientation, ERFA's
 * Sun, and rays over a uniform disc; no light time. Printed to 0.01 s; 0.1 s is allowed because a
 * disc sampled by rays seems smaller than it is, by some 0.3 % of the 13.6 s, at its first and last
 * light. */
#include "check.h"

#include "base/core/constants.h"
#include "environment/environment.h"
#include "orbit/frames.h"
#include "orbit/sun.h"
#include "orbit/time.h"
#include "orbit/tle.h"
#include "orbit/trajectory.h"

static const char *const envisat =
    "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n";

struct scene {
  struct um_context *context;
  struct um_orbit_trajectory *trajectory;
  struct um_orbit_earth_orientation orientation;
};

static enum um_status scene_at(void *self, double t, struct um_vec3 *r, struct um_vec3 *sun,
                               double *distance, struct um_vec3 *pole)
{
  struct scene *scene = self;
  struct um_vec3 v;
  struct um_mat3 to_itrf;
  UM_TRY(um_orbit_trajectory_state(scene->context, scene->trajectory, t, r, &v));
  UM_TRY(um_orbit_frames_gcrs_to_itrf(scene->context, &scene->orientation, t, &to_itrf));
  um_orbit_sun_apparent(NULL, t, *r, v, sun, distance);
  *pole = um_vec3(to_itrf.m[2][0], to_itrf.m[2][1], to_itrf.m[2][2]);
  return UM_OK;
}

static void check_ok(struct scene *scene, enum um_status status)
{
  if (status != UM_OK) fail_msg("%s", um_core_message(scene->context));
}

static double utc(struct scene *scene, const char *text)
{
  double t = NAN;
  check_ok(scene, um_orbit_time_parse(scene->context, text, &t));
  return t;
}

static void light_returns_on_time(void **state)
{
  (void)state;
  static const struct {
    enum um_environment_shadow shadow;
    double radius;
    const char *time[3]; /* fraction leaves 0, passes 1/2, reaches 1 */
  } row[] = {{UM_SHADOW_OBLATE,
              6378137.0,
              {"2016-09-21T20:36:51.86Z", "2016-09-21T20:36:58.68Z", "2016-09-21T20:37:05.48Z"}},
             {UM_SHADOW_SPHERE,
              6378137.0,
              {"2016-09-21T20:36:57.65Z", "2016-09-21T20:37:04.50Z", "2016-09-21T20:37:11.34Z"}},
             {UM_SHADOW_SPHERE,
              6371000.0,
              {"2016-09-21T20:36:54.35Z", "2016-09-21T20:37:01.21Z", "2016-09-21T20:37:08.06Z"}}};
  struct scene scene = {
      .orientation = {-0.267794, 0.23662 * UM_ARCSEC, 0.35129 * UM_ARCSEC, NULL, NULL}};
  struct um_orbit_tle tle;
  assert_int_equal(um_core_context_create(NULL, &scene.context), UM_OK);
  check_ok(&scene, um_orbit_tle_parse(scene.context, envisat, 1, &tle));
  check_ok(&scene, um_orbit_trajectory_create_tle(scene.context, &tle, &scene.orientation,
                                                  &scene.trajectory));
  double from = utc(&scene, "2016-09-21T20:31:02Z"), to = utc(&scene, "2016-09-21T20:44:12Z");
  for (int i = 0; i < 3; i++) {
    struct um_environment e;
    um_environment_defaults(&e);
    e.disc = UM_DISC_UNIFORM;
    e.shadow = row[i].shadow;
    e.shadow_radius = row[i].radius;
    struct um_environment_event *event = NULL;
    size_t count;
    check_ok(&scene, um_environment_events_find(scene.context, &e, scene_at, &scene, from, to, 60.0,
                                                &event, &count));
    assert_int_equal(count, 3);
    for (int k = 0; k < 3; k++) {
      assert_int_equal(event[k].kind, UM_EVENT_UMBRA_EXIT + k);
      double late = event[k].t_tai - utc(&scene, row[i].time[k]);
      print_message("%s  %+.4f s\n", row[i].time[k], late);
      check_near("light returns, late by [s]", late, 0.0, 0.1);
    }
    um_core_free(scene.context, event);
  }
  /* the last light before, behind the sphere, at 20:08:14: printed to the second */
  struct um_environment e;
  um_environment_defaults(&e);
  e.shadow = UM_SHADOW_SPHERE;
  e.disc = UM_DISC_UNIFORM;
  struct um_environment_event *event = NULL;
  size_t count;
  check_ok(&scene, um_environment_events_find(scene.context, &e, scene_at, &scene, from - 1800.0,
                                              from, 60.0, &event, &count));
  assert_int_equal(count, 3);
  assert_int_equal(event[2].kind, UM_EVENT_UMBRA_ENTRY);
  check_near("entry, late by [s]", event[2].t_tai - utc(&scene, "2016-09-21T20:08:14Z"), 0.0, 0.6);
  um_core_free(scene.context, event);
  um_orbit_trajectory_destroy(&scene.trajectory);
  um_core_context_destroy(&scene.context);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(light_returns_on_time)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
