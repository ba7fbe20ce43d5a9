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
}

/* The standard air bends a ray along the ground by what refraction tables give twice over for the
 * horizon, 2 x 34', and less with height; a straight ray crosses 7 % less air than the bent one, 2
 * x 37.9 (Kasten & Young 1989). */
static void standard_air(void **state)
{
  static struct um_environment_limb_air air;
  const struct um_environment_limb_profile profile = um_environment_limb_standard();
  (void)state;
  um_environment_limb_air_make(&profile, UM_EARTH_RADIUS, &air);
  check_near("bending on the ground [arcmin]", air.bending[0] / UM_DEG * 60.0, 68.0, 5.0);
  check_near("air mass on the ground", air.column[UM_LIMB_AIR][0], 0.93 * 75.8, 0.75);
  for (int k = 1; k < UM_LIMB_NODES; k++) {
    check_below("bending falls", air.bending[k], air.bending[k - 1]);
    check_below("air falls", air.column[UM_LIMB_AIR][k], air.column[UM_LIMB_AIR][k - 1]);
  }
}

/* Logistic layer n = e^x/(1 + e^x)^2, x = (z - z0)/w; vertical column w (1 - 1/(1 + e^(z0/w))). */
struct layer {
  double centre, width; /* [m] */
};
static double layer_density(const struct layer *l, double height)
{
  double c = cosh(0.5 * (height - l->centre) / l->width);
  return 0.25 / (c * c);
}

/* Slant over vertical column by heights: 2 int n (R + z)/sqrt((R + z)^2 - (R + h)^2) dz, with z = h
 * + u^2 against the pole; 20000 midpoints. */
static double layer_column(const struct layer *l, double h)
{
  enum { N = 20000 };
  double sum = 0.0, top = sqrt(200e3), low = UM_EARTH_RADIUS + h;
  for (int i = 0; i < N; i++) {
    double u = (i + 0.5) * top / N;
    double r = low + u * u;
    sum += layer_density(l, h + u * u) * 2.0 * r / sqrt(r + low) * top / N;
  }
  return 2.0 * sum / (l->width * (1.0 - 1.0 / (1.0 + exp(l->centre / l->width))));
}

/* Ozone at 20 km, 5 km (Lacis & Hansen 1974) and the stratosphere's aerosol at 16 km, 2.5 km. */
static void layers(void **state)
{
  static struct um_environment_limb_air air;
  static const struct layer ozone = {20e3, 5e3}, aerosol = {16e3, 2.5e3};
  const struct um_environment_limb_profile profile = um_environment_limb_standard();
  (void)state;
  um_environment_limb_air_make(&profile, UM_EARTH_RADIUS, &air);
  for (int k = 0; k <= 80; k += 10) {
    double h = k * UM_LIMB_STEP;
    check_near("ozone", air.column[UM_LIMB_OZONE][k] / layer_column(&ozone, h), 1.0, 1e-3);
    check_near("aerosol", air.column[UM_LIMB_AEROSOL][k] / layer_column(&aerosol, h), 1.0, 1e-3);
  }
}

int main(void)
{
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(density_as_printed),
      cmocka_unit_test(exponential_air),
      cmocka_unit_test(depths),
      cmocka_unit_test(standard_air),
      cmocka_unit_test(layers),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
