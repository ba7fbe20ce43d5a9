/* The air at the Earth's limb: density, bending and columns of a ray. */
#include "environment/limb_air.h"

#include "base/core/constants.h"
#include "environment/standard_air.h"
#include "tests/environment/check.h"

#define SCALE 8e3 /* [m] */

/* US Standard Atmosphere 1976, NOAA-S/T 76-1562, table 1: five digits are printed. */
static void density_as_printed(void **state)
{
  static const struct {
    double height, density; /* [km], [kg/m^3] */
  } printed[] = {{0, 1.2250},     {5, 0.73643},    {10, 0.41351},   {15, 0.19476},
                 {20, 0.088910},  {30, 0.018410},  {40, 0.0039957}, {50, 0.0010269},
                 {60, 3.0968e-4}, {70, 8.2829e-5}, {80, 1.8458e-5}};
  (void)state;
  for (size_t i = 0; i < sizeof printed / sizeof printed[0]; i++) {
    double rho = um_environment_standard_air_density(printed[i].height * 1e3);
    check_near("density", rho / printed[i].density, 1.0, 1e-4);
  }
  double at_top = um_environment_standard_air_density(86e3);
  check_near("no step at the top", um_environment_standard_air_density(86e3 + 1e-3) / at_top, 1.0,
             1e-6);
}

static double exponential(const void *self, double height)
{
  (void)self;
  return exp(-height / SCALE);
}
static double exponential_refractivity(const void *self, double height)
{
  return 2.92e-4 * exponential(self, height);
}
static double exponential_density(const void *self, enum um_environment_limb_constituent which,
                                  double height)
{
  (void)which;
  return exponential(self, height);
}

/* (n0 - 1) sqrt(2 pi R/H) = 71.05' and sqrt(2 pi R/H) = 70.78 on the ground
 * (docs/physics/shadow.md), falling by e in H; the next term of both is of order H/R: 3/8 H/R =
 * 5e-4 for the column (Chapman). */
static void exponential_air(void **state)
{
  static struct um_environment_limb_air air;
  const struct um_environment_limb_profile profile = {exponential_refractivity, exponential_density,
                                                      NULL};
  (void)state;
  um_environment_limb_air_make(&profile, UM_EARTH_RADIUS, &air);
  check_near("bending on the ground [arcmin]", air.bending[0] / UM_DEG * 60.0, 71.05, 0.1);
  check_near("air mass on the ground", air.column[UM_LIMB_AIR][0], 70.78, 0.1);
  for (int k = 0; k < UM_LIMB_NODES; k += 20) {
    double h = k * UM_LIMB_STEP, fall = exp(-h / SCALE) * sqrt(1.0 + h / UM_EARTH_RADIUS);
    check_near("bending", air.bending[k] / (2.92e-4 * sqrt(2.0 * UM_PI * UM_EARTH_RADIUS / SCALE)),
               fall, 1.5e-3 * fall);
    check_near("column", air.column[UM_LIMB_AIR][k] / sqrt(2.0 * UM_PI * UM_EARTH_RADIUS / SCALE),
               fall, 1.5e-3 * fall);
  }
}

/* Optical depths of Bodhaine et al. as docs/physics/air.md prints them; ozone at 602 nm absorbs
 * 5.1e-25 m^2 in its peak, 4.7e-25 in a mean over 20 nm: 0.0376 of 300 Dobson units. */
static void depths(void **state)
{
  static const struct {
    double nm, rayleigh;
  } printed[] = {
      {450, 0.221106}, {550, 0.097065}, {650, 0.049184}, {800, 0.021227}, {1000, 0.008641}};
  double depth[UM_LIMB_CONSTITUENTS];
  (void)state;
  for (size_t i = 0; i < sizeof printed / sizeof printed[0]; i++) {
    um_environment_limb_depth(printed[i].nm * 1e-9, depth);
    check_near("Rayleigh", depth[UM_LIMB_AIR], printed[i].rayleigh, 1e-6);
  }
  um_environment_limb_depth(610e-9, depth);
  check_near("ozone at 610 nm", 300.0 * depth[UM_LIMB_OZONE], 0.0376, 1e-4);
  um_environment_limb_depth(10e-6, depth);
  check_near("no ozone in the infrared", depth[UM_LIMB_OZONE], 0.0, 0.0);
  um_environment_limb_depth(550e-9, depth);
  check_near("haze at its reference", depth[UM_LIMB_HAZE], 1.0, 1e-12);
  check_near("aerosol at its reference", depth[UM_LIMB_AEROSOL], 1.0, 1e-12);
  um_environment_limb_depth(1.06e-6, depth);
  check_near("aerosol as LOWTRAN7 has it", depth[UM_LIMB_AEROSOL], 0.3017, 1e-6);
}

/* A ray marched through the plane, d(n t)/ds = grad n (Runge-Kutta, steps of 100 m), from its
 * lowest point upward: the angle by which it turns, and its column, both doubled. */
struct ray {
  double x, y, tx, ty; /* [m]; n times the direction [1] */
};
static struct ray rate(const struct um_environment_limb_profile *p, struct ray a)
{
  double r = hypot(a.x, a.y), z = r - UM_EARTH_RADIUS, n = 1.0 + p->refractivity(p->self, z);
  double g = (p->refractivity(p->self, z + 1.0) - p->refractivity(p->self, z - 1.0)) / 2.0;
  return (struct ray){a.tx / n, a.ty / n, g * a.x / r, g * a.y / r};
}
static struct ray along(struct ray a, double step, struct ray by)
{
  return (struct ray){a.x + step * by.x, a.y + step * by.y, a.tx + step * by.tx,
                      a.ty + step * by.ty};
}
static void march(const struct um_environment_limb_profile *p, double height, double *bending,
                  double *column)
{
  const double step = 100.0;
  struct ray a = {0.0, UM_EARTH_RADIUS + height, 1.0 + p->refractivity(p->self, height), 0.0};
  *column = 0.0;
  for (double z = height; z < 150e3; z = hypot(a.x, a.y) - UM_EARTH_RADIUS) {
    struct ray k1 = rate(p, a), middle = along(a, 0.5 * step, k1), k2 = rate(p, middle);
    struct ray k3 = rate(p, along(a, 0.5 * step, k2)), k4 = rate(p, along(a, step, k3));
    *column +=
        2.0 * step * p->density(p->self, UM_LIMB_AIR, hypot(middle.x, middle.y) - UM_EARTH_RADIUS);
    struct ray sum = along(along(along(k1, 2.0, k2), 2.0, k3), 1.0, k4);
    a = along(a, step / 6.0, sum);
  }
  *bending = 2.0 * atan2(-a.ty, a.tx);
}

/* Marched and by Bouguer's law: 1e-5; bending by the standard air 3e-3, for its temperature has
 * kinks, which 150 points step over. */
static void bent_rays(void **state)
{
  static struct um_environment_limb_air air;
  const struct um_environment_limb_profile profile[] = {
      {exponential_refractivity, exponential_density, NULL},
      um_environment_limb_standard(UM_LIMB_MIDDLE)};
  static const double within[] = {1e-5, 3e-3};
  (void)state;
  for (size_t i = 0; i < 2; i++) {
    double whole = 0.0;
    for (double z = 25.0; z < 150e3; z += 50.0)
      whole += 50.0 * profile[i].density(profile[i].self, UM_LIMB_AIR, z);
    um_environment_limb_air_bent(&profile[i], UM_EARTH_RADIUS, &air);
    for (int k = 4; k <= 80; k += 4) {
      double bending, column;
      march(&profile[i], air.height[k], &bending, &column);
      check_near("bent", air.bending[k] / bending, 1.0, within[i]);
      check_near("column", air.column[UM_LIMB_AIR][k] * whole / column, 1.0, 1e-5);
      double n = 1.0 + profile[i].refractivity(profile[i].self, air.height[k]);
      check_near("Bouguer", n * (UM_EARTH_RADIUS + air.height[k]),
                 UM_EARTH_RADIUS + k * UM_LIMB_STEP, 1e-6);
    }
  }
}

/* The ray that touches the ground is bent by what refraction tables give for the horizon, twice
 * over, 2 x 34' (Bennett 1982: 34.5'), and crosses 2 x 37.9 airmasses (Kasten & Young 1989). */
static void standard_air(void **state)
{
  static struct um_environment_limb_air air;
  const struct um_environment_limb_profile profile = um_environment_limb_standard(UM_LIMB_MIDDLE);
  (void)state;
  um_environment_limb_air_bent(&profile, UM_EARTH_RADIUS, &air);
  int k = 0;
  while (air.height[k + 1] < 0.0) k++;
  double x = -air.height[k] / (air.height[k + 1] - air.height[k]);
  check_near("bending on the ground [arcmin]",
             ((1.0 - x) * air.bending[k] + x * air.bending[k + 1]) / UM_DEG * 60.0, 68.0, 2.0);
  check_near("air mass on the ground",
             (1.0 - x) * air.column[UM_LIMB_AIR][k] + x * air.column[UM_LIMB_AIR][k + 1],
             2.0 * 37.9, 1.0);
  for (k = 1; k < UM_LIMB_NODES; k++) {
    check_below("bending falls", air.bending[k], air.bending[k - 1]);
    check_below("air falls", air.column[UM_LIMB_AIR][k], air.column[UM_LIMB_AIR][k - 1]);
  }
}

/* Logistic layer n = e^x/(1 + e^x)^2, x = (z - 20 km)/5 km, in air that does not bend; vertical
 * column w (1 - 1/(1 + e^(z0/w))). */
#define CENTRE 20e3 /* [m] */
#define WIDTH  5e3  /* [m] */
static double none(const void *self, double height)
{
  (void)self;
  return 0.0 * height;
}
static double layer_density(const void *self, enum um_environment_limb_constituent which,
                            double height)
{
  (void)self, (void)which;
  double c = cosh(0.5 * (height - CENTRE) / WIDTH);
  return 0.25 / (c * c);
}

/* Slant over vertical column by heights: 2 int n (R + z)/sqrt((R + z)^2 - (R + h)^2) dz, with z = h
 * + u^2 against the pole; 20000 midpoints. */
static double layer_column(double h)
{
  enum { N = 20000 };
  double sum = 0.0, top = sqrt(200e3), low = UM_EARTH_RADIUS + h;
  for (int i = 0; i < N; i++) {
    double u = (i + 0.5) * top / N;
    double r = low + u * u;
    sum += layer_density(NULL, UM_LIMB_OZONE, h + u * u) * 2.0 * r / sqrt(r + low) * top / N;
  }
  return 2.0 * sum / (WIDTH * (1.0 - 1.0 / (1.0 + exp(CENTRE / WIDTH))));
}

static void layers(void **state)
{
  static struct um_environment_limb_air straight, bent;
  const struct um_environment_limb_profile profile = {none, layer_density, NULL};
  (void)state;
  um_environment_limb_air_make(&profile, UM_EARTH_RADIUS, &straight);
  um_environment_limb_air_bent(&profile, UM_EARTH_RADIUS, &bent);
  for (int k = 0; k <= 80; k += 10) {
    double expected = layer_column(k * UM_LIMB_STEP);
    check_near("straight", straight.column[UM_LIMB_OZONE][k] / expected, 1.0, 1e-3);
    check_near("bent by nothing", bent.column[UM_LIMB_OZONE][k] / expected, 1.0, 1e-3);
    check_near("where it is", bent.height[k], k * UM_LIMB_STEP, 1e-6);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(density_as_printed),
      cmocka_unit_test(exponential_air),
      cmocka_unit_test(depths),
      cmocka_unit_test(bent_rays),
      cmocka_unit_test(standard_air),
      cmocka_unit_test(layers),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
