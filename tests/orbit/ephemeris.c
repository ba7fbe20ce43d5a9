/* Pole and Earth between nodes: close to the series, which tests/orbit/frames.c and sun.c hold
 * against figures of others. */
#include "orbit_test.h"

#include <erfa.h>

#include "orbit/ephemeris.h"
#include "orbit/frames.h"
#include "orbit/sun.h"
#include "orbit/time.h"

/* An instant of 1960 to 2040. */
static double instant(int k) { return -40.0 * 365.25 * 86400.0 + 47654.321 * k; }

/* Largest differences from the series: of the pole [rad], of the Earth's place [au] and speed
 * [au/d]. */
struct worst {
  double pole, place, speed;
};

static void compare(struct um_orbit_ephemeris *kept, double t, struct worst *worst)
{
  struct um_orbit_cip a, b;
  struct um_orbit_earth_motion p, q;
  um_orbit_ephemeris_cip(NULL, t, &a);
  um_orbit_ephemeris_cip(kept, t, &b);
  um_orbit_ephemeris_earth(NULL, t, &p);
  um_orbit_ephemeris_earth(kept, t, &q);
  worst->pole = fmax(worst->pole, fmax(fabs(a.x - b.x), fmax(fabs(a.y - b.y), fabs(a.s - b.s))));
  for (int i = 0; i < 3; i++) {
    worst->place = fmax(worst->place, fabs(p.r[i] - q.r[i]));
    worst->speed = fmax(worst->speed, fmax(fabs(p.v[i] - q.v[i]), fabs(p.v_b[i] - q.v_b[i])));
  }
}

/* Over eighty years, nodes giving way to others; before and at the time of an empty node. */
static void as_the_series(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_ephemeris *kept = NULL;
  struct worst worst = {0};
  assert_ok(context, um_orbit_ephemeris_create(context, &kept));
  for (int k = 0; k < 4000; k++) compare(kept, instant(10 * k), &worst);
  compare(kept, 0.0, &worst);
  compare(kept, -1.0, &worst);
  print_message("pole %.2g rad, place %.2g au, speed %.2g au/d\n", worst.pole, worst.place,
                worst.speed);
  assert_true(worst.pole < 1e-14);
  assert_true(worst.place < 1e-13);
  assert_true(worst.speed < 1e-14);
  um_orbit_ephemeris_destroy(context, &kept);
  assert_null(kept);
}

/* The answer has no memory: the same bits after other questions. */
static void without_memory(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_ephemeris *kept = NULL;
  struct um_orbit_cip a, b, other;
  assert_ok(context, um_orbit_ephemeris_create(context, &kept));
  um_orbit_ephemeris_cip(kept, instant(7), &a);
  for (int k = 0; k < 3000; k++) um_orbit_ephemeris_cip(kept, instant(k), &other);
  um_orbit_ephemeris_cip(kept, instant(7), &b);
  assert_memory_equal(&a, &b, sizeof a);
  um_orbit_ephemeris_destroy(context, &kept);
}

static struct um_mat3 matrix_at(struct um_context *context, struct um_orbit_ephemeris *kept,
                                double t)
{
  const struct um_orbit_earth_orientation orientation = {.ut1_utc = 0.1, .ephemeris = kept};
  struct um_mat3 m;
  assert_ok(context, um_orbit_frames_gcrs_to_itrf(context, &orientation, t, &m));
  return m;
}

/* The matrix is ERFA's own eraC2t06a: bit for bit of the series, to 2e-13 between nodes. */
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
    struct um_mat3 m = matrix_at(context, NULL, t), between = matrix_at(context, kept, t);
    assert_memory_equal(&m, erfa, sizeof m);
    for (int i = 0; i < 9; i++)
      assert_true(fabs(between.m[i / 3][i % 3] - erfa[i / 3][i % 3]) < 2e-13);
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
      cmocka_unit_test_setup_teardown(without_memory, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(matrices, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(no_time, context_setup, context_teardown),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
