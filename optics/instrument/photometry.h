/* Magnitudes and photon rates of light that is given per bin. Nothing here fails. */
#ifndef UMBRA_INSTRUMENT_PHOTOMETRY_H
#define UMBRA_INSTRUMENT_PHOTOMETRY_H

#include <stddef.h>

/* A band as it is computed: bins, and what the filter lets through of each. */
struct um_instrument_bins {
  size_t n;
  const double *wavelength, *width; /* [n] centres and widths [m] */
  const double *transmission;       /* [n] mean over each bin [1]; NULL: all of it */
};

/* Irradiance that passes the filter [W/m^2], of irradiance per bin [n] [W/m^2/m]. */
double um_instrument_irradiance(const struct um_instrument_bins *bins, const double *spectral);
/* AB magnitude, photon counting:
 *   m = -2.5 log10( int E T lambda d lambda / int (3631 Jy c/lambda^2) T lambda d lambda )
 * with E and T constant in each bin, so exact for the bins given (Oke & Gunn 1983;
 * docs/physics/instrument.md). INFINITY for zero irradiance, NaN for negative irradiance or no
 * bins. */
double um_instrument_magnitude_ab(const struct um_instrument_bins *bins, const double *spectral);
/* AB magnitude of Vega in that band, so that m_Vega = m_AB - this, Vega itself having 0 (Vegamag;
 * Johnson's V gives it 0.03). NaN where the band leaves 0.12-40 um. */
double um_instrument_vega_ab(const struct um_instrument_bins *bins);
/* Photons that pass per area and time [1/s/m^2]. */
double um_instrument_photons(const struct um_instrument_bins *bins, const double *spectral);

/* Mean irradiance of Vega above the atmosphere between two wavelengths [m], [W/m^2/m]. */
double um_instrument_vega(double from, double to);

#endif
