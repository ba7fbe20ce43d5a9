/* An isothermal sphere on a circular orbit, h 765 km, beta 0, alpha = eps = 0.8, 4860 J/m2/K, S
 * 1361, albedo 0.3, Earth IR 237 W/m2, cylindrical shadow: traced loads, periodic start, one orbit.
 *
 * docs/physics/conduction.md, for a load code with the albedo of the visible cap: T_max 299.527 K,
 * T_min 230.836 K at the exit from shadow. The facets' projected area differs from that of the
 * sphere by up to 0.1 % with direction (Cauchy: none on average), which is 0.02 to 0.03 K here;
 * 0.05 K allowed. */
#include "tests/thermal/body_help.h"
#include "thermal/loads/loads.h"

#define SAMPLES 720

static int ascending(const void *a, const void *b)
{
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static void test_sphere(void **state)
{
  (void)state;
  static struct um_environment_sample sample[SAMPLES];
  static double t[SAMPLES];
  struct um_environment environment;
  um_environment_defaults(&environment);
  environment.solar_irradiance = 1361.0;
  environment.albedo = 0.3;
  environment.outgoing_longwave = 237.0;
  environment.earth_radius = environment.shadow_radius = UM_EARTH_RADIUS;
  environment.shadow = UM_SHADOW_CYLINDER;
  environment.disc = UM_DISC_POINT;
  double a = UM_EARTH_RADIUS + 765e3, period = 2.0 * UM_PI * sqrt(a * a * a / UM_EARTH_GM);
  double half = asin(UM_EARTH_RADIUS / a) / (2.0 * UM_PI);
  double edge[2] = {period * (0.5 - half), period * (0.5 + half)};
  size_t n = 0;
  for (int k = 0; k <= 600; k++) t[n++] = k * period / 600.0;
  for (int e = 0; e < 2; e++) {
    t[n++] = edge[e] - 1e-3;
    t[n++] = edge[e] + 1e-3;
  }
  qsort(t, n, sizeof t[0], ascending);
  for (size_t k = 0; k < n; k++) {
    double u = 2.0 * UM_PI * t[k] / period;
    sample[k] =
        (struct um_environment_sample){.t_tai = t[k],
                                       .r = {a * cos(u), 0.6 * a * sin(u), 0.8 * a * sin(u)},
                                       .sun = {1, 0, 0},
                                       .sun_distance = UM_AU,
                                       .pole = {0, 0, 1},
                                       .q = {1, 0, 0, 0}};
    sample[k].sunlit_fraction = um_environment_sunlit_fraction(
        &environment, sample[k].r, sample[k].sun, UM_AU, sample[k].pole);
    /* turning: the mean over directions is the sphere's */
    sample[k].q = um_quat_from_axis(um_vec3_unit(um_vec3(1, 2, 3)), 0.37 * (double)k);
  }
  struct help_satellite s = {0};
  help_part(&s, "ball", UM_SHAPE_SPHERE, NULL);
  s.shape[0].radius = 1.0;
  s.shape[0].facet_size = 0.2;
  s.spec[0].kind = UM_THERMAL_LUMPED;
  s.spec[0].start_temperature = 280.0;
  s.group[0].absorptance_front = s.group[0].emittance_front = 0.8;
  help_build(&s, NULL, 0);
  struct um_irradiation_loads *loads = NULL;
  OK(um_irradiation_loads_trace(help_context, s.geometry, &environment, sample, n, edge, 2, 16,
                                &loads));
  struct um_thermal_solve_options options = help_options(1e-8, 1e-7, 0.0);
  double start = 0.0, drift = NAN, low = INFINITY, high = 0.0, low_at = 0.0, high_at = 0.0;
  OK(um_thermal_solve_periodic(help_context, s.body->network, loads, &options, NULL, 0.0, period,
                               1e-4, &start, &drift));
  struct um_thermal_history *history = NULL;
  OK(um_thermal_solve(help_context, s.body->network, loads, &options, &start, 0.0, t, n, &history));
  for (size_t k = 0; k < n; k++) {
    double value = history->temperature[k];
    if (value < low) {
      low = value;
      low_at = t[k] / period;
    }
    if (value > high) {
      high = value;
      high_at = t[k] / period;
    }
  }
  print_message("sphere: max %.3f K (299.527) at %.4f, min %.3f K (230.836) at %.4f of the orbit, "
                "drift %.1e K\n",
                high, high_at, low, low_at, drift);
  NEAR("largest", high, 299.527, 0.05);
  NEAR("smallest", low, 230.836, 0.05);
  NEAR("smallest at the exit", low_at, 0.5 + half, 1e-4);
  um_thermal_history_destroy(help_context, &history);
  um_irradiation_loads_destroy(help_context, &loads);
  help_end(&s);
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_sphere)};
  return cmocka_run_group_tests(tests, help_setup, help_teardown);
}
