/* The tabulated solar spectrum, private to the environment. */
#ifndef UMBRA_ENVIRONMENT_SOLAR_E490_IMPL_H
#define UMBRA_ENVIRONMENT_SOLAR_E490_IMPL_H

/* Spectral irradiance [W/m^2/m] of ASTM E490 at a wavelength [m]; 0 outside the table. */
double um_environment_e490_spectrum(double wavelength);
/* Its integral over a band [W/m^2]. */
double um_environment_e490_band(double from, double to);
/* Its integral over all wavelengths [W/m^2]. */
double um_environment_e490_total(void);

#endif
