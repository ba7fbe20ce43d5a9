/* Pole and Earth as they are kept by time: the bits of the series, which tests/orbit/frames.c and
 * sun.c hold against figures of others, whatever was asked before. */
#include "orbit_test.h"

#include <erfa.h>

#include "orbit/ephemeris.h"
#include "orbit/frames.h"
#include "orbit/sun.h"
#include "orbit/time.h"

/* An instant of 1960 to 2040. */
static double instant(int k) { return -40.0 * 365.25 * 86400.0 + 47654.321 * k; }

static void assert_as_series(struct um_orbit_ephemeris *kept, double t)
{
  struct um_orbit_cip a, b;
  struct um_orbit_earth_motion p, q;
  um_orbit_ephemeris_cip(NULL, t, &a);
  um_orbit_ephemeris_cip(kept, t, &b);
  um_orbit_ephemeris_earth(NULL, t, &p);
  um_orbit_ephemeris_earth(kept, t, &q);
  assert_memory_equal(&a, &b, sizeof a);
  assert_memory_equal(&p, &q, sizeof p);
}

/* First asked, then kept; more instants than there is room for, and then all of them again. */
static void as_the_series(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_ephemeris *kept = NULL;
  assert_ok(context, um_orbit_ephemeris_create(context, &kept));
  for (int k = 0; k < 40000; k++) {
    struct um_orbit_cip cip;
    struct um_orbit_earth_motion earth;
    if (k % 3 != 0) um_orbit_ephemeris_cip(kept, instant(k), &cip); /* one of the two, or both */
    if (k % 3 != 1) um_orbit_ephemeris_earth(kept, instant(k), &earth);
  }
  for (int k = 0; k < 40000; k += 7) assert_as_series(kept, instant(k));
  assert_as_series(kept, 0.0); /* the time of an empty entry */
  assert_as_series(kept, 0.0);
  um_orbit_ephemeris_destroy(context, &kept);
  assert_null(kept);
}

static struct um_mat3 matrix_at(struct um_context *context, struct um_orbit_ephemeris *kept,
                                double t)
{
  const struct um_orbit_earth_orientation orientation = {.ut1_utc = 0.1, .ephemeris = kept};
  struct um_mat3 m;
  assert_ok(context, um_orbit_frames_gcrs_to_itrf(context, &orientation, t, &m));
  return m;
}

/* The matrix is ERFA's own eraC2t06a, bit for bit, kept or not. */
static void matrices(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_ephemeris *kept = NULL;
  assert_ok(context, um_orbit_ephemeris_create(context, &kept));
  for (int k = 0; k < 60; k++) {
    double t = instant(977 * (k % 30)), tt[2], ut1[2], erfa[3][3];
    um_orbit_time_tt(t, tt);
    um_orbit_time_ut1(t, 0.1, ut1);
    eraC2t06a(tt[0], tt[1], ut1[0], ut1[1], 0.0, 0.0, erfa);
    struct um_mat3 m = matrix_at(context, k % 2 == 0 ? kept : NULL, t);
    assert_memory_equal(&m, erfa, sizeof m);
  }
  um_orbit_ephemeris_destroy(context, &kept);
}

/* No time at all gives no number, and no crash. */
static void no_time(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_ephemeris *kept = NULL;
  assert_ok(context, um_orbit_ephemeris_create(context, &kept));
  assert_true(isnan(um_orbit_sun_position(kept, NAN).x));
  um_orbit_ephemeris_destroy(context, &kept);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(as_the_series, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(matrices, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(no_time, context_setup, context_teardown),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
