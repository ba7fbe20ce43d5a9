/* By which angles the Earth's light arrives: angular moments against areas of the cap, laws of
 * isotropic light, and what a Schlick surface absorbs. */
#include "check.h"

#include "base/core/constants.h"
#include "environment/environment.h"
#include "environment/ground_view.h"

#define MOMENTS UM_ANGULAR_MOMENTS
#define NODES   65

/* Sums over areas of the cap, as in tests/environment/earth.c: value[0] of a plate's heat, the
 * others weighted with the polynomials. */
struct sums {
  double planet[MOMENTS + 1], albedo[MOMENTS + 1];
};

static void by_areas(const struct um_environment_ground_view *ground, struct um_vec3 up, double h,
                     struct um_vec3 sun, double irradiance, struct um_vec3 normal, int n,
                     struct sums *out)
{
  struct um_vec3 x, y;
  double cap = acos(1.0 / h);
  um_core_vec3_frame(up, &x, &y);
  *out = (struct sums){{0.0}, {0.0}};
  for (int i = 0; i < n; i++) {
    double u = (i + 0.5) / n, psi = cap * u * u * (3.0 - 2.0 * u);
    double dpsi = cap * 6.0 * u * (1.0 - u) / n, dphi = UM_PI / n;
    for (int j = 0; j < 2 * n; j++) {
      double phi = dphi * (j + 0.5), s = sin(psi);
      struct um_vec3 at =
          um_vec3_axpy(um_vec3_axpy(um_vec3_scale(up, cos(psi)), s * cos(phi), x), s * sin(phi), y);
      struct um_vec3 d = um_vec3_axpy(at, -h, up);
      double d2 = um_vec3_dot(d, d), at_plate = um_vec3_dot(d, normal);
      if (at_plate <= 0.0) continue;
      double element = -um_vec3_dot(d, at) * at_plate / (d2 * d2) * s * dpsi * dphi / UM_PI;
      struct um_environment_ground g = um_environment_ground_at(ground, at);
      double p[MOMENTS + 1] = {1.0};
      um_environment_angular_polynomials(at_plate / sqrt(d2), p + 1);
      double lit = g.albedo * irradiance * fmax(um_vec3_dot(at, sun), 0.0);
      for (int k = 0; k <= MOMENTS; k++) {
        out->planet[k] += element * g.longwave * p[k];
        out->albedo[k] += element * lit * p[k];
      }
    }
  }
}

static void near_areas(const struct um_environment *e, const struct um_environment_globe *globe,
                       double altitude, double zenith, double tilt, double turn, double tolerance)
{
  double h = 1.0 + altitude / e->earth_radius;
  double irradiance = um_environment_solar_irradiance(e, UM_AU);
  struct um_vec3 up = um_vec3_unit(um_vec3(0.8, 0.3, 0.5)), x, y;
  um_core_vec3_frame(up, &x, &y);
  struct um_vec3 sun = um_vec3_axpy(um_vec3_scale(up, cos(zenith)), sin(zenith), x);
  struct um_vec3 level = um_vec3_axpy(um_vec3_scale(x, cos(turn)), sin(turn), y);
  struct um_vec3 normal = um_vec3_axpy(um_vec3_scale(up, -cos(tilt)), sin(tilt), level);
  struct um_vec3 r = um_vec3_scale(up, h * e->earth_radius);
  struct um_environment_ground_view ground = um_environment_ground_view(e, globe, UM_AU);
  struct um_environment_earth_flux flux;
  struct um_environment_earth_moments m;
  struct sums sums;
  um_environment_earth_flux_by_angle(e, globe, r, sun, UM_AU, &normal, 1, &flux, &m);
  by_areas(&ground, up, h, sun, irradiance, normal, 400, &sums);
  double facing = um_environment_plate_view_factor(h, 0.0); /* of a plate that faces the Earth */
  for (int k = 0; k < MOMENTS; k++) {
    char what[128];
    (void)snprintf(what, sizeof what, "E_%d, h %.0f km, Sun at %.0f, plate at %.0f, %.0f deg",
                   k + 1, altitude / 1e3, zenith / UM_DEG, tilt / UM_DEG, turn / UM_DEG);
    check_near(what, m.planet[k] / e->outgoing_longwave, sums.planet[k + 1] / e->outgoing_longwave,
               tolerance * facing);
    check_near(what, m.albedo[k] / (e->albedo * irradiance),
               sums.albedo[k + 1] / (e->albedo * irradiance), tolerance * facing);
  }
}

/* The areas are good to 4e-5, which is what they move by from 400 to 1000 of them across. Where the
 * terminator crosses the cap, rings meet it like a power 3/2. */
static void moments_are_those_of_areas(void **state)
{
  (void)state;
  static const double altitude[] = {200e3, 765e3, 2000e3, 35786e3};
  static const double zenith[] = {0, 40, 75, 90, 110}, turn[] = {0, 110};
  struct um_environment e;
  um_environment_defaults(&e);
  for (size_t a = 0; a < sizeof altitude / sizeof altitude[0]; a++) {
    double cap = acos(1.0 / (1.0 + altitude[a] / e.earth_radius));
    for (size_t z = 0; z < sizeof zenith / sizeof zenith[0]; z++)
      for (size_t t = 0; t < sizeof turn / sizeof turn[0]; t++)
        for (int tilt = 0; tilt <= 165; tilt += 15)
          near_areas(&e, NULL, altitude[a], zenith[z] * UM_DEG, tilt * UM_DEG, turn[t] * UM_DEG,
                     fabs(zenith[z] * UM_DEG - 0.5 * UM_PI) > cap ? 7e-5
                     : altitude[a] < 1e7                          ? 2e-4
                                                                  : 1e-3);
  }
}

/* Knocke's Earth, in whose bands of latitude albedo and exitance differ, by 512 cells of the cap.
 */
static void so_are_those_of_an_earth_that_varies(void **state)
{
  (void)state;
  const struct um_environment_globe globe = {
      .t_tai = 6107.5 * 86400.0, .pole = {0, 0, 1}, .greenwich = {1, 0, 0}};
  struct um_environment e;
  um_environment_defaults(&e);
  e.earth = UM_EARTH_KNOCKE;
  e.earth_spectrum_on = false;
  for (int zenith = 0; zenith <= 60; zenith += 30)
    for (int tilt = 0; tilt <= 150; tilt += 30)
      near_areas(&e, &globe, 765e3, zenith * UM_DEG, tilt * UM_DEG, 0.7, 5e-4);
}

/* Close above the ground the Earth fills half of the sky: what it emits comes from all sides, and a
 * plate that faces it has no moment but E_0. */
static void isotropic_light_has_none(void **state)
{
  (void)state;
  struct um_environment e;
  um_environment_defaults(&e);
  struct um_vec3 down = {-1, 0, 0};
  struct um_environment_earth_flux flux;
  struct um_environment_earth_moments m;
  um_environment_earth_flux_by_angle(&e, NULL, um_vec3(e.earth_radius, 0, 0), um_vec3(1, 0, 0),
                                     UM_AU, &down, 1, &flux, &m);
  check_near("irradiance", flux.planet / e.outgoing_longwave, 1.0, 1e-9);
  for (int k = 0; k < MOMENTS; k++)
    check_near("moment", m.planet[k] / e.outgoing_longwave, 0.0, 1e-6);
}

/* alpha = 1 - (1 - u)^3 is of degree 3 in u and so comes back number for number; of light from all
 * sides is absorbed 1 - 4 int (1 - u)^3 u^3 du = 34/35. */
static void a_polynomial_comes_back(void **state)
{
  (void)state;
  double value[NODES], a[MOMENTS], p[MOMENTS];
  for (int i = 0; i < NODES; i++) value[i] = 1.0 - pow(1.0 - i / (NODES - 1.0), 3.0);
  um_environment_angular_project(value, NODES, a);
  for (double c = 0.0; c <= 1.0; c += 0.125) {
    double sum = 34.0 / 35.0;
    um_environment_angular_polynomials(c, p);
    for (int k = 0; k < MOMENTS; k++) sum += a[k] * p[k];
    check_near("absorptance", sum, 1.0 - pow(1.0 - sqrt(c), 3.0), 5e-5);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {cmocka_unit_test(moments_are_those_of_areas),
                                     cmocka_unit_test(so_are_those_of_an_earth_that_varies),
                                     cmocka_unit_test(isotropic_light_has_none),
                                     cmocka_unit_test(a_polynomial_comes_back)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
