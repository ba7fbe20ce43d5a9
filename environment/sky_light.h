/* The sky by day, at twilight and under the Moon: light of a lamp far away that clear air scatters
 * toward a telescope on the ground. */
#ifndef UMBRA_ENVIRONMENT_SKY_LIGHT_H
#define UMBRA_ENVIRONMENT_SKY_LIGHT_H

#include "environment/environment.h"
#include "environment/slant_air.h"

#define UM_SKY_LIGHT_WAVELENGTHS 12
#define UM_SKY_LIGHT_HEIGHTS     16
#define UM_SKY_LIGHT_ANGLES      34
#define UM_SKY_LIGHT_POINTS      60

/* What scatters above a station; made once, never written afterwards. */
struct um_environment_sky_light {
  struct um_environment_slant slant;
  double height;                         /* of the station [m] */
  double ozone, haze, angstrom, aerosol; /* of the environment it was made of: units there */
  size_t first, count;                   /* wavelengths for which orders are known */
  /* ln of the mean radiance that is scattered again, over irradiance above the air [1/sr] */
  double again[UM_SKY_LIGHT_WAVELENGTHS][UM_SKY_LIGHT_HEIGHTS][UM_SKY_LIGHT_ANGLES];
};

/* Shortest and longest wavelength that is known [m]: beyond 1.2 um the air glows more at night than
 * it scatters, and is left dark. */
#define UM_SKY_LIGHT_SHORTEST 0.30e-6 /* [m] */
#define UM_SKY_LIGHT_LONGEST  1.20e-6 /* [m] */

/* The air of the environment above a station at a height [m]: its ozone and aerosol, the aerosol of
 * the stratosphere as stated for the shadow's edge; light that is scattered more than once, at
 * wavelengths [m] from one to another (or none, where these are not known). environment->limb is
 * wanted, and borrowed. About 25 ms a wavelength of the twelve. UM_ERR_MEMORY; the caller frees
 * *out with um_core_free. */
enum um_status um_environment_sky_light_make(struct um_context *context,
                                             const struct um_environment *environment,
                                             double height, double from, double to,
                                             struct um_environment_sky_light **out);

/* Would um_environment_sky_light_make give the same, number for number? */
bool um_environment_sky_light_is_of(const struct um_environment_sky_light *light,
                                    const struct um_environment *environment, double height,
                                    double from, double to);

/* A line of sight: cells of air on it, and how the lamp lights them. */
struct um_environment_sky_path {
  const struct um_environment_sky_light *light;
  double amount[UM_LIMB_CONSTITUENTS]; /* of what is stated [1] */
  double angstrom;                     /* [1] */
  double cosine; /* of the angle between the line of sight and where the lamp's light goes on [1] */
  struct {
    double inside[UM_LIMB_CONSTITUENTS]; /* columns of the cell, to its middle, of the lamp's ray
                                            [1] */
    double before[UM_LIMB_CONSTITUENTS]; /* [1] */
    double lamp[UM_LIMB_CONSTITUENTS];   /* [1] */
    double arrives;  /* of the lamp's light without extinction; 0 in the Earth's shadow [1] */
    double row, col; /* place in the table of what is scattered again [1] */
  } cell[UM_SKY_LIGHT_POINTS];
};

/* environment: its sky as it is now, with what effects add; elevation at which the line of sight is
 * seen and airless one of the lamp [rad], cosine of the angle between the two directions [1]. */
void um_environment_sky_path(const struct um_environment_sky_light *light,
                             const struct um_environment *environment, double elevation,
                             double lamp_elevation, double separation_cosine,
                             struct um_environment_sky_path *out);

/* Radiance of the sky there over the lamp's irradiance above the air, of all orders of scattering
 * or, `once`, of the first [1/sr]; 0 outside the wavelengths that are known [m]. Test:
 * environment/sky_light. */
double um_environment_sky_path_radiance(const struct um_environment_sky_path *path,
                                        double wavelength, bool once);

#endif
