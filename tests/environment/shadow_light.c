/* Sunlight through the Earth's limb, against the closed forms of docs/physics/shadow.md. */
#include "environment/shadow_light.h"

#include "base/core/constants.h"
#include "environment/shadow_impl.h"
#include "tests/environment/check.h"

#define RADIUS 7136e3 /* [m] of the satellite */

static const struct um_vec3 north = {0.0, 0.0, 1.0};

/* An exponential atmosphere that only scatters, over a sphere, to first order in the refractivity,
 * as docs/physics/shadow.md has it; no clouds. */
static struct um_environment exponential_earth(struct um_environment_limb *limb)
{
  struct um_environment e;
  um_environment_defaults(&e);
  um_environment_limb_make(&e, limb);
  for (int z = 0; z < UM_LIMB_ZONES; z++)
    for (int k = 0; k < UM_LIMB_NODES; k++) {
      double h = k * UM_LIMB_STEP, fall = exp(-h / 8e3);
      limb->bent[z].height[k] = h;
      limb->bent[z].bending[k] = 2.92e-4 * sqrt(2.0 * UM_PI * UM_EARTH_RADIUS / 8e3) * fall;
      for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++)
        limb->bent[z].column[c][k] = sqrt(2.0 * UM_PI * UM_EARTH_RADIUS / 8e3) * fall;
    }
  e.limb = limb;
  e.shadow = UM_SHADOW_SPHERE;
  e.disc = UM_DISC_UNIFORM;
  e.ozone_dobson = e.haze = e.aerosol = 0.0;
  e.cloud_top = -100e3;
  return e;
}

struct place {
  struct um_vec3 r, sun;
  double distance;
};

/* theta [deg] from the anti-solar direction, in parallel sunlight */
static struct place place_at(double theta)
{
  return (struct place){um_vec3(-RADIUS * cos(theta * UM_DEG), RADIUS * sin(theta * UM_DEG), 0.0),
                        um_vec3(1.0, 0.0, 0.0), UM_AU};
}

static double at(const struct um_environment *e, double theta, double wavelength)
{
  struct um_environment_shadow_light light;
  struct place p = place_at(theta);
  um_environment_shadow_light(e, p.r, p.sun, p.distance, north, &light);
  return um_environment_shadow_light_at(&light, wavelength);
}

/* The same by plain sums: 4000 strips of the disc, each from the height whose ray is bent to it,
 * found by bisection; columns and bending as docs/physics/shadow.md has them, exponential. */
static double by_strips(double theta, double wavelength, double dispersion)
{
  double depth[UM_LIMB_CONSTITUENTS], sum = 0.0, norm = 0.0;
  double disc = asin(UM_SOLAR_RADIUS / UM_AU);
  um_environment_limb_depth(wavelength, depth);
  double mass = depth[UM_LIMB_AIR] * sqrt(2.0 * UM_PI * UM_EARTH_RADIUS / 8e3);
  double bend = 2.92e-4 * sqrt(2.0 * UM_PI * UM_EARTH_RADIUS / 8e3) * dispersion;
  for (int i = 0; i < 4000; i++) {
    double v = (i + 0.5) / 2000.0 - 1.0, angle = theta * UM_DEG + disc * v;
    double chord = sqrt(1.0 - v * v), low = 0.0, high = 200e3;
    norm += chord;
    if (asin(UM_EARTH_RADIUS / RADIUS) - bend > angle) continue;
    for (int k = 0; k < 60; k++) {
      double h = 0.5 * (low + high);
      double true_angle = asin((UM_EARTH_RADIUS + h) / RADIUS) - bend * exp(-h / 8e3);
      *(true_angle < angle ? &low : &high) = h;
    }
    double seen = asin((UM_EARTH_RADIUS + low) / RADIUS), alpha = bend * exp(-low / 8e3);
    double way = RADIUS * cos(seen); /* dh/d theta' */
    sum +=
        chord * exp(-mass * exp(-low / 8e3)) / (1.0 + way * alpha / 8e3) * sin(seen) / sin(angle);
  }
  return sum / norm;
}

/* Strips: 2e-4. docs/physics/shadow.md prints what
 * heights h - D alpha over a plane limb give, 0.006 above a fine sum of its own formula at 64 deg
 * (0.8229). */
static void exponential_disc(void **state)
{
  static struct um_environment_limb limb;
  static const struct {
    double theta, green, red;
  } printed[] = {{63.000, 0.01806, 0.08631},
                 {63.362, 0.12456, 0.25184},
                 {63.600, 0.34275, 0.47537},
                 {64.000, 0.82901, 0.87443}};
  const struct um_environment e = exponential_earth(&limb);
  (void)state;
  for (size_t i = 0; i < sizeof printed / sizeof printed[0]; i++) {
    double theta = printed[i].theta;
    double green = at(&e, theta, 550e-9), red = at(&e, theta, 700e-9);
    printf("%.3f deg: %.5f (%.5f), %.5f (%.5f)\n", theta, green, printed[i].green, red,
           printed[i].red);
    check_near("550 nm, strips", green, by_strips(theta, 550e-9, 1.0), 2e-4);
    check_near("700 nm, strips", red, by_strips(theta, 700e-9, 0.99279), 2e-4);
    check_near("550 nm, printed", green, printed[i].green, 0.006);
    check_near("700 nm, printed", red, printed[i].red, 0.006);
  }
}

/* Refractivity over that at 550 nm by another formula (Peck & Reeder 1972, J. Opt. Soc. Am. 62:958,
 * four terms). */
static double peck_reeder(double um)
{
  double s2 = 1.0 / (um * um);
  return 8060.51 + 2480990.0 / (132.274 - s2) + 17455.7 / (39.32957 - s2);
}

/* Each wavelength is bent by its own refractivity: strips bent so, in 3e-4, where as if of 550 nm
 * the light of 400 and 1000 nm is off by up to 0.002 and 0.004. */
static void dispersion(void **state)
{
  static struct um_environment_limb limb;
  static const double wavelength[] = {0.40, 0.55, 1.0, 1.6};
  struct um_environment e = exponential_earth(&limb);
  double most = 0.0;
  (void)state;
  for (size_t i = 0; i < sizeof wavelength / sizeof wavelength[0]; i++) {
    double um = wavelength[i], q = peck_reeder(um) / peck_reeder(0.55);
    check_near("dispersion", um_environment_limb_dispersion(um * 1e-6), q, 1e-4);
    for (double theta = 62.9; theta < 64.2; theta += 0.1) {
      double here = at(&e, theta, um * 1e-6), strips = by_strips(theta, um * 1e-6, q);
      check_near("strips", here, strips, 3e-4);
      most = fmax(most, fabs(by_strips(theta, um * 1e-6, 1.0) - strips));
    }
  }
  printf("dispersion changes the light by up to %.4f\n", most);
  assert_true(most > 2e-3);
}

/* One narrow beam: a Sun so far off that its disc spans 30 m at the limb is dimmed by transmission
 * and dilution as printed for the height h at which it passes. The straight ray of that height is
 * at (R + h) cos(alpha) - sqrt(r^2 - (R + h)^2) sin(alpha) from the axis, alpha = alpha_0
 * exp(-h/H). 1 % for what the page takes to first order, 2 % at the two lowest for what the limb
 * gathers. */
static void narrow_beam(void **state)
{
  static struct um_environment_limb limb;
  static const struct {
    double height, green, red; /* [km] */
  } printed[] = {
      {5, 4.62e-3, 4.62e-2}, {10, 4.13e-2, 0.1416}, {20, 0.3385, 0.4819}, {50, 0.9713, 0.9794}};
  const struct um_environment e = exponential_earth(&limb);
  (void)state;
  for (size_t i = 0; i < sizeof printed / sizeof printed[0]; i++) {
    double low = UM_EARTH_RADIUS + printed[i].height * 1e3;
    double alpha = 0.02067 * exp(-printed[i].height / 8.0);
    double y = low * cos(alpha) - sqrt(RADIUS * RADIUS - low * low) * sin(alpha);
    struct um_vec3 r = um_vec3(-sqrt(RADIUS * RADIUS - y * y), y, 0.0);
    struct um_environment_shadow_light light;
    um_environment_shadow_light(&e, r, um_vec3(1.0, 0.0, 0.0), 1000.0 * UM_AU, north, &light);
    double green = um_environment_shadow_light_at(&light, 550e-9);
    double red = um_environment_shadow_light_at(&light, 700e-9);
    printf("%.0f km: %.5f (%.5f), %.5f (%.5f)\n", printed[i].height, green, printed[i].green, red,
           printed[i].red);
    check_near("550 nm", green / printed[i].green, 1.0, 0.03);
    check_near("700 nm", red / printed[i].red, 1.0, 0.03);
  }
}

static void no_bending(struct um_environment_limb *limb)
{
  for (int z = 0; z < UM_LIMB_ZONES; z++)
    for (int k = 0; k < UM_LIMB_NODES; k++) limb->bent[z].bending[k] = 0.0;
}

/* Air that neither bends nor dims leaves the sunlit fraction of the bare sphere, whose limb across
 * the disc is exact there and to its mean here: 1e-4. */
static void no_air(void **state)
{
  static struct um_environment_limb limb;
  struct um_environment e = exponential_earth(&limb);
  (void)state;
  no_bending(&limb);
  e.air_factor = 0.0;
  for (int disc = UM_DISC_UNIFORM; disc <= UM_DISC_LIMB_DARKENED; disc++)
    for (double theta = 62.8; theta < 64.2; theta += 0.037) {
      struct place p = place_at(theta);
      e.disc = (enum um_environment_disc)disc;
      double bare = um_environment_airless_fraction(&e, p.r, p.sun, p.distance, north);
      check_near("bare", at(&e, theta, 550e-9), bare, 3e-4);
    }
}

/* Clouds alone, before a Sun so far off that its disc spans 30 m at the limb: the share of clear
 * sight (1 + erf((h - h_cloud)/(sqrt 2 s)))/2 of the straight ray's height, s = 2.5 km. Heights lie
 * in steps of 0.5 km: 1e-3. */
static void clouds(void **state)
{
  static struct um_environment_limb limb;
  static const struct {
    double over, share; /* the clouds' tops [2.5 km]; normal distribution function, tables */
  } printed[] = {{-2, 0.02275}, {-1, 0.15866}, {0, 0.5}, {1, 0.84134}, {3, 0.99865}};
  struct um_environment e = exponential_earth(&limb);
  (void)state;
  no_bending(&limb);
  e.air_factor = 0.0;
  e.cloud_top = 12e3;
  for (size_t i = 0; i < sizeof printed / sizeof printed[0]; i++) {
    double y = UM_EARTH_RADIUS + e.cloud_top + printed[i].over * 2.5e3;
    struct um_vec3 r = um_vec3(-sqrt(RADIUS * RADIUS - y * y), y, 0.0);
    struct um_environment_shadow_light light;
    um_environment_shadow_light(&e, r, um_vec3(1.0, 0.0, 0.0), 1000.0 * UM_AU, north, &light);
    check_near("clear sight", um_environment_shadow_light_at(&light, 550e-9), printed[i].share,
               1e-3);
  }
}

/* Heat takes int E(lambda) F(lambda) dlambda / int E dlambda: here over 2000 wavelengths, there in
 * 24 bands, 0.25 to 4 um of both. */
static void mean_of_the_spectrum(void **state)
{
  static struct um_environment_limb limb;
  struct um_environment e;
  (void)state;
  um_environment_defaults(&e);
  um_environment_limb_make(&e, &limb);
  e.limb = &limb;
  for (double theta = 62.0; theta < 65.0; theta += 0.25) {
    struct um_environment_shadow_light light;
    struct place p = place_at(theta);
    double sum = 0.0, all = 0.0;
    um_environment_shadow_light(&e, p.r, p.sun, p.distance, north, &light);
    for (int i = 0; i < 2000; i++) {
      double wavelength = 0.25e-6 * pow(16.0, (i + 0.5) / 2000.0);
      double energy = wavelength * um_environment_solar_spectrum(&e, wavelength);
      all += energy;
      sum += energy * um_environment_shadow_light_at(&light, wavelength);
    }
    check_near("mean", um_environment_sunlit_fraction(&e, p.r, p.sun, p.distance, north), sum / all,
               2e-3);
  }
}

/* With all that the air holds, light grows without a step from exactly none to exactly all of it,
 * redder the lower the Sun, and never above what arrives without extinction. */
static void standard_limb(void **state)
{
  static struct um_environment_limb limb;
  struct um_environment e;
  (void)state;
  um_environment_defaults(&e);
  um_environment_limb_make(&e, &limb);
  e.limb = &limb;
  double before = 0.0, sum = 0.0;
  for (int k = 0; k < UM_LIMB_BANDS; k++) sum += limb.share[k];
  check_near("shares", sum, 1.0, 1e-12);
  assert_true(at(&e, 61.5, 650e-9) == 0.0);
  assert_true(at(&e, 66.0, 450e-9) == 1.0);
  for (double theta = 61.5; theta < 66.0; theta += 0.01) {
    struct place p = place_at(theta);
    double mean = um_environment_sunlit_fraction(&e, p.r, p.sun, p.distance, north);
    double blue = at(&e, theta, 450e-9), red = at(&e, theta, 800e-9);
    check_below("red is brighter", blue, red + 1e-12);
    check_below("grows", before, mean + 1e-9);
    check_below("no step", mean - before, 0.02);
    check_below("a fraction", mean, 1.0);
    before = mean;
  }
}

/* What is not stated is that of the latitude under the ray's lowest point, in between a mixture of
 * its neighbours; what is stated holds everywhere, and factor and shift act on both. */
static void by_latitude(void **state)
{
  static struct um_environment_limb limb;
  struct um_environment e, stated;
  (void)state;
  um_environment_defaults(&e);
  um_environment_limb_make(&e, &limb);
  e.limb = &limb;
  stated = e;
  const struct place p = place_at(63.6);
  const double degrees[] = {0.0, 52.5, 90.0}, dobson[] = {259.0, 322.5, 327.0};
  const double cloud[] = {8.3e3, 6.7e3, 6.4e3};
  double before = 1.0;
  for (size_t i = 0; i < 3; i++) {
    double a = degrees[i] * UM_DEG; /* the ray is lowest over +y */
    struct um_vec3 pole = um_vec3(0.0, sin(a), cos(a));
    double here = um_environment_sunlit_fraction(&e, p.r, p.sun, p.distance, pole);
    stated.ozone_dobson = dobson[i];
    stated.cloud_top = cloud[i];
    double there = um_environment_sunlit_fraction(&stated, p.r, p.sun, p.distance, pole);
    check_near("as stated", there, here, i == 1 ? 1e-3 : 1e-12);
    struct um_environment more = e;
    more.ozone_factor = 1.2;
    stated.ozone_dobson *= 1.2;
    more.cloud_shift = 1e3;
    stated.cloud_top += 1e3;
    check_near("changed", um_environment_sunlit_fraction(&more, p.r, p.sun, p.distance, pole),
               um_environment_sunlit_fraction(&stated, p.r, p.sun, p.distance, pole),
               i == 1 ? 1e-3 : 1e-12);
    assert_true(fabs(here - before) > 1e-3);
    before = here;
  }
}

/* The switch, a point and a cylinder leave the bare Earth, to the bit. */
static void where_it_does_not_act(void **state)
{
  static struct um_environment_limb limb;
  struct um_environment e = exponential_earth(&limb), bare = e;
  (void)state;
  bare.limb = NULL;
  for (double theta = 63.0; theta < 64.0; theta += 0.05) {
    struct place p = place_at(theta);
    double expected = um_environment_sunlit_fraction(&bare, p.r, p.sun, p.distance, north);
    struct um_environment off = e;
    off.shadow_refraction_on = false;
    assert_true(um_environment_sunlit_fraction(&off, p.r, p.sun, p.distance, north) == expected);
    struct um_environment point = e;
    point.disc = UM_DISC_POINT;
    double f = um_environment_sunlit_fraction(&point, p.r, p.sun, p.distance, north);
    assert_true(f == 0.0 || f == 1.0);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(exponential_disc),
      cmocka_unit_test(dispersion),
      cmocka_unit_test(narrow_beam),
      cmocka_unit_test(no_air),
      cmocka_unit_test(clouds),
      cmocka_unit_test(mean_of_the_spectrum),
      cmocka_unit_test(standard_limb),
      cmocka_unit_test(by_latitude),
      cmocka_unit_test(where_it_does_not_act),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
