/* Effects on attitude, time, orbit and exposure, on the spinning plate in its orbit. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/core/constants.h"
#include "model/build/timeline.h"
#include "tests/effects/case.h"
#include "tests/support/cmocka_all.h"

static struct um_environment_sample sample(const struct case_run *run, size_t k)
{
  return run->tables->sample[k];
}

static double distance(struct um_vec3 a, struct um_vec3 b)
{
  return um_vec3_norm(um_vec3_sub(a, b));
}

static void expect_same_orbit(const struct case_run *a, const struct case_run *b)
{
  for (size_t k = 0; k < a->tables->nobs; k++) {
    assert_true(sample(a, k).t_tai == sample(b, k).t_tai);
    assert_true(distance(sample(a, k).r, sample(b, k).r) == 0.0);
    assert_true(distance(sample(a, k).sun, sample(b, k).sun) == 0.0);
  }
}

/* Rodrigues: in a frame turned by theta about the unit vector e, the components of v become
 * v cos + (v x e) sin + e (e.v)(1 - cos). The vector (3, 0, 4) deg turns by 5 deg about (0.6, 0,
 * 0.8) of the body. */
static void attitude_offset_turns_the_body(void **state)
{
  (void)state;
  struct case_run a = case_with(case_spinner, NULL);
  struct case_run b = case_with(case_spinner, "attitude_offset,x_deg=3,z_deg=4");
  const struct um_vec3 e = um_vec3(0.6, 0.0, 0.8);
  double c = cos(5.0 * UM_DEG), s = sin(5.0 * UM_DEG);
  expect_same_orbit(&a, &b);
  for (size_t k = 0; k < a.tables->nobs; k++) {
    struct um_vec3 v = um_quat_apply(sample(&a, k).q, sample(&a, k).sun);
    struct um_vec3 expected = um_vec3_axpy(um_vec3_scale(v, c), s, um_vec3_cross(v, e));
    expected = um_vec3_axpy(expected, um_vec3_dot(e, v) * (1.0 - c), e);
    assert_true(distance(um_quat_apply(sample(&b, k).q, sample(&b, k).sun), expected) <= 1e-14);
  }
  case_release(&a);
  case_release(&b);
}

/* The body turns about its axis (0, 0.6, 0.8) by 2 pi (t - t_0) (1/P' - 1/P) more; the reference
 * time t_0 is 60 s after the first observation. */
static void spin_period_keeps_the_phase(void **state)
{
  (void)state;
  const double period = 700.0, relative = 0.02;
  const struct um_vec3 axis = um_vec3(0.0, 0.6, 0.8);
  struct case_run a = case_with(case_spinner, NULL);
  struct case_run b = case_with(case_spinner, "spin_period,relative_shift=0.02");
  expect_same_orbit(&a, &b);
  for (size_t k = 0; k < a.tables->nobs; k++) {
    double t = sample(&a, k).t_tai - a.tables->t_obs[0] - 60.0; /* light time included */
    double more = 2.0 * UM_PI * t * (1.0 / (period * (1.0 + relative)) - 1.0 / period);
    struct um_quat expected = um_quat_then(sample(&a, k).q, um_quat_from_axis(axis, more));
    struct um_vec3 x = um_vec3(1, 0, 0);
    assert_true(distance(um_quat_apply(sample(&b, k).q, x), um_quat_apply(expected, x)) <= 1e-11);
  }
  case_release(&a);
  case_release(&b);
  /* a law that is no spin stays */
  a = case_with(case_plate, NULL);
  b = case_with(case_plate, "spin_period,relative_shift=0.02");
  assert_true(case_same(&a, &b));
  case_release(&a);
  case_release(&b);
}

/* Azimuth of v about an axis, from any fixed direction across it [rad]. */
static double azimuth(struct um_vec3 v, struct um_vec3 axis)
{
  struct um_vec3 a, b;
  um_core_vec3_frame(axis, &a, &b);
  return atan2(um_vec3_dot(v, b), um_vec3_dot(v, a));
}

/* A body of inertia k times as large about its axis as across it, tipped by theta, whose turns in
 * space and about itself come to one in P: its axis goes about the momentum at
 * phi' = 2 pi/P / (1 + cos(theta) (1 - k)/k), and in its own axes the momentum goes about the axis
 * at -psi' = -phi' cos(theta) (1 - k)/k (Goldstein, Poole & Safko 2001, 5.6), which is against the
 * turn of a long body and with that of a flat one. The shift adds to the scenario's ratio. */
static void nutation_follows_the_inertia(void **state)
{
  (void)state;
  static const struct {
    const char *with, *ratio;
    double k, theta;
  } rows[] = {{"nutation,tip_deg=5", "attitude.0.spin.inertia_ratio=1", 1.0, 5.0},
              {"nutation,tip_deg=5,inertia_shift=0.5", "attitude.0.spin.inertia_ratio=1", 1.5, 5.0},
              {"nutation,tip_deg=3,tip_across_deg=4,inertia_shift=-0.4",
               "attitude.0.spin.inertia_ratio=1", 0.6, 5.0},
              {"nutation,tip_across_deg=40,inertia_shift=-0.4", "attitude.0.spin.inertia_ratio=1.3",
               0.9, 40.0}};
  const double period = 700.0;
  const struct um_vec3 axis = um_vec3(0.0, 0.6, 0.8); /* of the body */
  struct case_run plain = case_with(case_spinner, NULL);
  struct um_vec3 momentum = um_quat_apply(um_quat_conjugate(sample(&plain, 0).q), axis);
  case_release(&plain);
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    const char *const with[] = {rows[i].with, NULL}, *const set[] = {rows[i].ratio, NULL};
    struct case_run run = case_compute(case_spinner, with, NULL, set);
    double k = rows[i].k, theta = rows[i].theta * UM_DEG, own = cos(theta) * (1.0 - k) / k;
    double phi = 2.0 * UM_PI / period / (1.0 + own), psi = phi * own;
    double before[2] = {0.0, 0.0};
    for (size_t r = 0; r < run.tables->nobs; r++) {
      struct um_quat q = sample(&run, r).q;
      struct um_vec3 e = um_quat_apply(um_quat_conjugate(q), axis); /* in space */
      struct um_vec3 m = um_quat_apply(q, momentum);                /* in the body */
      double now[2] = {azimuth(e, momentum), azimuth(m, axis)}, t = sample(&run, r).t_tai;
      assert_true(fabs(um_vec3_dot(e, momentum) - cos(theta)) <= 1e-12);
      if (r > 0) {
        double dt = t - sample(&run, r - 1).t_tai;
        double space = remainder(now[0] - before[0] - phi * dt, 2.0 * UM_PI);
        double body = remainder(now[1] - before[1] + psi * dt, 2.0 * UM_PI);
        if (!(fabs(space) <= 1e-9 && fabs(body) <= 1e-9))
          fail_msg("%s: axis off by %g rad, momentum by %g", rows[i].with, space, body);
      }
      memcpy(before, now, sizeof before);
    }
    case_release(&run);
  }
}

/* Free motion with rates r times as fast goes through the same attitudes r times as soon: at the
 * reference time plus t (1 + x), with the period longer by x, the body stands as without it at plus
 * t. The rows of the second run are 1.25 times as far from the reference time. */
static void spin_period_slows_a_tumble(void **state)
{
  (void)state;
#define TUMBLE                                                                                     \
  "attitude=[{tumble: {q_gcrs: [0.6, 0.48, 0, 0.64], rates_deg_s: [0.5, -1.0, 0.7], "              \
  "inertia_kg_m2: [17, 120, 129], at_utc: 2020-03-20T12:00:00Z}}]"
  static const char *const set[] = {TUMBLE, "time.step_s=16", "time.light_time=false",
                                    "time.stop_utc=2020-03-20T12:03:12Z", NULL};
  static const char *const later[] = {TUMBLE, "time.step_s=20", "time.light_time=false",
                                      "time.stop_utc=2020-03-20T12:04:00Z", NULL};
  struct case_run a = case_compute(case_spinner, NULL, NULL, set);
  static const char *const slower[] = {"spin_period,relative_shift=0.25", NULL};
  struct case_run b = case_compute(case_spinner, slower, NULL, later);
  assert_true(a.tables->nobs == 13 && b.tables->nobs == 13);
  for (size_t k = 0; k < a.tables->nobs; k++)
    for (int axis = 0; axis < 3; axis++) {
      struct um_vec3 x = um_vec3(axis == 0, axis == 1, axis == 2);
      assert_true(distance(um_quat_apply(sample(&a, k).q, x), um_quat_apply(sample(&b, k).q, x)) <=
                  1e-10);
    }
  case_release(&a);
  case_release(&b);
}

/* Tags that are 8 s late show what was 8 s before: a scenario that starts then, in which everything
 * else has its epoch. Binary fractions: the times are the same numbers. */
static void time_tag_shows_what_was_before(void **state)
{
  (void)state;
  static const char *const set[] = {"time.start_utc=2020-03-20T11:59:52Z",
                                    "time.stop_utc=2020-03-20T12:03:52Z", NULL};
  struct case_run a = case_compute(case_spinner, NULL, NULL, set);
  struct case_run b = case_with(case_spinner, "time_tag,shift_s=8");
  assert_int_equal(a.tables->nobs, b.tables->nobs);
  for (size_t k = 0; k < a.tables->nobs; k++)
    assert_true(b.tables->t_obs[k] == a.tables->t_obs[k] + 8.0);
  expect_same_orbit(&a, &b);
  assert_true(case_same(&a, &b));
  case_release(&a);
  case_release(&b);
}

/* Where the orbit has it 3 s later; the attitude in GCRS, whose law knows nothing of the orbit,
 * keeps its time. Without light time, whose microseconds change with the range. */
static void along_track_moves_the_satellite(void **state)
{
  (void)state;
  static const char *const with[] = {"along_track,shift_s=3", NULL}, *const set[] = {
                                                                         "time.light_time=false",
                                                                         NULL};
  struct case_run a = case_compute(case_spinner, NULL, NULL, set);
  struct case_run b = case_compute(case_spinner, with, NULL, set);
  for (size_t k = 0; k < a.tables->nobs; k++) {
    struct um_environment_sample later;
    assert_int_equal(um_model_sample_at(case_context(), a.model, sample(&a, k).t_tai + 3.0, &later),
                     UM_OK);
    assert_true(distance(sample(&b, k).r, later.r) <= 1e-6); /* [m] */
    assert_true(distance(sample(&b, k).r, sample(&a, k).r) >= 22e3);
    assert_memory_equal(&a.tables->sample[k].q, &b.tables->sample[k].q, sizeof(struct um_quat));
  }
  case_release(&a);
  case_release(&b);
}

/* Exposures add in squares: 60^2 + 80^2 = 100^2, of which the roots are exact; so they go down, and
 * none is shorter than 0. */
static void exposure_adds_in_squares(void **state)
{
  (void)state;
  static const char *const sixty[] = {"time.exposure_s=60", NULL},
                           *const hundred[] = {"time.exposure_s=100", NULL},
                           *const with[] = {"exposure,square_s2=6400", NULL},
                           *const less[] = {"exposure,square_s2=-6400", NULL};
  struct case_run e = case_compute(case_spinner, NULL, NULL, sixty);
  struct case_run f = case_compute(case_spinner, less, NULL, hundred);
  struct case_run g = case_compute(case_spinner, less, NULL, sixty);
  struct case_run a = case_compute(case_spinner, NULL, NULL, hundred);
  struct case_run b = case_compute(case_spinner, with, NULL, sixty);
  struct case_run c = case_with(case_spinner, "exposure,square_s2=10000");
  struct case_run d = case_with(case_spinner, NULL);
  assert_true(case_same(&a, &b));
  assert_true(case_same(&a, &c));
  assert_false(case_same(&a, &d));
  assert_int_equal(d.tables->nsub, 1);
  assert_true(case_same(&e, &f));
  for (size_t i = 0; i < g.result->nobs * g.result->nband; i++) /* means of equal instants */
    case_near("no exposure", g.result->irradiance[i], d.result->irradiance[i], 1e-12);
  case_release(&e);
  case_release(&f);
  case_release(&g);
  case_release(&a);
  case_release(&b);
  case_release(&c);
  case_release(&d);
}

/* A Lambert plate that turns about an axis in its plane, lit and seen along one direction, sends
 * cos^2(w t) = (1 + cos(2 w t))/2. Its mean over an exposure T at its maximum is
 *   1/2 + sin(w T) / (2 w T) = 1 - (w T)^2/6 + (w T)^4/60 - ...,
 * of which five instants of equal weight have the quadratic term exactly and the next to 1.4 %,
 * which is 1.5e-5 for 8 s and a sixteenth of that for 4 s. */
static void exposure_flattens_a_maximum(void **state)
{
  (void)state;
  static const char scenario[] =
      "schema: 1\n"
      "name: maximum\n"
      "time: {start_utc: 2020-03-20T12:00:00Z, stop_utc: 2020-03-20T12:00:00Z, step_s: 1,\n"
      "  light_time: false}\n"
      "orbit: {fixed: {position_gcrs_km: [0, 2000000, 0]}}\n"
      "attitude: [{spin: {axis_gcrs: [0, 0, 1], axis_body: [0, 1, 0], period_s: 100}}]\n"
      "observer: {direction: {unit_gcrs: [1, 0, 0], range_km: 1000}}\n"
      "environment: {sun: frozen}\n"
      "parts:\n"
      "  - {name: plate, plate: {size_m: [2, 1]}, front: grey_white, back: grey_white,\n"
      "     lumped: true, shell: {areal_heat_capacity_J_m2_K: 3000}}\n"
      "effects: [{effect: earthshine, off: true}]\n"
      "bands: {vis: {from_um: 0.38, to_um: 0.78, bins: 1}}\n";
  const double w = 2.0 * UM_PI / 100.0, T = 8.0;
  double turn[3], light[3];
  /* the phase at which the front faces +x, from the unsmeared plate */
  struct case_run a = case_with(scenario, NULL);
  struct um_vec3 x = um_quat_apply(um_quat_conjugate(sample(&a, 0).q), um_vec3(0, 0, 1));
  double phase = -atan2(x.y, x.x) / UM_DEG;
  char set_phase[80];
  snprintf(set_phase, sizeof set_phase, "attitude.0.spin.phase_deg=%.12f", phase);
  case_release(&a);
  const char *const set[] = {set_phase, NULL};
  static const char *const with[3] = {"exposure,square_s2=0", "exposure,square_s2=16",
                                      "exposure,square_s2=64"};
  for (int i = 0; i < 3; i++) {
    const char *const list[] = {with[i], NULL};
    struct case_run b = case_compute(scenario, list, NULL, set);
    double t = 0.5 * i * T;
    light[i] = case_intensity(&b, 0, "vis", "grey_white", UM_MECHANISM_SUN);
    turn[i] = i == 0 ? 1.0 : 0.5 + 0.5 * sin(w * t) / (w * t);
    case_release(&b);
  }
  /* the Sun stands 0.1 deg beside +x, which puts the maximum beside the middle: 2e-6 */
  case_near("4 s", light[1] / light[0], turn[1], 4e-6);
  case_near("8 s", light[2] / light[0], turn[2], 2e-5);
  assert_true(turn[2] < 0.985);
}

static void exposures_must_not_overlap(void **state)
{
  (void)state;
  /* 100 s every 60 s */
  case_refused(case_plate, "exposure,square_s2=10000", "exposures that do not overlap");
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(attitude_offset_turns_the_body),
      cmocka_unit_test(spin_period_keeps_the_phase),
      cmocka_unit_test(nutation_follows_the_inertia),
      cmocka_unit_test(spin_period_slows_a_tumble),
      cmocka_unit_test(time_tag_shows_what_was_before),
      cmocka_unit_test(along_track_moves_the_satellite),
      cmocka_unit_test(exposure_adds_in_squares),
      cmocka_unit_test(exposure_flattens_a_maximum),
      cmocka_unit_test(exposures_must_not_overlap),
  };
  return cmocka_run_group_tests(tests, case_begin, case_end);
}
