/* A ray whose lowest point is at height h over a sphere of radius R runs at heights
 * z(s) = sqrt((R + h)^2 + s^2) - R, s the way from that point. A constituent of density n has on it
 *
 *   column N(h) = 2 int_0^inf n(z(s)) ds,
 *
 * and refraction turns it by the change of its optical path with height,
 *
 *   alpha(h) = -2 int_0^inf (R + h)/(R + z) d(refractivity)/dz ds,
 *
 * to first order in both (Link 1969, Eclipse Phenomena in Astronomy, ch. 1). For an exponential
 * atmosphere these are close to n(h) sqrt(2 pi R H) and (n - 1)(h) sqrt(2 pi R/H).
 *
 * Ozone lies in a layer n = e^x/(1 + e^x)^2, x = (z - 20 km)/5 km (Lacis & Hansen 1974, J. Atmos.
 * Sci. 31:118). Haze falls by e in 2 km. The aerosol of the stratosphere is given the same form as
 * ozone, at 16 km, 2.5 km: assumed, after the profiles of SAGE II outside volcanic years. */
#include "environment/limb_air.h"

#include <math.h>
#include <stddef.h>

#include "environment/standard_air.h"

#define REFRACTIVITY  2.92e-4   /* n - 1 on the ground, 0.55 um, 0 deg C: docs/physics/shadow.md */
#define POINTS        400       /* along half a ray */
#define LONGEST       1600e3    /* [m] of half a ray: 200 km above its lowest point */
#define DIFFERENCE    10.0      /* [m] of height */
#define VERTICAL_STEP 50.0      /* [m] */
#define HIGHEST       150e3     /* [m] of the vertical column */
#define DOBSON        2.6867e20 /* molecules of a Dobson unit [1/m^2] */

static double layer(double height, double centre, double width)
{
  double x = exp((height - centre) / width);
  return x / ((1.0 + x) * (1.0 + x));
}

static double standard_refractivity(const void *self, double height)
{
  (void)self;
  return REFRACTIVITY * um_environment_standard_air_density(height) /
         um_environment_standard_air_density(0.0);
}

static double standard_density(const void *self, enum um_environment_limb_constituent which,
                               double height)
{
  (void)self;
  switch (which) {
  case UM_LIMB_AIR:
    return um_environment_standard_air_density(height);
  case UM_LIMB_OZONE:
    return layer(height, 20e3, 5e3);
  case UM_LIMB_HAZE:
    return exp(-height / 2e3);
  default:
    return layer(height, 16e3, 2.5e3);
  }
}

struct um_environment_limb_profile um_environment_limb_standard(void)
{
  return (struct um_environment_limb_profile){standard_refractivity, standard_density, NULL};
}

/* Points s = LONGEST x^2 of a midpoint rule: dense where the ray is low. */
static double way(int i, double *weight)
{
  double x = (i + 0.5) / POINTS;
  *weight = 2.0 * x * LONGEST / POINTS;
  return LONGEST * x * x;
}

static double bending(const struct um_environment_limb_profile *p, double radius, double h)
{
  double sum = 0.0, weight;
  for (int i = 0; i < POINTS; i++) {
    double s = way(i, &weight), z = hypot(radius + h, s) - radius;
    double up = p->refractivity(p->self, z + DIFFERENCE);
    double down = p->refractivity(p->self, z - DIFFERENCE);
    sum += weight * (down - up) / (2.0 * DIFFERENCE) * (radius + h) / (radius + z);
  }
  return 2.0 * sum;
}

static double column(const struct um_environment_limb_profile *p,
                     enum um_environment_limb_constituent which, double radius, double h)
{
  double sum = 0.0, weight;
  for (int i = 0; i < POINTS; i++) {
    double s = way(i, &weight);
    sum += weight * p->density(p->self, which, hypot(radius + h, s) - radius);
  }
  return 2.0 * sum;
}

static double vertical(const struct um_environment_limb_profile *p,
                       enum um_environment_limb_constituent which)
{
  double sum = 0.0;
  for (double z = 0.5 * VERTICAL_STEP; z < HIGHEST; z += VERTICAL_STEP)
    sum += VERTICAL_STEP * p->density(p->self, which, z);
  return sum;
}

void um_environment_limb_air_make(const struct um_environment_limb_profile *profile, double radius,
                                  struct um_environment_limb_air *out)
{
  for (int k = 0; k < UM_LIMB_NODES; k++)
    out->bending[k] = bending(profile, radius, k * UM_LIMB_STEP);
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) {
    double whole = vertical(profile, (enum um_environment_limb_constituent)c);
    for (int k = 0; k < UM_LIMB_NODES; k++)
      out->column[c][k] = whole > 0.0 ? column(profile, (enum um_environment_limb_constituent)c,
                                               radius, k * UM_LIMB_STEP) /
                                            whole
                                      : 0.0;
  }
}

/* Absorption cross-section of ozone [1e-26 m^2]. Hartley and Huggins bands below 0.36 um rounded
 * (Molina & Molina 1986, J. Geophys. Res. 91:14501): a ray in the limb is dark there. */
static const struct {
  double wavelength, area; /* [nm], [1e-26 m^2] */
} ozone[] = {
    {250, 110000}, {280, 39000}, {290, 14000}, {300, 3900},  {310, 1000},  {320, 290},
    {330, 64},     {340, 16},    {350, 3.4},   {370, 0.070}, {390, 0.047}, {410, 0.214},
    {430, 0.699},  {450, 1.95},  {470, 4.30},  {490, 8.38},  {510, 15.4},  {530, 24.5},
    {550, 33.0},   {570, 44.7},  {590, 45.5},  {610, 46.6},  {630, 34.8},  {650, 24.5},
    {670, 16.6},   {690, 10.8},  {710, 7.01},  {730, 4.63},  {750, 3.73},  {770, 2.63},
    {790, 2.08},   {810, 1.77},  {830, 1.05},  {1000, 0.01},
};
#define OZONE_ROWS (sizeof ozone / sizeof ozone[0])

/* Log of the area linear in wavelength. */
static double ozone_area(double wavelength)
{
  double nm = wavelength * 1e9;
  if (nm >= ozone[OZONE_ROWS - 1].wavelength) return 0.0;
  if (nm <= ozone[0].wavelength) return ozone[0].area * 1e-26;
  size_t k = 1;
  while (nm > ozone[k].wavelength) k++;
  double x = (nm - ozone[k - 1].wavelength) / (ozone[k].wavelength - ozone[k - 1].wavelength);
  return 1e-26 * exp((1.0 - x) * log(ozone[k - 1].area) + x * log(ozone[k].area));
}

/* Bodhaine et al. 1999, eq. 30, for 0.25 um on; shorter waves as there, where nothing passes. */
static double rayleigh(double wavelength)
{
  double um = fmax(wavelength * 1e6, 0.25), l2 = um * um;
  return 0.0021520 * (1.0455996 - 341.29061 / l2 - 0.90230850 * l2) /
         (1.0 + 0.0027059889 / l2 - 85.968563 * l2);
}

void um_environment_limb_depth(double wavelength, double depth[UM_LIMB_CONSTITUENTS])
{
  depth[UM_LIMB_AIR] = rayleigh(wavelength);
  depth[UM_LIMB_OZONE] = ozone_area(wavelength) * DOBSON;
  depth[UM_LIMB_HAZE] = depth[UM_LIMB_AEROSOL] = pow(wavelength / 0.55e-6, -1.3);
}
