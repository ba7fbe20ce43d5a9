/* What the Earth sends to plates: view factors and albedo against tables, quadrature and laws. */
#include "check.h"

#include "base/core/constants.h"
#include "environment/environment.h"

static struct um_environment unit_environment(void)
{
  struct um_environment e;
  um_environment_defaults(&e);
  e.albedo = 1.0; /* E/(a S) */
  e.solar_irradiance = 1.0;
  e.outgoing_longwave = 1.0;
  return e;
}

/* Satellite on +x, Sun at `zenith` from it toward +y. */
static struct um_vec3 sun_at(double zenith) { return um_vec3(cos(zenith), sin(zenith), 0.0); }

static struct um_environment_earth_flux flux(const struct um_environment *e, double altitude,
                                             struct um_vec3 sun, struct um_vec3 normal)
{
  struct um_environment_earth_flux out;
  um_environment_earth_flux(e, NULL, um_vec3(UM_EARTH_RADIUS + altitude, 0, 0), sun, UM_AU, &normal,
                            1, &out);
  return out;
}

/* The definition: the ground seen from (h, 0, 0) in Earth radii, area by area over the cap.
 * Midpoints in azimuth and in a map of the central angle that is flat at both ends. */
static void by_areas(double h, struct um_vec3 sun, struct um_vec3 normal, int n,
                     double *view_factor, double *albedo)
{
  double cap = acos(1.0 / h);
  *view_factor = *albedo = 0.0;
  for (int i = 0; i < n; i++) {
    double x = (i + 0.5) / n, psi = cap * x * x * (3.0 - 2.0 * x);
    double dpsi = cap * 6.0 * x * (1.0 - x) / n, dphi = UM_PI / n;
    for (int j = 0; j < 2 * n; j++) {
      double phi = dphi * (j + 0.5);
      struct um_vec3 ground = {cos(psi), sin(psi) * cos(phi), sin(psi) * sin(phi)};
      struct um_vec3 d = um_vec3_sub(ground, um_vec3(h, 0, 0));
      double d2 = um_vec3_dot(d, d), at_plate = um_vec3_dot(d, normal);
      if (at_plate <= 0.0) continue;
      double element =
          -um_vec3_dot(d, ground) * at_plate / (d2 * d2) * sin(psi) * dpsi * dphi / UM_PI;
      *view_factor += element;
      *albedo += element * fmax(um_vec3_dot(ground, sun), 0.0);
    }
  }
}

/* Howell's catalogue, evaluated independently and checked there by 1.3 million points to 2e-6. */
static void view_factor_table(void **state)
{
  (void)state;
  static const double tilt[] = {0, 30, 45, 60, 90, 120, 135, 150};
  static const struct {
    double altitude, plate[8], sphere;
  } row[] = {{400e3,
              {0.885456, 0.771249, 0.660629, 0.537163, 0.288727, 0.094435, 0.034517, 0.004422},
              0.330778},
             {600e3,
              {0.835427, 0.724685, 0.612558, 0.489329, 0.249009, 0.071616, 0.021821, 0.001184},
              0.297162},
             {765e3,
              {0.797278, 0.690707, 0.578861, 0.456749, 0.223367, 0.058110, 0.015101, 0.000244},
              0.274877},
             {800e3,
              {0.789522, 0.683899, 0.572242, 0.450437, 0.218529, 0.055676, 0.013966, 0.000153},
              0.270611},
             {35786e3, {0.022882, 0.019817, 0.016180, 0.011441, 0.000740, 0, 0, 0}, 0.005754}};
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    double h = 1.0 + row[i].altitude / UM_EARTH_RADIUS;
    for (int k = 0; k < 8; k++)
      check_near("plate", um_environment_plate_view_factor(h, tilt[k] * UM_DEG), row[i].plate[k],
                 6e-7);
    check_near("sphere", um_environment_sphere_view_factor(h), row[i].sphere, 6e-7);
  }
}

/* Closed form against areas: 600 x 1200 midpoints resolve 2e-5, mostly at the plate's horizon. */
static void view_factor_is_the_integral(void **state)
{
  (void)state;
  const double altitude[] = {200e3, 765e3, 5000e3, 35786e3};
  for (int i = 0; i < 4; i++)
    for (int k = 0; k <= 6; k++) {
      double h = 1.0 + altitude[i] / UM_EARTH_RADIUS, t = 29.0 * k * UM_DEG, f, unused;
      by_areas(h, um_vec3(0, 0, 1), um_vec3(-cos(t), sin(t), 0), 600, &f, &unused);
      check_near("plate", um_environment_plate_view_factor(h, t), f, 2e-5);
    }
}

/* No jump and no rise with tilt or altitude, 0 to GEO: the slope of F is at most 1 a radian. */
static void view_factor_is_continuous(void **state)
{
  (void)state;
  for (int i = 0; i <= 400; i++) {
    double h = 1.0 + 6e-6 * pow(1.04, i); /* 38 m to 250 000 km */
    double next = 1.0 + 6e-6 * pow(1.04, i + 1), before = 1.0 / (h * h);
    for (int k = 0; k <= 1800; k++) {
      double t = 0.1 * k * UM_DEG, f = um_environment_plate_view_factor(h, t);
      assert_true(f >= 0.0 && f <= 1.0);
      check_below("rise with tilt", f - before, 1e-12);
      check_below("step with tilt", before - f, 0.1 * UM_DEG + 1e-12);
      check_below("rise with altitude", um_environment_plate_view_factor(next, t) - f, 1e-9);
      before = f;
    }
    check_near("180 deg", before, 0.0, 1e-12);
  }
  check_near("on the ground", um_environment_plate_view_factor(1.0, 1.0), 0.5 * (1.0 + cos(1.0)),
             1e-12);
  check_near("on the ground, sphere", um_environment_sphere_view_factor(1.0), 0.5, 1e-15);
}

enum { TILTS = 200, TURNS = 100, NORMALS = TILTS * TURNS };

/* Normals of equal weight: midpoints in the cosine of the tilt and in azimuth. */
static void normals_all_round(struct um_vec3 *normal)
{
  for (int i = 0; i < TILTS; i++)
    for (int j = 0; j < TURNS; j++) {
      double c = -1.0 + 2.0 * (i + 0.5) / TILTS, s = sqrt(1.0 - c * c);
      double phi = 2.0 * UM_PI * (j + 0.5) / TURNS;
      normal[i * TURNS + j] = um_vec3(c, s * cos(phi), s * sin(phi));
    }
}

static double sphere_albedo(const struct um_environment *e, double altitude, struct um_vec3 sun,
                            double *view_factor)
{
  static struct um_vec3 normal[NORMALS];
  static struct um_environment_earth_flux out[NORMALS];
  normals_all_round(normal);
  um_environment_earth_flux(e, NULL, um_vec3(UM_EARTH_RADIUS + altitude, 0, 0), sun, UM_AU, normal,
                            NORMALS, out);
  double sum = 0.0, factor = 0.0;
  for (int i = 0; i < NORMALS; i++) sum += out[i].albedo, factor += out[i].view_factor;
  *view_factor = factor / NORMALS;
  return sum / NORMALS;
}

/* E/(a S) at 765 km by 72 million areas of the cap, good to 2e-8, rows of sub-satellite Sun zenith
 * angle. A table of six digits made independently agrees with these to 2.3e-6. The promise for
 * single plates is 1e-4, for the nadir plate and the mean over normals 2e-5; 1e-6 is what eight
 * nodes do, and midpoints over normals add 2e-6 to the sphere. */
static void albedo_table(void **state)
{
  (void)state;
  static const double row[][4] = {
      {0, 0.27110554, 0.78874193, 0.21947271},  {30, 0.23478428, 0.68307055, 0.20441682},
      {60, 0.13555277, 0.39437097, 0.13458762}, {75, 0.07044877, 0.20466470, 0.08452170},
      {90, 0.01217855, 0.03068494, 0.02869577}, {100, 0.00123956, 0.00242414, 0.00393072},
      {110, 0.00003335, 0.00006057, 0.00011491}};
  static const double independent[][3] = {
      {0.271106, 0.788743, 0.219475}, {0.234785, 0.683071, 0.204418},
      {0.135553, 0.394371, 0.134588}, {0.070449, 0.204664, 0.084522},
      {0.012178, 0.030685, 0.028695}, {0.001239, 0.002424, 0.003930},
      {0.000033, 0.000060, 0.000114}};
  struct um_environment e = unit_environment();
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    struct um_vec3 sun = sun_at(row[i][0] * UM_DEG);
    double f, sphere = sphere_albedo(&e, 765e3, sun, &f);
    double nadir = flux(&e, 765e3, sun, um_vec3(-1, 0, 0)).albedo;
    double horizon = flux(&e, 765e3, sun, um_vec3(0, 1, 0)).albedo;
    check_near("sphere", sphere, row[i][1], 3e-6);
    check_near("nadir plate", nadir, row[i][2], 3e-8);
    check_near("horizon plate", horizon, row[i][3], 1e-6);
    check_near("sphere, independent", sphere, independent[i][0], 4e-6);
    check_near("nadir plate, independent", nadir, independent[i][1], 3e-6);
    check_near("horizon plate, independent", horizon, independent[i][2], 3e-6);
    check_near("mean view factor", f,
               um_environment_sphere_view_factor(1.0 + 765e3 / UM_EARTH_RADIUS), 4e-6);
  }
}

/* While the whole cap is lit, E = cos(SZA) times one integral across the rings, by Simpson to
 * 1e-12: nadir 2 int cos(psi) cos(theta) sin(theta) dtheta, with theta = asin(1/h) (1 - s^2) to
 * tame the limb. 1e-9 is 2e4 times better than promised: this plate and the sphere carry the heat
 * balance. */
static void albedo_of_a_lit_cap_is_elementary(void **state)
{
  (void)state;
  struct um_environment e = unit_environment();
  const double altitude[] = {200e3, 765e3, 35786e3};
  for (int i = 0; i < 3; i++) {
    double h = 1.0 + altitude[i] / UM_EARTH_RADIUS, limb = asin(1.0 / h), sum = 0.0;
    const int n = 20000;
    for (int k = 0; k <= n; k++) {
      double s = (double)k / n, t = limb * (1.0 - s * s), g = fmin(h * sin(t), 1.0);
      double psi = asin(g) - t;
      double f = 2.0 * cos(psi) * cos(t) * sin(t) * 2.0 * limb * s;
      sum += f * (k == 0 || k == n ? 1.0 : k % 2 ? 4.0 : 2.0) / (3.0 * n);
    }
    double zenith = 0.9 * (0.5 * UM_PI - acos(1.0 / h)); /* all of the cap is in daylight */
    for (int k = 0; k < 2; k++)
      check_near("nadir", flux(&e, altitude[i], sun_at(k * zenith), um_vec3(-1, 0, 0)).albedo,
                 sum * cos(k * zenith), 1e-9);
  }
}

/* Any plate, any Sun, against areas; in units of the view factor of a nadir plate, 3e-5: from 200
 * km the areas themselves are good to 1e-5. The promise is 1e-4. */
static void albedo_is_the_integral(void **state)
{
  (void)state;
  struct um_environment e = unit_environment();
  const double altitude[] = {200e3, 765e3, 1500e3, 35786e3};
  double worst = 0.0;
  for (int i = 0; i < 60; i++) {
    double z = 0.042 * i, c = cos(2.3 * i), s = sqrt(1.0 - c * c), turn = 1.7 * i; /* all over */
    double h = 1.0 + altitude[i % 4] / UM_EARTH_RADIUS, f, a;
    struct um_vec3 sun = um_vec3(cos(z), sin(z) * cos(0.4 * i), sin(z) * sin(0.4 * i));
    struct um_vec3 normal = um_vec3(c, s * cos(turn), s * sin(turn));
    struct um_environment_earth_flux out = flux(&e, altitude[i % 4], sun, normal);
    by_areas(h, sun, normal, 500, &f, &a);
    double error = fabs(out.albedo - a) * h * h;
    worst = fmax(worst, error);
    check_below("albedo against areas", error, 3e-5);
    check_below("view factor against areas", fabs(out.view_factor - f) * h * h, 3e-5);
    assert_true(out.planet == out.view_factor);
  }
  print_message("largest difference from areas %.1e of the nadir view factor\n", worst);
}

/* Earth's light on a plate as a share of the Sun's, albedo 0.3, 765 km: 0.2366, 9.2e-3, 7.3e-4 at
 * SZA 0, 90, 100 deg (printed digits). */
static void earthshine_shares(void **state)
{
  (void)state;
  struct um_environment e = unit_environment();
  e.albedo = 0.3;
  const struct um_vec3 nadir = {-1, 0, 0};
  check_near("0 deg", flux(&e, 765e3, sun_at(0.0), nadir).albedo, 0.2366, 5e-5);
  check_near("90 deg", flux(&e, 765e3, sun_at(90 * UM_DEG), nadir).albedo, 9.2e-3, 5e-5);
  check_near("100 deg", flux(&e, 765e3, sun_at(100 * UM_DEG), nadir).albedo, 7.3e-4, 5e-6);
}

/* The albedo knows nothing of the satellite's own eclipse: the lit Earth is seen beyond the sub-
 * satellite terminator (SZA 90-116.7 deg at 765 km), and whether the satellite itself is in shadow
 * does not matter. Beyond 90 deg + acos(R/r) it is exactly 0. */
static void albedo_acts_after_sunset(void **state)
{
  (void)state;
  struct um_environment e = unit_environment();
  const struct um_vec3 horizon = {0, 1, 0};
  const struct um_vec3 r = {UM_EARTH_RADIUS + 765e3, 0, 0};
  for (int z = 90; z < 117; z++)
    assert_true(flux(&e, 765e3, sun_at(z * UM_DEG), horizon).albedo > 0.0 || z > 116);
  assert_true(flux(&e, 765e3, sun_at(117 * UM_DEG), horizon).albedo == 0.0);
  e.shadow_radius = 7.0e6; /* a taller shadow: dark at 110 deg already */
  struct um_vec3 sun = sun_at(110 * UM_DEG);
  assert_true(um_environment_sunlit_fraction(&e, r, sun, UM_AU, um_vec3(0, 0, 1)) == 0.0);
  check_near("in shadow", flux(&e, 765e3, sun, horizon).albedo, 0.000115, 1e-6);
  e.albedo_on = e.planet_on = false; /* switches are the caller's */
  check_near("switched off", flux(&e, 765e3, sun, horizon).albedo, 0.000115, 1e-6);
}

/* No jump as the plate turns or the Sun sets: the flux of the definition has slopes of at most
 * F_nadir a radian and more in the plate's tilt, and of the same in the Sun's angle. */
static void albedo_is_continuous(void **state)
{
  (void)state;
  struct um_environment e = unit_environment();
  const double altitude[] = {200e3, 765e3, 35786e3};
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 12; k++) {
      double h = 1.0 + altitude[i] / UM_EARTH_RADIUS, step = 0.1 * UM_DEG;
      double bound = step / h * 1.01 + 1e-7, before = NAN; /* |V| is at most 1/h here */
      for (int j = 0; j <= 3600; j++) { /* a plate turning about an inclined axis */
        double t = step * j;
        struct um_vec3 n = um_vec3(cos(t), sin(t) * cos(0.5), sin(t) * sin(0.5));
        double a = flux(&e, altitude[i], sun_at(0.2 * k), n).albedo;
        assert_true(a >= 0.0);
        if (j > 0) check_below("step with tilt", fabs(a - before), bound);
        before = a;
      }
      for (int j = 0; j <= 1800; j++) { /* the Sun setting */
        double t = 0.5 * k;
        struct um_vec3 n = um_vec3(-cos(t), sin(t) * cos(0.5), sin(t) * sin(0.5));
        double a = flux(&e, altitude[i], sun_at(step * j), n).albedo;
        if (j > 0) check_below("step with the Sun", fabs(a - before), bound);
        before = a;
      }
    }
}

/* E(n) - E(-n) is linear in n: three axes give every other plate. It is not how the far half is
 * computed for tilts beyond 90 deg, so it ties both halves together. */
static void front_minus_back_is_a_vector(void **state)
{
  (void)state;
  struct um_environment e = unit_environment();
  struct um_vec3 sun = um_vec3_unit(um_vec3(0.2, 0.7, -0.5));
  double v[3];
  for (int k = 0; k < 3; k++) {
    struct um_vec3 n = um_vec3(k == 0, k == 1, k == 2);
    v[k] = flux(&e, 765e3, sun, n).albedo - flux(&e, 765e3, sun, um_vec3_scale(n, -1.0)).albedo;
  }
  for (int k = 0; k < 50; k++) {
    struct um_vec3 n = um_vec3_unit(um_vec3(sin(1.0 + 3 * k), sin(2.0 + 5 * k), sin(3.0 + 7 * k)));
    double both =
        flux(&e, 765e3, sun, n).albedo - flux(&e, 765e3, sun, um_vec3_scale(n, -1.0)).albedo;
    check_near("vector", both, v[0] * n.x + v[1] * n.y + v[2] * n.z, 2e-6);
  }
}

/* Radiation scales as it should, the frame does not matter, and NaN comes out as NaN. */
static void scaling_rotation_and_nan(void **state)
{
  (void)state;
  struct um_environment e;
  um_environment_defaults(&e);
  struct um_vec3 sun = um_vec3_unit(um_vec3(0.5, 0.6, 0.3)),
                 n = um_vec3_unit(um_vec3(-0.3, 0.8, 0.5));
  struct um_environment unit = unit_environment();
  struct um_environment_earth_flux a = flux(&unit, 765e3, sun, n), b = flux(&e, 765e3, sun, n), c;
  check_near("albedo", b.albedo, 0.3 * 1361.0 * a.albedo, 1e-9);
  check_near("planet", b.planet, 237.0 * a.view_factor, 1e-9);
  struct um_quat q = um_quat_normalize((struct um_quat){0.3, -0.5, 0.7, 0.4});
  struct um_vec3 turned = um_quat_apply(q, n);
  um_environment_earth_flux(&unit, NULL, um_quat_apply(q, um_vec3(UM_EARTH_RADIUS + 765e3, 0, 0)),
                            um_quat_apply(q, sun), 2.0 * UM_AU, &turned, 1, &c);
  check_near("turned, at 2 au", c.albedo, 0.25 * a.albedo, 1e-13);
  check_near("turned", c.view_factor, a.view_factor, 1e-13);
  assert_true(isnan(flux(&unit, 765e3, sun, um_vec3(NAN, 0, 0)).albedo));
  assert_true(isnan(flux(&unit, 765e3, um_vec3(NAN, 0, 0), n).albedo));
  assert_true(isnan(flux(&unit, NAN, sun, n).albedo));
  assert_true(isnan(flux(&unit, NAN, sun, n).planet));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(view_factor_table),
      cmocka_unit_test(view_factor_is_the_integral),
      cmocka_unit_test(view_factor_is_continuous),
      cmocka_unit_test(albedo_table),
      cmocka_unit_test(albedo_of_a_lit_cap_is_elementary),
      cmocka_unit_test(albedo_is_the_integral),
      cmocka_unit_test(earthshine_shares),
      cmocka_unit_test(albedo_acts_after_sunset),
      cmocka_unit_test(albedo_is_continuous),
      cmocka_unit_test(front_minus_back_is_a_vector),
      cmocka_unit_test(scaling_rotation_and_nan),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
