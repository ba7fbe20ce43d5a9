/* The lower atmosphere of the US Standard Atmosphere 1976. */
#ifndef UMBRA_ENVIRONMENT_STANDARD_AIR_H
#define UMBRA_ENVIRONMENT_STANDARD_AIR_H

/* Density [kg/m^3] at a height [m], 0 to 86 km; beyond, as it goes on there, 5.4 km a factor of e.
 * Source: US Standard Atmosphere 1976, NOAA-S/T 76-1562, equations 18 to 42. To 1e-4 of its printed
 * table; test: environment/standard_air. */
double um_environment_standard_air_density(double height);

/* Refractivity n - 1 of dry air of 15 deg C, 101325 Pa and 450 ppm of carbon dioxide, as on the
 * ground of that atmosphere, at a wavelength [m] [1]. Source: Ciddor 1996, Appl. Opt. 35:1566, eq.
 * 1, of 0.23 to 1.69 um; shorter waves as there, longer ones as the formula goes on. Test:
 * environment/standard_air. */
double um_environment_refractivity(double wavelength);

#endif
