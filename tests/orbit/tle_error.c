/* The error that is stated for elements of an age, against sets of the same satellite: where an old
 * set puts it at the epoch of a new one, which is off by much less. Distances and the part of drag
 * by python-sgp4 2.24 (Rhodes; Vallado's code), another implementation. */
#include "tests/orbit/orbit_test.h"

#include "orbit/sgp4.h"
#include "orbit/tle.h"

/* Two sets of FUNcube-1, 97.7 deg, 600 km (AMSAT-UK, February 2016); ENVISAT, 765 km, 2016. */
static const char *const funcube[2] = {
    "1 39444U 13066AE  16035.38257241  .00000865  00000-0  11531-3 0  9990\n"
    "2 39444  97.7004  94.3150 0060634  98.1157 262.6940 14.80829622117779\n",
    "1 39444U 13066AE  16041.86935662 +.00001155 +00000-0 +15169-3 0  9994\n"
    "2 39444 097.6991 100.5439 0060542 077.4170 283.3805 14.80846882118145\n"};
static const char *const envisat[2] = {
    "1 27386U 02009A   16058.06144687  .00000037  00000-0  26298-4 0  9994\n"
    "2 27386  98.2990 115.3795 0000852  79.1696 280.9586 14.37857112732659\n",
    "1 27386U 02009A   16249.14961597  .00000004  00000-0  15306-4 0  9994\n"
    "2 27386  98.2759 299.6736 0001263  83.7600 276.3746 14.37874511760117\n"};

static double distance(struct um_context *context, const struct um_orbit_tle *old,
                       const struct um_orbit_tle *new)
{
  struct um_orbit_sgp4 *a, *b;
  struct um_vec3 r[2], v;
  assert_ok(context, um_orbit_sgp4_create(context, old, &a));
  assert_ok(context, um_orbit_sgp4_create(context, new, &b));
  assert_ok(context, um_orbit_sgp4_state(context, a, (new->epoch_tai - old->epoch_tai) / 60.0,
                                         &r[0], &v, NULL));
  assert_ok(context, um_orbit_sgp4_state(context, b, 0.0, &r[1], &v, NULL));
  um_orbit_sgp4_destroy(&a);
  um_orbit_sgp4_destroy(&b);
  return um_vec3_norm(um_vec3_sub(r[1], r[0]));
}

/* days, distance [km], part of drag [km] of the other implementation. What is stated is a standard
 * deviation: a distance beyond three of it, or below a tenth, would make it a poor one. */
static void against(struct um_context *context, const char *const text[2], double days, double km,
                    double drag_km)
{
  struct um_orbit_tle old, new;
  double error;
  assert_ok(context, um_orbit_tle_parse(context, text[0], 1, &old));
  assert_ok(context, um_orbit_tle_parse(context, text[1], 1, &new));
  assert_close((new.epoch_tai - old.epoch_tai) / 86400.0, days, 0.01);
  double far = distance(context, &old, &new);
  assert_close(far, 1e3 * km, 20.0);
  assert_ok(context, um_orbit_tle_error(context, &old, new.epoch_tai, &error));
  assert_close(error, 1e3 * hypot(1.0 + days, drag_km), 20.0);
  assert_true(far > 0.1 * error && far < 3.0 * error);
}

static void sets_against_each_other(void **state)
{
  against(*state, funcube, 6.487, 8.95, 2.56);
  against(*state, envisat, 191.088, 493.20, 195.05);
}

/* 1 km at the epoch, more each day both ways, faster where there is more air. */
static void grows_with_age(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_tle tle[2];
  double before = 0.0, error[2];
  assert_ok(context, um_orbit_tle_parse(context, funcube[0], 1, &tle[0]));
  assert_ok(context, um_orbit_tle_parse(context, envisat[0], 1, &tle[1]));
  assert_ok(context, um_orbit_tle_error(context, &tle[0], tle[0].epoch_tai, &error[0]));
  assert_close(error[0], 1000.0, 1e-6);
  for (int day = 1; day <= 30; day++) {
    for (int i = 0; i < 2; i++)
      assert_ok(context,
                um_orbit_tle_error(context, &tle[i], tle[i].epoch_tai + 86400.0 * day, &error[i]));
    assert_true(error[0] > before && error[0] > error[1]);
    assert_true(error[1] >= 1e3 * (1.0 + day));
    before = error[0];
    assert_ok(context,
              um_orbit_tle_error(context, &tle[0], tle[0].epoch_tai - 86400.0 * day, &error[1]));
    assert_true(error[1] >= 1e3 * (1.0 + day));
  }
}

/* What was measured in low orbits says nothing of high ones; a decay nothing of what comes after.
 * The geostationary set is made up. */
static void is_not_stated_beyond(void **state)
{
  struct um_context *context = *state;
  static const char geostationary[] =
      "1 41866U 16071A   24001.50000000 -.00000096  00000-0  00000-0 0  9993\n"
      "2 41866   0.0500  90.0000 0001000  90.0000 180.0000  1.00270000 26000\n";
  struct um_orbit_tle tle;
  double error;
  assert_ok(context, um_orbit_tle_parse(context, geostationary, 0, &tle));
  assert_ok(context, um_orbit_tle_error(context, &tle, tle.epoch_tai + 1e5, &error));
  assert_true(isnan(error));
  assert_ok(context, um_orbit_tle_parse(context, funcube[0], 1, &tle));
  tle.bstar = 0.1;
  assert_ok(context, um_orbit_tle_error(context, &tle, tle.epoch_tai + 400.0 * 86400.0, &error));
  assert_true(isnan(error));
  assert_string_equal(um_core_message(context), "");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(sets_against_each_other, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(grows_with_age, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(is_not_stated_beyond, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
