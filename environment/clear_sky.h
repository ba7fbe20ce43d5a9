/* Clear air between a telescope on the ground and space: what it lets through, and how it glows. */
#ifndef UMBRA_ENVIRONMENT_CLEAR_SKY_H
#define UMBRA_ENVIRONMENT_CLEAR_SKY_H

#include <stdbool.h>

enum um_environment_sky_profile {
  UM_SKY_US_STANDARD, /* 1976 */
  UM_SKY_MID_LATITUDE_SUMMER,
  UM_SKY_MID_LATITUDE_WINTER,
  UM_SKY_PROFILES
};

struct um_environment_sky_table; /* of a file, sky_table.h */

struct um_environment_clear_sky {
  bool present;              /* the observer stands below air that the scenario states */
  bool on;                   /* core switch atmosphere */
  double temperature;        /* near the ground [K] */
  double ozone_temperature;  /* as ozone glows [K] */
  double water;              /* precipitable [mm = kg/m^2] */
  double ozone_dobson;       /* [DU] */
  double aerosol;            /* optical depth in the zenith at 0.55 um [1] */
  double angstrom;           /* exponent of its wavelength [1] */
  double pressure;           /* of sea level's [1] */
  double cirrus;             /* optical depth of ice in the zenith at 0.55 um [1] */
  double cirrus_temperature; /* [K] */
  const struct um_environment_sky_table *table; /* in place of all these; NULL: none */
};

/* Air of a profile above a station [m] above sea level: water halves every 1.39 km, pressure falls
 * by e in 8.4 km; no aerosol, no cirrus, which would have 225 K. Not on. */
struct um_environment_clear_sky um_environment_clear_sky_of(enum um_environment_sky_profile profile,
                                                            double height);
/* True where wavelengths [m] lie within what is known: 0.30-1.16 and 7.02-14.28 um, or the table.
 */
bool um_environment_clear_sky_covers(const struct um_environment_clear_sky *sky, double from,
                                     double to);
/* Mean transmission between two wavelengths [m] that are covered, along a path of this airmass, 1
 * or more [1]. To 0.023 of LOWTRAN7 in 5 nm and to 0.015 in 5 1/cm, without aerosol, at zenith
 * angles to 70 deg (tests/environment/clear_sky.c). */
double um_environment_clear_sky_transmission(const struct um_environment_clear_sky *sky,
                                             double from, double to, double airmass);
/* Radiance of that path downward, mean between two wavelengths [W/m^2/sr/m]: its own heat, and no
 * scattered light (sky_light.h) or heat. To 7 % of LOWTRAN7 in 2 1/cm. */
double um_environment_clear_sky_radiance(const struct um_environment_clear_sky *sky, double from,
                                         double to, double airmass);
/* Amounts of a whole column along a path, in the units of the coefficients
 * (clear_sky_cells_impl.h): an infrared optical depth is their product [1]. */
struct um_environment_infrared_amounts {
  double uniform, water, continuum, ozone;
};
struct um_environment_infrared_amounts
um_environment_infrared_amounts(const struct um_environment_clear_sky *sky, double airmass);

#endif
