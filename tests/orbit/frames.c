/* Frames: Vallado's published case, orthogonality, the finals2000A reader. */
#include "orbit_test.h"

#include "orbit/frames.h"
#include "orbit/geodesy.h"

/* Vallado et al. 2006, AIAA 2006-6753, appendix C: 2004-04-06T07:51:28.386009 UTC. The position is
 * published to 0.1 mm in ITRF; 2 cm is 3 nrad, the level at which IAU-76 and IAU 2006 frames differ
 * and the published digits of GCRS end. */
static const struct um_orbit_earth_orientation vallado = {
    .ut1_utc = -0.4399619, .xp = -0.140682 * UM_ARCSEC, .yp = 0.333309 * UM_ARCSEC};
static const char vallado_utc[] = "2004-04-06T07:51:28.386009Z";

static void vallado_case(void **state)
{
  struct um_context *context = *state;
  double t = utc(context, vallado_utc);
  struct um_vec3 r_teme = {5094180.16210, 6127644.65950, 6380344.53270};
  struct um_vec3 v_teme = {-4746.131487, 785.818041, 5531.931288}, r, v;
  assert_ok(context,
            um_orbit_frames_teme_to_itrf(context, &vallado, t, 1.5563e-3, r_teme, v_teme, &r, &v));
  assert_vec_near(r, um_vec3(-1033479.3830, 7901295.2754, 6380356.5958), 0.02);
  /* velocity: 1e-6 km/s are the digits printed of v_TEME */
  assert_vec_near(v, um_vec3(-3225.636517, -2872.451453, 5531.924446), 2e-3);

  struct um_mat3 m, e;
  assert_ok(context, um_orbit_frames_teme_to_gcrs(context, &vallado, t, &m));
  assert_vec_near(um_mat3_apply(m, r_teme), um_vec3(5102508.959, 6123011.403, 6378136.925), 0.02);
  /* GCRS -> ITRF closes the triangle */
  assert_ok(context, um_orbit_frames_gcrs_to_itrf(context, &vallado, t, &e));
  assert_vec_near(um_mat3_apply(e, um_mat3_apply(m, r_teme)), r, 1e-6);
}

/* A state of one frame stands in GCRS where that of another one does. */
static void expect_state(struct um_context *context, const char *name, struct um_vec3 r,
                         struct um_vec3 v, struct um_vec3 r_gcrs, struct um_vec3 v_gcrs,
                         double metres, double metres_per_second)
{
  enum um_orbit_frame frame;
  double t = utc(context, vallado_utc);
  assert_true(um_orbit_frame_find(name, &frame));
  assert_ok(context, um_orbit_frame_to_gcrs(context, &vallado, frame, t, &r, &v));
  assert_vec_near(r, r_gcrs, metres);
  assert_vec_near(v, v_gcrs, metres_per_second);
}

/* Vallado 2013, example 3-15 (the same instant): ITRF and GCRS by IAU 2006/2000A. Its dates are one
 * double, 40 us of the Earth's turn, hence 2 cm; its velocity has LOD 1.5563 ms, which is taken as
 * 0 here: 1.8e-8 omega r = 10 um/s. astropy 8.0 of the same ITRF and TEME, with this UT1 and pole,
 * has dates of two doubles: 0.1 mm; its velocities, differences of two states, have the pole's
 * precession in them, 20 arcsec a year of 8000 km: 30 um/s. J2000, MOD and TOD by IAU 1976/1980
 * without corrections stand in AIAA 2006-6753: that they are one state needs no UT1, 1 mm are the
 * digits printed of J2000 and the terms of nutation. */
static void frames_of_others(void **state)
{
  struct um_context *context = *state;
  const struct um_vec3 r_itrf = {-1033479.3830, 7901295.2754, 6380356.5958};
  const struct um_vec3 v_itrf = {-3225.636520, -2872.451450, 5531.924446};
  const struct um_vec3 r_teme = {5094180.16210, 6127644.65950, 6380344.53270};
  const struct um_vec3 v_teme = {-4746.131487, 785.818041, 5531.931288};
  expect_state(context, "ITRF2014", r_itrf, v_itrf,
               um_vec3(5102508.9579, 6123011.4038, 6378136.9282),
               um_vec3(-4743.220157, 790.536497, 5533.755727), 0.02, 3e-5);
  expect_state(context, "ITRF", r_itrf, v_itrf,
               um_vec3(5102508.965812, 6123011.397148, 6378136.925304),
               um_vec3(-4743.220136967, 790.536500136, 5533.755741138), 1e-4, 5e-5);
  expect_state(context, "TEME", r_teme, v_teme,
               um_vec3(5102508.959215, 6123011.402634, 6378136.925257),
               um_vec3(-4743.220080879, 790.536473988, 5533.755741417), 1e-4, 2e-4);
  struct um_vec3 j = {5102509.6000, 6123011.5200, 6378136.3000};
  struct um_vec3 w = {-4743.219600, 790.536600, 5533.756190};
  assert_ok(context, um_orbit_frame_to_gcrs(context, &vallado, UM_ORBIT_FRAME_EME2000,
                                            utc(context, vallado_utc), &j, &w));
  expect_state(context, "MOD", um_vec3(5094029.0167, 6127870.9363, 6380247.8885),
               um_vec3(-4746.262495, 786.014149, 5531.791025), j, w, 1e-3, 1e-5);
  expect_state(context, "TOD", um_vec3(5094514.7804, 6127366.4612, 6380344.5328),
               um_vec3(-4746.088567, 786.077222, 5531.931288), j, w, 1e-3, 1e-5);
}

static void names(void **state)
{
  (void)state;
  static const char *const known[] = {"GCRF", "GCRF3",      "ICRF",      "EME2000",  "J2000",
                                      "ITRF", "ITRF-93",    "ITRF2020",  "TEME",     "TOD",
                                      "MOD",  "TEMEOFDATE", "TOD_EARTH", "MOD_EARTH"};
  static const char *const unknown[] = {"",     "GTOD", "PEF",      "TDR",      "ITRF-",
                                        "itrf", "TOD2", "ITRF20X4", "EME20001", "WGS84"};
  enum um_orbit_frame frame;
  for (size_t k = 0; k < sizeof known / sizeof *known; k++)
    if (!um_orbit_frame_find(known[k], &frame)) fail_msg("%s is not known", known[k]);
  for (size_t k = 0; k < sizeof unknown / sizeof *unknown; k++)
    if (um_orbit_frame_find(unknown[k], &frame)) fail_msg("%s is known", unknown[k]);
}

static void rotations(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_earth_orientation none = {0};
  for (int k = 0; k < 20; k++) {
    struct um_mat3 m[2];
    double t = 2e7 * k;
    assert_ok(context, um_orbit_frames_teme_to_gcrs(context, &none, t, &m[0]));
    assert_ok(context, um_orbit_frames_gcrs_to_itrf(context, &none, t, &m[1]));
    for (int i = 0; i < 2; i++) {
      struct um_mat3 unit = um_mat3_multiply(m[i], um_mat3_transpose(m[i]));
      for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) assert_close(unit.m[a][b], a == b ? 1.0 : 0.0, 1e-14);
    }
    /* the Earth's pole precesses by 20.04"/yr toward the equinox: below 0.13 deg until 2012 */
    assert_true(m[1].m[2][2] > cos(0.13 * UM_DEG));
  }
}

/* Graz, 47.067 N 15.493 E 495 m: N = a / sqrt(1 - e^2 sin^2 lat), evaluated with 60 digits. */
static void geodesy(void **state)
{
  (void)state;
  double lat = 47.067 * UM_DEG, lon = 15.493 * UM_DEG, back[3];
  struct um_vec3 r = um_orbit_geodesy_forward(lat, lon, 495.0);
  assert_vec_near(r, um_vec3(4194415.343, 1162662.485, 4647203.875), 1e-3);
  um_orbit_geodesy_reverse(r, &back[0], &back[1], &back[2]);
  assert_close(back[0], lat, 1e-14);
  assert_close(back[1], lon, 1e-14);
  assert_close(back[2], 495.0, 1e-8);
  /* 100 m up, and a point due north on the horizon plane */
  struct um_vec3 up =
      um_orbit_geodesy_enu(lat, lon, 495.0, um_orbit_geodesy_forward(lat, lon, 595.0));
  assert_vec_near(up, um_vec3(0.0, 0.0, 100.0), 1e-8);
  struct um_vec3 north = {-sin(lat) * cos(lon), -sin(lat) * sin(lon), cos(lat)};
  assert_vec_near(um_orbit_geodesy_enu(lat, lon, 495.0, um_vec3_axpy(r, 1e6, north)),
                  um_vec3(0.0, 1e6, 0.0), 1e-8);
}

/* One row in the columns of readme.finals2000A: 1-2 year, 3-4 month, 5-6 day, 8-15 MJD, 17 flag,
 * 19-27 xp, 28-36 its error, 38-46 yp, 47-55 error, 58 flag, 59-68 UT1-UTC, 69-78 error. */
static int finals_row(char *out, size_t size, int yymmdd, double mjd, double xp, double yp,
                      double dut)
{
  return snprintf(out, size, "%06d %8.2f I %9.6f%9.6f %9.6f%9.6f  I%10.7f%10.7f\n", yymmdd, mjd, xp,
                  3e-5, yp, 2e-5, dut, 9e-6);
}

static void finals_table(void **state)
{
  struct um_context *context = *state;
  char text[1024], path[256];
  size_t n = 0;
  /* around the leap second of 2016-12-31: UT1-UTC steps by one second, UT1-TAI does not */
  n += (size_t)finals_row(text + n, sizeof text - n, 161230, 57752.0, 0.10, 0.30, -0.4060);
  n += (size_t)finals_row(text + n, sizeof text - n, 161231, 57753.0, 0.12, 0.32, -0.4070);
  n += (size_t)finals_row(text + n, sizeof text - n, 170101, 57754.0, 0.16, 0.30, 0.5920);
  n += (size_t)finals_row(text + n, sizeof text - n, 170102, 57755.0, 0.18, 0.34, 0.5900);
  snprintf(text + n, sizeof text - n, "170103 57756.00\n"); /* not yet predicted: blank */
  scratch_write("finals.txt", text, path);
  struct um_orbit_earth_orientation eop = {.ut1_utc = 9.0};
  assert_ok(context, um_orbit_finals_read(context, path, &eop.finals));
  double dut, xp, yp;
  assert_ok(context, um_orbit_earth_orientation_at(
                         context, &eop, utc(context, "2016-12-30T12:00:00Z"), &dut, &xp, &yp));
  assert_close(dut, -0.4065, 1e-8);
  assert_close(xp, 0.11 * UM_ARCSEC, 1e-14);
  assert_close(yp, 0.31 * UM_ARCSEC, 1e-14);
  /* 43200 s into a day of 86401 s; UT1-UTC before the leap second */
  assert_ok(context, um_orbit_earth_orientation_at(
                         context, &eop, utc(context, "2016-12-31T12:00:00Z"), &dut, &xp, &yp));
  assert_close(dut, -0.4070 - 0.0010 * 43200.0 / 86401.0, 1e-8);
  assert_ok(context, um_orbit_earth_orientation_at(
                         context, &eop, utc(context, "2017-01-01T12:00:00Z"), &dut, &xp, &yp));
  assert_close(dut, 0.5910, 1e-8);
  assert_int_equal(um_orbit_earth_orientation_at(
                       context, &eop, utc(context, "2017-01-03T00:00:00Z"), &dut, &xp, &yp),
                   UM_ERR_INPUT);
  assert_string_equal(um_core_message(context),
                      "Earth orientation is wanted at 2017-01-03T00:00:00.000Z; the finals table "
                      "covers 2016-12-30T00:00:00.000Z to 2017-01-02T00:00:00.000Z");
  um_orbit_finals_destroy(&eop.finals);
  assert_null(eop.finals);
  remove(path);
}

static void finals_refusals(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_finals *finals = NULL;
  char row[3][128], text[512], path[256], want[512];
  finals_row(row[0], sizeof row[0], 161230, 57752.0, 0.10, 0.30, -0.4060);
  finals_row(row[1], sizeof row[1], 161231, 57753.0, 0.12, 0.32, -0.4070);
  finals_row(row[2], sizeof row[2], 161231, 57753.0, 0.12, 0.32, -0.4070);

  snprintf(text, sizeof text, "%s%s%s", row[0], row[1], row[2]);
  scratch_write("order.txt", text, path);
  assert_int_equal(um_orbit_finals_read(context, path, &finals), UM_ERR_INPUT);
  snprintf(want, sizeof want, "%s:3: MJD 57753.00 does not come after the row before", path);
  assert_string_equal(um_core_message(context), want);
  assert_null(finals);
  remove(path);

  um_core_message_clear(context);
  row[1][60] = 'x';
  snprintf(text, sizeof text, "%s%s", row[0], row[1]);
  scratch_write("letter.txt", text, path);
  assert_int_equal(um_orbit_finals_read(context, path, &finals), UM_ERR_INPUT);
  snprintf(
      want, sizeof want,
      "%s:2: columns 59-68 (UT1-UTC): no number there; the fixed columns of an IERS finals2000A "
      "file are accepted",
      path);
  assert_string_equal(um_core_message(context), want);
  remove(path);

  um_core_message_clear(context);
  assert_int_equal(um_orbit_finals_read(context, "no_such_finals.txt", &finals), UM_ERR_IO);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(vallado_case, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(frames_of_others, context_setup, context_teardown),
      cmocka_unit_test(names),
      cmocka_unit_test_setup_teardown(rotations, context_setup, context_teardown),
      cmocka_unit_test(geodesy),
      cmocka_unit_test_setup_teardown(finals_table, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(finals_refusals, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
