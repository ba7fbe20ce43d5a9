/* What stars say of a telescope and the air above it. */
#ifndef UMBRA_INSTRUMENT_CALIBRATION_H
#define UMBRA_INSTRUMENT_CALIBRATION_H

#include <stdbool.h>

#include "base/core/context.h"

/* One star in one frame. */
struct um_instrument_star {
  double airmass;         /* [1] */
  double measured, sigma; /* counts [1/s] */
  double predicted;       /* those of the telescope as it is stated, above this extinction [1/s] */
};
struct um_instrument_calibration {
  double kappa, kappa_sigma;           /* factor of the counts [1] */
  double extinction, extinction_sigma; /* k [mag per airmass] */
  double correlation;                  /* of -2.5 log10 kappa and k [1] */
  double chi2;                         /* [1] */
  size_t dof;
};

/* Weighted least squares of
 *   -2.5 log10(measured/predicted) = -2.5 log10 kappa + k X            (docs/physics/instrument.md)
 * to n stars. extinction: NAN, or k as it is known, then kappa alone is fitted. UM_ERR_INPUT with
 * the index of the star in *at where it is one (n: none): fewer than two stars (one with a known
 * extinction), a count, a sigma, a prediction or an airmass that is not above 0, all airmasses the
 * same, a result that is no telescope's: a factor beyond 1e+-100, an extinction beyond
 * +-10 mag per airmass. */
enum um_status um_instrument_calibrate(struct um_context *context,
                                       const struct um_instrument_star *star, size_t n,
                                       double extinction, struct um_instrument_calibration *out,
                                       size_t *at);

/* Factor of the counts at an airmass, kappa 10^(-0.4 k X) [1], and its relative standard error. */
double um_instrument_calibration_factor(const struct um_instrument_calibration *calibration,
                                        double airmass, double *relative);

#endif
