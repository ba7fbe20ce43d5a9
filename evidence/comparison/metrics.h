/* How far a model is from measurements: per segment and in all, in linear flux. */
#ifndef UMBRA_COMPARE_METRICS_H
#define UMBRA_COMPARE_METRICS_H

#include <stddef.h>

#include "base/core/context.h"
#include "evidence/comparison/residual.h"

/* What does not exist is NaN, never 0: sd of one observation, rms/mean where the mean measured flux
 * is not positive, chi-square without sigma. Residual r = measured - model. Units are those of the
 * quantity; magnitudes have become flux relative to magnitude 0. */
struct um_compare_metrics {
  size_t count;
  double mean_measured, mean_model;
  double bias;          /* mean r: above 0, the model is too faint or too cold */
  double sd;            /* standard deviation of r about the bias, divisor count - 1 */
  double rms;           /* sqrt(mean r^2) */
  double rms_over_mean; /* rms / mean measured [-]; NaN for temperatures */
  double median_ratio; /* median of measured / model over observations with a model above 0 [-]; NaN
                          for temperatures; the reciprocal is the median model / measured */
  double scale;        /* c that makes sum (measured - c model)^2 least [-]; NaN for temperatures */
  double rms_scaled;   /* rms of measured - scale x model, never above rms */
  double correlation; /* Pearson's, of measured and model magnitudes, over the observations in which
                         both are finite; a scale does not change it; NaN for other quantities,
                         below 3 observations and where one of them is constant */
  double bias_mag;    /* of magnitudes: mean of measured - model [mag], over the observations whose
                         both magnitudes are finite: above 0, the model is too bright; NaN for
                         other quantities */
  double rms_mag;     /* of magnitudes: sqrt(mean square) of the same [mag] */
  double model_share; /* mean of model_sigma^2 / (sigma^2 + model_sigma^2) over the observations
                         with a sigma [1]: how much of the error is the model's own sampling */
  double chi2, dof;   /* sum (r / s)^2 over the observations with a sigma, s^2 = sigma^2 +
                         model_sigma^2; degrees of freedom */
  double chi2_reduced;  /* chi2 / dof; NaN when dof <= 0 */
  double chi2_p;        /* P(chi-square of dof > chi2) */
  double durbin_watson; /* of r / s (of r where an observation has no sigma) in the order given, in
                           [0, 4]: 2 white, 0 slow drifts or an offset, 4 alternating */
  double white_p;       /* two-sided probability that white noise about 0 is as far from 2 */
};

/* A label that leaves the observation out. */
#define UM_COMPARE_LABEL_NONE ((size_t)-1)

/* Metrics of one channel.
 *   count: observations, in order of time (whiteness compares neighbours)
 *   residual: shape [count], of `quantity`, whose magnitudes have become flux; model_sigma >= 0
 *   label: shape [count], segment below nlabel, or UM_COMPARE_LABEL_NONE; NULL: no segments
 *   fitted: number of parameters fitted to these observations; the degrees of freedom of `all` are
 *     its observations with sigma less `fitted`, those of a segment are less its share of them
 *   segment: shape [nlabel], may be NULL when nlabel is 0
 *   all: of every observation with a label, or NULL
 * A segment without observations has count 0 and NaN elsewhere. Sigma of a magnitude is linearised,
 * which wants sigma below about 0.3 mag.
 * UM_ERR_NUMERIC: measured, model or model_sigma not finite in an observation with a label, sigma
 * not positive or model_sigma negative (named by its number from 1). UM_ERR_INPUT: a label out of
 * range. UM_ERR_MEMORY. Durbin & Watson 1950/1951; exact numbers in verify_compare_metrics,
 * distributions in stat_compare_statistics. */
enum um_status um_compare_metrics_compute(struct um_context *context,
                                          enum um_compare_quantity quantity, size_t count,
                                          const struct um_compare_residual *residual,
                                          const size_t *label, size_t nlabel, double fitted,
                                          struct um_compare_metrics *segment,
                                          struct um_compare_metrics *all);

#endif
