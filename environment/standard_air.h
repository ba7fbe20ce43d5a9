/* The lower atmosphere of the US Standard Atmosphere 1976. */
#ifndef UMBRA_ENVIRONMENT_STANDARD_AIR_H
#define UMBRA_ENVIRONMENT_STANDARD_AIR_H

/* Density [kg/m^3] at a height [m], 0 to 86 km; beyond, as it goes on there, 5.4 km a factor of e.
 * Source: US Standard Atmosphere 1976, NOAA-S/T 76-1562, equations 18 to 42. To 1e-4 of its printed
 * table; test: environment/standard_air. */
double um_environment_standard_air_density(double height);

#endif
