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

double um_environment_earth_upward(double wavelength, double below, double height, double surface,
                                   double cosine)
{
  struct um_environment_clear_sky air = {
      .water = 17.5 * exp(0.064 * (surface - 288.0)), .ozone_dobson = OZONE, .pressure = 1.0};
  if (!um_environment_clear_sky_covers(&air, wavelength, wavelength) || wavelength < 2e-6)
    return um_core_planck_radiance(wavelength, below);
  double x = um_environment_airmass(asin(fmin(fmax(cosine, 0.0), 1.0)));
  struct um_environment_infrared_depths depth = um_environment_infrared_depths(&air, wavelength, x);
  double sum = 0.0, last = 0.0, lower = height;
  for (int k = 0; k <= LAYERS; k++) {
    double share = (double)k / LAYERS, z = fmax(height, TOP * share * sqrt(share));
    double t =
        exp(-depth.uniform * exp(-z / GAS_HEIGHT) - depth.water * exp(-0.6 * z / WATER_HEIGHT) -
            depth.continuum * exp(-2.0 * z / WATER_HEIGHT));
    double glow = surface - LAPSE * 0.5 * (lower + z);
    sum += k == 0 ? t * um_core_planck_radiance(wavelength, below)
                  : (t - last) * um_core_planck_radiance(wavelength, glow);
    last = t;
    lower = z;
  }
  sum += (1.0 - last) * um_core_planck_radiance(wavelength, surface - LAPSE * fmax(lower, TOP));
  double ozone = OZONE_AT + OZONE_SLOPE * (surface - 288.0), through = exp(-depth.ozone);
  return through * sum + (1.0 - through) * um_core_planck_radiance(wavelength, ozone);
}

static double ratio(double from, double to, double below, double surface, double cosine)
{
  double height = (surface - below) / LAPSE, sum = 0.0, black = 0.0;
  int n = (int)ceil((to - from) / (0.5 * UM_INFRARED_STEP * from * from));
  if (n < 1) n = 1;
  for (int i = 0; i < n; i++) {
    double at = from + (to - from) * (i + 0.5) / n;
    sum += um_environment_earth_upward(at, below, height, surface, cosine);
    black += um_core_planck_radiance(at, below);
  }
  return black > 0.0 ? sum / black : 1.0;
}

double um_environment_earth_clear_ratio(double from, double to, double temperature, double cosine)
{
  return ratio(from, to, temperature, temperature, cosine);
}

double um_environment_earth_cloud_ratio(double from, double to, double temperature, double cosine)
{
  return ratio(from, to, temperature, temperature + CLOUD_BELOW, cosine);
}

void um_environment_earth_window_fill(double out[UM_EARTH_TEMPERATURES])
{
  for (int k = 0; k < UM_EARTH_TEMPERATURES; k++)
    out[k] = ratio(UM_EARTH_NADIR_WINDOW, UM_EARTH_NADIR_WINDOW,
                   UM_EARTH_COLDEST + UM_EARTH_STEP * k, UM_EARTH_COLDEST + UM_EARTH_STEP * k, 1.0);
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
