/* The Earth in front of the Sun: published cases, rays, and what must be exact.
 *
 *            Sun          theta = angle of the satellite from the anti-solar direction,
 *             :           seen from the geocentre; the Sun is 1 au from there
 *        ( Earth )
 *             : \ theta
 *             :  o satellite, r = 7136 km */
#include "check.h"

#include "base/core/constants.h"
#include "environment/environment.h"

static const struct um_vec3 north = {0.0, 0.0, 1.0};

struct geometry {
  struct um_vec3 r, sun;
  double distance;
};

/* Satellite at theta [rad] from the anti-solar direction, toward `side`; Sun along `sunward`. */
static struct geometry geometry_at(double radius, double theta, struct um_vec3 sunward,
                                   struct um_vec3 side)
{
  struct geometry g;
  g.r = um_vec3_axpy(um_vec3_scale(sunward, -radius * cos(theta)), radius * sin(theta), side);
  struct um_vec3 to_sun = um_vec3_sub(um_vec3_scale(sunward, UM_AU), g.r);
  g.distance = um_vec3_norm(to_sun);
  g.sun = um_vec3_scale(to_sun, 1.0 / g.distance);
  return g;
}

static double fraction(const struct um_environment *e, struct geometry g)
{
  return um_environment_sunlit_fraction(e, g.r, g.sun, g.distance, north);
}

static double limb(const struct um_environment *e, struct geometry g)
{
  return um_environment_limb_angle(e, g.r, g.sun, g.distance, north);
}

static struct um_environment with(enum um_environment_shadow shadow, enum um_environment_disc disc)
{
  struct um_environment e;
  um_environment_defaults(&e);
  e.shadow = shadow;
  e.disc = disc;
  return e;
}

/* Two plane circles, a Sun, b Earth, c apart: Montenbruck & Gill 2000, 3.4.2. */
static double plane_circles(double a, double b, double c)
{
  if (c >= a + b) return 1.0;
  if (c <= b - a) return 0.0;
  double x = (c * c + a * a - b * b) / (2.0 * c), y = sqrt(fmax(a * a - x * x, 0.0));
  double area = a * a * acos(x / a) + b * b * acos((c - x) / b) - c * y;
  return 1.0 - area / (UM_PI * a * a);
}

/* Any Sun radius a and Earth radius b at separation c [rad], through the public function. */
static double sphere_case(double a, double b, double c)
{
  struct um_environment e = with(UM_SHADOW_SPHERE, UM_DISC_UNIFORM);
  e.shadow_radius = 7e6 * sin(b);
  struct geometry g = {um_vec3(-7e6, 0.0, 0.0), um_vec3(cos(c), sin(c), 0.0),
                       UM_SOLAR_RADIUS / sin(a)};
  return fraction(&e, g);
}

/* Printed by plane circles, to which true rays come within 2.2e-4: 5e-4. */
static void overlap_of_discs(void **state)
{
  (void)state;
  const double d = UM_DEG;
  check_near("a = b = c", sphere_case(d, d, d), 1.0 - 2.0 / 3.0 + sqrt(3.0) / (2.0 * UM_PI), 1e-12);
  check_near("a = b = c, printed", sphere_case(d, d, d), 0.6089978, 5e-4);
  check_near("63.9", sphere_case(0.2666 * d, 64 * d, 63.9 * d), 0.267284, 5e-4);
  check_near("64.0", sphere_case(0.2666 * d, 64 * d, 64.0 * d), 0.500442, 5e-4);
  check_near("64.1", sphere_case(0.2666 * d, 64 * d, 64.1 * d), 0.733420, 5e-4);
}

/* Cases at 7136 km, computed by sampling rays over the disc. 5e-4 where the print has five digits
 * by plane circles, 1e-4 where it is sampled. */
static void oblate_and_spherical_cases(void **state)
{
  (void)state;
  const double d = UM_DEG, r = 7136e3;
  const struct um_vec3 x = {1, 0, 0}, y = {0, 1, 0};
  struct um_environment sphere = with(UM_SHADOW_SPHERE, UM_DISC_UNIFORM);
  struct um_environment oblate = with(UM_SHADOW_OBLATE, UM_DISC_UNIFORM);
  struct um_environment darkened = with(UM_SHADOW_OBLATE, UM_DISC_LIMB_DARKENED);
  check_near("sphere 63.2", fraction(&sphere, geometry_at(r, 63.2 * d, x, y)), 0.14853, 5e-4);
  check_near("sphere 63.4", fraction(&sphere, geometry_at(r, 63.4 * d, x, y)), 0.60320, 5e-4);
  check_near("sphere 63.5", fraction(&sphere, geometry_at(r, 63.5 * d, x, y)), 0.82515, 5e-4);
  check_near("sphere 63.362", fraction(&sphere, geometry_at(r, 63.362 * d, x, y)), 0.51288, 5e-4);
  check_near("sphere 63.6", fraction(&sphere, geometry_at(r, 63.6 * d, x, y)), 0.98477, 5e-4);
  assert_true(fraction(&sphere, geometry_at(r, 63.0 * d, x, y)) == 0.0);
  assert_true(fraction(&sphere, geometry_at(r, 64.0 * d, x, y)) == 1.0);
  check_near("equatorial limb", fraction(&oblate, geometry_at(r, 63.2 * d, x, y)), 0.1484, 1e-4);
  check_near("polar limb 63.2", fraction(&oblate, geometry_at(r, 63.2 * d, x, north)), 0.9622,
             1e-4);
  check_near("polar limb 63.0", fraction(&oblate, geometry_at(r, 63.0 * d, x, north)), 0.55646,
             1e-4);
  check_near("darkened", fraction(&darkened, geometry_at(r, 63.0 * d, x, north)), 0.56140, 1e-4);
}

/* Where the centre of the Sun stands on the limb: 63.35435 deg from the anti-solar direction at the
 * equator, 62.97401 deg at the pole, for a Sun infinitely far; 1 au turns it by r/au. Printed to
 * 1e-5 deg. */
static void limb_angle_at_equator_and_pole(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SHADOW_OBLATE, UM_DISC_UNIFORM);
  const struct um_vec3 side[] = {{0, 1, 0}, north};
  const double printed[] = {63.35435, 62.97401};
  for (int i = 0; i < 2; i++) {
    double t = 63.2 * UM_DEG;
    struct um_vec3 r = um_vec3_axpy(um_vec3(-7136e3 * cos(t), 0, 0), 7136e3 * sin(t), side[i]);
    /* at a polar or equatorial limb the limb angle is just the difference */
    double angle = um_environment_limb_angle(&e, r, um_vec3(1, 0, 0), UM_AU, north);
    double a = t - angle, before;
    for (int k = 0; k < 20; k++) { /* the limb itself depends on where the satellite is */
      before = a;
      r = um_vec3_axpy(um_vec3(-7136e3 * cos(a), 0, 0), 7136e3 * sin(a), side[i]);
      a -= um_environment_limb_angle(&e, r, um_vec3(1, 0, 0), UM_AU, north);
      if (fabs(a - before) < 1e-14) break;
    }
    check_near("limb", a / UM_DEG, printed[i], 1e-5);
  }
}

/* The ray meets the ellipsoid z'^2 (a/b)^2: the test's own statement of it. */
static int ray_is_free(struct um_vec3 r, struct um_vec3 d, double a, double b)
{
  double k = a / b;
  struct um_vec3 p = {r.x, r.y, r.z * k}, q = {d.x, d.y, d.z * k};
  double pq = um_vec3_dot(p, q);
  if (pq >= 0.0) return 1;
  struct um_vec3 nearest = um_vec3_axpy(p, -pq / um_vec3_dot(q, q), q);
  return um_vec3_norm(nearest) > a;
}

/* Rays over the disc on a grid of equal areas (rings times azimuths). */
static double by_rays(struct geometry g, double a, double b, double darkening)
{
  enum { RINGS = 600, AROUND = 1200 };
  struct um_vec3 t, s;
  um_core_vec3_frame(g.sun, &t, &s);
  double free = 0.0, all = 0.0, sine = UM_SOLAR_RADIUS / g.distance;
  for (int i = 0; i < RINGS; i++) {
    double x = (i + 0.5) / RINGS, rho = sine * sqrt(x), w = 1.0 - darkening * (1.0 - sqrt(1.0 - x));
    for (int j = 0; j < AROUND; j++) {
      double phi = 2.0 * UM_PI * (j + 0.5 * (i % 2)) / AROUND;
      struct um_vec3 d = um_vec3_scale(g.sun, sqrt(1.0 - rho * rho));
      d = um_vec3_axpy(um_vec3_axpy(d, rho * cos(phi), t), rho * sin(phi), s);
      all += w;
      if (ray_is_free(g.r, d, a, b)) free += w;
    }
  }
  return free / all;
}

/* Low orbit to GEO, limb at all latitudes, any part of the disc: 720 000 rays resolve 2e-4. */
static void agrees_with_rays(void **state)
{
  (void)state;
  const double b = UM_EARTH_RADIUS * (1.0 - UM_EARTH_FLATTENING);
  struct um_environment uniform = with(UM_SHADOW_OBLATE, UM_DISC_UNIFORM);
  struct um_environment darkened = with(UM_SHADOW_OBLATE, UM_DISC_LIMB_DARKENED);
  const double radius[] = {6578e3, 7143e3, 26560e3, 42164e3};
  struct um_vec3 x = um_vec3_unit(um_vec3(0.9, 0.1, -0.4)), y, z;
  um_core_vec3_frame(x, &y, &z);
  double worst = 0.0;
  for (int i = 0; i < 12; i++) {
    double turn = 0.3 + 0.55 * i, height = -0.8 + 0.15 * i; /* of the Sun, in its radii */
    struct um_vec3 side = um_vec3_axpy(um_vec3_scale(y, cos(turn)), sin(turn), z);
    double theta = asin(UM_EARTH_RADIUS / radius[i % 4]);
    struct geometry g = geometry_at(radius[i % 4], theta, x, side);
    for (int k = 0; k < 10; k++) {
      theta += 0.0046 * height - limb(&uniform, g);
      g = geometry_at(radius[i % 4], theta, x, side);
    }
    double u = fraction(&uniform, g), l = fraction(&darkened, g);
    assert_true(u > 0.01 && u < 0.99);
    double eu = fabs(u - by_rays(g, UM_EARTH_RADIUS, b, 0.0));
    double el = fabs(l - by_rays(g, UM_EARTH_RADIUS, b, 0.6));
    worst = fmax(worst, fmax(eu, el));
    check_below("uniform against rays", eu, 2e-4);
    check_below("darkened against rays", el, 2e-4);
  }
  print_message("largest difference from rays %.1e\n", worst);
}

/* Plane circles everywhere in the penumbra, 400 km to GEO. */
static void agrees_with_plane_circles(void **state)
{
  (void)state;
  const double radius[] = {6778e3, 7143e3, 12000e3, 42164e3};
  double worst = 0.0;
  for (int i = 0; i < 4; i++)
    for (int k = -100; k <= 100; k++) {
      double a = asin(UM_SOLAR_RADIUS / UM_AU), b = asin(UM_EARTH_RADIUS / radius[i]);
      struct um_environment e = with(UM_SHADOW_SPHERE, UM_DISC_UNIFORM);
      double c = b + 0.01 * k * a;
      struct geometry g = {um_vec3(-radius[i], 0, 0), um_vec3(cos(c), sin(c), 0), UM_AU};
      double error = fabs(fraction(&e, g) - plane_circles(a, b, c));
      worst = fmax(worst, error);
      check_below("plane circles", error, 5e-4);
    }
  print_message("largest difference from plane circles %.1e\n", worst);
}

/* Through the penumbra: never falling, never a jump (the disc is at most 2/(pi a) wide in flux per
 * radian, darkened 2.4/(pi a)), exactly 0 before and exactly 1 after, the edges at -+ the angular
 * radius of the Sun. */
static void penumbra_is_smooth(void **state)
{
  (void)state;
  const struct um_vec3 x = {0.8, 0.0, 0.6}, y = {-0.36, 0.8, 0.48}; /* orthonormal */
  for (int shadow = UM_SHADOW_SPHERE; shadow <= UM_SHADOW_OBLATE; shadow++)
    for (int disc = UM_DISC_UNIFORM; disc <= UM_DISC_LIMB_DARKENED; disc++) {
      struct um_environment e =
          with((enum um_environment_shadow)shadow, (enum um_environment_disc)disc);
      enum { N = 20000 };
      double from = 62.5 * UM_DEG, to = 64.2 * UM_DEG, before = 0.0, before_angle = 0.0;
      for (int i = 0; i <= N; i++) {
        struct geometry g = geometry_at(7143e3, from + (to - from) * i / N, x, y);
        double f = fraction(&e, g), angle = limb(&e, g), a = asin(UM_SOLAR_RADIUS / g.distance);
        assert_true((f == 0.0) == (angle <= -a) || fabs(angle + a) < 1e-7);
        assert_true((f == 1.0) == (angle >= a) || fabs(angle - a) < 1e-7);
        if (i > 0) {
          assert_true(f >= before - 1e-15);
          check_below("step of the fraction", f - before,
                      2.6 / (UM_PI * a) * (angle - before_angle));
        }
        before = f;
        before_angle = angle;
      }
      assert_true(before == 1.0);
    }
}

/* Over a revolution the limb angle changes hardly faster than the satellite turns: it is fit for
 * root finding. Left out: 1 deg around the Earth's own axis of shadow, where the direction to the
 * nearest limb, and with it the oblate Earth's radius (0.4 %), swings round. */
static void limb_angle_is_smooth(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SHADOW_OBLATE, UM_DISC_UNIFORM);
  const struct um_vec3 sunward = um_vec3_unit(um_vec3(0.9, 0.1, 0.4));
  const struct um_vec3 side = um_vec3_unit(um_vec3(0.1, -0.9, 0.0));
  enum { N = 36000 };
  double before = 0.0, step = 2.0 * UM_PI / N;
  for (int i = 0; i <= N; i++) {
    double angle = limb(&e, geometry_at(7143e3, step * i, sunward, side));
    assert_true(isfinite(angle));
    if (i % (N / 2) > 100 && i % (N / 2) < N / 2 - 100)
      check_below("step of the limb angle", fabs(angle - before), 1.05 * step);
    before = angle;
  }
}

static void no_darkening_is_uniform(void **state)
{
  (void)state;
  struct um_environment uniform = with(UM_SHADOW_OBLATE, UM_DISC_UNIFORM);
  struct um_environment darkened = with(UM_SHADOW_OBLATE, UM_DISC_LIMB_DARKENED);
  darkened.limb_darkening = 0.0;
  for (int i = 0; i < 60; i++) {
    struct geometry g =
        geometry_at(7143e3, (62.6 + 0.02 * i) * UM_DEG, um_vec3(1, 0, 0), um_vec3(0, 0.6, 0.8));
    check_near("u = 0", fraction(&darkened, g), fraction(&uniform, g), 1e-15);
  }
}

/* Half angle asin(R/r) about the anti-solar direction, 63.24049 deg at 765 km; nothing between. */
static void cylinder_point_and_none(void **state)
{
  (void)state;
  struct um_environment cylinder = with(UM_SHADOW_CYLINDER, UM_DISC_LIMB_DARKENED);
  struct um_environment point = with(UM_SHADOW_SPHERE, UM_DISC_POINT);
  struct um_environment none = with(UM_SHADOW_NONE, UM_DISC_UNIFORM);
  for (int i = 0; i < 2; i++) {
    struct um_environment *e = i ? &point : &cylinder;
    for (int k = 0; k < 3600; k++) {
      double t = (0.05 + 0.1 * k) * UM_DEG, r = 7143137.0;
      struct geometry g = {um_vec3(-r * cos(t), r * sin(t), 0), um_vec3(1, 0, 0), UM_AU};
      double dark = t < 63.24049 * UM_DEG || t > (360 - 63.24049) * UM_DEG;
      assert_true(fraction(e, g) == (dark != 0.0 ? 0.0 : 1.0));
      assert_true(fraction(&none, g) == 1.0);
    }
    double t = 63.24049 * UM_DEG; /* printed to 1e-5 deg */
    struct geometry g = {um_vec3(-7143137.0 * cos(t), 7143137.0 * sin(t), 0), um_vec3(1, 0, 0),
                         UM_AU};
    check_near("edge", limb(e, g) / UM_DEG, 0.0, 1e-5);
  }
}

/* Under ground it is dark; beyond the umbra's tip the Earth is a spot on the Sun, (b/a)^2 of it;
 * in line with the geocentre nothing is undefined. */
static void odd_places(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SHADOW_OBLATE, UM_DISC_UNIFORM);
  struct geometry g = {um_vec3(6e6, 0, 0), um_vec3(1, 0, 0), UM_AU};
  assert_true(fraction(&e, g) == 0.0);
  g.r = um_vec3(-7e6, 0, 0);
  assert_true(fraction(&e, g) == 0.0);
  g.r = um_vec3(7e6, 0, 0);
  assert_true(fraction(&e, g) == 1.0);
  g.r = um_vec3(-3e9, 0, 0);
  e.shadow = UM_SHADOW_SPHERE;
  double a = asin(UM_SOLAR_RADIUS / UM_AU), b = asin(UM_EARTH_RADIUS / 3e9);
  check_near("annular", fraction(&e, g), 1.0 - b * b / (a * a), 1e-12);
  for (int disc = UM_DISC_POINT; disc <= UM_DISC_LIMB_DARKENED; disc++) { /* NaN stays NaN */
    e = with(UM_SHADOW_OBLATE, (enum um_environment_disc)disc);
    g.r = um_vec3(NAN, 0, 0);
    assert_true(isnan(fraction(&e, g)) && isnan(limb(&e, g)));
  }
}

/* From full shadow to full light behind a limb 3200.3 km away: 2 D tan(a) = 29.77 km of movement
 * across the ray, printed digits. */
static void penumbra_width(void **state)
{
  (void)state;
  struct um_environment e = with(UM_SHADOW_SPHERE, UM_DISC_UNIFORM);
  double low = 0.0, high = 0.0;
  for (int i = 0; i < 60000; i++) { /* metres above the geometric shadow's edge */
    double x = i - 30000.0;
    struct geometry g = {um_vec3(-3200.3e3, UM_EARTH_RADIUS + x, 0), um_vec3(1, 0, 0), UM_AU};
    double f = fraction(&e, g);
    if (f == 0.0) low = x;
    if (f < 1.0) high = x;
  }
  check_near("width [km]", 1e-3 * (high - low), 29.77, 0.01);
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(overlap_of_discs),
      cmocka_unit_test(oblate_and_spherical_cases),
      cmocka_unit_test(limb_angle_at_equator_and_pole),
      cmocka_unit_test(agrees_with_rays),
      cmocka_unit_test(agrees_with_plane_circles),
      cmocka_unit_test(penumbra_is_smooth),
      cmocka_unit_test(limb_angle_is_smooth),
      cmocka_unit_test(no_darkening_is_uniform),
      cmocka_unit_test(cylinder_point_and_none),
      cmocka_unit_test(odd_places),
      cmocka_unit_test(penumbra_width),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
