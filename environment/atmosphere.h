/* The upper atmosphere as what heats a satellite that moves through it. */
#ifndef UMBRA_ENVIRONMENT_ATMOSPHERE_H
#define UMBRA_ENVIRONMENT_ATMOSPHERE_H

#include "environment/timeline.h"

/* Density [kg/m^3] at a height above the ellipsoid [m], mean solar activity: exponential between
 * the heights of a table (Vallado 2013, Fundamentals of Astrodynamics and Applications, table 8-4:
 * US Standard Atmosphere 1976 to 25 km, CIRA-72 to 1000 km for 1000 K). Solar activity moves it by
 * a factor of 3 either way at 400 km, 10 at 700 km. Below 0 m that of 0 m. */
double um_environment_atmosphere_density(double height);

/* Energy that the atmosphere brings before a surface normal to the flow in free-molecular flow,
 * rho v^3 / 2 [W/m^2], v the satellite's velocity over the atmosphere, which turns with the Earth;
 * the direction from which it comes into *from (unit, GCRS; zero where nothing does: a satellite
 * without a velocity). Thermal motion of the gas is left out, 1/10 of v. */
double um_environment_atmosphere_flow(const struct um_environment_sample *sample,
                                      struct um_vec3 *from);

#endif
