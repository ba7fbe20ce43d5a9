/* How observations scatter about a model that is a little wrong everywhere: more than their sigma
 * says, with outliers, and with a discrepancy of the model that goes together along time or
 * another coordinate (Kennedy & O'Hagan 2001, J. R. Stat. Soc. B 63:425). */
#ifndef UMBRA_INFERENCE_NOISE_H
#define UMBRA_INFERENCE_NOISE_H

#include "base/inference/correlation.h"

/* Which observations there are, and along what a discrepancy may go. */
struct um_inference_noise_family {
  size_t nobservation, nchannel;
  const size_t *channel; /* [nobservation]; rows of a channel in order of time; borrowed */
  size_t nkind;
  struct um_inference_correlation **kind; /* [nkind] borrowed */
  /* [nchannel] how large a discrepancy is usually: the width of the normal prior of its rms, in
   * sigma; NULL: any is as good. Borrowed */
  const double *usual;
};

struct um_inference_noise_channel {
  double scale; /* on sigma, 1 or more; beside a discrepancy it may be less */
  double ratio; /* root of the discrepancy's variance over scale sigma; 0: none */
  size_t kind;  /* of the family, where ratio is above 0 */
};

/* Covariance of whitened residuals, of a channel with F = diag(factor):
 *
 *   C = scale^2 F (I + ratio^2 K) F */
struct um_inference_noise {
  const struct um_inference_noise_family *family; /* borrowed */
  struct um_inference_noise_channel *channel;     /* [nchannel] */
  double *factor;                                 /* [nobservation] 1; above: set aside */
  size_t noutlier;
  /* of the residual it was estimated from: r'C^-1 r + ln det C + what outliers cost + that of the
   * prior of discrepancies + ln n a number that was estimated; as chi-square for white noise of
   * unit variance */
  double worth;
  double *work; /* [nobservation] */
};

/* The noise of a residual [nobservation] (over sigma) by its largest likelihood. Each number costs
 * ln n; where it is not worth that, scale is 1 and ratio 0. from: NULL: outliers are looked for
 * (rows, one or two together, that others of their channel foretell, more than UM_INFERENCE_OUTLIER
 * sigma off, at most a tenth of a channel); else those of that noise are kept. UM_ERR_MEMORY. The
 * caller releases. */
enum um_status um_inference_noise_estimate(struct um_context *context,
                                           const struct um_inference_noise_family *family,
                                           const double *residual,
                                           const struct um_inference_noise *from,
                                           struct um_inference_noise *out);
void um_inference_noise_release(struct um_context *context, struct um_inference_noise *noise);

/* Whether it is more than white noise of unit variance. */
bool um_inference_noise_is_white(const struct um_inference_noise *noise);
/* v [nobservation] <- C^-1/2 v, the symmetric root; and back. NULL: nothing. */
void um_inference_noise_whiten(struct um_inference_noise *noise, double *v);
void um_inference_noise_colour(struct um_inference_noise *noise, double *v);
/* The discrepancy that is expected of a residual [nobservation]: a^2 K C^-1 r, over sigma. */
void um_inference_noise_discrepancy(struct um_inference_noise *noise, const double *residual,
                                    double *out);

#endif
