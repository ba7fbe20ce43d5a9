/* Synthetic photometry, photon counting (Oke & Gunn 1983, ApJ 266:713; Bessell & Murphy 2012):
 *   m_AB = -2.5 log10( sum E_i T_i int_i lambda d lambda / (F_0 c sum T_i int_i d lambda/lambda) )
 * F_0 = 3631 Jy. Over a bin of centre l and width w: int lambda = l w, int 1/lambda = ln(to/from).
 */
#include "optics/instrument/photometry.h"

#include <math.h>

#include "base/core/constants.h"

#define JANSKY 1e-26 /* [W/m^2/Hz] */

static double transmission(const struct um_instrument_bins *bins, size_t i)
{
  return bins->transmission != NULL ? bins->transmission[i] : 1.0;
}

double um_instrument_irradiance(const struct um_instrument_bins *bins, const double *spectral)
{
  double sum = 0.0;
  for (size_t i = 0; i < bins->n; i++) sum += spectral[i] * transmission(bins, i) * bins->width[i];
  return sum;
}

/* sum E T lambda d lambda [W/m]: photons times h c. */
static double photon_energy(const struct um_instrument_bins *bins, const double *spectral)
{
  double sum = 0.0;
  for (size_t i = 0; i < bins->n; i++)
    sum += spectral[i] * bins->wavelength[i] * transmission(bins, i) * bins->width[i];
  return sum;
}

static double magnitude(const struct um_instrument_bins *bins, double flux)
{
  double reference = 0.0;
  for (size_t i = 0; i < bins->n; i++) /* ln((l + w/2)/(l - w/2)) */
    reference += transmission(bins, i) * 2.0 * atanh(0.5 * bins->width[i] / bins->wavelength[i]);
  if (bins->n == 0) return NAN;
  if (flux == 0.0) return INFINITY;
  return -2.5 * log10(flux / (UM_AB_ZERO_JY * JANSKY * UM_LIGHT_SPEED * reference));
}

double um_instrument_magnitude_ab(const struct um_instrument_bins *bins, const double *spectral)
{
  return magnitude(bins, photon_energy(bins, spectral));
}

double um_instrument_vega_ab(const struct um_instrument_bins *bins)
{
  double flux = 0.0;
  for (size_t i = 0; i < bins->n; i++) {
    double l = bins->wavelength[i], half = 0.5 * bins->width[i];
    flux += um_instrument_vega(l - half, l + half) * l * transmission(bins, i) * bins->width[i];
  }
  return magnitude(bins, flux);
}

double um_instrument_photons(const struct um_instrument_bins *bins, const double *spectral)
{
  return photon_energy(bins, spectral) / (UM_PLANCK * UM_LIGHT_SPEED);
}
