/* scenarios/sphere: an isothermal grey Lambert sphere through the shadow, seen from a fixed
 * direction.
 *
 *            observer
 *            /  gamma
 *      sphere ------------> Sun
 *
 *   C dT/dt = alpha (S/4 nu + albedo) + eps OLR F - eps sigma T^4        per area of the sphere
 *   I_vis = E_vis rho r^2 p(gamma),  p = 2/(3 pi) (sin gamma + (pi - gamma) cos gamma)
 *   I_lwir = eps pi r^2 int B dlambda
 *
 * The temperatures expected were computed apart from this program: albedo by Gauss quadrature of
 * the visible cap (32 x 96 points), Runge-Kutta of order 4 with 5500 steps an orbit from edge to
 * edge, six orbits, after which the state repeats to 1e-9 K. The two extremes are also in Umbra's
 * list of cases: 299.527 and 230.836 K. */
#include "tests/scenarios/support.h"

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "model/build/bands.h"

#define SCENARIO UMBRA_SOURCE_DIR "/scenarios/sphere"
#define TEXTS(...)                                                                                 \
  (const char *const[]){__VA_ARGS__}, sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *)

/* Quadratic through three points at t[0..2], at t. */
static double parabola(const double *t, const double *y, double at)
{
  double sum = 0.0;
  for (int i = 0; i < 3; i++) {
    double l = y[i];
    for (int j = 0; j < 3; j++)
      if (j != i) l *= (at - t[j]) / (t[i] - t[j]);
    sum += l;
  }
  return sum;
}

/* Temperature at an edge of the shadow, from the three observations before it [K]. */
static double before(const struct support_run *run, const double *temperature,
                     enum um_environment_event_kind kind)
{
  for (size_t e = 0; e < run->tables->nevent; e++) {
    double edge = run->tables->event[e].t_tai - run->tables->t_obs[0];
    if (run->tables->event[e].kind != kind || edge < 0.0) continue;
    size_t k = 3;
    while (k < run->result->nobs && support_time(run, k) < edge) k++;
    double t[3] = {support_time(run, k - 3), support_time(run, k - 2), support_time(run, k - 1)};
    return parabola(t, temperature + k - 3, edge);
  }
  fail_msg("no such event");
  return NAN;
}

/* 5 mK: the mesh, whose projected area depends on the direction, may take 1e-4 of the sunlight. */
static void temperatures(void **state)
{
  (void)state;
  struct support_run run;
  /* 600 steps are one orbit of 6008.2010 s, 2 pi sqrt(a^3/mu) */
  support_compute(SCENARIO,
                  TEXTS("time.step_s=10.0136682577", "time.stop_utc=2016-03-20T06:10:08.3Z"), &run);
  assert_int_equal(run.result->nobs, 601);
  const double *temperature = support_temperature(&run, "sphere");
  size_t top = 1;
  double mean = 0.0;
  for (size_t k = 0; k + 1 < run.result->nobs; k++) {
    if (temperature[k] > temperature[top]) top = k;
    mean += 0.5 * (temperature[k] + temperature[k + 1]) / 600.0;
  }
  double a = temperature[top - 1], b = temperature[top], c = temperature[top + 1];
  double highest = b + (a - c) * (a - c) / (8.0 * (2.0 * b - a - c));
  double entry = before(&run, temperature, UM_EVENT_HALF_ENTRY);
  double exit = before(&run, temperature, UM_EVENT_HALF_EXIT);
  print_message("highest %.4f, entry %.4f, exit %.4f, mean %.4f, drift %.1e K, audit %.1e\n",
                highest, entry, exit, mean, temperature[600] - temperature[0],
                run.result->audit_error);
  support_close("highest [K]", highest, 299.5270, 5e-3);
  support_close("at entry [K]", entry, 295.5239, 5e-3);
  support_close("lowest, at exit [K]", exit, 230.8364, 5e-3);
  support_close("mean [K]", mean, 271.5246, 5e-3);
  support_close("drift [K]", temperature[600] - temperature[0], 0.0, 1e-3);
  support_close("energy audit", run.result->audit_error, 0.0, 1e-6);
  support_release(&run);
}

static double lambert_sphere(double gamma)
{
  return 2.0 / (3.0 * UM_PI) * (sin(gamma) + (UM_PI - gamma) * cos(gamma));
}

/* Largest errors of p(gamma), relative to p(0), and of the emitted intensity, relative. */
static void curve_errors(const char *facet_size, double *vis, double *lwir, double *noise)
{
  static const int degrees[] = {0, 30, 60, 90, 120, 150};
  *vis = *lwir = *noise = 0.0;
  for (size_t i = 0; i < sizeof degrees / sizeof degrees[0]; i++) {
    char direction[96];
    double gamma = degrees[i] * UM_DEG;
    snprintf(direction, sizeof direction, "observer.direction.unit_gcrs=[%.12f, %.12f, 0]",
             cos(gamma), sin(gamma));
    struct support_run run;
    support_compute(SCENARIO,
                    TEXTS(direction, facet_size, "thermal.start=isothermal",
                          "thermal.orbits_before=0", "time.stop_utc=2016-03-20T04:30:10Z"),
                    &run);
    const struct um_model_result *r = run.result;
    size_t b_vis = um_model_band_find(run.model, "vis"), b = um_model_band_find(run.model, "lwir");
    const struct um_environment_sample *s = &run.tables->sample[0];
    double e = um_environment_solar_band(&run.model->environment, 0.38e-6, 0.78e-6);
    double p = r->intensity[b_vis * UM_MECHANISM_COUNT + UM_MECHANISM_SUN] / (e * 0.2);
    double expected = lambert_sphere(um_vec3_angle(s->sun, s->to_observer));
    *vis = fmax(*vis, fabs(p - expected) / (2.0 / 3.0));
    double emitted = r->intensity[b * UM_MECHANISM_COUNT + UM_MECHANISM_EMITTED];
    double temperature = support_temperature(&run, "sphere")[0];
    double black = 0.8 * UM_PI * um_core_planck_band(8e-6, 12e-6, temperature);
    *lwir = fmax(*lwir, fabs(emitted / black - 1.0));
    *noise = fmax(*noise, r->standard_error[b_vis] / (e * 0.2) / (2.0 / 3.0));
    print_message("%s gamma %3d: p %.6f, sphere %.6f (%+.3f %% of p(0)); emitted %+.4f %%\n",
                  facet_size, degrees[i], p, expected, 150.0 * (p - expected),
                  100.0 * (emitted / black - 1.0));
    support_release(&run);
  }
}

/* A convex body shadows no part of a facet, so that there is no Monte-Carlo error; the mesh's falls
 * with the square of the facet size. Its size: flat facets turn normals by up to h/2r = 0.08, and
 * the light of a facet with them by up to h^2/4r^2 = 0.6 % at second order; the facets' mean of it
 * is ten times less. */
static void light_curves(void **state)
{
  (void)state;
  double vis[2], lwir[2], noise[2];
  curve_errors("parts.sphere.facet_size_m=0.32", &vis[0], &lwir[0], &noise[0]);
  curve_errors("parts.sphere.facet_size_m=0.16", &vis[1], &lwir[1], &noise[1]);
  support_close("Monte-Carlo error", noise[1], 0.0, 1e-12);
  support_close("p(gamma), of p(0)", vis[1], 0.0, 6e-4);
  support_close("emitted, relative", lwir[1], 0.0, 8e-4);
  support_close("order of p(gamma)", log2(vis[0] / vis[1]), 2.0, 0.2);
  support_close("order of the emitted light", log2(lwir[0] / lwir[1]), 2.0, 0.2);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(temperatures),
                                     cmocka_unit_test(light_curves)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
