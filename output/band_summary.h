/* The light of a band over a run in a few numbers. */
#ifndef UMBRA_OUTPUT_BAND_SUMMARY_H
#define UMBRA_OUTPUT_BAND_SUMMARY_H

#include "model/geometry/tables.h"
#include "model/run/result.h"

#define UM_OUTPUT_LARGE_ERROR                                                                      \
  0.05 /* Monte-Carlo error of a total whose instants are counted [1]                              \
        */

struct um_output_band_summary {
  double low, high; /* intensity [W/sr] */
  size_t lit;       /* instants with light */
  double error;     /* Monte-Carlo error of their totals: largest, */
  double median;    /* .. median [1]; NaN without light */
  size_t large;     /* .. instants at which it is above UM_OUTPUT_LARGE_ERROR */
  size_t umbra;     /* instants in it, base/core/constants.h */
  double umbra_sun; /* largest Sun term of those [W/sr] */
  double umbra_low; /* their lowest total [W/sr] */
};
/* work: shape [nobs]. */
struct um_output_band_summary um_output_band_summary(const struct um_model_tables *tables,
                                                     const struct um_model_result *r, size_t band,
                                                     double *work);

#endif
