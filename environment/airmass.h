/* The atmosphere between satellite and station: where it lets the satellite be seen, and how long
 * the path through it is. */
#ifndef UMBRA_ENVIRONMENT_AIRMASS_H
#define UMBRA_ENVIRONMENT_AIRMASS_H

/* Relative optical airmass [1] of the elevation at which a thing is seen [rad]: Kasten & Young
 * 1989, Appl. Opt. 28:4735. NaN below the horizon and for NaN. */
double um_environment_airmass(double apparent_elevation);

/* Elevation at which a thing is seen that stands at an airless one [rad]: Saemundsson 1986, Sky &
 * Telescope 72:70, in the US Standard Atmosphere at sea level, visible light. To 0.2' of a ray
 * through that air, which the horizon is lifted by 33' in; airmass to 0.03 % at 10 deg, 0.15 % on
 * the horizon (tests/environment/airmass.c). In 8-12 um it is 1 to 2 % less; a station 4 km up has
 * a third less, as weather moves it by a tenth. Below the horizon, where nothing is seen, it only
 * goes on ascending. */
double um_environment_apparent_elevation(double elevation);

/* Airmass [1] of what stands at an airless elevation [rad]; NaN where it is not seen, which is
 * below -0.56 deg, and for NaN. */
double um_environment_airmass_toward(double elevation);

#endif
