/* Synthetic photometry, photon counting (Oke & Gunn 1983, ApJ 266:713; Bessell & Murphy 2012):
 *   m_AB = -2.5 log10( sum E_i int_i lambda d lambda / (F_0 c sum int_i d lambda/lambda) )
 * F_0 = 3631 Jy. Over a bin of centre l and width w: int lambda = l w, int 1/lambda = ln(to/from).
 */
#include <math.h>

#include "core/constants.h"
#include "optics/optics.h"

#define JANSKY 1e-26 /* [W/m^2/Hz] */

double um_optics_magnitude_ab(const double *spectral_irradiance, const double *wavelength,
                              const double *width, size_t nbin)
{
  double flux = 0.0, reference = 0.0;
  for (size_t i = 0; i < nbin; i++) {
    flux += spectral_irradiance[i] * wavelength[i] * width[i];
    /* ln((l + w/2)/(l - w/2)) */
    reference += 2.0 * atanh(0.5 * width[i] / wavelength[i]);
  }
  if (nbin == 0) return NAN;
  if (flux == 0.0) return INFINITY;
  return -2.5 * log10(flux / (UM_AB_ZERO_JY * JANSKY * UM_LIGHT_SPEED * reference));
}
