/* ENVISAT over Graz on 2016-09-21, computed from a public TLE with independent programs (astropy
 * and Skyfield agree with each other to 1e-4 deg and 9 m); light time off, no refraction. Then
 * light time, moving observers and directions against closed forms. */
#include "orbit_test.h"

#include "orbit/geodesy.h"
#include "orbit/observer.h"
#include "orbit/sun.h"

static const char envisat[] =
    "1 27386U 02009A   16250.75012691  .00000017  00000-0  19645-4 0  9999\n"
    "2 27386  98.2753 301.2152 0001254  82.1013 278.0311 14.37874790760345\n";
/* IERS-B for the date */
static const struct um_orbit_earth_orientation eop = {
    .ut1_utc = -0.267794, .xp = 0.23662 * UM_ARCSEC, .yp = 0.35129 * UM_ARCSEC};

static struct um_orbit_trajectory *satellite(struct um_context *context)
{
  struct um_orbit_tle tle;
  struct um_orbit_trajectory *orbit = NULL;
  assert_ok(context, um_orbit_tle_parse(context, envisat, 1, &tle));
  assert_ok(context, um_orbit_trajectory_create_tle(context, &tle, &eop, &orbit));
  return orbit;
}

static struct um_orbit_observer graz(void)
{
  return (struct um_orbit_observer){.kind = UM_OBSERVER_STATION,
                                    .latitude = 47.067 * UM_DEG,
                                    .longitude = 15.493 * UM_DEG,
                                    .height = 495.0,
                                    .orientation = eop};
}

/* Angle at the satellite between the apparent Sun and the observer. */
static double phase_angle(const struct um_orbit_look *look)
{
  struct um_vec3 sun;
  double distance;
  um_orbit_sun_apparent(NULL, look->t_satellite, look->r_gcrs, look->v_gcrs, &sun, &distance);
  return um_vec3_angle(sun, look->to_observer);
}

/* 2016-09-21T20:33:00: angles to 1e-3 deg (three printed digits and the spread of the programs),
 * range to 10 m. */
static void first_light(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_trajectory *orbit = satellite(context);
  struct um_orbit_observer station = graz();
  struct um_orbit_look look;
  double t = utc(context, "2016-09-21T20:33:00Z");
  assert_ok(context, um_orbit_observer_look(context, &station, orbit, t, &look));
  print_message(
      "20:33:00: azimuth %.4f, elevation %.4f deg, range %.4f km, phase angle %.4f deg, Sun "
      "at %.3f deg\n",
      look.azimuth / UM_DEG, look.elevation / UM_DEG, 1e-3 * look.range,
      phase_angle(&look) / UM_DEG, look.sun_elevation / UM_DEG);
  assert_close(look.azimuth / UM_DEG, 215.6793, 1e-3);
  assert_close(look.elevation / UM_DEG, 6.6881, 1e-3);
  assert_close(look.range, 2562928.0, 10.0);
  assert_close(phase_angle(&look) / UM_DEG, 76.868, 1e-3);
  assert_close(look.sun_elevation / UM_DEG, -33.9, 0.05);
  assert_close(look.t_satellite, t, 0.0);
  /* position printed to 0.01 mm; 1 m is what two frame chains (IAU-76 and 2006) may differ by */
  assert_vec_near(look.r_gcrs, um_vec3(4099220.41742, -4721166.05404, 3450550.87333), 0.1);
  um_orbit_trajectory_destroy(&orbit);
}

/* Time in [a, b] at which the satellite crosses the equator of date northward, by bisection. */
static double node_crossing(struct um_context *context, struct um_orbit_trajectory *orbit, double a,
                            double b)
{
  while (b - a > 1e-4) {
    struct um_vec3 r;
    struct um_mat3 to_gcrs;
    double t = 0.5 * (a + b);
    assert_ok(context, um_orbit_trajectory_state(context, orbit, t, &r, NULL));
    assert_ok(context, um_orbit_frames_teme_to_gcrs(context, &eop, t, &to_gcrs));
    if (um_mat3_apply(um_mat3_transpose(to_gcrs), r).z > 0.0)
      b = t;
    else
      a = t;
  }
  return 0.5 * (a + b);
}

/* TEME and ITRF states and the osculating elements of the same instant (mu of WGS-84). Digits of
 * the table: a 1 mm, e 1e-6, angles 1e-5 deg. */
static void states(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_trajectory *orbit = satellite(context);
  double t = utc(context, "2016-09-21T20:33:00Z");
  struct um_vec3 r, v, r_itrf, v_itrf;
  struct um_mat3 to_gcrs, to_teme;
  assert_ok(context, um_orbit_trajectory_state(context, orbit, t, &r, &v));
  assert_ok(context, um_orbit_frames_teme_to_gcrs(context, &eop, t, &to_gcrs));
  to_teme = um_mat3_transpose(to_gcrs);
  r = um_mat3_apply(to_teme, r);
  v = um_mat3_apply(to_teme, v);
  /* the epoch of the elements rests on a UTC day fraction of 8 decimals: 0.1 us, 1 mm */
  assert_vec_near(r, um_vec3(4111275.20803, -4705673.83044, 3457364.34805), 5e-3);
  assert_vec_near(v, um_vec3(-3278.947997, 1885.277006, 6445.314435), 1e-5);
  assert_ok(context, um_orbit_frames_teme_to_itrf(context, &eop, t, 0.0, r, v, &r_itrf, &v_itrf));
  assert_vec_near(r_itrf, um_vec3(6245770.53485, 190650.88262, 3457357.50780), 0.02);

  double radius = um_vec3_norm(r);
  struct um_vec3 h = um_vec3_cross(r, v);
  double a = 1.0 / (2.0 / radius - um_vec3_dot(v, v) / UM_EARTH_GM);
  struct um_vec3 e =
      um_vec3_sub(um_vec3_scale(um_vec3_cross(v, h), 1.0 / UM_EARTH_GM), um_vec3_unit(r));
  double inclination = acos(h.z / um_vec3_norm(h)), node = atan2(h.x, -h.y);
  struct um_vec3 towards_node = um_vec3(cos(node), sin(node), 0.0);
  double latitude_argument = um_vec3_angle(towards_node, r);
  assert_close(a, 7145509.0, 1.0);
  assert_close(um_vec3_norm(e), 0.001405, 1e-6);
  assert_close(inclination / UM_DEG, 98.27254, 1e-5);
  assert_close(node / UM_DEG + 360.0, 315.75744, 1e-5);
  assert_close(latitude_argument / UM_DEG, 29.28943, 1e-5);
  /* from the ascending node next to the epoch to the tenth after it: drag (1e-6 rev/day^2) and the
   * turn of the perigee shift that by some 10 ms */
  double epoch = um_orbit_trajectory_epoch(orbit);
  double node_at = node_crossing(context, orbit, epoch - 60.0, epoch + 60.0);
  double tenth = node_at + 10.0 * um_orbit_trajectory_period(orbit);
  assert_close(node_crossing(context, orbit, tenth - 60.0, tenth + 60.0), tenth, 0.02);
  assert_close(um_orbit_trajectory_epoch(orbit), utc(context, "2016-09-06T18:00:10.965Z"), 1e-3);
  um_orbit_trajectory_destroy(&orbit);
}

/* The pass: times printed to 0.01 s, azimuths to 1e-3 deg, ranges to 10 m. Tolerance of the times:
 * the elevation of 1e-4 deg in which Skyfield and astropy agree, at 0.05 deg/s (horizon) and
 * 0.08 deg/s (10 deg), 2 ms, plus half a digit; culmination is flat and is asked to 0.02 s. */
static void pass(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_trajectory *orbit = satellite(context);
  struct um_orbit_observer station = graz();
  double from = utc(context, "2016-09-21T20:00:00Z"), to = utc(context, "2016-09-21T21:20:00Z");
  static const struct {
    double limit;
    const char *rise, *set;
    double rise_azimuth, set_azimuth;
  } want[] = {{0.0, "2016-09-21T20:31:01.14Z", "2016-09-21T20:44:12.41Z", 205.328, 333.306},
              {10.0, "2016-09-21T20:33:53.68Z", "2016-09-21T20:41:17.34Z", 222.264, 316.206}};
  for (size_t k = 0; k < 2; k++) {
    struct um_orbit_pass *passes = NULL;
    size_t count = 0;
    assert_ok(context, um_orbit_passes_find(context, &station, orbit, from, to,
                                            want[k].limit * UM_DEG, &passes, &count));
    assert_int_equal(count, 1);
    char text[3][32];
    um_orbit_time_format(passes->rise, text[0]);
    um_orbit_time_format(passes->culmination, text[1]);
    um_orbit_time_format(passes->set, text[2]);
    print_message(
        "above %g deg: rise %s %.4f, culmination %s %.4f at %.4f deg %.4f km, set %s %.4f\n",
        want[k].limit, text[0], passes->rise_azimuth / UM_DEG, text[1],
        passes->culmination_azimuth / UM_DEG, passes->culmination_elevation / UM_DEG,
        1e-3 * passes->culmination_range, text[2], passes->set_azimuth / UM_DEG);
    assert_close(passes->rise, utc(context, want[k].rise), 0.01);
    assert_close(passes->set, utc(context, want[k].set), 0.01);
    assert_close(passes->culmination, utc(context, "2016-09-21T20:37:34.76Z"), 0.02);
    assert_close(passes->rise_azimuth / UM_DEG, want[k].rise_azimuth, 1e-3);
    assert_close(passes->set_azimuth / UM_DEG, want[k].set_azimuth, 1e-3);
    assert_close(passes->culmination_azimuth / UM_DEG, 269.207, 3e-3); /* 0.15 deg/s x 0.01 s */
    assert_close(passes->culmination_elevation / UM_DEG, 19.998, 1e-3);
    assert_close(passes->culmination_range, 1716440.0, 20.0);
    um_core_free(context, passes);
  }
  struct um_orbit_look look;
  assert_ok(context, um_orbit_observer_look(context, &station, orbit,
                                            utc(context, "2016-09-21T20:37:34.76Z"), &look));
  assert_close(phase_angle(&look) / UM_DEG, 108.327, 1e-3);
  um_orbit_trajectory_destroy(&orbit);
}

/* Two days: as many passes as a fine scan finds; clipped windows; refusals. */
static void pass_search(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_trajectory *orbit = satellite(context);
  struct um_orbit_observer station = graz();
  double from = utc(context, "2016-09-20T00:00:00Z"), to = from + 86400.0;
  struct um_orbit_pass *passes = NULL;
  size_t count = 0, crossings = 0;
  assert_ok(context,
            um_orbit_passes_find(context, &station, orbit, from, to, 0.0, &passes, &count));
  bool above = false;
  for (double t = from; t <= to; t += 10.0) {
    struct um_orbit_look look;
    assert_ok(context, um_orbit_observer_look(context, &station, orbit, t, &look));
    if (look.elevation > 0.0 && !above) crossings++;
    above = look.elevation > 0.0;
  }
  assert_int_equal(count, crossings);
  for (size_t i = 0; i < count; i++) {
    struct um_orbit_look look;
    assert_true(passes[i].rise <= passes[i].culmination && passes[i].culmination <= passes[i].set);
    if (i > 0) assert_true(passes[i].rise > passes[i - 1].set);
    assert_ok(context, um_orbit_observer_look(context, &station, orbit, passes[i].rise, &look));
    /* 1 ms at the steepest 7.5 km/s / 760 km */
    if (passes[i].rise > from) assert_close(look.elevation, 0.0, 1e-5);
  }
  um_core_free(context, passes);
  /* a window inside the pass: clipped at both ends */
  double inside = utc(context, "2016-09-21T20:36:00Z");
  assert_ok(context, um_orbit_passes_find(context, &station, orbit, inside, inside + 200.0, 0.0,
                                          &passes, &count));
  assert_int_equal(count, 1);
  assert_close(passes->rise, inside, 0.0);
  assert_close(passes->set, inside + 200.0, 0.0);
  assert_close(passes->culmination, utc(context, "2016-09-21T20:37:34.76Z"), 0.02);
  um_core_free(context, passes);
  /* a limit just below the culmination (19.998 deg): a pass shorter than the sampling step */
  assert_ok(context, um_orbit_passes_find(context, &station, orbit, inside - 3000.0,
                                          inside + 3000.0, 19.99 * UM_DEG, &passes, &count));
  assert_int_equal(count, 1);
  assert_true(passes->set - passes->rise < 30.0);
  um_core_free(context, passes);
  station.kind = UM_OBSERVER_DIRECTION;
  assert_int_equal(um_orbit_passes_find(context, &station, orbit, from, to, 0.0, &passes, &count),
                   UM_ERR_INPUT);
  assert_string_equal(um_core_message(context), "passes: the observer must be a station");
  um_orbit_trajectory_destroy(&orbit);
}

/* At culmination, 1716.44 km, light takes 5.7 ms, in which the satellite moves 43 m. */
static void light_time(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_trajectory *orbit = satellite(context);
  struct um_orbit_observer station = graz();
  struct um_orbit_look off, on;
  double t = utc(context, "2016-09-21T20:37:34.76Z");
  assert_ok(context, um_orbit_observer_look(context, &station, orbit, t, &off));
  station.light_time = 1;
  assert_ok(context, um_orbit_observer_look(context, &station, orbit, t, &on));
  double tau = t - on.t_satellite;
  assert_close(tau, 5.7e-3, 0.05e-3);
  assert_close(tau, on.range / UM_LIGHT_SPEED, 2e-7); /* the resolution of t_tai is 0.06 us */
  assert_close(um_vec3_norm(um_vec3_sub(on.r_gcrs, off.r_gcrs)), 43.0, 0.5);
  assert_vec_near(um_vec3_axpy(off.r_gcrs, -tau, off.v_gcrs), on.r_gcrs, 0.01);
  um_orbit_trajectory_destroy(&orbit);
}

/* Observers that are no station: another orbit, and a direction at infinity. */
static void other_observers(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_trajectory *orbit = NULL, *other = NULL;
  struct um_orbit_look look;
  assert_ok(context,
            um_orbit_trajectory_create_circular(context, 5e8, 500e3, 6378e3, 0.3, 0.0, &orbit));
  assert_ok(context, um_orbit_trajectory_create_fixed(context, um_vec3(0, 0, 4.2e7), &other));
  struct um_orbit_observer observer = {
      .kind = UM_OBSERVER_TRAJECTORY, .trajectory = other, .light_time = 1};
  assert_ok(context, um_orbit_observer_look(context, &observer, orbit, 5e8 + 1000.0, &look));
  struct um_vec3 r, difference;
  assert_ok(context, um_orbit_trajectory_state(context, orbit, look.t_satellite, &r, NULL));
  difference = um_vec3_sub(um_vec3(0, 0, 4.2e7), r);
  assert_close(look.range, um_vec3_norm(difference), 1e-6);
  assert_vec_near(look.to_observer, um_vec3_unit(difference), 1e-15);
  assert_close(5e8 + 1000.0 - look.t_satellite, look.range / UM_LIGHT_SPEED, 2e-7);
  assert_true(isnan(look.azimuth) && isnan(look.elevation) && isnan(look.sun_elevation));

  observer = (struct um_orbit_observer){
      .kind = UM_OBSERVER_DIRECTION, .direction_gcrs = {0, 3, 4}, .range = 1e6, .light_time = 1};
  assert_ok(context, um_orbit_observer_look(context, &observer, orbit, 5e8 + 1000.0, &look));
  assert_vec_near(look.to_observer, um_vec3(0, 0.6, 0.8), 1e-15);
  assert_close(look.range, 1e6, 0.0);
  assert_close(look.t_satellite, 5e8 + 1000.0, 0.0);
  assert_true(isnan(look.azimuth) && isnan(look.elevation) && isnan(look.sun_elevation));
  um_orbit_trajectory_destroy(&other);
  um_orbit_trajectory_destroy(&orbit);
}

/* A station carried by a fixed frame: a point straight above it, 1000 km up, is in the zenith; one
 * displaced due east stands at azimuth 90 deg. */
static void station_frame(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_observer station = graz();
  struct um_mat3 to_itrf;
  double t = utc(context, "2016-09-21T20:33:00Z");
  assert_ok(context, um_orbit_frames_gcrs_to_itrf(context, &eop, t, &to_itrf));
  struct um_vec3 up = um_orbit_geodesy_forward(station.latitude, station.longitude, 1000495.0);
  struct um_vec3 east = {-sin(station.longitude), cos(station.longitude), 0.0};
  struct um_vec3 points[2] = {up, um_vec3_axpy(up, 1e6, east)};
  for (int k = 0; k < 2; k++) {
    struct um_orbit_trajectory *point = NULL;
    struct um_orbit_look look;
    assert_ok(context, um_orbit_trajectory_create_fixed(
                           context, um_mat3_apply(um_mat3_transpose(to_itrf), points[k]), &point));
    assert_ok(context, um_orbit_observer_look(context, &station, point, t, &look));
    /* asin near the zenith keeps half the digits */
    assert_close(look.elevation, k == 0 ? 0.5 * UM_PI : 0.25 * UM_PI, k == 0 ? 1e-7 : 1e-12);
    if (k == 1) assert_close(look.azimuth, 0.5 * UM_PI, 1e-12);
    um_orbit_trajectory_destroy(&point);
  }
}

/* There and back: the direction under which the satellite stands and its height above the ellipsoid
 * say where it is, to 1 mm; so do the height alone straight up, and a place below the horizon.
 * Light time moves the time of emission, not the place. 1 mm: asin near the zenith keeps half the
 * digits of the elevation, 1e-9 rad at 45 deg from it, and t_tai is known to 0.1 us, 0.05 mm of the
 * Earth's turn. */
static void locate(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_trajectory *orbit = satellite(context);
  static const double latitudes[] = {-90.0, -47.0, 0.0, 32.4, 89.9};
  double worst = 0.0, t0 = utc(context, "2016-09-21T20:33:00Z");
  for (size_t i = 0; i < sizeof latitudes / sizeof latitudes[0]; i++)
    for (int k = 0; k < 40; k++) {
      struct um_orbit_observer station = graz();
      struct um_orbit_look seen, made;
      struct um_mat3 to_itrf;
      double latitude, longitude, height, t = t0 + 151.0 * k;
      station.latitude = latitudes[i] * UM_DEG;
      station.light_time = k % 2;
      assert_ok(context, um_orbit_observer_look(context, &station, orbit, t, &seen));
      assert_ok(context, um_orbit_frames_gcrs_to_itrf(context, &eop, t, &to_itrf));
      um_orbit_geodesy_reverse(um_mat3_apply(to_itrf, seen.r_gcrs), &latitude, &longitude, &height);
      assert_ok(context, um_orbit_observer_locate(context, &station, t, seen.azimuth,
                                                  seen.elevation, height, &made));
      /* the far side of the Earth is reached through it: the range is still the only one */
      worst = fmax(worst, um_vec3_norm(um_vec3_sub(made.r_gcrs, seen.r_gcrs)));
      assert_close(made.range, seen.range, 1e-3);
      assert_close(made.t_satellite, seen.t_satellite, 2e-7);
      assert_vec_near(made.to_observer, seen.to_observer, 1e-9);
      assert_close(made.elevation, seen.elevation, 1e-9);
      assert_close(made.sun_elevation, seen.sun_elevation, 0.0);
    }
  print_message("place from direction and height: %.3g m off at most\n", worst);
  assert_true(worst <= 1e-3);

  struct um_orbit_observer station = graz();
  struct um_orbit_look up;
  assert_ok(context, um_orbit_observer_locate(context, &station, t0, 1.0, 0.5 * UM_PI, 550e3, &up));
  assert_close(up.range, 550e3 - 495.0, 1e-5);
  assert_close(um_vec3_norm(up.v_gcrs), 0.0, 0.0);
  assert_close(up.t_satellite, t0, 0.0);
  um_orbit_trajectory_destroy(&orbit);
}

static void locate_refusals(void **state)
{
  struct um_context *context = *state;
  static const struct {
    double azimuth, elevation, height;
    const char *message;
  } bad[] = {
      {0.0, 0.5, 495.0, "satellite height 0.495 km; accepted: above the station at 0.495 km"},
      {0.0, 0.5, NAN, "satellite height nan km; accepted: above the station at 0.495 km"},
      {NAN, 0.5, 5e5,
       "azimuth nan deg, elevation 28.6479 deg; accepted: finite numbers, "
       "elevation from -90 to 90 deg"},
      {0.0, 2.0, 5e5,
       "azimuth 0 deg, elevation 114.592 deg; accepted: finite numbers, "
       "elevation from -90 to 90 deg"}};
  struct um_orbit_observer station = graz();
  struct um_orbit_look look;
  double t = utc(context, "2016-09-21T20:33:00Z");
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
    assert_int_equal(um_orbit_observer_locate(context, &station, t, bad[i].azimuth,
                                              bad[i].elevation, bad[i].height, &look),
                     UM_ERR_INPUT);
    assert_string_equal(um_core_message(context), bad[i].message);
    um_core_message_clear(context);
  }
  struct um_orbit_observer far = {.kind = UM_OBSERVER_DIRECTION, .direction_gcrs = {0, 0, 1}};
  assert_int_equal(um_orbit_observer_locate(context, &far, t, 0.0, 0.5, 5e5, &look), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "azimuth and elevation want a station; accepted: observer.station");
}

/* A trajectory that is none says so. */
static void no_track(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_trajectory *none = NULL;
  struct um_vec3 r;
  assert_ok(context, um_orbit_trajectory_create_none(context, &none));
  assert_true(isnan(um_orbit_trajectory_period(none)));
  assert_int_equal(um_orbit_trajectory_state(context, none, 5e8, &r, NULL), UM_ERR_INPUT);
  assert_non_null(strstr(um_core_message(context), "the observations stand alone (orbit.points)"));
  um_orbit_trajectory_destroy(&none);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(first_light, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(states, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(pass, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(pass_search, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(light_time, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(other_observers, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(station_frame, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(locate, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(locate_refusals, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(no_track, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
