/* Trajectories: Kepler motion, the circular orbit of altitude and beta, tables, fixed points. */
#include "orbit_test.h"

#include "orbit/sun.h"
#include "orbit/trajectory.h"
#include "orbit/trajectory_impl.h"

/* Kepler's equation over eccentricity and anomaly, many turns included: M = E - e sin E holds to
 * the last bits of M (4 ulp of 2 pi, the size of M here), also where Newton alone diverges. */
static void kepler_equation(void **state)
{
  struct um_context *context = *state;
  static const double e[] = {0.0, 1e-8, 0.01, 0.3, 0.7, 0.9, 0.97, 0.99, 0.999, 0.999999};
  for (size_t k = 0; k < sizeof e / sizeof e[0]; k++)
    for (int i = -4000; i <= 4000; i++) {
      double m = i < 0 ? -pow(10.0, i / 250.0) : 0.001 * UM_PI * i, anomaly;
      assert_ok(context, um_orbit_kepler_solve(context, m, e[k], &anomaly));
      assert_close(anomaly - e[k] * sin(anomaly), m, 4e-15 + 2e-16 * fabs(m));
    }
  double anomaly;
  assert_int_equal(um_orbit_kepler_solve(context, NAN, 0.5, &anomaly), UM_ERR_NUMERIC);
}

/* Energy, momentum, period and apsides of the two-body problem. Bounds: 1e-12 relative, a hundred
 * roundings of the largest term. */
static void kepler_orbit(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_kepler k = {.epoch_tai = 5e8,
                              .a = 26.6e6,
                              .e = 0.74,
                              .i = 63.4 * UM_DEG,
                              .raan = 40.0 * UM_DEG,
                              .argp = 270.0 * UM_DEG,
                              .mean_anomaly = 0.0};
  struct um_orbit_trajectory *orbit = NULL;
  struct um_vec3 r, v;
  assert_ok(context, um_orbit_trajectory_create_kepler(context, &k, &orbit));
  double period = um_orbit_trajectory_period(orbit);
  assert_close(period, 2.0 * UM_PI * sqrt(k.a * k.a * k.a / UM_EARTH_GM), 1e-8);
  /* perigee: argument 270 deg puts it at declination -i */
  assert_ok(context, um_orbit_trajectory_state(context, orbit, k.epoch_tai, &r, &v));
  assert_close(um_vec3_norm(r), k.a * (1.0 - k.e), 1e-6);
  assert_close(asin(r.z / um_vec3_norm(r)), -k.i, 1e-12);
  assert_close(um_vec3_norm(v), sqrt(UM_EARTH_GM / k.a * (1.0 + k.e) / (1.0 - k.e)), 1e-8);
  for (int i = 0; i <= 40; i++) {
    double t = k.epoch_tai + period * i / 16.0;
    assert_ok(context, um_orbit_trajectory_state(context, orbit, t, &r, &v));
    double energy = 0.5 * um_vec3_dot(v, v) - UM_EARTH_GM / um_vec3_norm(r);
    assert_close(energy * -2.0 * k.a / UM_EARTH_GM, 1.0, 1e-12);
    struct um_vec3 h = um_vec3_cross(r, v);
    assert_close(um_vec3_norm(h) / sqrt(UM_EARTH_GM * k.a * (1.0 - k.e * k.e)), 1.0, 1e-12);
    assert_vec_near(um_vec3_unit(h),
                    um_vec3(sin(k.raan) * sin(k.i), -cos(k.raan) * sin(k.i), cos(k.i)), 1e-12);
    /* v is the derivative of r: central difference, r''' h^2 / 6 below 1e-3 m/s at perigee */
    struct um_vec3 before, after;
    assert_ok(context, um_orbit_trajectory_state(context, orbit, t - 0.125, &before, NULL));
    assert_ok(context, um_orbit_trajectory_state(context, orbit, t + 0.125, &after, NULL));
    assert_vec_near(um_vec3_scale(um_vec3_sub(after, before), 4.0), v, 1e-3);
  }
  assert_ok(context,
            um_orbit_trajectory_state(context, orbit, k.epoch_tai + 0.5 * period, &r, NULL));
  assert_close(um_vec3_norm(r), k.a * (1.0 + k.e), 1.0); /* 60 ns of t at 1 km/s */
  um_orbit_trajectory_destroy(&orbit);
  assert_null(orbit);
}

/* Beta is the angle between the plane and the Sun; the epoch point is the nearest to the Sun. */
static void circular_orbit(void **state)
{
  struct um_context *context = *state;
  double epoch = utc(context, "2016-06-21T10:00:00Z");
  struct um_vec3 sun = um_vec3_unit(um_orbit_sun_position(NULL, epoch)), r, v;
  for (int beta = -90; beta <= 90; beta += 15) {
    struct um_orbit_trajectory *orbit = NULL;
    assert_ok(context, um_orbit_trajectory_create_circular(context, epoch, 408e3, 6371e3,
                                                           beta * UM_DEG, 0.0, &orbit));
    double period = um_orbit_trajectory_period(orbit), nearest = -2.0;
    /* Kepler's own period at 6371 + 408 km is 5554.685 s */
    assert_close(period, 5554.685, 1e-3);
    for (int k = 0; k < 100; k++) {
      assert_ok(context,
                um_orbit_trajectory_state(context, orbit, epoch + period * k / 100.0, &r, &v));
      struct um_vec3 normal = um_vec3_unit(um_vec3_cross(r, v));
      assert_close(um_vec3_norm(r), 6779e3, 1e-6);
      assert_close(um_vec3_dot(r, v), 0.0, 1e-2);
      /* asin has no digits at 90 deg: compare the cosine there too */
      assert_close(um_vec3_dot(normal, sun), sin(beta * UM_DEG), 1e-13);
      assert_close(um_vec3_norm(um_vec3_cross(normal, sun)), cos(beta * UM_DEG), 1e-12);
      assert_true(beta == -90 || beta == 90 || normal.z > 0.0 || beta < -60);
      double aim = um_vec3_dot(um_vec3_unit(r), sun);
      if (k == 0) nearest = aim;
      assert_true(aim <= nearest + 1e-12);
    }
    assert_close(nearest, cos(beta * UM_DEG), 1e-12);
    um_orbit_trajectory_destroy(&orbit);
  }
  struct um_orbit_trajectory *orbit = NULL;
  assert_ok(context, um_orbit_trajectory_create_circular(context, epoch, 408e3, 6371e3, 0.0,
                                                         5560.988, &orbit));
  assert_close(um_orbit_trajectory_period(orbit), 5560.988, 1e-9);
  struct um_vec3 again;
  assert_ok(context, um_orbit_trajectory_state(context, orbit, epoch, &r, NULL));
  assert_ok(context,
            um_orbit_trajectory_state(context, orbit, epoch + 3.0 * 5560.988, &again, NULL));
  assert_vec_near(again, r, 2e-3); /* 0.1 us of time at 7.7 km/s */
  um_orbit_trajectory_destroy(&orbit);
}

/* Rows of a circular orbit every `step` seconds, as text. */
static void table_text(struct um_context *context, double epoch, double step, int rows,
                       bool velocities, char *text, size_t size)
{
  size_t n = (size_t)snprintf(text, size, "time_utc,x_km,y_km,z_km%s\n",
                              velocities ? ",vx_km_s,vy_km_s,vz_km_s" : "");
  struct um_orbit_trajectory *orbit = NULL;
  assert_ok(context,
            um_orbit_trajectory_create_circular(context, epoch, 622e3, 6378e3, 0.5, 0.0, &orbit));
  for (int i = 0; i < rows; i++) {
    char time[32];
    struct um_vec3 r, v;
    assert_ok(context, um_orbit_trajectory_state(context, orbit, epoch + step * i, &r, &v));
    um_orbit_time_format(epoch + step * i, time);
    n += (size_t)snprintf(text + n, size - n, "%s,%.9f,%.9f,%.9f", time, 1e-3 * r.x, 1e-3 * r.y,
                          1e-3 * r.z);
    if (velocities)
      n += (size_t)snprintf(text + n, size - n, ",%.12f,%.12f,%.12f", 1e-3 * v.x, 1e-3 * v.y,
                            1e-3 * v.z);
    n += (size_t)snprintf(text + n, size - n, "\n");
  }
  um_orbit_trajectory_destroy(&orbit);
}

/* Largest error [m] of a table against the orbit it came from, at quarter points. */
static double table_error(struct um_context *context, double epoch, double step, int rows,
                          bool velocities)
{
  static char text[1 << 17];
  char path[256];
  struct um_orbit_trajectory *orbit = NULL, *table = NULL;
  double worst = 0.0, first, last;
  table_text(context, epoch, step, rows, velocities, text, sizeof text);
  scratch_write("table.csv", text, path);
  assert_ok(context,
            um_orbit_trajectory_create_circular(context, epoch, 622e3, 6378e3, 0.5, 0.0, &orbit));
  assert_ok(context, um_orbit_trajectory_create_table(context, path, NULL, &table));
  um_orbit_trajectory_span(table, &first, &last);
  assert_close(first, epoch, 1e-6);
  assert_close(last, epoch + step * (rows - 1), 1e-6);
  for (int i = 0; i < 4 * (rows - 1); i++) {
    struct um_vec3 r, want;
    double t = first + 0.25 * step * i;
    assert_ok(context, um_orbit_trajectory_state(context, table, t, &r, NULL));
    assert_ok(context, um_orbit_trajectory_state(context, orbit, t, &want, NULL));
    worst = fmax(worst, um_vec3_norm(um_vec3_sub(r, want)));
  }
  um_orbit_trajectory_destroy(&table);
  um_orbit_trajectory_destroy(&orbit);
  remove(path);
  return worst;
}

/* Hermite error of a circle: r (n h)^4 / 384 (fourth derivative r n^4, bound h^4 / 384): radius
 * 7000 km, n = 1.078e-3 rad/s, h = 60 s gives 0.32 m, order 4. The spline with not-a-knot ends has
 * the same order; its bound is 5 times that inside (5/384), more at the ends: 15 times is asked. */
static void table_hermite(void **state)
{
  struct um_context *context = *state;
  double epoch = utc(context, "2016-06-21T10:00:00Z");
  double n = sqrt(UM_EARTH_GM / 7e6) / 7e6, bound = 7e6 * pow(60.0 * n, 4.0) / 384.0;
  double given = table_error(context, epoch, 60.0, 101, true);
  double spline = table_error(context, epoch, 60.0, 101, false);
  double finer = table_error(context, epoch, 30.0, 201, false);
  print_message("table, 60 s: Hermite %.3g m (bound %.3g m), spline %.3g m; at 30 s %.3g m\n",
                given, bound, spline, finer);
  assert_true(given <= 1.01 * bound);
  assert_true(spline <= 15.0 * bound);
  assert_true(spline / finer > 14.0); /* 16 is order four */
}

/* A cubic in time is reproduced by the spline whatever the steps (not-a-knot), a parabola by three
 * rows, a line by two; to the 1 mm of the table's digits. */
static void table_exact(void **state)
{
  struct um_context *context = *state;
  static const int seconds[] = {0, 7, 20, 60, 75, 130, 131, 200};
  for (size_t rows = 2; rows <= 8; rows++) {
    int degree = rows > 3 ? 3 : (int)rows - 1;
    char text[1024] = "# an orbit\nz_km,time_utc,x_km,y_km\n", path[256];
    for (size_t i = 0; i < rows; i++) {
      double x = pow(seconds[i], degree);
      snprintf(text + strlen(text), sizeof text - strlen(text),
               "%.9f,2016-09-21T20:%02d:%02dZ,%.9f,%.9f\n", 7000.0 - 1e-4 * x, seconds[i] / 60,
               seconds[i] % 60, 7000.0 + 1e-3 * x, 1e-5 * x);
    }
    scratch_write("cubic.csv", text, path);
    struct um_orbit_trajectory *table = NULL;
    assert_ok(context, um_orbit_trajectory_create_table(context, path, NULL, &table));
    double start = utc(context, "2016-09-21T20:00:00Z");
    for (double s = 0.0; s <= seconds[rows - 1]; s += 0.5) {
      struct um_vec3 r, v;
      double x = pow(s, degree), dx = degree * pow(s, degree - 1);
      assert_ok(context, um_orbit_trajectory_state(context, table, start + s, &r, &v));
      assert_vec_near(r, um_vec3(7e6 + x, 1e-2 * x, 7e6 - 0.1 * x), 0.02);
      assert_vec_near(v, um_vec3(dx, 1e-2 * dx, -0.1 * dx), 0.02);
    }
    um_orbit_trajectory_destroy(&table);
    remove(path);
  }
}

static void refused_table(struct um_context *context, const char *text, const char *message)
{
  char path[256], want[512];
  struct um_orbit_trajectory *table = NULL;
  scratch_write("bad.csv", text, path);
  um_core_message_clear(context);
  assert_int_equal(um_orbit_trajectory_create_table(context, path, NULL, &table), UM_ERR_INPUT);
  assert_null(table);
  snprintf(want, sizeof want, "%s%s", path, message);
  assert_string_equal(um_core_message(context), want);
  remove(path);
}

static void table_refusals(void **state)
{
  struct um_context *context = *state;
  refused_table(
      context,
      "time_utc,x_km,y_km,z_km\n2016-01-01T00:00:00Z,7000,0,0\n2016-01-01T00:00:00Z,7000,1,0\n",
      ":3: column 'time_utc': 2016-01-01T00:00:00Z is not after the row before it "
      "(2016-01-01T00:00:00Z); ascending times are accepted");
  refused_table(context, "time_utc,x_km,y_km,z_km\n2016-01-01T00:00:00Z,7000,0,0\n",
                ": 1 rows, at least 2 are accepted");
  refused_table(context,
                "time_utc,x_km,y_km,z_km,vx_km_s\n2016-01-01T00:00:00Z,7000,0,0,1\n"
                "2016-01-01T00:00:10Z,7000,0,0,1\n",
                ": 1 of the columns vx_km_s,vy_km_s,vz_km_s; all three or none are accepted");
  refused_table(
      context, "time_utc,x_km,y_km,z_km,speed\n2016-01-01T00:00:00Z,7000,0,0,1\n",
      ": column 'speed' is unknown; time_utc,x_km,y_km,z_km and vx_km_s,vy_km_s,vz_km_s are "
      "accepted");
  refused_table(
      context,
      "time_utc,x_km,y_km,z_km\n2016-01-01T00:00:00Z,7000,0,0\n2016-01-41T00:00:00Z,1,1,0\n",
      ":3: column 'time_utc': '2016-01-41T00:00:00Z': that month does not have this day");
  /* found by the fuzz target orbit_table: a period of 0 s, and positions that overflow */
  refused_table(context,
                "time_utc,x_km,y_km,z_km\n2016-01-01T00:00:00Z,0,0,0\n"
                "2016-01-01T00:01:00Z,7000,1,0\n",
                ":2: column 'x_km': the position is 0 km from the geocentre; accepted: 6000 to "
                "1e+09 km");
  refused_table(context,
                "time_utc,x_km,y_km,z_km\n2016-01-01T00:00:00Z,7000,0,0\n"
                "2016-01-01T00:01:00Z,3e9,4e9,0\n",
                ":3: column 'x_km': the position is 5e+09 km from the geocentre; accepted: 6000 to "
                "1e+09 km");
  refused_table(context,
                "time_utc,x_km,y_km,z_km,vx_km_s,vy_km_s,vz_km_s\n"
                "2016-01-01T00:00:00Z,7000,0,0,0,3e5,0\n2016-01-01T00:01:00Z,7000,1,0,0,7,0\n",
                ":2: column 'vx_km_s': the speed is 300000 km/s; accepted: less than light's");
  struct um_orbit_trajectory *table = NULL;
  char path[256], want[512];
  scratch_write(
      "span.csv",
      "time_utc,x_km,y_km,z_km\n2016-01-01T00:00:00Z,7000,0,0\n2016-01-01T00:01:00Z,7000,1,0\n",
      path);
  um_core_message_clear(context);
  assert_ok(context, um_orbit_trajectory_create_table(context, path, NULL, &table));
  assert_int_equal(um_orbit_trajectory_state(context, table,
                                             utc(context, "2016-01-01T00:01:00.001Z"), NULL, NULL),
                   UM_ERR_INPUT);
  snprintf(want, sizeof want,
           "%s: a position is wanted at 2016-01-01T00:01:00.001Z; the table covers "
           "2016-01-01T00:00:00.000Z to 2016-01-01T00:01:00.000Z",
           path);
  assert_string_equal(um_core_message(context), want);
  um_orbit_trajectory_destroy(&table);
  remove(path);
}

static void fixed_and_refusals(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_trajectory *orbit = NULL;
  struct um_vec3 r, v;
  double first, last;
  assert_ok(context, um_orbit_trajectory_create_fixed(context, um_vec3(7e6, -1e6, 2e6), &orbit));
  assert_ok(context, um_orbit_trajectory_state(context, orbit, 5e8, &r, &v));
  assert_vec_near(r, um_vec3(7e6, -1e6, 2e6), 0.0);
  assert_vec_near(v, um_vec3(0, 0, 0), 0.0);
  assert_true(isnan(um_orbit_trajectory_period(orbit)) && isnan(um_orbit_trajectory_epoch(orbit)));
  um_orbit_trajectory_span(orbit, &first, &last);
  assert_true(first == -INFINITY && last == INFINITY);
  um_orbit_trajectory_destroy(&orbit);
  um_orbit_trajectory_destroy(&orbit);

  struct um_orbit_kepler k = {.a = 800e3, .e = 0.1};
  assert_int_equal(um_orbit_trajectory_create_kepler(context, &k, &orbit), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "Kepler elements: perigee radius 720.000 km (a 800.000 km, e 0.1), above the "
                      "Earth's 6356.752 km is accepted");
  k = (struct um_orbit_kepler){.a = 8000e3, .e = 1.0};
  um_core_message_clear(context);
  assert_int_equal(um_orbit_trajectory_create_kepler(context, &k, &orbit), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "Kepler elements: eccentricity 1, 0 to below 1 is accepted");
  um_core_message_clear(context);
  assert_int_equal(um_orbit_trajectory_create_circular(context, 0.0, 4e5, 6.4e6, 2.0, 0.0, &orbit),
                   UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "circular orbit: beta 114.592 deg, -90 to 90 deg is accepted");
  assert_int_equal(um_orbit_trajectory_create_fixed(context, um_vec3(NAN, 0, 0), &orbit),
                   UM_ERR_INPUT);
  assert_null(orbit);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(kepler_equation, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(kepler_orbit, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(circular_orbit, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(table_hermite, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(table_exact, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(table_refusals, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(fixed_and_refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
