/* Black-body radiation. Wavelengths in metres. */
#ifndef UMBRA_CORE_PLANCK_H
#define UMBRA_CORE_PLANCK_H

/* Spectral radiance B_lambda(T) [W/m^2/sr/m]; 0 for T <= 0. Planck's law. */
double um_core_planck_radiance(double wavelength /* [m] */, double temperature /* [K] */);
/* Temperature [K] of a black body of that spectral radiance; 0 where it is not positive. */
double um_core_planck_temperature(double wavelength /* [m] */, double radiance /* [W/m^2/sr/m] */);
/* Fraction of sigma T^4 below lambda T: Chang & Rhee 1984 series, and the power series for small
 * z (docs/physics/thermal-emission.md); relative accuracy 1e-12 over 0..1. x = lambda T [m K]. */
double um_core_planck_fraction(double lambda_t /* [m K] */);
/* Band radiance [W/m^2/sr] of a black body between two wavelengths. */
double um_core_planck_band(double from /* [m] */, double to /* [m] */,
                           double temperature /* [K] */);
/* dL/dT of the band radiance [W/m^2/sr/K]. */
double um_core_planck_band_slope(double from, double to, double temperature);
/* Photon band radiance [1/s/m^2/sr]. */
double um_core_planck_band_photons(double from, double to, double temperature);

#endif
