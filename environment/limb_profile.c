/* Ozone: the shape is that of the AFGL profiles (Anderson et al. 1986, AFGL-TR-86-0110, as LOWTRAN7
 * has them): tropical; middle latitudes and subarctic, each the mean of summer and winter. The
 * columns are annual means of both hemispheres by SBUV, 2005 to 2015 (NOAA's cohesive record, Wild
 * & Long; version 8 zonal means): 0 to 20, 35 to 55 and 55 to 70 deg. SBUV's own layers above 25 km
 * have these shapes to 13 % (tests/reference/ozone-sbuv.csv).
 *
 * Aerosol of the stratosphere: the shape is the background of LOWTRAN7 (Kneizys et al. 1988,
 * AFGL-TR-88-0177), mean of its two seasons, 0.0076 in all at 0.55 um; 3 km higher in the tropics.
 * Typical profiles of SAGE III on the Space Station, 2017 to 2026, have it at 0.010 within a factor
 * of 1.6 from 18 to 28 km (tests/reference/aerosol-sage3.csv). Haze falls by e in 2 km: 0.1 of it
 * is 7.9e-4 1/km in the mean of 6 to 12 km, where SAGE I and II saw about 7e-4 (Kent et al. 1998,
 * J. Geophys. Res. 103:28863: 1e-4 to 7e-4 at 1.02 um by latitude).
 *
 * Clouds: of the rays that SAGE followed, 30 % reached 7 km in the tropics and 60 % at high
 * latitudes (Woodbury & McCormick 1986, J. Geophys. Res. 91:2775). With the spread of
 * shadow_light.c half are hidden at 8.3 and 6.4 km; 45 deg is put between by its latitude. */
#include "environment/limb_profile.h"

#include <math.h>
#include <stddef.h>

#include "base/core/constants.h"
#include "environment/standard_air.h"

#define REFERENCE      0.55e-6 /* wavelength of the refractivity [m] */
#define TROPICS_HIGHER 3e3     /* that the aerosol of their stratosphere lies [m] */

static const double latitude_deg[UM_LIMB_ZONES] = {15.0, 45.0, 60.0};
static const double ozone_dobson[UM_LIMB_ZONES] = {259.0, 318.0, 327.0};
static const double cloud_top[UM_LIMB_ZONES] = {8.3e3, 7.0e3, 6.4e3};

#define OZONE_ROWS 34
#define DENSE_ROWS 31
#define DENSE_STEP 2e3 /* [m] up to 60 km; then 70, 80 and 100 km */
static const double ozone[UM_LIMB_ZONES][OZONE_ROWS] = {
    /* [Dobson units/km] */
    {2.41,  2.32,  2.02,  1.85,   1.67,  1.67, 1.85,   1.93,    2.02,     4.92,   9.49,  11.3,
     14.6,  15.3,  14.4,  12.1,   9.34,  6.94, 4.94,   3.37,    2.23,     1.4,    0.857, 0.527,
     0.332, 0.219, 0.145, 0.0952, 0.062, 0.04, 0.0258, 0.00197, 0.000487, 1.5e-05},
    {2.5,   2.27,  2.35,  2.77,   3.52,  5.21,   7.94,   9.84,    9.86,     11.9,    15.2,  15.4,
     14.4,  12.8,  10.6,  8.5,    6.94,  5.44,   4.1,    2.96,    2.04,     1.3,     0.803, 0.5,
     0.317, 0.201, 0.132, 0.0863, 0.057, 0.0381, 0.0256, 0.00226, 0.000301, 1.55e-05},
    {1.9,   2.05,  2.22,  2.53,   3.57,   6.81,   8.35,   11.3,    12.9,     15.2,    17.3,  16.6,
     14.3,  11.4,  9.04,  7.07,   5.84,   4.64,   3.54,   2.59,    1.79,     1.13,    0.714, 0.441,
     0.273, 0.178, 0.118, 0.0777, 0.0516, 0.0346, 0.0232, 0.00259, 0.000229, 1.58e-05},
};

static const struct {
  double height, extinction; /* [km], [1/km] at 0.55 um */
} aerosol[] = {
    {10, 0.0},     {11, 7.57e-4}, {12, 6.53e-4}, {13, 5.70e-4}, {14, 5.44e-4},   {15, 5.19e-4},
    {16, 5.12e-4}, {17, 5.13e-4}, {18, 5.41e-4}, {19, 5.36e-4}, {20, 5.06e-4},   {21, 4.27e-4},
    {22, 3.58e-4}, {23, 2.71e-4}, {24, 1.94e-4}, {25, 1.40e-4}, {30, 3.32e-5},   {35, 1.64e-5},
    {40, 7.99e-6}, {45, 4.01e-6}, {50, 2.10e-6}, {70, 1.60e-7}, {100, 9.31e-10},
};
#define AEROSOL_ROWS (sizeof aerosol / sizeof aerosol[0])

/* Exponential between two values; linear from none. */
static double between(double low, double high, double x)
{
  return low > 0.0 ? low * pow(high / low, x) : x * high;
}

/* As its last two rows go on above them; that of the ground below it. */
static double ozone_density(const double row[OZONE_ROWS], double height)
{
  static const double above[] = {60e3, 70e3, 80e3, 100e3};
  double place = fmax(height, 0.0) / DENSE_STEP;
  if (place < DENSE_ROWS - 1) {
    size_t k = (size_t)place;
    return between(row[k], row[k + 1], place - (double)k);
  }
  size_t k = height < above[1] ? 0 : height < above[2] ? 1 : 2;
  double x = (height - above[k]) / (above[k + 1] - above[k]);
  return between(row[DENSE_ROWS - 1 + k], row[DENSE_ROWS + k], x);
}

static double aerosol_density(double height)
{
  double km = height * 1e-3;
  size_t k = 1;
  if (km <= aerosol[0].height) return 0.0;
  while (k + 1 < AEROSOL_ROWS && km > aerosol[k].height) k++;
  double x = (km - aerosol[k - 1].height) / (aerosol[k].height - aerosol[k - 1].height);
  return between(aerosol[k - 1].extinction, aerosol[k].extinction, x);
}

static double standard_refractivity(const void *self, double height)
{
  (void)self;
  return um_environment_refractivity(REFERENCE) * um_environment_standard_air_density(height) /
         um_environment_standard_air_density(0.0);
}

static double standard_density(const void *self, enum um_environment_limb_constituent which,
                               double height)
{
  enum um_environment_limb_zone zone = *(const enum um_environment_limb_zone *)self;
  switch (which) {
  case UM_LIMB_AIR:
    return um_environment_standard_air_density(height);
  case UM_LIMB_OZONE:
    return ozone_density(ozone[zone], height);
  case UM_LIMB_HAZE:
    return exp(-height / 2e3);
  default:
    return aerosol_density(height - (zone == UM_LIMB_TROPICAL ? TROPICS_HIGHER : 0.0));
  }
}

struct um_environment_limb_profile um_environment_limb_standard(enum um_environment_limb_zone zone)
{
  static const enum um_environment_limb_zone zones[] = {UM_LIMB_TROPICAL, UM_LIMB_MIDDLE,
                                                        UM_LIMB_HIGH};
  return (struct um_environment_limb_profile){standard_refractivity, standard_density,
                                              &zones[zone]};
}

void um_environment_limb_zones(double latitude, double share[UM_LIMB_ZONES])
{
  double deg = fabs(latitude) / UM_DEG;
  for (int z = 0; z < UM_LIMB_ZONES; z++) share[z] = 0.0;
  int k = deg < latitude_deg[UM_LIMB_MIDDLE] ? UM_LIMB_TROPICAL : UM_LIMB_MIDDLE;
  double x = (deg - latitude_deg[k]) / (latitude_deg[k + 1] - latitude_deg[k]);
  share[k + 1] = fmin(fmax(x, 0.0), 1.0);
  share[k] = 1.0 - share[k + 1];
}

double um_environment_limb_zone_ozone(enum um_environment_limb_zone zone)
{
  return ozone_dobson[zone];
}

double um_environment_limb_zone_cloud(enum um_environment_limb_zone zone)
{
  return cloud_top[zone];
}
