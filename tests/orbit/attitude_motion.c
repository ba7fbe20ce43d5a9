/* Attitude laws of free motion: nutation against Euler's equations, and tumbling. */
#include "attitude_test.h"

/* Free motion of a body with inertias (1, 1, k) along (t, b, e): Euler's equations
 *   I w' = -w x I w,  R' = R [w]x
 * integrated by Runge and Kutta's fourth order in steps of a 4000th of a turn, from where the law
 * says that the body stands, with the momentum along the law's axis. R takes body to GCRS. */
struct free_body {
  struct um_vec3 w;
  double r[9];
};

static struct free_body slope_of(const struct free_body *s, double k)
{
  struct free_body d;
  struct um_vec3 l = um_vec3(s->w.x, s->w.y, k * s->w.z);
  struct um_vec3 m = um_vec3_cross(l, s->w);
  d.w = um_vec3(m.x, m.y, m.z / k);
  for (int i = 0; i < 3; i++) {
    const double *row = &s->r[3 * i];
    d.r[3 * i] = row[1] * s->w.z - row[2] * s->w.y;
    d.r[3 * i + 1] = row[2] * s->w.x - row[0] * s->w.z;
    d.r[3 * i + 2] = row[0] * s->w.y - row[1] * s->w.x;
  }
  return d;
}

static struct free_body moved(const struct free_body *s, double h, const struct free_body *d)
{
  struct free_body out;
  out.w = um_vec3_axpy(s->w, h, d->w);
  for (int i = 0; i < 9; i++) out.r[i] = s->r[i] + h * d->r[i];
  return out;
}

/* The rate by which rows are laid out: what stands in space bends in body axes by its square at
 * most, and it is not half as much again. */
static void rate_bounds_bend(struct um_context *context, const struct um_orbit_attitude *a)
{
  static const struct um_vec3 stands[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0.0, 0.8}};
  double most = 0.0, rate = um_orbit_attitude_rate(a, 1e-3), h = 0.05;
  for (int n = 0; n < 2000; n++)
    for (size_t i = 0; i < sizeof stands / sizeof *stands; i++) {
      struct um_vec3 s[3];
      for (int k = 0; k < 3; k++) {
        struct um_orbit_attitude_input at = input_at(50.0 + 0.5 * n + (k - 1) * h);
        s[k] = um_quat_apply(attitude_at(context, a, &at), stands[i]);
      }
      struct um_vec3 bend = um_vec3_axpy(um_vec3_add(s[0], s[2]), -2.0, s[1]);
      most = fmax(most, um_vec3_norm(bend) / (h * h));
    }
  if (!(most <= 1.001 * rate * rate && rate * rate <= 2.25 * most))
    fail_msg("bends by %g, rate %g", most, rate);
}

static void nutation_case(struct um_context *context, double k, double tip, double across,
                          enum um_orbit_axis_frame frame)
{
  struct um_vec3 axis = um_vec3_unit(um_vec3(0.3, -0.5, 0.8)), z = um_vec3(0.0, 0.0, 1.0);
  struct um_orbit_attitude_law law = {.kind = UM_ATTITUDE_SPIN,
                                      .axis_frame = frame,
                                      .axis = frame == UM_AXIS_BODY ? z : axis,
                                      .axis_body = z,
                                      .q = {0.6, 0.48, 0.0, 0.64},
                                      .period = 100.0,
                                      .phase = 0.7,
                                      .at_tai = 50.0,
                                      .nutation = {tip, across},
                                      .inertia_ratio = k};
  struct um_orbit_attitude *a = attitude_of(context, law);
  if (frame == UM_AXIS_GCRS) rate_bounds_bend(context, a);
  struct um_orbit_attitude_input now = input_at(50.0);
  struct um_quat q = attitude_at(context, a, &now);
  double theta = hypot(tip, across), own = cos(theta) * (1.0 - k) / k;
  double precession = 2.0 * UM_PI / 100.0 / (1.0 + own); /* L / I_t */
  struct um_vec3 l = frame == UM_AXIS_BODY ? um_quat_apply(um_quat_conjugate(law.q), z) : axis;
  struct um_vec3 in_body = um_vec3_scale(um_quat_apply(q, l), precession);
  assert_close(in_body.z / precession, cos(theta), TIGHT);
  struct free_body s = {.w = um_vec3(in_body.x, in_body.y, in_body.z / k)};
  const struct um_vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int c = 0; c < 3; c++) {
    struct um_vec3 column = um_quat_apply(um_quat_conjugate(q), unit[c]);
    s.r[c] = column.x;
    s.r[3 + c] = column.y;
    s.r[6 + c] = column.z;
  }
  enum { STEPS = 4000 };
  double h = 100.0 / STEPS;
  for (int n = 1; n <= 2 * STEPS; n++) {
    struct free_body k1 = slope_of(&s, k), y2 = moved(&s, 0.5 * h, &k1), k2 = slope_of(&y2, k);
    struct free_body y3 = moved(&s, 0.5 * h, &k2), k3 = slope_of(&y3, k);
    struct free_body y4 = moved(&s, h, &k3), k4 = slope_of(&y4, k);
    s = moved(&s, h / 6.0, &k1);
    s = moved(&s, h / 3.0, &k2);
    s = moved(&s, h / 3.0, &k3);
    s = moved(&s, h / 6.0, &k4);
    if (n % 500 != 0) continue;
    now = input_at(50.0 + n * h);
    q = attitude_at(context, a, &now);
    for (int c = 0; c < 3; c++) {
      struct um_vec3 column = um_quat_apply(um_quat_conjugate(q), unit[c]);
      assert_close(column.x, s.r[c], 1e-9);
      assert_close(column.y, s.r[3 + c], 1e-9);
      assert_close(column.z, s.r[6 + c], 1e-9);
    }
  }
  um_orbit_attitude_destroy(&a);
}

static void nutation(void **state)
{
  struct um_context *context = *state;
  nutation_case(context, 0.14, 0.3, -0.2, UM_AXIS_GCRS); /* a rod about its length */
  nutation_case(context, 1.8, 0.2, 0.1, UM_AXIS_GCRS);   /* a disc about its axis */
  nutation_case(context, 0.5, 1.0, 1.0, UM_AXIS_BODY);
  nutation_case(context, 1.0, 0.0, 0.4, UM_AXIS_GCRS); /* a ball: the tip stands in space */
}

/* The law is the tumble of orbit/tumble.c, from at_tai on (tests/orbit/tumble.c). */
static void tumble(void **state)
{
  struct um_context *context = *state;
  struct um_orbit_attitude_law law = {.kind = UM_ATTITUDE_TUMBLE,
                                      .q = {0.6, 0.48, 0.0, 0.64},
                                      .inertia = {1.0, 2.0, 2.5, 0.1, 0.0, 0.0},
                                      .rate = {0.01, 0.02, 0.005},
                                      .at_tai = 50.0};
  struct um_orbit_attitude *a = attitude_of(context, law);
  struct um_orbit_attitude_input now = input_at(50.0), later = input_at(50.001);
  struct um_quat q = attitude_at(context, a, &now), after = attitude_at(context, a, &later);
  assert_close(fabs(q.w * 0.6 + q.x * 0.48 + q.z * 0.64), 1.0, TIGHT);
  struct um_quat turn = um_quat_then(um_quat_conjugate(q), after);
  assert_close(2.0 * turn.x / 1e-3, 0.01, 1e-6);
  assert_close(2.0 * turn.y / 1e-3, 0.02, 1e-6);
  assert_close(2.0 * turn.z / 1e-3, 0.005, 1e-6);
  assert_true(um_orbit_attitude_rate(a, 1e-3) >= sqrt(0.01 * 0.01 + 0.02 * 0.02 + 0.005 * 0.005));
  um_orbit_attitude_destroy(&a);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(nutation, context_setup, context_teardown),
      cmocka_unit_test_setup_teardown(tumble, context_setup, context_teardown)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
