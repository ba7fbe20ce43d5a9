/* Sunlight that the Moon reflects onto a satellite. */
#ifndef UMBRA_ENVIRONMENT_MOONLIGHT_H
#define UMBRA_ENVIRONMENT_MOONLIGHT_H

#include "environment/shadow_light.h"
#include "environment/timeline.h"

/* Reflectance A of the Moon's disc [1]: of the light that a white Lambert disc of its size would
 * send back if it faced Sun and observer, the share that the Moon sends. phase: Sun-Moon-observer
 * [rad], 0 to pi; longitude: of the Sun from the observer as they stand over the Moon, along the
 * ecliptic, positive while the Moon waxes, no more than the phase counts [rad]; wavelength [m].
 *
 * Kieffer & Stone 2005, Astron. J. 129:2887, eq. 10 with table 4, without libration, its 32 bands
 * smoothed over wavelength (they scatter by 4 % rms, 13 % at most, about the smooth course), 0.35
 * to 2.4 um, beyond these the value at the end; from 1.55 to 97 deg, and beyond 97 deg on by the
 * phase law V = 0.026 g + 4e-9 g^4 (Krisciunas & Schaefer 1991, PASP 103:1033, eq. 9; g in deg).
 * Of full to half Moon both agree within 0.1 mag. Test: environment/moonlight. */
double um_environment_moon_reflectance(double phase, double longitude, double wavelength);

/* Put the Moon, at a geocentric place [m], into a sample that has everything else. The sample stays
 * without it where the Earth hides it, where moonlight is off and where it is no more than 1e-4 of
 * the sunlight that arrives, both at 0.6 um: beside sunlight, and an Earth that the Sun lights, the
 * Moon's part is not seen, and costs no rays. */
void um_environment_moon_place(const struct um_environment *environment, struct um_vec3 moon,
                               struct um_environment_sample *sample);

/* Moonlight at one place. */
struct um_environment_moonlight {
  double scale;            /* E/E_sun(1 au) where A = 1 and nothing hides it [1] */
  double phase, longitude; /* [rad] */
  double eclipse;          /* of the sunlight on its disc, what the Earth lets by [1] */
  struct um_environment_shadow_light earth; /* what the Earth before it lets by */
};

/* Of a sample; scale 0 where the sample has no Moon. The Earth hides the Moon as it hides the Sun,
 * air and all, the disc taken as evenly bright; in an eclipse of the Moon the sunlight of seven
 * places of the disc is averaged over its whole spectrum. */
void um_environment_moonlight(const struct um_environment *environment,
                              const struct um_environment_sample *sample,
                              struct um_environment_moonlight *out);
/* Its spectral irradiance at a wavelength [m], of the Sun's at 1 au [1]; 0 beyond 3 um, where the
 * Moon's own heat outshines what it reflects and is left out. */
double um_environment_moonlight_at(const struct um_environment_moonlight *light, double wavelength);

/* Angular radius of the Moon from a distance [m] [rad]. */
double um_environment_moon_radius(double distance);

#endif
