/* Light curves on their own, before any model: import of survey tracks, noise model, one channel as
 * a series in linear flux, period search and phase folding. */
#ifndef UMBRA_COMPARE_SERIES_H
#define UMBRA_COMPARE_SERIES_H

#include "compare/measurements.h"

/* ---- survey tracks ---- */

/* What a survey states beside a row. */
struct um_compare_mmt_point {
  double standard_magnitude; /* reduced to a standard place by the survey [mag]; NaN */
  double distance;           /* [m]; NaN */
  double phase;              /* phase angle [rad]; NaN */
  bool penumbra;             /* the survey's own flag */
};

/* Import text tracks of Mini-MegaTORTORA (mmt.favor2.info/satellites; Karpov et al. 2016, RevMexAA
 * Conf. Ser. 48), as that site writes them: '#' lines "# key: value" of which `track` is used,
 * then one '#' line of column names, then rows divided by blanks. Columns by name:
 * Date, Time (UTC), Mag, Filter are needed; StdMag, Penumbra (0 or 1), Distance [km], Phase [deg],
 * Channel (camera), Track, Satellite are optional, others refused.
 *
 * Mag is the apparent magnitude calibrated by field stars, hence exo-atmospheric; it becomes
 * magnitude_vega of the filter's name ("Clear" is light without a filter; the scenario has to
 * have a filter of that name). A track becomes "TRACK/CHANNEL", because each camera
 * has its own zero point and the order in time holds per camera. The file gives neither sigma nor
 * exposure: both are NaN, see um_compare_noise_fill. Penumbra rows are kept and not flagged.
 *
 * points: shape [count of the set], in row order, the caller frees; NULL when not wanted.
 * Refused, one line naming file and line: unreadable, no or unknown columns, a wrong number of
 * fields, non-numeric fields, more than one satellite, and what um_compare_measurements_read
 * refuses between rows. UM_ERR_IO, UM_ERR_INPUT, UM_ERR_MEMORY. The caller destroys the set. */
enum um_status um_compare_mmt_read(struct um_context *context, const char *path,
                                   struct um_compare_measurements **out,
                                   struct um_compare_mmt_point **points);

/* ---- noise ---- */

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

/* ---- one channel ---- */

/* A value and its sigma in linear flux: magnitudes become flux relative to magnitude 0,
 *   F = 10^(-0.4 m),  sigma_F = 0.4 ln 10 F sigma_m,
 * +infinity being no light; other quantities pass through. sigma NaN stays NaN. */
void um_compare_linear(enum um_compare_quantity quantity, double value, double sigma, double *flux,
                       double *flux_sigma);

/* Rows of one channel in linear flux, in order of time. */
struct um_compare_series {
  size_t count;
  double *t;     /* [count] t_tai [s], not decreasing */
  double *value; /* [count] linear */
  double *sigma; /* [count], or NULL when a row has none */
  size_t *row;   /* [count] index into the set */
  size_t *track; /* [count] of the set, or NULL: all one track */
};
/* Rows with flag 0 of a channel and one track, or of all tracks with SIZE_MAX. UM_ERR_MEMORY. The
 * caller destroys. */
enum um_status um_compare_series_create(struct um_context *context,
                                        const struct um_compare_measurements *measurements,
                                        size_t channel, size_t track,
                                        struct um_compare_series **out);
void um_compare_series_destroy(struct um_context *context, struct um_compare_series **series);

/* ---- period ---- */

/* Zero means the default. */
struct um_compare_period_options {
  double frequency_min; /* [Hz]; 2/T, T the time that the longest track spans; not below it */
  double frequency_max; /* [Hz]; half the inverse of the median step (times that repeat left out) */
  double oversampling;  /* steps per 1/span of all; 10 */
};

/* A period with a higher false-alarm probability is not named. */
#define UM_COMPARE_PERIOD_LEVEL 1e-3

struct um_compare_period {
  size_t count;
  double *frequency; /* [count] the grid [Hz] */
  double *power;     /* [count] in [0, 1]: fraction of chi-square that a sine explains beside the
                        trend, red noise made white */
  /* the best sine, off the grid: value = trend + amplitude cos(2 pi (t - epoch) / period) */
  double period, period_sigma; /* [s]; sigma for the noise that is left beside the sine */
  double best_power;
  double amplitude, offset; /* unit of the series; offset: weighted mean of value less sine */
  double epoch;             /* a maximum, the first at or after the first observation: t_tai [s] */
  double false_alarm; /* probability that noise alone, white and red, peaks so high anywhere in the
                         band */
  /* noise without a sine: variance of the part that is correlated between neighbours, in units of
   * the white part's, and its correlation time [s] */
  double red, red_time;
  size_t trend_terms; /* of all tracks together */
};

/* Generalised Lomb-Scargle periodogram (Zechmeister & Kuerster 2009, A&A 496, 577) with a floating
 * trend in place of a floating mean, weighted by sigma where given, in noise that is white beside
 * an Ornstein-Uhlenbeck process (AR(1)), which takes what trend and glints leave between
 * neighbours.
 *
 * Trend: a polynomial in time for every track, a constant below 8 observations and a degree more
 * each time there are half as many again, up to the seventh at 90: range, phase angle, airmass and
 * one broad glint over a pass. Red noise: its size and time are fitted without a sine, so that a
 * period has to beat the red noise that would explain it. False-alarm probability by Davies' bound
 * (Baluev 2008, MNRAS 385, 1279; for correlated noise Delisle, Hara & Segransan 2020, A&A 635,
 * A83) in what the noise's own filter makes white: an upper bound where the sampling aliases.
 * Nothing slower than two turns in the longest track is looked for: trend and red noise would
 * explain it as well. stat_compare_period holds it to what noise does: white, red, under a pass,
 * and under a hump.
 *
 * The light curve of a tumbling body often repeats twice or more a turn: the period of the
 * strongest sine may be a fraction of the spin's. UM_ERR_INPUT: fewer than 5 observations, or fewer
 * than 4 beside the trends, all at one time, a flat series, bounds out of order, or more than 2^24
 * frequencies. Shape [count] arrays in `series` are not changed. The caller destroys. Results do
 * not depend on the number of threads. Tested by verify_compare_period and stat_compare_period. */
enum um_status um_compare_period_search(struct um_context *context,
                                        const struct um_compare_series *series,
                                        const struct um_compare_period_options *options,
                                        struct um_compare_period **out);
void um_compare_period_destroy(struct um_context *context, struct um_compare_period **period);

/* One bin of a folded curve, phase from i/bins to (i+1)/bins. */
struct um_compare_fold_bin {
  size_t count;
  double mean;  /* weighted by 1/sigma^2 where the series has sigma; NaN when empty */
  double sigma; /* of the mean: from the rows' sigmas, or from their scatter (NaN below 2 rows) */
};
/* Fold and bin; bins >= 1, out: shape [bins]. Does not fail. */
void um_compare_fold_bins(const struct um_compare_series *series, double period, double epoch,
                          size_t bins, struct um_compare_fold_bin *out);

#endif
