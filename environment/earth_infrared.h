/* The Earth's own infrared by wavelength and angle, of clear ground and of cloud. */
#ifndef UMBRA_ENVIRONMENT_EARTH_INFRARED_H
#define UMBRA_ENVIRONMENT_EARTH_INFRARED_H

#include <stdbool.h>
#include <stddef.h>

#include "environment/ground.h"

/* Wavelength [m] of brightness temperatures in the window: the middle of 10.5-12.5 um, for which
 * Ohring, Gruber & Ellingson 1984 have theirs (knocke.c). */
#define UM_EARTH_NADIR_WINDOW 11.5e-6
/* Wavelength [m] at which brightness temperatures of places are averaged. */
#define UM_EARTH_WINDOW 10e-6

/* Spectral radiance [W/m^2/sr/m] that leaves the air upward at a wavelength [m]. A black surface of
 * temperature `below` [K] stands `height` [m] above ground whose temperature is `surface` [K];
 * cosine: between the zenith there and the view, 0..1 [1]. Air of that ground: 6.0 K/km, water
 * vapour by Stephens 1990, ozone 340 DU. Against LOWTRAN7's six profiles, mean of 8-12 um to 75 deg
 * from the zenith: 1.7 %, of the subarctic winter 2.1 % (tests/environment/earth_infrared.c).
 * Outside 7.02-14.28 um the black body alone. */
double um_environment_earth_upward(double wavelength, double below, double height, double surface,
                                   double cosine);
/* Mean of that over black-body radiance between two wavelengths [m], from <= to, for clear ground
 * of a temperature [K], and for cloud tops of it [1]. cosine, clear, cloud: [n]. */
void um_environment_earth_ratios(double from, double to, double temperature, const double *cosine,
                                 size_t n, double *clear, double *cloud);

/* What a place shows: clear ground, and cloud over `cover` of it. */
struct um_environment_ground_parts {
  double cover;        /* 0..1 [1] */
  double surface, top; /* temperatures of ground and of cloud tops [K] */
};
/* The temperature of cloud tops follows from the place's brightness temperature, so that both
 * together are as bright in the window, seen from above, as the place is said to be. Where no top
 * between 190 K and the ground's brightness does that, the cover changes, or the ground.
 * ratio: of clear ground in the window by um_environment_earth_window_fill, NULL: none, 1. */
struct um_environment_ground_parts
um_environment_ground_split(const struct um_environment_ground *ground, const double *ratio);

/* Ratios of clear ground in the window, seen from above, at UM_EARTH_TEMPERATURES from
 * UM_EARTH_COLDEST on [K]. */
#define UM_EARTH_TEMPERATURES 9
#define UM_EARTH_COLDEST      200.0
#define UM_EARTH_STEP         15.0
void um_environment_earth_window_fill(double ratio[UM_EARTH_TEMPERATURES]);

/* Mean of 8-12 um toward a cosine over that toward the zenith, of the mean Earth [1]; and radiance
 * of all wavelengths over that of a Lambert surface of the same exitance [1]. */
double um_environment_earth_limb(double cosine);
double um_environment_earth_anisotropy(double cosine);

#endif
