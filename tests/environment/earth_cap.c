/* The visible cap as directions: what it must add up to. */
#include "check.h"

#include "base/core/constants.h"
#include "environment/environment.h"

static size_t cap_at(double altitude, struct um_vec3 sun, struct um_environment_cap_point *cap,
                     struct um_environment *e)
{
  um_environment_defaults(e);
  return um_environment_earth_cap(e, NULL, um_vec3(UM_EARTH_RADIUS + altitude, 0, 0), sun, UM_AU,
                                  cap);
}

/* 2 pi (1 - sqrt(1 - R^2/r^2)); every direction points at the Earth. */
static void solid_angle_is_exact(void **state)
{
  (void)state;
  const double altitude[] = {100.0, 200e3, 765e3, 35786e3};
  for (int i = 0; i < 4; i++) {
    struct um_environment e;
    struct um_environment_cap_point cap[UM_EARTH_CAP_POINTS];
    size_t n = cap_at(altitude[i], um_vec3(0.6, 0.8, 0.0), cap, &e);
    assert_true(n > 0 && n <= UM_EARTH_CAP_POINTS);
    double x = UM_EARTH_RADIUS / (UM_EARTH_RADIUS + altitude[i]), sum = 0.0;
    for (size_t k = 0; k < n; k++) {
      sum += cap[k].solid_angle;
      check_near("unit", um_vec3_norm(cap[k].direction), 1.0, 1e-14);
      assert_true(-cap[k].direction.x > sqrt(1.0 - x * x) && cap[k].albedo_radiance >= 0.0);
      check_near("planet", cap[k].planet_radiance, 237.0 / UM_PI, 1e-12);
    }
    check_near("relative", sum / (2.0 * UM_PI * (1.0 - sqrt(1.0 - x * x))), 1.0, 1e-12);
  }
}

/* Sums over the directions against the integrals, plates all round, day, terminator and night: 1 %
 * of what a nadir plate gets at the same place, in planet radiation and in albedo by overhead Sun.
 */
static void sums_reproduce_the_flux(void **state)
{
  (void)state;
  const double altitude[] = {200e3, 765e3, 1500e3, 35786e3};
  double worst_albedo = 0.0, worst_planet = 0.0;
  for (int i = 0; i < 4; i++)
    for (int z = 0; z <= 180; z += 10) {
      struct um_environment e;
      struct um_environment_cap_point cap[UM_EARTH_CAP_POINTS];
      struct um_vec3 r = um_vec3(UM_EARTH_RADIUS + altitude[i], 0, 0);
      struct um_vec3 sun = um_vec3(cos(z * UM_DEG), sin(z * UM_DEG), 0);
      size_t n = cap_at(altitude[i], sun, cap, &e);
      double h = r.x / UM_EARTH_RADIUS, planet = 237.0 / (h * h), albedo = 0.3 * 1361.0 / (h * h);
      for (int k = 0; k < 200; k++) {
        struct um_vec3 normal =
            um_vec3_unit(um_vec3(sin(1.0 + 3 * k), sin(2.0 + 5 * k), sin(3.0 + 7 * k)));
        struct um_environment_earth_flux flux;
        um_environment_earth_flux(&e, NULL, r, sun, UM_AU, &normal, 1, &flux);
        double a = 0.0, p = 0.0;
        for (size_t j = 0; j < n; j++) {
          double c = fmax(um_vec3_dot(cap[j].direction, normal), 0.0) * cap[j].solid_angle;
          a += c * cap[j].albedo_radiance;
          p += c * cap[j].planet_radiance;
        }
        worst_albedo = fmax(worst_albedo, fabs(a - flux.albedo) / albedo);
        worst_planet = fmax(worst_planet, fabs(p - flux.planet) / planet);
      }
    }
  print_message("largest differences: albedo %.1e, planet %.1e\n", worst_albedo, worst_planet);
  check_below("albedo", worst_albedo, 0.01);
  check_below("planet", worst_planet, 0.01);
}

/* All reflected light together is what a sphere gets, per area E/(a S) = sum of L dOmega / (4 a S),
 * to 1 % of itself even where the terminator leaves a sliver. Values: environment/earth. */
static void total_light_is_kept(void **state)
{
  (void)state;
  static const double row[][2] = {{0, 0.27110554},  {30, 0.23478428}, {60, 0.13555277},
                                  {75, 0.07044877}, {90, 0.01217855}, {100, 0.00123956}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    struct um_environment e;
    struct um_environment_cap_point cap[UM_EARTH_CAP_POINTS];
    double z = row[i][0] * UM_DEG, sum = 0.0;
    size_t n = cap_at(765e3, um_vec3(cos(z), sin(z), 0), cap, &e);
    for (size_t k = 0; k < n; k++) sum += cap[k].albedo_radiance * cap[k].solid_angle;
    check_near("relative", sum / (4.0 * e.albedo * e.solar_irradiance * row[i][1]), 1.0, 0.01);
  }
}

/* Dark where the whole cap is in night. */
static void night_is_dark(void **state)
{
  (void)state;
  struct um_environment e;
  struct um_environment_cap_point cap[UM_EARTH_CAP_POINTS];
  size_t n = cap_at(765e3, um_vec3(cos(2.05), sin(2.05), 0), cap, &e); /* 117.5 deg */
  for (size_t k = 0; k < n; k++) assert_true(cap[k].albedo_radiance == 0.0);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(solid_angle_is_exact),
      cmocka_unit_test(sums_reproduce_the_flux),
      cmocka_unit_test(total_light_is_kept),
      cmocka_unit_test(night_is_dark),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
