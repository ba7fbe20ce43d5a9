/* The pulse of heat that fits. Private to evidence/missing_heat/. */
#ifndef UMBRA_MISSING_HEAT_PULSE_IMPL_H
#define UMBRA_MISSING_HEAT_PULSE_IMPL_H

#include "base/inference/projection.h"

/* Responses of the observations to heat in each bin, with the nuisances projected out. */
struct um_missing_heat_bins {
  size_t nbin, nleft;
  double *edge;   /* [nbin + 1] t_tai [s] */
  double *column; /* [nbin][nleft] */
  /* sums over the bins before: of the products of projected columns, of whole ones, and with the
   * residual; [nbin + 1][nbin + 1], the same, [nbin + 1] */
  double *product, *whole, *with;
};
/* column: [nbin][nobservation], taken as it is; residual: [nleft] projected. */
enum um_status um_missing_heat_bins_create(struct um_context *context,
                                           struct um_inference_projection *projection,
                                           const double *residual, size_t nbin, const double *edge,
                                           const double *column, struct um_missing_heat_bins *out);
void um_missing_heat_bins_release(struct um_context *context, struct um_missing_heat_bins *bins);

struct um_missing_heat_pulse {
  size_t from, to; /* edges */
  double chi2;     /* explained */
  double power;    /* [W] */
  double start_sigma, energy_sigma;
};
/* The best of all pulses between two edges. Its sigmas are those of all pulses, weighted by their
 * likelihood. */
void um_missing_heat_pulse_find(const struct um_missing_heat_bins *bins,
                                struct um_missing_heat_pulse *out);

#endif
