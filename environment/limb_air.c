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
 * The bent ray keeps p = n r sin(chi) (Bouguer), chi its angle from the vertical, r0 its lowest
 * point, n(r0) r0 = p = R + b:
 *
 *   N(b) = 2 int n(r) x/sqrt(x^2 - p^2) dr,   x = (1 + refractivity) r,
 *   alpha(b) = -2 int d(refractivity)/dr p/((1 + refractivity) sqrt(x^2 - p^2)) dr.
 *
 * At b = 10 km it runs 0.6 km lower than a straight one, through 14 % more air. */
#include "environment/limb_air.h"

#include <math.h>
#include <stddef.h>

#include "environment/standard_air.h"

#define POINTS        400    /* along half a ray */
#define LONGEST       1600e3 /* [m] of half a ray: 200 km above its lowest point */
#define DIFFERENCE    10.0   /* [m] of height */
#define VERTICAL_STEP 50.0   /* [m] */
#define HIGHEST       150e3  /* [m] of the vertical column, and of bent rays */
#define MOST_LIFTED   5e3    /* [m] that a bent ray passes below its impact height */
#define HALVINGS      50
#define BENT_POINTS   150       /* along half a bent ray */
#define DOBSON        2.6867e20 /* molecules of a Dobson unit [1/m^2] */

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
  for (int k = 0; k < UM_LIMB_NODES; k++) {
    out->height[k] = k * UM_LIMB_STEP;
    out->bending[k] = bending(profile, radius, k * UM_LIMB_STEP);
  }
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) {
    double whole = vertical(profile, (enum um_environment_limb_constituent)c);
    for (int k = 0; k < UM_LIMB_NODES; k++)
      out->column[c][k] = whole > 0.0 ? column(profile, (enum um_environment_limb_constituent)c,
                                               radius, k * UM_LIMB_STEP) /
                                            whole
                                      : 0.0;
  }
}

/* --- bent rays -------------------------------------------------------------------------------- */

static double index_of(const struct um_environment_limb_profile *p, double height)
{
  return 1.0 + p->refractivity(p->self, height);
}

/* Height of the lowest point of the ray of an impact height: n r ascends with r. */
static double lowest(const struct um_environment_limb_profile *p, double radius, double impact)
{
  double low = impact - MOST_LIFTED, high = impact;
  for (int i = 0; i < HALVINGS; i++) {
    double middle = 0.5 * (low + high);
    *(index_of(p, middle) * (radius + middle) < radius + impact ? &low : &high) = middle;
  }
  return 0.5 * (low + high);
}

/* Points r = r0 + u^2 of a midpoint rule along half a bent ray, and x/sqrt(x^2 - p^2) dr there. */
struct bent {
  double radius, impact, from; /* R, b, r0 - R [m] */
};
static double bent_at(const struct um_environment_limb_profile *p, const struct bent *ray, int i,
                      double *height)
{
  double step = sqrt(HIGHEST - ray->from) / BENT_POINTS, u = (i + 0.5) * step;
  *height = ray->from + u * u;
  double x = index_of(p, *height) * (ray->radius + *height), b = ray->radius + ray->impact;
  return 2.0 * u * step * x / sqrt((x - b) * (x + b));
}

/* d(refractivity)/dz over the index [1/m] */
static double slope(const struct um_environment_limb_profile *p, double height)
{
  double up = p->refractivity(p->self, height + DIFFERENCE);
  double down = p->refractivity(p->self, height - DIFFERENCE);
  return (up - down) / (2.0 * DIFFERENCE * index_of(p, height));
}

void um_environment_limb_air_bent(const struct um_environment_limb_profile *profile, double radius,
                                  struct um_environment_limb_air *out)
{
  double whole[UM_LIMB_CONSTITUENTS];
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++)
    whole[c] = vertical(profile, (enum um_environment_limb_constituent)c);
  for (int k = 0; k < UM_LIMB_NODES; k++) {
    struct bent ray = {radius, k * UM_LIMB_STEP, lowest(profile, radius, k * UM_LIMB_STEP)};
    double sum[UM_LIMB_CONSTITUENTS] = {0.0}, bending = 0.0, height;
    for (int i = 0; i < BENT_POINTS; i++) {
      double way = bent_at(profile, &ray, i, &height);
      double sine = (radius + ray.impact) / (index_of(profile, height) * (radius + height));
      bending -= 2.0 * way * slope(profile, height) * sine;
      for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++)
        sum[c] += 2.0 * way *
                  profile->density(profile->self, (enum um_environment_limb_constituent)c, height);
    }
    out->height[k] = ray.from;
    out->bending[k] = bending;
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++)
      out->column[c][k] = whole[c] > 0.0 ? sum[c] / whole[c] : 0.0;
  }
}

double um_environment_limb_dispersion(double wavelength)
{
  return um_environment_refractivity(wavelength) / um_environment_refractivity(0.55e-6);
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

/* Extinction of droplets of sulphuric acid over that at 0.55 um: the background of LOWTRAN7. */
static const struct {
  double wavelength, extinction; /* [um], [1] */
} droplet[] = {
    {0.2, 2.0752},   {0.3, 1.8656},   {0.3371, 1.7246},  {0.55, 1.0},      {0.6943, 0.70156},
    {1.06, 0.3017},  {1.536, 0.1144}, {2.0, 0.051225},   {2.25, 0.034285}, {2.5, 0.023475},
    {2.7, 0.016878}, {3.0, 0.066506}, {3.3923, 0.10943}, {3.75, 0.089653}, {4.5, 0.067609},
};
#define DROPLET_ROWS (sizeof droplet / sizeof droplet[0])

/* Log of it linear in that of the wavelength; the ends' beyond them. */
static double droplets(double wavelength)
{
  double um = wavelength * 1e6;
  if (um <= droplet[0].wavelength) return droplet[0].extinction;
  if (um >= droplet[DROPLET_ROWS - 1].wavelength) return droplet[DROPLET_ROWS - 1].extinction;
  size_t k = 1;
  while (um > droplet[k].wavelength) k++;
  double x =
      log(um / droplet[k - 1].wavelength) / log(droplet[k].wavelength / droplet[k - 1].wavelength);
  return droplet[k - 1].extinction * pow(droplet[k].extinction / droplet[k - 1].extinction, x);
}

void um_environment_limb_depth(double wavelength, double depth[UM_LIMB_CONSTITUENTS])
{
  depth[UM_LIMB_AIR] = rayleigh(wavelength);
  depth[UM_LIMB_OZONE] = ozone_area(wavelength) * DOBSON;
  depth[UM_LIMB_HAZE] = pow(wavelength / 0.55e-6, -1.3);
  depth[UM_LIMB_AEROSOL] = droplets(wavelength);
}
