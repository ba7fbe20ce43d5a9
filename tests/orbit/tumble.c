/* Free motion of a rigid body: closed forms, and Euler's equations step by step. */
#include "orbit/tumble_impl.h"

#include "orbit_test.h"

#include "orbit/elliptic_impl.h"

/* Abramowitz & Stegun, table 17.1 (K at m = 0, 0.5, 0.99) and 17.5 (F at modular angle 60 deg,
 * amplitude 45 deg); DLMF 22.5: at u = K/2 sn = (1 + sqrt m1)^-1/2, dn = m1^1/4. */
static void elliptic(void **state)
{
  (void)state;
  assert_close(um_orbit_elliptic_k(1.0), 0.5 * UM_PI, 1e-15);
  assert_close(um_orbit_elliptic_k(0.5), 1.85407467730137, 1e-14);
  assert_close(um_orbit_elliptic_k(0.01), 3.69563736298987, 1e-14);
  assert_close(um_orbit_elliptic_f(45.0 * UM_DEG, 0.25), 0.85122375, 5e-9);
  const double m1[] = {1.0, 0.9, 0.5, 0.1, 1e-3, 1e-6};
  for (size_t i = 0; i < sizeof m1 / sizeof *m1; i++) {
    double k = um_orbit_elliptic_k(m1[i]), sn, cn, dn;
    um_orbit_elliptic_jacobi(0.5 * k, m1[i], &sn, &cn, &dn);
    assert_close(sn, 1.0 / sqrt(1.0 + sqrt(m1[i])), 1e-12);
    assert_close(dn, sqrt(sqrt(m1[i])), 1e-12);
    for (double u = -0.95 * k; u < k; u += 0.1 * k) {
      um_orbit_elliptic_jacobi(u, m1[i], &sn, &cn, &dn);
      assert_close(um_orbit_elliptic_f(atan2(sn, cn), m1[i]), u, 1e-9);
    }
  }
}

struct motion {
  struct um_quat q; /* GCRS to body */
  struct um_vec3 w; /* body axes [rad/s] */
};

static struct um_vec3 times(const double i[6], struct um_vec3 w)
{
  return um_vec3(i[0] * w.x + i[3] * w.y + i[4] * w.z, i[3] * w.x + i[1] * w.y + i[5] * w.z,
                 i[4] * w.x + i[5] * w.y + i[2] * w.z);
}

/* I^-1 v by Cramer's rule. */
static struct um_vec3 over(const double i[6], struct um_vec3 v)
{
  struct um_vec3 a = um_vec3(i[0], i[3], i[4]), b = um_vec3(i[3], i[1], i[5]);
  struct um_vec3 c = um_vec3(i[4], i[5], i[2]);
  double d = um_vec3_dot(a, um_vec3_cross(b, c));
  return um_vec3(um_vec3_dot(v, um_vec3_cross(b, c)) / d, um_vec3_dot(v, um_vec3_cross(c, a)) / d,
                 um_vec3_dot(v, um_vec3_cross(a, b)) / d);
}

/* I w' = I w x w; q' = q (0, w)/2. */
static struct motion slope(const double i[6], struct motion s)
{
  struct um_quat spin = {0.0, 0.5 * s.w.x, 0.5 * s.w.y, 0.5 * s.w.z};
  return (struct motion){um_quat_then(s.q, spin), over(i, um_vec3_cross(times(i, s.w), s.w))};
}

static struct motion moved(struct motion s, double h, struct motion d)
{
  return (struct motion){
      {s.q.w + h * d.q.w, s.q.x + h * d.q.x, s.q.y + h * d.q.y, s.q.z + h * d.q.z},
      um_vec3_axpy(s.w, h, d.w)};
}

static struct motion stepped(const double i[6], struct motion s, double h)
{
  struct motion a = slope(i, s), b = slope(i, moved(s, 0.5 * h, a));
  struct motion c = slope(i, moved(s, 0.5 * h, b)), d = slope(i, moved(s, h, c));
  s = moved(moved(s, h / 6.0, a), h / 3.0, b);
  return moved(moved(s, h / 3.0, c), h / 6.0, d);
}

static const struct um_quat begin = {0.6, 0.48, 0.0, 0.64};

static struct um_orbit_tumble made(struct um_context *context, const double i[6], struct um_vec3 w)
{
  struct um_orbit_tumble t;
  assert_ok(context, um_orbit_tumble_make(context, i, w, begin, &t));
  return t;
}

static void same_turn(struct um_quat a, struct um_quat b, double tolerance)
{
  double dot = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z, sign = dot < 0.0 ? -1.0 : 1.0;
  assert_close(a.w, sign * b.w, tolerance);
  assert_close(a.x, sign * b.x, tolerance);
  assert_close(a.y, sign * b.y, tolerance);
  assert_close(a.z, sign * b.z, tolerance);
}

/* About both kinds of axis, both senses, with products of inertia, near the separatrix: against
 * Runge and Kutta's fourth order with steps of 2e-3 rad, whose error is below 1e-9 here. */
static void steps(void **state)
{
  struct um_context *context = *state;
  static const struct {
    double inertia[6];
    struct um_vec3 rate; /* [rad/s] */
  } row[] = {{{17023.3, 124825.7, 129112.2, 397.1, -2171.4, 344.2}, {0.004, -0.02, 0.025}},
             {{1.0, 2.0, 2.5, 0.0, 0.0, 0.0}, {0.01, 0.02, 0.03}},
             {{1.0, 2.0, 2.5, 0.0, 0.0, 0.0}, {-0.03, 0.01, -0.01}},
             {{2.0, 2.5, 1.0, 0.0, 0.0, 0.0}, {0.01, -0.03, -0.02}},
             {{2.5, 1.0, 2.0, 0.0, 0.0, 0.0}, {0.001, 0.0005, 0.03}},
             {{1.0, 1.0, 1.8, 0.0, 0.0, 0.0}, {0.01, 0.0, 0.02}},
             {{1.8, 0.3, 1.8, 0.0, 0.0, 0.0}, {0.01, 0.02, -0.02}},
             {{1.0, 2.0, 2.5, 0.4, -0.2, 0.1}, {0.02, 0.02, 0.0}}};
  for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
    const double *i = row[k].inertia;
    struct um_orbit_tumble t = made(context, i, row[k].rate);
    struct motion s = {begin, row[k].rate};
    const double h = 0.05;
    double e = um_vec3_dot(row[k].rate, times(i, row[k].rate)), worst = 0.0;
    struct um_vec3 l = um_quat_apply(um_quat_conjugate(begin), times(i, row[k].rate));
    for (int n = 0; n <= 24000; n++, s = stepped(i, s, h)) {
      if (n % 400 != 0) continue;
      struct um_vec3 w;
      struct um_quat q = um_orbit_tumble_at(&t, n * h, &w);
      same_turn(q, s.q, 1e-9);
      assert_close(um_vec3_norm(um_vec3_sub(w, s.w)), 0.0, 1e-10);
      struct um_vec3 now = um_quat_apply(um_quat_conjugate(q), times(i, w));
      worst = fmax(worst, um_vec3_norm(um_vec3_sub(now, l)) / um_vec3_norm(l));
      worst = fmax(worst, fabs(um_vec3_dot(w, times(i, w)) / e - 1.0));
      assert_true(um_vec3_norm(w) <= um_orbit_tumble_fastest(&t) * (1.0 + 1e-12));
    }
    print_message("case %zu: m1 %.3g, energy and momentum kept to %.1e\n", k, t.m1, worst);
    assert_true(worst <= 1e-11);
  }
}

/* A symmetric top: the rate goes about its axis at w_3 (I_3 - I)/I (Euler), period 2 pi over it. */
static void top(void **state)
{
  struct um_context *context = *state;
  const double i[6] = {1.0, 1.0, 1.7};
  struct um_orbit_tumble t = made(context, i, um_vec3(0.02, 0.0, 0.05));
  double about = 0.05 * 0.7;
  assert_close(um_orbit_tumble_period(&t), 2.0 * UM_PI / about, 1e-9);
  for (double since = -500.0; since < 500.0; since += 7.0) {
    struct um_vec3 w;
    um_orbit_tumble_at(&t, since, &w);
    assert_close(w.x, 0.02 * cos(about * since), 1e-13);
    assert_close(w.y, 0.02 * sin(about * since), 1e-13);
    assert_close(w.z, 0.05, 1e-14);
  }
}

/* A wing nut (Dzhanibekov): spun about the middle axis with 1e-4 across it, it turns over. Between
 * two passages of zero of that rate lie 2 K(m)/n; for little across it K = ln(4/sqrt m1). */
static void flips(void **state)
{
  struct um_context *context = *state;
  const double i[6] = {1.0, 2.0, 3.0}, small = 1e-4;
  struct um_orbit_tumble t = made(context, i, um_vec3(0.0, 1.0, small));
  double half = 0.5 * um_orbit_tumble_period(&t);
  /* n = w sqrt((3 - 2)(2 - 1)/(3 1)); m1 = I_a (I_a - I_c)/(I_b (I_b - I_c)) small^2 at L^2 > 2 E
   * I_b */
  double m1 = 3.0 * small * small;
  assert_close(half, 2.0 * log(4.0 / sqrt(m1)) * sqrt(3.0), 1e-3);
  double crossed[4], last = 1.0;
  int n = 0;
  for (double s = 0.01; n < 4; s += 0.01) {
    struct um_vec3 w;
    um_orbit_tumble_at(&t, s, &w);
    if (w.y * last < 0.0) crossed[n++] = s;
    last = w.y;
  }
  print_message("flips at %.2f %.2f %.2f s, every %.4f s; log form %.4f s\n", crossed[0],
                crossed[1], crossed[2], half, 2.0 * log(4.0 / sqrt(m1)) * sqrt(3.0));
  for (int k = 1; k < 4; k++) assert_close(crossed[k] - crossed[k - 1], half, 0.011);
  assert_close(crossed[0], 0.5 * half, 0.011);
}

/* Along an axis of inertia, the middle one too, and of a ball, nothing tumbles. */
static void steady(void **state)
{
  struct um_context *context = *state;
  static const double ball[6] = {2.0, 2.0, 2.0}, block[6] = {1.0, 2.0, 2.5};
  struct um_vec3 w = um_vec3(0.01, -0.02, 0.03), middle = um_vec3(0.0, 0.05, 0.0), now;
  struct um_orbit_tumble t = made(context, ball, w);
  struct um_quat turn = um_quat_from_axis(um_vec3_unit(w), um_vec3_norm(w) * 300.0);
  same_turn(um_orbit_tumble_at(&t, 300.0, &now), um_quat_then(begin, turn), 1e-13);
  assert_true(isinf(um_orbit_tumble_period(&t)));
  t = made(context, block, middle);
  turn = um_quat_from_axis(um_vec3(0.0, 1.0, 0.0), 0.05 * 300.0);
  same_turn(um_orbit_tumble_at(&t, 300.0, &now), um_quat_then(begin, turn), 1e-13);
  assert_close(now.y, 0.05, 0.0);
  assert_close(um_orbit_tumble_fastest(&t), 0.05, 0.0);
}

static void refused(struct um_context *context, const double i[6], struct um_vec3 w,
                    const char *message)
{
  struct um_orbit_tumble t;
  um_core_message_clear(context);
  assert_int_equal(um_orbit_tumble_make(context, i, w, begin, &t), UM_ERR_INPUT);
  assert_string_equal(um_core_message(context), message);
}

/* On the separatrix L^2 = 2 E I_b: I_a (I_a - I_b) w_a^2 = I_c (I_b - I_c) w_c^2. */
static void errors(void **state)
{
  struct um_context *context = *state;
  static const double block[6] = {1.0, 2.0, 3.0}, flat[6] = {1.0, 1.0, 3.0},
                      none[6] = {0.0, 1.0, 1.0};
  refused(context, block, um_vec3(0.0, 0.0, 0.0),
          "attitude: the rates are (0, 0, 0) rad/s; accepted: finite, not all 0");
  refused(
      context, flat, um_vec3(0.1, 0.0, 0.0),
      "attitude: principal moments of inertia 1, 1, 3; accepted: above 0, none greater than the "
      "sum of the others");
  refused(
      context, none, um_vec3(0.1, 0.0, 0.0),
      "attitude: principal moments of inertia 0, 1, 1; accepted: above 0, none greater than the "
      "sum of the others");
  static const double third[6] = {1.0, 2.0, 2.5};
  refused(
      context, third, um_vec3(sqrt(1.25), 1.0, 1.0),
      "attitude: the rates lie on the separatrix about the middle axis of inertia; accepted: rates "
      "beside it, 1 - m of 1e-13 or more");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(elliptic, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(steps, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(top, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(flips, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(steady, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(errors, context_setup, context_teardown),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
