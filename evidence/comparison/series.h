/* One channel of a measurement set as a series in linear flux, and its folding with a period. */
#ifndef UMBRA_COMPARE_SERIES_H
#define UMBRA_COMPARE_SERIES_H

#include "evidence/measurements/set.h"

/* Observations of one channel in linear flux, in order of time. */
struct um_compare_series {
  size_t count;
  double *t;     /* [count] t_tai [s], not decreasing */
  double *value; /* [count] linear */
  double *sigma; /* [count], or NULL when an observation has none */
  /* [count] what an observation counts for beside others, whatever its value; NULL: 1/sigma^2 */
  double *weight;
  size_t *row;   /* [count] index into the set */
  size_t *track; /* [count] of the set, or NULL: all one track */
};
/* Observations with flag 0 of a channel and one track, or of all tracks with SIZE_MAX.
 *
 * Where all have a sigma, weight is (F^s/sigma)^2: 1/sigma^2 times what makes it independent of
 * the value F. The stated sigmas follow F^s, s from 0 to 1. It is 1 for errors in
 * magnitudes or of so many percent, 1/2 for counted photons, 0 for errors of one size; else every
 * mean is that of the faintest, whose error is smallest. A value of 0 or below: s = 0.
 * UM_ERR_MEMORY. The caller destroys. */
enum um_status um_compare_series_create(struct um_context *context,
                                        const struct um_compare_measurements *measurements,
                                        size_t channel, size_t track,
                                        struct um_compare_series **out);
void um_compare_series_destroy(struct um_context *context, struct um_compare_series **series);

/* Does not fail. */
double um_compare_series_weight(const struct um_compare_series *series, size_t i);

/* One bin of a folded curve, phase from i/bins to (i+1)/bins. */
struct um_compare_fold_bin {
  size_t count;
  double mean;  /* by the weights of the series; NaN when empty */
  double sigma; /* of the mean: from the observations' sigmas, or from their scatter (NaN below 2
                   observations) */
};
/* The bin that a time falls into. Does not fail. */
size_t um_compare_fold_bin_of(double t, double period, double epoch, size_t bins);
/* Fold and bin; bins >= 1, out: shape [bins]. Does not fail. */
void um_compare_fold_bins(const struct um_compare_series *series, double period, double epoch,
                          size_t bins, struct um_compare_fold_bin *out);

#endif
