/* Light that air scatters into the line of sight. Over the cells of the line of sight
 *
 *   L = E_0 sum_i exp(-tau_i) (1 - exp(-d tau_i)) / d tau_i
 *           [ sum_c w_c d tau_ci (P_c(Theta) D_i exp(-tau_sun,i) + J_i) ],
 *
 * tau_i from the station to the cell, d tau_ci the cell's own depth of constituent c, w_c the share
 * of it that scatters, D_i and tau_sun,i what refraction and extinction leave of the lamp's ray
 * (slant_air.h), J_i the mean radiance of light that was scattered before (sky_orders.c). Air:
 *
 *   P = 3/(16 pi (1 + 2 g)) (1 + 3 g + (1 - g) cos^2 Theta),   g = d/(2 - d), d = 0.0279
 *
 * (Bucholtz 1995, Appl. Opt. 34:2765); aerosol: Henyey & Greenstein 1941, Astrophys. J. 93:70, with
 * asymmetry 0.70, of which 0.95 scatters (Dubovik et al. 2002, J. Atmos. Sci. 59:590: 0.64 to 0.72
 * and 0.85 to 0.98 at 0.55 um). Haze falls by e in 2 km from sea level up, above a station that
 * stands high too, so that its depth there is what the scenario states. Polarisation is left out
 * (some 5 % of twice scattered light by day: Mishchenko et al. 1994, J. Quant. Spectrosc. Radiat.
 * Transf. 51:491), as are the bands of water and oxygen, clouds, and ice. */
#include "environment/sky_light.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/core/constants.h"
#include "environment/shadow_light.h"
#include "environment/sky_light_impl.h"

#define DEPOLARISATION 0.0279
#define TOP            100e3 /* of the line of sight [m] */

void um_environment_sky_amounts(const struct um_environment *environment,
                                const struct um_environment_slant *slant, double height,
                                double amount[UM_LIMB_CONSTITUENTS])
{
  double above[UM_LIMB_CONSTITUENTS];
  um_environment_slant_up(slant, height, 1.0, above);
  amount[UM_LIMB_AIR] = 1.0;
  amount[UM_LIMB_OZONE] = environment->sky.ozone_dobson;
  amount[UM_LIMB_HAZE] = environment->sky.aerosol / above[UM_LIMB_HAZE];
  amount[UM_LIMB_AEROSOL] = environment->aerosol;
}

void um_environment_sky_depths(const double amount[UM_LIMB_CONSTITUENTS], double angstrom,
                               double wavelength, double depth[UM_LIMB_CONSTITUENTS])
{
  um_environment_limb_depth(wavelength, depth);
  depth[UM_LIMB_HAZE] = pow(wavelength / 0.55e-6, -angstrom);
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) depth[c] *= amount[c];
}

double um_environment_sky_rayleigh(double cosine)
{
  const double g = DEPOLARISATION / (2.0 - DEPOLARISATION);
  return 3.0 / (16.0 * UM_PI * (1.0 + 2.0 * g)) * (1.0 + 3.0 * g + (1.0 - g) * cosine * cosine);
}

double um_environment_sky_aerosol(double cosine)
{
  const double g = UM_SKY_AEROSOL_ASYMMETRY;
  return (1.0 - g * g) / (4.0 * UM_PI) * pow(1.0 + g * g - 2.0 * g * cosine, -1.5);
}

/* What the light is made of, without the orders of scattering. */
static void begin(const struct um_environment *environment, double height, double from, double to,
                  struct um_environment_sky_light *light)
{
  const double *known = um_environment_sky_wavelengths;
  size_t last = 0;
  um_environment_slant_make(&environment->limb->straight, environment->shadow_radius,
                            &light->slant);
  light->height = height;
  light->ozone = environment->sky.ozone_dobson;
  light->haze = environment->sky.aerosol;
  light->angstrom = environment->sky.angstrom;
  light->aerosol = environment->aerosol;
  while (light->first + 2 < UM_SKY_LIGHT_WAVELENGTHS && known[light->first + 1] <= from)
    light->first++;
  while (last + 1 < UM_SKY_LIGHT_WAVELENGTHS && known[last] < to) last++;
  if (to > UM_SKY_LIGHT_SHORTEST && from < UM_SKY_LIGHT_LONGEST)
    light->count = last < light->first + 1 ? 2 : last - light->first + 1;
}

enum um_status um_environment_sky_light_make(struct um_context *context,
                                             const struct um_environment *environment,
                                             double height, double from, double to,
                                             struct um_environment_sky_light **out)
{
  UM_TRY(um_core_allocate(context, 1, sizeof **out, out));
  begin(environment, height, from, to, *out);
  enum um_status status = um_environment_sky_orders(context, environment, *out);
  if (status != UM_OK) um_core_free(context, *out);
  if (status != UM_OK) *out = NULL;
  return status;
}

bool um_environment_sky_light_is_of(const struct um_environment_sky_light *light,
                                    const struct um_environment *environment, double height,
                                    double from, double to)
{
  struct um_environment_sky_light other;
  memset(&other, 0, sizeof other);
  begin(environment, height, from, to, &other);
  return memcmp(&other, light, offsetof(struct um_environment_sky_light, again)) == 0;
}

/* A cell of the line of sight from a height to another, seen at an elevation. */
static void add_cell(const struct um_environment_sky_light *light, int i, double elevation,
                     double lamp_zenith, double separation, struct um_environment_sky_path *out)
{
  const struct um_environment_slant *slant = &light->slant;
  double r0 = slant->radius + light->height, u = sin(elevation), way[3], z = 0.0, upward = 0.0;
  for (int k = 0; k < 3; k++) { /* begin, middle, end */
    double x = (i + 0.5 * k) / UM_SKY_LIGHT_POINTS;
    z = light->height + (TOP - light->height) * x * x;
    double r = slant->radius + z;
    way[k] = sqrt(r * r - r0 * r0 * (1.0 - u) * (1.0 + u)) - r0 * u;
    if (k != 1) continue;
    upward = (way[1] + r0 * u) / r;
    /* r = r0 + s v, of which the lamp's direction has r0 cos(zenith angle) + s cos(separation) */
    double cosine = (r0 * cos(lamp_zenith) + way[1] * separation) / r;
    double there = acos(fmin(fmax(cosine, -1.0), 1.0)), *to = out->cell[i].before;
    double dilution = 0.0, rest[UM_LIMB_CONSTITUENTS];
    um_environment_slant_up(slant, light->height, u, to);
    um_environment_slant_up(slant, z, upward, rest);
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) to[c] = fmax(to[c] - rest[c], 0.0);
    bool lit = um_environment_slant_sun(slant, z, there, out->cell[i].lamp, &dilution);
    out->cell[i].arrives = lit ? dilution : 0.0;
    for (int c = 0; c < UM_LIMB_CONSTITUENTS && !lit; c++) out->cell[i].lamp[c] = 0.0;
    out->cell[i].row = um_environment_sky_row(z);
    out->cell[i].col = um_environment_sky_col(there);
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++)
      out->cell[i].inside[c] =
          um_environment_slant_density(slant, (enum um_environment_limb_constituent)c, z);
  }
  for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) out->cell[i].inside[c] *= way[2] - way[0];
}

void um_environment_sky_path(const struct um_environment_sky_light *light,
                             const struct um_environment *environment, double elevation,
                             double lamp_elevation, double separation_cosine,
                             struct um_environment_sky_path *out)
{
  double lamp_zenith = 0.5 * UM_PI - lamp_elevation, up = fmax(elevation, 0.0);
  out->light = light;
  out->cosine = separation_cosine;
  out->angstrom = environment->sky.angstrom;
  um_environment_sky_amounts(environment, &light->slant, light->height, out->amount);
  for (int i = 0; i < UM_SKY_LIGHT_POINTS; i++)
    add_cell(light, i, up, lamp_zenith, separation_cosine, out);
}

/* Place of a wavelength between two of the table's: the first, and the share of the second. */
static size_t place_of(const struct um_environment_sky_light *light, double wavelength,
                       double *share)
{
  const double *known = um_environment_sky_wavelengths;
  size_t k = light->first, last = light->first + light->count - 1;
  while (k + 2 <= last && known[k + 1] < wavelength) k++;
  *share = fmin(fmax(log(wavelength / known[k]) / log(known[k + 1] / known[k]), 0.0), 1.0);
  return k;
}

/* Mean radiance of what is scattered again, as it lights a cell. */
static double again_at(const struct um_environment_sky_path *path, int i, size_t k, double share)
{
  double row = path->cell[i].row, col = path->cell[i].col;
  return exp((1.0 - share) * um_environment_sky_again(path->light->again[k], row, col) +
             share * um_environment_sky_again(path->light->again[k + 1], row, col));
}

double um_environment_sky_path_radiance(const struct um_environment_sky_path *path,
                                        double wavelength, bool once)
{
  const double aside = 1.0 - UM_SKY_AEROSOL_ASYMMETRY;
  const bool more = !once && path->light->count > 0;
  double depth[UM_LIMB_CONSTITUENTS], sum = 0.0, share = 0.0;
  if (!(wavelength >= UM_SKY_LIGHT_SHORTEST && wavelength <= UM_SKY_LIGHT_LONGEST)) return 0.0;
  size_t k = more ? place_of(path->light, wavelength, &share) : 0;
  um_environment_sky_depths(path->amount, path->angstrom, wavelength, depth);
  double air = um_environment_sky_rayleigh(path->cosine);
  double aerosol = um_environment_sky_aerosol(path->cosine);
  for (int i = 0; i < UM_SKY_LIGHT_POINTS; i++) {
    double tau = 0.0, lamp = 0.0, own = 0.0, source = 0.0;
    for (int c = 0; c < UM_LIMB_CONSTITUENTS; c++) {
      tau += depth[c] * path->cell[i].before[c];
      own += depth[c] * path->cell[i].inside[c];
      lamp += depth[c] * path->cell[i].lamp[c];
    }
    double by_air = depth[UM_LIMB_AIR] * path->cell[i].inside[UM_LIMB_AIR];
    double by_aerosol =
        UM_SKY_AEROSOL_ALBEDO * (depth[UM_LIMB_HAZE] * path->cell[i].inside[UM_LIMB_HAZE] +
                                 depth[UM_LIMB_AEROSOL] * path->cell[i].inside[UM_LIMB_AEROSOL]);
    if (path->cell[i].arrives > 0.0)
      source = (by_air * air + by_aerosol * aerosol) * path->cell[i].arrives * exp(-lamp);
    if (more) source += (by_air + by_aerosol * aside) * again_at(path, i, k, share);
    /* the depth before it is that to its middle */
    double fade = own > 1e-3 ? 2.0 * sinh(0.5 * own) / own : 1.0;
    sum += source * fade * exp(-tau);
  }
  return sum;
}
