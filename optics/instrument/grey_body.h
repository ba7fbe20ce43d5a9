/* Temperature and area of what glows, from its light in several thermal bands: what infrared
 * observers report of an object that no telescope resolves. */
#ifndef UMBRA_INSTRUMENT_GREY_BODY_H
#define UMBRA_INSTRUMENT_GREY_BODY_H

#include <stdbool.h>

#include "base/core/context.h"
#include "optics/instrument/photometry.h"

/* Grey bodies whose light together is that of the object. */
struct um_instrument_grey_body {
  size_t n;              /* 1 or 2, the colder one first */
  double temperature[2]; /* characteristic temperature [K] */
  double area[2];        /* infrared cross-section: emissivity times area seen, [m^2] for W/sr; of
                            irradiance in W/m^2, m^2 per square of the range */
  double temperature_sigma[2], area_sigma[2]; /* INFINITY: not determined [K], [m^2] */
  double chi2, bic;                           /* bic: chi2 + 2 n ln(bands) [1] */
};

/* Bands below this and above that are not the object's heat [m]. */
#define UM_INSTRUMENT_THERMAL_FROM 3e-6
#define UM_INSTRUMENT_THERMAL_TO   40e-6

/* Least squares of
 *   I_b = sum_j A_j int T_b B_lambda(T_j) d lambda,   j = 1 or 1, 2,
 * to intensities [nband] with sigma [nband] of bands that are known as bins (characteristic
 * temperature and infrared cross-section: Paxson et al. on MSX's objects; two components: Catsamas
 * et al. 2025, arXiv 2511.13030). Of two, the hotter one is at most 4.5 times as warm and the share
 * of area has a weak prior, 2 to 98 %. UM_ERR_INPUT: fewer bands than 3 for one or 5 for two, a
 * sigma that is not above 0, no light in any band. UM_ERR_NUMERIC, UM_ERR_MEMORY. */
enum um_status um_instrument_grey_body_fit(struct um_context *context,
                                           const struct um_instrument_bins *band,
                                           const double *intensity, const double *sigma,
                                           size_t nband, size_t n,
                                           struct um_instrument_grey_body *out);

/* The same; n 0 in `out` and no error where the bands are too few or no grey body fits.
 * UM_ERR_MEMORY, UM_ERR_LIBRARY. */
enum um_status um_instrument_grey_body_try(struct um_context *context,
                                           const struct um_instrument_bins *band,
                                           const double *intensity, const double *sigma,
                                           size_t nband, size_t n,
                                           struct um_instrument_grey_body *out);

/* Standard errors of temperature [K] and area of one grey body that was fitted with `sigma`, where
 * the intensities have the errors `error` [nband], independent of each other; to first order, so
 * that error = sigma gives what the fit states (tests/optics/instrument/grey_body.c). Does not
 * fail. */
void um_instrument_grey_body_error(const struct um_instrument_grey_body *body,
                                   const struct um_instrument_bins *band, const double *sigma,
                                   const double *error, size_t nband, double *temperature,
                                   double *area);

/* Are two grey bodies a better explanation than one, each parameter paid for (BIC)? false where one
 * of them has n 0. */
bool um_instrument_grey_body_prefers_two(const struct um_instrument_grey_body *one,
                                         const struct um_instrument_grey_body *two);

/* Mean of the temperatures, weighted by area: the effective temperature of the same paper [K]. */
double um_instrument_grey_body_effective(const struct um_instrument_grey_body *body);

/* Intensity of a band by them [W/sr]. */
double um_instrument_grey_body_intensity(const struct um_instrument_grey_body *body,
                                         const struct um_instrument_bins *band);

#endif
