/* Statistics of a study: how far each value is spread, and which parameter spreads it. */
#ifndef UMBRA_STUDY_STATISTICS_H
#define UMBRA_STUDY_STATISTICS_H

#include "study/result.h"

#define UM_STUDY_QUANTILES 5
extern const double um_study_quantile[UM_STUDY_QUANTILES]; /* 0.05, 0.25, 0.5, 0.75, 0.95 */

/* Where the indices come from. */
enum um_study_indices {
  UM_STUDY_INDICES_NONE,      /* too few points: not even correlations */
  UM_STUDY_INDICES_SURROGATE, /* closed form, without sampling error */
  UM_STUDY_INDICES_SAMPLED,   /* of Saltelli's points */
  UM_STUDY_INDICES_MORRIS,    /* squares of elementary effects over their sum, as shares */
  UM_STUDY_INDICES_RANKS /* squares of rank correlations: of designs that are made for neither */
};

struct um_study_statistics {
  size_t ndone; /* points that did not fail */
  enum um_study_indices indices;
  double *quantile;         /* [UM_STUDY_QUANTILES][nvalue] */
  double *mean, *deviation; /* [nvalue] */
  /* [nparameter][nvalue] share of the variance that is the parameter's own, with its error
   * (sampled: standard; surrogate: at most, by what it leaves unexplained), and with all that it
   * does together with others (surrogate, sampled); NULL: not of these indices. NaN where nothing
   * varies, and where a surrogate does not bear them: withheld. */
  double *first, *first_error, *total;
  double *correlation;           /* [nparameter][nvalue] Spearman's */
  double *effect, *effect_sigma; /* [nparameter][nvalue] Morris's mu* and sigma; NULL otherwise */
  /* [nparameter][nquantity] first, summed over the curve: sum_t S_i V / sum_t V (Gamboa, Janon,
   * Klein & Lagnoux 2014, Electron. J. Stat. 8:575) */
  double *over_curve;
};

/* weight [npoint] of the points (of measurements), or NULL; indices do not know it. UM_ERR_INPUT:
 * fewer than two points succeeded. UM_ERR_MEMORY. The caller destroys. */
enum um_status um_study_statistics_create(struct um_context *context,
                                          const struct um_study_result *result,
                                          const double *weight, struct um_study_statistics **out);
/* Accepts NULL, sets NULL. */
void um_study_statistics_destroy(struct um_context *context,
                                 struct um_study_statistics **statistics);

/* Standard deviation of a curve below which nothing varies it: a thousandth of its largest one, or
 * what is rounding of its largest value. */
double um_study_quiet(const struct um_study_statistics *statistics,
                      const struct um_study_quantity *quantity);

/* "share of the variance, closed form of the surrogate" and so on. */
const char *um_study_indices_words(enum um_study_indices indices);

#endif
