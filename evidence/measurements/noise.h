/* Sigma of measurements that state none. */
#ifndef UMBRA_COMPARE_NOISE_H
#define UMBRA_COMPARE_NOISE_H

#include "evidence/measurements/set.h"

/* sigma^2 = (relative x value)^2 + floor^2. Both >= 0, one > 0. Floor in the quantity's unit. For
 * magnitudes `relative` is of the flux and the floor is in magnitudes:
 * sigma^2 = (2.5/ln 10 x relative)^2 + floor^2. */
struct um_compare_noise {
  double relative; /* [-] */
  double floor;    /* unit of the quantity */
};
/* Sigma of one value by the model; does not fail. Take the value of a model where there is one: a
 * sigma from the measured value weights low scatter up and biases a fit low. */
double um_compare_noise_sigma(enum um_compare_quantity quantity,
                              const struct um_compare_noise *noise, double value);
/* Fill the sigma of one channel where the file gave none. model: value of each row of the set in
 * the measurement's unit, shape [count], or NULL for the measured values. UM_ERR_INPUT: noise out
 * of range, or a row whose sigma would be 0 (named by file and line); nothing is changed then. */
enum um_status um_compare_noise_fill(struct um_context *context,
                                     struct um_compare_measurements *measurements, size_t channel,
                                     const struct um_compare_noise *noise, const double *model);

struct um_scenario;
/* Sigma of every row of the set in the measurement's unit, shape [count]: its own, else by the
 * scenario's measurements.noise, whose entry for the row's band or place goes before one for the
 * quantity alone; NaN where neither says. model: model value of each row in the measurement's unit,
 * NaN for rows that are left out, which keep NaN. UM_ERR_INPUT: an entry with relative and floor
 * both 0, two entries for the same, a sigma that is not above 0. */
enum um_status um_compare_noise_sigmas(struct um_context *context,
                                       const struct um_scenario *scenario,
                                       const struct um_compare_measurements *measurements,
                                       const double *model, double *sigma);

#endif
