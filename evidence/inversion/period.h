/* Period of a light curve on its own, before any model. */
#ifndef UMBRA_COMPARE_PERIOD_H
#define UMBRA_COMPARE_PERIOD_H

#include <stdbool.h>

#include "evidence/comparison/series.h"

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

/* Is the highest peak a period that is named? The rule of table, JSON and picture. */
static inline bool um_compare_period_is_named(const struct um_compare_period *period)
{
  return period->false_alarm < UM_COMPARE_PERIOD_LEVEL;
}

#endif
