/* Event times on circular orbits, whose eclipses are elementary.
 *
 * With the Sun in a fixed direction at the angle beta from the orbit plane and phi the angle along
 * the orbit from the point nearest the anti-solar direction, the Sun stands cos c = cos(beta)
 * cos(phi) from the geocentre, so that it is k a above the limb of a sphere at
 *
 *   phi = acos(cos(b + k a) / cos(beta)),  sin(b) = R/r,  k = -1, 0, 1 */
#include "check.h"

#include "base/core/constants.h"
#include "environment/environment.h"

struct orbit {
  double radius, beta, rate; /* [m], [rad], [rad/s] */
  double noon;               /* time of phi = 0 [s] */
  int calls;
  double broken_after; /* the callback fails beyond this time [s] */
  double nan_after;    /* and gives NaN beyond this [s] */
};

static enum um_status orbit_at(void *self, double t, struct um_vec3 *r, struct um_vec3 *sun,
                               double *distance, struct um_vec3 *pole)
{
  struct orbit *o = self;
  double phi = o->rate * (t - o->noon);
  o->calls++;
  if (t > o->broken_after) return UM_ERR_IO;
  if (t > o->nan_after) phi = NAN;
  *r = um_vec3(-o->radius * cos(phi), o->radius * sin(phi), 0.0);
  *sun = um_vec3(cos(o->beta), 0.0, sin(o->beta));
  *distance = UM_AU;
  *pole = um_vec3(0.0, 0.0, 1.0);
  return UM_OK;
}

/* Times of real missions, 5e8 s from the epoch of t_tai, where a double resolves 6e-8 s. */
#define EPOCH 5.2e8

static struct orbit orbit_of(double altitude, double beta)
{
  double radius = UM_EARTH_RADIUS + altitude;
  return (struct orbit){.radius = radius,
                        .beta = beta,
                        .rate = sqrt(UM_EARTH_GM / (radius * radius * radius)),
                        .noon = EPOCH + 1234.5,
                        .broken_after = INFINITY,
                        .nan_after = INFINITY};
}

static struct um_environment with(enum um_environment_shadow shadow, enum um_environment_disc disc)
{
  struct um_environment e;
  um_environment_defaults(&e);
  e.shadow = shadow;
  e.disc = disc;
  return e;
}

struct found {
  struct um_context *context;
  struct um_environment_event *event;
  size_t count;
};

static struct found search(const struct um_environment *e, struct orbit *o, double from, double to,
                           double step)
{
  struct found found = {NULL, NULL, 0};
  assert_int_equal(um_core_context_create(NULL, &found.context), UM_OK);
  enum um_status status = um_environment_events_find(found.context, e, orbit_at, o, from, to, step,
                                                     &found.event, &found.count);
  if (status != UM_OK) fail_msg("%s", um_core_message(found.context));
  return found;
}

static void release(struct found *found)
{
  um_core_free(found->context, found->event);
  um_core_context_destroy(&found->context);
}

/* f_E = acos(sqrt(h^2 + 2 R h) / ((R + h) cos(beta))) / pi; printed to 1e-6 of a revolution. */
static void eclipse_fraction_of_circular_orbits(void **state)
{
  (void)state;
  static const struct {
    double altitude, beta, fraction;
  } row[] = {{765e3, 0.0, 0.351336},
             {765e3, 42.956, 0.289078},
             {600e3, 0.0, 0.367036},
             {600e3, 60.0, 0.198733},
             {400e3, 0.0, 0.390100}};
  struct um_environment e = with(UM_SHADOW_CYLINDER, UM_DISC_UNIFORM);
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    struct orbit o = orbit_of(row[i].altitude, row[i].beta * UM_DEG);
    double period = 2.0 * UM_PI / o.rate;
    struct found f = search(&e, &o, o.noon - 0.5 * period, o.noon + 0.5 * period, 60.0);
    assert_int_equal(f.count, 6); /* a point: three coincide */
    for (int k = 0; k < 3; k++) {
      assert_int_equal(f.event[k].kind, UM_EVENT_PENUMBRA_ENTRY + k);
      assert_int_equal(f.event[3 + k].kind, UM_EVENT_UMBRA_EXIT + k);
      assert_true(f.event[k].t_tai == f.event[0].t_tai);
    }
    check_near("f_E", (f.event[3].t_tai - f.event[0].t_tai) / period, row[i].fraction, 6e-7);
    if (i == 0) { /* P = 6008.20 s, in shadow 2110.90 s */
      check_near("period [s]", period, 6008.20, 0.005);
      check_near("shadow [s]", f.event[3].t_tai - f.event[0].t_tai, 2110.90, 0.005);
    }
    release(&f);
  }
}

/* No eclipse above beta* = asin(R/r): 63.2405, 66.0665, 70.2179 deg at 765, 600, 400 km (1e-4). */
static void no_eclipse_above_critical_beta(void **state)
{
  (void)state;
  const double altitude[] = {765e3, 600e3, 400e3}, beta[] = {63.2405, 66.0665, 70.2179};
  struct um_environment e = with(UM_SHADOW_CYLINDER, UM_DISC_UNIFORM);
  for (int i = 0; i < 3; i++)
    for (int side = -1; side <= 1; side += 2) {
      struct orbit o = orbit_of(altitude[i], (beta[i] + side * 1e-4) * UM_DEG);
      struct found f = search(&e, &o, EPOCH, EPOCH + 2.0 * UM_PI / o.rate, 60.0);
      assert_int_equal(f.count, side < 0 ? 6 : 0);
      release(&f);
    }
}

/* Three revolutions, six events each, in order and within 1 ms; steps that divide nothing. */
static void times_to_a_millisecond(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SHADOW_SPHERE, UM_DISC_LIMB_DARKENED);
  const double step[] = {1.0, 17.3, 60.0, 240.0};
  double worst = 0.0;
  for (int s = 0; s < 4; s++)
    for (int i = 0; i < 4; i++) {
      struct orbit o = orbit_of(400e3 + 300e3 * i, 15.0 * i * UM_DEG);
      double period = 2.0 * UM_PI / o.rate, a = asin(UM_SOLAR_RADIUS / UM_AU);
      double b = asin(UM_EARTH_RADIUS / o.radius);
      struct found f = search(&e, &o, o.noon - 0.5 * period, o.noon + 2.5 * period, step[s]);
      assert_int_equal(f.count, 18);
      for (int n = 0; n < 18; n++) {
        int k = n % 6 < 3 ? 1 - n % 3 : n % 3 - 1; /* +1 0 -1, -1 0 +1 */
        double phi = acos(cos(b + k * a) / cos(o.beta)) * (n % 6 < 3 ? -1.0 : 1.0);
        double t = o.noon + period * (n / 6) + phi / o.rate;
        assert_int_equal(f.event[n].kind, UM_EVENT_PENUMBRA_ENTRY + n % 6);
        check_near("time [s]", f.event[n].t_tai, t, 1e-3);
        worst = fmax(worst, fabs(f.event[n].t_tai - t));
      }
      release(&f);
    }
  print_message("largest error of a time %.1e s\n", worst);
}

/* The satellite dips into the penumbra for 0.12, 1.2 or 12 s, wherever the samples of 60 s fall: in
 * the first, a middle or the last interval. At beta = b + a - depth the dip lasts 2 acos(cos(b + a)
 * / cos(beta)) / rate; rounding of the limb angle, 1e-15 rad, moves its ends by 3e-8 s at most. */
static void grazing_eclipse_is_found(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SHADOW_SPHERE, UM_DISC_UNIFORM);
  struct orbit o = orbit_of(765e3, 0.0);
  double a = asin(UM_SOLAR_RADIUS / UM_AU), b = asin(UM_EARTH_RADIUS / o.radius);
  const double depth[] = {1e-9, 1e-7, 1e-5}; /* [rad] */
  for (int d = 0; d < 3; d++)
    for (int shift = 0; shift < 12; shift++) {
      o.beta = b + a - depth[d];
      double phi = acos(cos(b + a) / cos(o.beta)), from = o.noon - 7.0 - 17.0 * shift;
      double to = o.noon + 7.0 + 29.0 * (shift % 4);
      assert_true(phi / o.rate < 6.5);
      struct found f = search(&e, &o, from, to, 60.0);
      assert_int_equal(f.count, 2);
      assert_int_equal(f.event[0].kind, UM_EVENT_PENUMBRA_ENTRY);
      assert_int_equal(f.event[1].kind, UM_EVENT_PENUMBRA_EXIT);
      check_near("entry [s]", f.event[0].t_tai, o.noon - phi / o.rate, 1e-3);
      check_near("exit [s]", f.event[1].t_tai, o.noon + phi / o.rate, 1e-3);
      release(&f);
      o.beta = b + a + depth[d]; /* just missed */
      f = search(&e, &o, from, to, 60.0);
      assert_int_equal(f.count, 0);
      release(&f);
    }
}

/* The fraction agrees with the events: 1 before, falling between, 0 inside. */
static void events_bound_the_fraction(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SHADOW_OBLATE, UM_DISC_LIMB_DARKENED);
  struct orbit o = orbit_of(765e3, 43.0 * UM_DEG);
  double period = 2.0 * UM_PI / o.rate;
  struct found f = search(&e, &o, o.noon - 0.5 * period, o.noon + 0.5 * period, 60.0);
  assert_int_equal(f.count, 6);
  const double before[] = {1.0, 0.5, NAN, 0.0, 0.5, NAN}, after[] = {NAN, 0.5, 0.0, NAN, 0.5, 1.0};
  for (int i = 0; i < 6; i++)
    for (int side = -1; side <= 1; side += 2) {
      struct um_vec3 r, sun, pole;
      double distance, expected = side < 0 ? before[i] : after[i];
      assert_int_equal(orbit_at(&o, f.event[i].t_tai + side * 1e-4, &r, &sun, &distance, &pole),
                       UM_OK);
      double fraction = um_environment_sunlit_fraction(&e, r, sun, distance, pole);
      /* half: the limb is curved, 3e-4, and 1e-4 s passes 1e-5 of the disc */
      if (isnan(expected))
        assert_true(fraction > 0.0 && fraction < 1.0);
      else
        check_near("fraction", fraction, expected, expected == 0.5 ? 3e-4 : 0.0);
    }
  release(&f);
}

static void nothing_to_find(void **state)
{
  (void)state;
  struct orbit o = orbit_of(765e3, 0.0);
  struct um_environment none = with(UM_SHADOW_NONE, UM_DISC_UNIFORM);
  struct um_environment e = with(UM_SHADOW_SPHERE, UM_DISC_UNIFORM);
  struct found f = search(&none, &o, EPOCH, EPOCH + 6000.0, 60.0);
  assert_int_equal(f.count, 0);
  release(&f);
  f = search(&e, &o, EPOCH, EPOCH, 60.0);
  assert_int_equal(f.count, 0);
  release(&f);
  f = search(&e, &o, o.noon - 10.0, o.noon + 10.0, 60.0); /* inside the umbra all the time */
  assert_int_equal(f.count, 0);
  release(&f);
}

static void bad_input_is_refused(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SHADOW_SPHERE, UM_DISC_UNIFORM);
  struct um_context *context = NULL;
  assert_int_equal(um_core_context_create(NULL, &context), UM_OK);
  static const struct {
    double from, to, step, broken_after, nan_after;
    enum um_status status;
  } row[] = {
      {0, -1, 60, INFINITY, INFINITY, UM_ERR_INPUT}, {0, NAN, 60, INFINITY, INFINITY, UM_ERR_INPUT},
      {0, 9, 0, INFINITY, INFINITY, UM_ERR_INPUT},   {0, 9, -1, INFINITY, INFINITY, UM_ERR_INPUT},
      {0, 9, NAN, INFINITY, INFINITY, UM_ERR_INPUT}, {0, 1e9, 1, INFINITY, INFINITY, UM_ERR_INPUT},
      {0, 9000, 60, 5000, INFINITY, UM_ERR_IO},      {0, 9000, 60, INFINITY, 5000, UM_ERR_NUMERIC}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    struct orbit o = orbit_of(765e3, 0.0);
    o.noon = 0.0;
    o.broken_after = row[i].broken_after;
    o.nan_after = row[i].nan_after;
    struct um_environment_event *event = (void *)&o;
    size_t count = 7;
    um_core_message_clear(context);
    assert_int_equal(um_environment_events_find(context, &e, orbit_at, &o, row[i].from, row[i].to,
                                                row[i].step, &event, &count),
                     row[i].status);
    assert_null(event);
    assert_int_equal(count, 0);
    if (row[i].status != UM_ERR_IO) assert_true(um_core_message(context)[0] != '\0');
  }
  um_core_context_destroy(&context);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(eclipse_fraction_of_circular_orbits),
      cmocka_unit_test(no_eclipse_above_critical_beta),
      cmocka_unit_test(times_to_a_millisecond),
      cmocka_unit_test(grazing_eclipse_is_found),
      cmocka_unit_test(events_bound_the_fraction),
      cmocka_unit_test(nothing_to_find),
      cmocka_unit_test(bad_input_is_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
