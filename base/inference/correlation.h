/* What of a model's error goes together: rows that lie near each other along something, such as
 * time or the phase of the orbit, are off alike. */
#ifndef UMBRA_INFERENCE_CORRELATION_H
#define UMBRA_INFERENCE_CORRELATION_H

#include <stddef.h>

#include "base/core/context.h"

/* Eigenvectors and eigenvalues of the correlation of a channel's rows. */
struct um_inference_correlation_part {
  size_t nrow, rank;
  size_t *row;   /* [nrow] observations of the channel, in their order */
  double *basis; /* [rank][nrow] orthonormal */
  double *value; /* [rank] above 0 */
};

struct um_inference_correlation {
  const char *name; /* "time, 300 s"; borrowed */
  size_t nchannel;
  struct um_inference_correlation_part *part; /* [nchannel] */
};

/* k(i, j) = (exp(-|z_i - z_j|^2 / 2) + 1) / 2 between rows of one channel, 0 between channels: half
 * of the variance is a pattern, half a level. z: [nobservation][ndimension], in lengths over which
 * rows are alike. Smaller eigenvalues than 1e-4 of the trace are left out. *out: NULL where a
 * channel wants more than UM_INFERENCE_CORRELATION_RANK of them. UM_ERR_MEMORY. The caller
 * destroys. */
enum um_status um_inference_correlation_create(struct um_context *context, const char *name,
                                               size_t nobservation, const size_t *channel,
                                               size_t nchannel, size_t ndimension, const double *z,
                                               struct um_inference_correlation **out);
void um_inference_correlation_destroy(struct um_context *context,
                                      struct um_inference_correlation **correlation);

#endif
