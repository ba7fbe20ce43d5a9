/* Transmission of clear air, in cells of wavelength that hold coefficients. With x the airmass, w
 * the precipitable water [cm], o the ozone [atm cm], p the pressure [of sea level's]: visible   -ln
 * t = (tau_R p + tau_O3 + tau_a) x + k_w (w x)^0.6 + k_u p (x)^0.5 infrared  -ln t = k_u p x^0.8 +
 * k_w (w x)^0.6 + k_c w^2 x + k_o (o x)^0.7 + tau_a x Rayleigh and ozone's tau as at the Earth's
 * limb (limb_air.h); k_w lines of water vapour and k_u of oxygen, carbon dioxide and the like,
 * whose cores are black, so that they grow less than their amount (curve of growth: Goody & Yung
 * 1989, ch. 4); k_c water's continuum, which grows with its own pressure (Roberts, Selby & Biberman
 * 1976, Appl. Opt. 15:2085). The infrared glows as two layers: ozone at its temperature behind all
 * else, which is colder than the ground by d t^0.25 of its own transmission t, L = (1 - t) B(T - d
 * t^0.25) + t (1 - t_o) B(T_o). Cirrus hangs between the two at its own temperature: it takes its
 * extinction from what passes, e^(-e c x), glows by its absorption, (1 - a) B(T_c), a = e^(-k c x),
 * and lets a of the ozone's heat through, since what it scatters goes nearly straight on
 * (cirrus.h). Coefficients: least squares of ours to twelve columns of LOWTRAN7 (three profiles at
 * 0, 45, 60 and 70 deg, no aerosol). Fitted without the three columns at 60 deg they give those to
 * 0.006 in the infrared and 0.010 in the visible. */
#include "environment/clear_sky.h"

#include <math.h>
#include <stddef.h>

#include "base/core/planck.h"
#include "environment/cirrus.h"
#include "environment/limb_air.h"
#include "environment/sky_table.h"

#define LINES         0.6    /* exponents of the curves of growth [1] */
#define OXYGEN        0.5    /* [1] */
#define CARBON        0.8    /* [1] */
#define OZONE         0.7    /* [1] */
#define COOLING       0.25   /* [1] */
#define SCALE         8400.0 /* of pressure [m] */
#define WATER_SCALE   2000.0 /* of water vapour [m] */
#define DOBSON_PER_CM 1000.0 /* [DU/cm] */
#define CIRRUS        225.0  /* temperature at 10 km (US Standard Atmosphere 1976: 223 K) [K] */

/* Cells of 20 nm from 0.30 um: k_w, k_u. */
#define VISIBLE_FROM 0.30e-6 /* [m] */
#define VISIBLE_STEP 0.02e-6 /* [m] */
static const struct {
  double water, uniform;
} visible[] = {{0, 0},
               {0, 0},
               {0, 0},
               {0, 0},
               {0, 0},
               {0, 0},
               {0, 0},
               {0, 0},
               {0, 0},
               {0, 0},
               {0, 0},
               {0, 0},
               {0, 0},
               {0.00278, 0},
               {0.015, 0},
               {0, 0},
               {0.00296, 0.00373},
               {0.0143, 0},
               {0.000655, 0},
               {0.0187, 0.0335},
               {0.0522, 0},
               {0.0784, 0},
               {0.00324, 0.0101},
               {0, 0.161},
               {0.0137, 0},
               {0.045, 0},
               {0.0514, 0},
               {0.00971, 0},
               {0.000287, 0},
               {0.0351, 0.00384},
               {0.165, 0.000919},
               {0.277, 0.0733},
               {0.424, 0},
               {0.155, 0.00602},
               {0.0219, 0.000804},
               {0.0119, 0.00033},
               {0.00511, 0.000171},
               {0.00139, 0.000284},
               {0.0142, 0.0015},
               {0.0715, 0.00257},
               /* beyond LOWTRAN7's table: water's band at 1.13 um taken as that at 0.94 um */
               {0.155, 0},
               {0.424, 0},
               {0.424, 0}};
#define NVISIBLE (sizeof visible / sizeof visible[0])

/* Cells of 25 1/cm from 700 1/cm: k_u, k_w, k_c, k_o, d [K]. */
#define INFRARED_FROM 70000.0 /* [1/m] */
#define INFRARED_STEP 2500.0  /* [1/m] */
static const struct {
  double uniform, water, continuum, ozone, cooling;
} infrared[] = {{0, 1.444, 0, 5.464, 0},
                {0, 0.8589, 0.02448, 2.063, 0},
                {0, 0.3538, 0.04995, 0.6121, 0.25},
                {0, 0.1855, 0.05777, 0.2119, 2.25},
                {0, 0.1227, 0.05078, 0.1108, 2.75},
                {0.02616, 0.05078, 0.04591, 0.007422, 6.25},
                {0.02292, 0.05691, 0.04011, 0, 7},
                {0.02491, 0.04263, 0.03558, 0, 7.75},
                {0.02566, 0.03563, 0.03141, 0, 7.5},
                {0.03154, 0.03555, 0.02762, 0, 7.25},
                {0.0322, 0.04677, 0.02458, 0.007851, 7.5},
                {0.02736, 0.0226, 0.0234, 0.1318, 8.25},
                {0, 0, 0.02256, 0.8936, 6},
                {0.02698, 0, 0.01932, 1.789, 6.75},
                {0, 0.04609, 0.01771, 1.093, 5.25},
                {0.03226, 0.05056, 0.01803, 0.1082, 8},
                {0.01394, 0.07109, 0.01796, 0.0724, 7.25},
                {0.0252, 0.08242, 0.01793, 0.08946, 7},
                {0.0363, 0.1234, 0.01785, 0.0625, 6.75},
                {0.02793, 0.1868, 0.01856, 0.04605, 6.25},
                {0, 0.2728, 0.01915, 0.07566, 4.75},
                {0.004518, 0.3687, 0.02132, 0.2409, 3.25},
                {0, 0.8879, 0.008236, 0.7049, 3.25},
                {0.3721, 1.037, 0.03454, 0.5935, 6.25},
                {0.5769, 1.608, 0.06508, 0, 8.25},
                {0.1571, 2.712, 0.09965, 0, 8},
                {0, 2.559, 0, 3.665, 4},
                {0, 1.051, 0, 8.902, 0},
                {0, 0.8502, 0, 9.621, 0}};
#define NINFRARED (sizeof infrared / sizeof infrared[0])

/* Temperature near the ground, of glowing ozone [K], water [mm], ozone [DU] (Anderson et al. 1986,
 * AFGL-TR-86-0110; the second fitted). */
static const struct {
  double temperature, ozone_temperature, water, ozone;
} profiles[UM_SKY_PROFILES] = {
    [UM_SKY_US_STANDARD] = {288.2, 242.0, 14.18, 344.0},
    [UM_SKY_MID_LATITUDE_SUMMER] = {294.2, 261.0, 29.2, 332.0},
    [UM_SKY_MID_LATITUDE_WINTER] = {272.2, 241.0, 8.53, 377.0},
};

struct um_environment_clear_sky um_environment_clear_sky_of(enum um_environment_sky_profile profile,
                                                            double height)
{
  return (struct um_environment_clear_sky){.present = true,
                                           .temperature = profiles[profile].temperature,
                                           .ozone_temperature = profiles[profile].ozone_temperature,
                                           .water =
                                               profiles[profile].water * exp(-height / WATER_SCALE),
                                           .ozone_dobson = profiles[profile].ozone,
                                           .angstrom = 1.3,
                                           .cirrus_temperature = CIRRUS,
                                           .pressure = exp(-height / SCALE)};
}

static double visible_to(void)
{
  const size_t n = NVISIBLE;
  return VISIBLE_FROM + VISIBLE_STEP * (double)n;
}

/* Rounding of an edge that is meant. */
#define EDGE 1e-12

bool um_environment_clear_sky_covers(const struct um_environment_clear_sky *sky, double from,
                                     double to)
{
  if (sky->table != NULL) return um_environment_sky_table_covers(sky->table, from, to);
  const size_t n = NINFRARED;
  double longest = 1.0 / INFRARED_FROM;
  double shortest = 1.0 / (INFRARED_FROM + INFRARED_STEP * (double)n);
  return (from >= VISIBLE_FROM - EDGE && to <= visible_to() + EDGE) ||
         (from >= shortest - EDGE && to <= longest + EDGE);
}

static double aerosol_depth(const struct um_environment_clear_sky *sky, double wavelength)
{
  if (!(sky->aerosol > 0.0)) return 0.0;
  return sky->aerosol * pow(wavelength / 0.55e-6, -sky->angstrom);
}

/* What cirrus leaves of a beam, and of the heat behind it [1]. */
static double past_ice(const struct um_environment_clear_sky *sky, double per_depth, double x)
{
  return sky->cirrus > 0.0 ? exp(-per_depth * sky->cirrus * x) : 1.0;
}

/* At a wavelength of the visible cell that it lies in. */
static double visible_at(const struct um_environment_clear_sky *sky, double wavelength, double x)
{
  double place = (wavelength - VISIBLE_FROM) / VISIBLE_STEP, depth[UM_LIMB_CONSTITUENTS];
  size_t c = place > 0.0 ? (size_t)place : 0;
  if (c >= NVISIBLE) c = NVISIBLE - 1;
  um_environment_limb_depth(wavelength, depth);
  double sum = (depth[UM_LIMB_AIR] * sky->pressure + depth[UM_LIMB_OZONE] * sky->ozone_dobson +
                aerosol_depth(sky, wavelength)) *
               x;
  sum += visible[c].water * pow(0.1 * sky->water * x, LINES);
  sum += visible[c].uniform * sky->pressure * pow(x, OXYGEN);
  return exp(-sum) * past_ice(sky, um_environment_ice_at(wavelength).extinction, x);
}

struct layers {
  double lower, ozone; /* transmissions [1] */
  double cooling;      /* [K] */
};

static struct layers infrared_at(const struct um_environment_clear_sky *sky, double wavelength,
                                 double x)
{
  double place = (1.0 / wavelength - INFRARED_FROM) / INFRARED_STEP, w = 0.1 * sky->water;
  size_t c = place > 0.0 ? (size_t)place : 0;
  if (c >= NINFRARED) c = NINFRARED - 1;
  double lower = infrared[c].uniform * sky->pressure * pow(x, CARBON) +
                 infrared[c].water * pow(w * x, LINES) + infrared[c].continuum * w * w * x +
                 aerosol_depth(sky, wavelength) * x;
  double ozone = infrared[c].ozone * pow(sky->ozone_dobson / DOBSON_PER_CM * x, OZONE);
  return (struct layers){exp(-lower), exp(-ozone), infrared[c].cooling};
}

typedef double at_wavelength(const struct um_environment_clear_sky *, double wavelength,
                             double airmass);

static double transmission_at(const struct um_environment_clear_sky *sky, double wavelength,
                              double x)
{
  if (wavelength <= visible_to()) return visible_at(sky, wavelength, x);
  struct layers l = infrared_at(sky, wavelength, x);
  return l.lower * l.ozone * past_ice(sky, um_environment_ice_at(wavelength).extinction, x);
}

static double radiance_at(const struct um_environment_clear_sky *sky, double wavelength, double x)
{
  if (wavelength <= visible_to()) return 0.0;
  struct layers l = infrared_at(sky, wavelength, x);
  double ground = sky->temperature - l.cooling * pow(l.lower, COOLING);
  double a = past_ice(sky, um_environment_ice_at(wavelength).absorption, x);
  double sum =
      (1.0 - l.lower) * um_core_planck_radiance(wavelength, ground) +
      l.lower * (1.0 - l.ozone) * um_core_planck_radiance(wavelength, sky->ozone_temperature) * a;
  if (a < 1.0)
    sum += l.lower * (1.0 - a) * um_core_planck_radiance(wavelength, sky->cirrus_temperature);
  return sum;
}

/* Mean over a bin by its middles: as many as cells of the narrower kind that it may touch. */
static double mean(at_wavelength *f, const struct um_environment_clear_sky *sky, double from,
                   double to, double x)
{
  double step = to <= visible_to() + EDGE ? VISIBLE_STEP / 4.0 : INFRARED_STEP * from * from / 4.0;
  int n = (int)ceil((to - from) / step);
  double sum = 0.0;
  if (n < 1) n = 1;
  for (int i = 0; i < n; i++) sum += f(sky, from + (to - from) * (i + 0.5) / n, x);
  return sum / n;
}

double um_environment_clear_sky_transmission(const struct um_environment_clear_sky *sky,
                                             double from, double to, double airmass)
{
  if (sky->table != NULL)
    return um_environment_sky_table_transmission(sky->table, from, to, airmass);
  return mean(transmission_at, sky, from, to, airmass);
}

double um_environment_clear_sky_radiance(const struct um_environment_clear_sky *sky, double from,
                                         double to, double airmass)
{
  if (sky->table != NULL) return um_environment_sky_table_radiance(sky->table, from, to, airmass);
  return mean(radiance_at, sky, from, to, airmass);
}
