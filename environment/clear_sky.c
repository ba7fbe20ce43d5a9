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
 * 0, 45, 60 and 70 deg, no aerosol), cell by cell (clear_sky_cells.c). */
#include "environment/clear_sky.h"

#include <math.h>
#include <stddef.h>

#include "base/core/planck.h"
#include "environment/cirrus.h"
#include "environment/clear_sky_cells_impl.h"
#include "environment/limb_air.h"
#include "environment/sky_table.h"

#define LINES         0.6    /* exponents of the curves of growth [1] */
#define OXYGEN        0.5    /* [1] */
#define CARBON        0.8    /* [1] */
#define OZONE         0.7    /* [1] */
#define COOLING       0.25   /* [1] */
#define SCALE         8400.0 /* of pressure [m] */
#define LAPSE         6.5e-3 /* of temperature (US Standard Atmosphere 1976) [K/m] */
#define WATER_SCALE   2000.0 /* of water vapour [m] */
#define DOBSON_PER_CM 1000.0 /* [DU/cm] */
#define CIRRUS        225.0  /* temperature at 10 km (US Standard Atmosphere 1976: 223 K) [K] */

#define VISIBLE_FROM 0.30e-6 /* [m] */
#define VISIBLE_TO   1.16e-6
/* Beyond LOWTRAN7's table water's band at 1.13 um is taken as that at 0.94 um. */
#define BORROWED 0.19e-6

/* Temperature near the ground, of glowing ozone [K], water [mm], ozone [DU] (Anderson et al. 1986,
 * AFGL-TR-86-0110). Of ozone's the standard's is that of its layer; the others are as much warmer
 * and colder as fits of their columns have them, which say no more: 10 K more all round fit as
 * well. */
static const struct {
  double temperature, ozone_temperature, water, ozone;
} profiles[UM_SKY_PROFILES] = {
    [UM_SKY_US_STANDARD] = {288.2, 234.0, 14.18, 344.0},
    [UM_SKY_MID_LATITUDE_SUMMER] = {294.2, 247.0, 29.2, 332.0},
    [UM_SKY_MID_LATITUDE_WINTER] = {272.2, 229.0, 8.53, 377.0},
};

struct um_environment_clear_sky um_environment_clear_sky_of(enum um_environment_sky_profile profile,
                                                            double height)
{
  return (struct um_environment_clear_sky){
      .present = true,
      .temperature = profiles[profile].temperature - LAPSE * height,
      .ozone_temperature = profiles[profile].ozone_temperature,
      .water = profiles[profile].water * exp(-height / WATER_SCALE),
      .ozone_dobson = profiles[profile].ozone,
      .angstrom = 1.3,
      .cirrus_temperature = CIRRUS,
      .pressure = exp(-height / SCALE)};
}

/* Rounding of an edge that is meant. */
#define EDGE 1e-12

bool um_environment_clear_sky_covers(const struct um_environment_clear_sky *sky, double from,
                                     double to)
{
  if (sky->table != NULL) return um_environment_sky_table_covers(sky->table, from, to);
  double longest = 1.0 / UM_INFRARED_FIRST;
  double shortest = 1.0 / (UM_INFRARED_FIRST + UM_INFRARED_STEP * (UM_INFRARED_NODES - 1));
  return (from >= VISIBLE_FROM - EDGE && to <= VISIBLE_TO + EDGE) ||
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

/* Lines of the cell that a wavelength lies in; none below the first. */
static struct um_environment_visible_cell lines_at(double wavelength)
{
  const double last = UM_VISIBLE_FROM + UM_VISIBLE_STEP * UM_VISIBLE_CELLS;
  if (wavelength < UM_VISIBLE_FROM) return (struct um_environment_visible_cell){0.0, 0.0};
  if (wavelength >= last) wavelength -= BORROWED;
  size_t c = (size_t)((wavelength - UM_VISIBLE_FROM) / UM_VISIBLE_STEP);
  return um_environment_visible_cells[c < UM_VISIBLE_CELLS ? c : UM_VISIBLE_CELLS - 1];
}

static double visible_at(const struct um_environment_clear_sky *sky, double wavelength, double x)
{
  struct um_environment_visible_cell lines = lines_at(wavelength);
  double depth[UM_LIMB_CONSTITUENTS];
  um_environment_limb_depth(wavelength, depth);
  double sum = (depth[UM_LIMB_AIR] * sky->pressure + depth[UM_LIMB_OZONE] * sky->ozone_dobson +
                aerosol_depth(sky, wavelength)) *
               x;
  sum += lines.water * pow(0.1 * sky->water * x, LINES);
  sum += lines.uniform * sky->pressure * pow(x, OXYGEN);
  return exp(-sum) * past_ice(sky, um_environment_ice_at(wavelength).extinction, x);
}

struct layers {
  double lower, ozone; /* transmissions [1] */
  double cooling;      /* [K] */
};

struct um_environment_infrared_amounts
um_environment_infrared_amounts(const struct um_environment_clear_sky *sky, double airmass)
{
  double w = 0.1 * sky->water, ozone = sky->ozone_dobson / DOBSON_PER_CM;
  return (struct um_environment_infrared_amounts){.uniform = sky->pressure * pow(airmass, CARBON),
                                                  .water = pow(w * airmass, LINES),
                                                  .continuum = w * w * airmass,
                                                  .ozone = pow(ozone * airmass, OZONE)};
}

static struct layers infrared_at(const struct um_environment_clear_sky *sky, double wavelength,
                                 double x)
{
  struct um_environment_infrared_node k = um_environment_infrared_at(1.0 / wavelength);
  struct um_environment_infrared_amounts a = um_environment_infrared_amounts(sky, x);
  double lower = k.uniform * a.uniform + k.water * a.water + k.continuum * a.continuum +
                 aerosol_depth(sky, wavelength) * x;
  return (struct layers){exp(-lower), exp(-k.ozone * a.ozone), k.cooling};
}

typedef double at_wavelength(const struct um_environment_clear_sky *, double wavelength,
                             double airmass);

static double transmission_at(const struct um_environment_clear_sky *sky, double wavelength,
                              double x)
{
  if (wavelength <= VISIBLE_TO) return visible_at(sky, wavelength, x);
  struct layers l = infrared_at(sky, wavelength, x);
  return l.lower * l.ozone * past_ice(sky, um_environment_ice_at(wavelength).extinction, x);
}

static double radiance_at(const struct um_environment_clear_sky *sky, double wavelength, double x)
{
  if (wavelength <= VISIBLE_TO) return 0.0;
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
  double step =
      to <= VISIBLE_TO + EDGE ? UM_VISIBLE_STEP / 4.0 : UM_INFRARED_STEP * from * from / 2.0;
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
