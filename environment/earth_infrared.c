/* Upward radiance through the air of clear_sky.c, whose coefficients serve both ways:
 *
 *   L = t_o (t(0) B(T) + sum over layers of B(T_k) (t_k+1 - t_k)) + (1 - t_o) B(T_o)
 *
 * t_k is the transmission from the bottom of layer k to space without ozone, which glows above all
 * else. Amounts above a height z fall like exp(-z/H); water's continuum, going with its pressure,
 * like the square. Lapse, heights of scale and T_o, linear in the ground's temperature, are those
 * with which LOWTRAN7's upward radiance of six profiles is met best. Water vapour over ground of
 * temperature T_s [K] is that of Stephens 1990, J. Climate 3:634, 17.5 mm exp(0.064 (T_s - 288)).
 *
 * Cloud tops stand 25 K below the ground's temperature: water above them is little, so that this
 * height hardly matters. */
#include "environment/earth_infrared.h"

#include <math.h>
#include <stddef.h>

#include "base/core/constants.h"
#include "base/core/planck.h"
#include "environment/airmass.h"
#include "environment/clear_sky.h"
#include "environment/clear_sky_cells_impl.h"

#define LAPSE         6.0e-3 /* [K/m] */
#define WATER_HEIGHT  1600.0 /* [m] */
#define GAS_HEIGHT    3000.0 /* of carbon dioxide, nitrous oxide and methane, by pressure [m] */
#define TOP           12e3   /* of the layers [m] */
#define LAYERS        8
#define OZONE_AT      231.5 /* temperature of ozone over ground of 288 K [K] */
#define OZONE_SLOPE   0.483 /* [1] */
#define OZONE         340.0 /* [DU] */
#define CLOUD_BELOW   25.0  /* cloud tops below the ground's temperature [K] */
#define COLDEST_CLOUD 190.0 /* [K] */
/* What the coefficients cover [m]. */
#define SHORTEST (1.0 / (UM_INFRARED_FIRST + UM_INFRARED_STEP * (UM_INFRARED_NODES - 1)))
#define LONGEST  (1.0 / UM_INFRARED_FIRST)
#define EDGE     1e-12 /* rounding of an edge that is meant [1] */
#define VIEWS    16    /* at once */

/* Air above a black surface: of each level what of an amount is above it, and how warm the layer
 * below it is. Level 0 is the surface. */
struct column {
  struct um_environment_clear_sky air;
  double gas[LAYERS + 1], water[LAYERS + 1], continuum[LAYERS + 1]; /* [1] */
  double glow[LAYERS + 1], top, ozone;                              /* [K]; glow[0]: the surface */
};

static struct column column_of(double below, double height, double surface)
{
  struct column c = {.air = {.water = 17.5 * exp(0.064 * (surface - 288.0)),
                             .ozone_dobson = OZONE,
                             .pressure = 1.0},
                     .ozone = OZONE_AT + OZONE_SLOPE * (surface - 288.0)};
  double lower = height;
  for (int k = 0; k <= LAYERS; k++) {
    double share = (double)k / LAYERS, z = fmax(height, TOP * share * sqrt(share));
    c.gas[k] = exp(-z / GAS_HEIGHT);
    c.water[k] = exp(-0.6 * z / WATER_HEIGHT);
    c.continuum[k] = exp(-2.0 * z / WATER_HEIGHT);
    c.glow[k] = k == 0 ? below : surface - LAPSE * 0.5 * (lower + z);
    lower = z;
  }
  c.top = surface - LAPSE * fmax(lower, TOP);
  return c;
}

static void amounts_of(const struct column *c, const double *cosine, size_t n,
                       struct um_environment_infrared_amounts *out)
{
  for (size_t i = 0; i < n; i++)
    out[i] = um_environment_infrared_amounts(
        &c->air, um_environment_airmass(asin(fmin(fmax(cosine[i], 0.0), 1.0))));
}

/* Toward n views, of a wavelength that the coefficients cover. */
static void upward(const struct column *c, double wavelength,
                   const struct um_environment_infrared_amounts *amount, size_t n, double *out)
{
  struct um_environment_infrared_node k = um_environment_infrared_at(1.0 / wavelength);
  double glow[LAYERS + 1], top = um_core_planck_radiance(wavelength, c->top);
  double ozone = um_core_planck_radiance(wavelength, c->ozone);
  for (int l = 0; l <= LAYERS; l++) glow[l] = um_core_planck_radiance(wavelength, c->glow[l]);
  for (size_t i = 0; i < n; i++) {
    double gas = k.uniform * amount[i].uniform, water = k.water * amount[i].water;
    double continuum = k.continuum * amount[i].continuum, last = 0.0, sum = 0.0;
    for (int l = 0; l <= LAYERS; l++) {
      double t = exp(-gas * c->gas[l] - water * c->water[l] - continuum * c->continuum[l]);
      sum += (t - last) * glow[l];
      last = t;
    }
    double through = exp(-k.ozone * amount[i].ozone);
    out[i] = through * (sum + (1.0 - last) * top) + (1.0 - through) * ozone;
  }
}

double um_environment_earth_upward(double wavelength, double below, double height, double surface,
                                   double cosine)
{
  struct column c = column_of(below, height, surface);
  struct um_environment_infrared_amounts amount;
  double out;
  if (wavelength < SHORTEST * (1.0 - EDGE) || wavelength > LONGEST * (1.0 + EDGE))
    return um_core_planck_radiance(wavelength, below);
  amounts_of(&c, &cosine, 1, &amount);
  upward(&c, wavelength, &amount, 1, &out);
  return out;
}

/* 1 + integral of (L - B) over the integral of B, toward n <= VIEWS views: beyond what the
 * coefficients cover L is B. */
static void ratios(double from, double to, double below, double surface, const double *cosine,
                   size_t n, double *out)
{
  double first = fmax(from, SHORTEST), last = fmin(to, LONGEST);
  for (size_t i = 0; i < n; i++) out[i] = 1.0;
  if (last < first) return;
  struct column c = column_of(below, (surface - below) / LAPSE, surface);
  struct um_environment_infrared_amounts amount[VIEWS];
  double radiance[VIEWS], width = to > from ? last - first : 1.0;
  double all =
      to > from ? um_core_planck_band(from, to, below) : um_core_planck_radiance(from, below);
  if (!(all > 0.0)) return;
  int steps = (int)fmax(ceil((last - first) / (0.5 * UM_INFRARED_STEP * first * first)), 1.0);
  amounts_of(&c, cosine, n, amount);
  for (int k = 0; k < steps; k++) {
    double at = first + (last - first) * (k + 0.5) / steps;
    double black = um_core_planck_radiance(at, below);
    upward(&c, at, amount, n, radiance);
    for (size_t i = 0; i < n; i++) out[i] += width / steps * (radiance[i] - black) / all;
  }
}

void um_environment_earth_ratios(double from, double to, double temperature, const double *cosine,
                                 size_t n, double *clear, double *cloud)
{
  for (size_t i = 0; i < n; i += VIEWS) {
    size_t some = n - i < VIEWS ? n - i : VIEWS;
    ratios(from, to, temperature, temperature, cosine + i, some, clear + i);
    ratios(from, to, temperature, temperature + CLOUD_BELOW, cosine + i, some, cloud + i);
  }
}

void um_environment_earth_window_fill(double out[UM_EARTH_TEMPERATURES])
{
  const double zenith = 1.0;
  for (int k = 0; k < UM_EARTH_TEMPERATURES; k++) {
    double temperature = UM_EARTH_COLDEST + UM_EARTH_STEP * k;
    ratios(UM_EARTH_NADIR_WINDOW, UM_EARTH_NADIR_WINDOW, temperature, temperature, &zenith, 1,
           &out[k]);
  }
}

static double ratio_at(const double *table, double temperature)
{
  if (table == NULL) return 1.0;
  double place = (temperature - UM_EARTH_COLDEST) / UM_EARTH_STEP;
  place = fmin(fmax(place, 0.0), UM_EARTH_TEMPERATURES - 1.0);
  int k = (int)fmin(place, UM_EARTH_TEMPERATURES - 2.0);
  return table[k] + (place - k) * (table[k + 1] - table[k]);
}

struct um_environment_ground_parts
um_environment_ground_split(const struct um_environment_ground *ground, const double *ratio)
{
  const double at = UM_EARTH_NADIR_WINDOW;
  struct um_environment_ground_parts p = {ground->cloud, ground->surface, ground->brightness};
  double all = um_core_planck_radiance(at, ground->brightness);
  double clear = ratio_at(ratio, p.surface) * um_core_planck_radiance(at, p.surface);
  if (!(clear > all) || !(p.cover > 0.0)) {
    /* as bright as the place: the temperature whose radiance through its air is `all` */
    for (int k = 0; k < 4; k++)
      p.surface = um_core_planck_temperature(at, all / ratio_at(ratio, p.surface));
    p.top = ground->brightness;
    return p;
  }
  double coldest = um_core_planck_radiance(at, COLDEST_CLOUD);
  double cloud = (all - (1.0 - p.cover) * clear) / p.cover;
  if (!(cloud > coldest)) {
    cloud = fmin(coldest, all);
    p.cover = (clear - all) / (clear - cloud);
  }
  p.top = um_core_planck_temperature(at, cloud);
  return p;
}

/* Both constants of um_environment_earth_limb are from the mean of clear ground of 288 K and cloud
 * of 262 K, cover 0.65. */
#define LIMB_SLOPE 0.07 /* [1] */
#define LIMB_REACH 0.25 /* [1] */

double um_environment_earth_limb(double cosine)
{
  return 1.0 - LIMB_SLOPE * (1.0 / (fmax(cosine, 0.0) + LIMB_REACH) - 1.0 / (1.0 + LIMB_REACH));
}

/* Linear in the cosine, of which the flux is 1: toward the zenith 1.06, as measured of the whole
 * Earth (Smith, Manalo, Suttles & Walker 1989, limb-darkening functions of ERBE's scanners along
 * the track, 1.02 to 1.09 and typically 1.06). */
#define ANISOTROPY 0.18

double um_environment_earth_anisotropy(double cosine)
{
  return 1.0 + ANISOTROPY * (cosine - 2.0 / 3.0);
}
