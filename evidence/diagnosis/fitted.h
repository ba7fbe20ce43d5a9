/* What is known of fitted parameters together: draws from their posterior, and pairs of which only
 * a combination is known. */
#ifndef UMBRA_DIAGNOSIS_FITTED_H
#define UMBRA_DIAGNOSIS_FITTED_H

#include <stdint.h>

#include "evidence/sensitivity/forward.h"

/* A parameter that was fitted: of the effects in their order, then of the nuisances. */
struct um_diagnosis_fitted {
  const struct um_effect *effect; /* borrowed, as is the next */
  const char *target;
  size_t parameter; /* of the effect */
  bool nuisance;
  double value; /* as fitted */
  size_t free;  /* which of those that a fit knows */
};

/* A pair of which measurements and priors tell only what they make together: a x b^power of two
 * factors, else a + power b. */
struct um_diagnosis_tie {
  size_t a, b;        /* of the fitted */
  double correlation; /* of factors that of their logarithms */
  bool product;
  double power;        /* in the unit of a over that of b where it is a sum */
  double value, sigma; /* of the combination */
};

#define UM_DIAGNOSIS_QUANTILES 5 /* 2.5, 16, 50, 84, 97.5 % */
#define UM_DIAGNOSIS_BAND      3 /* 5, 50, 95 % */

struct um_diagnosis_posterior {
  size_t n, nfitted, nobservation;
  uint64_t seed;
  double *value;          /* [n][nfitted] */
  double *weight;         /* [n] sum 1 */
  double effective, tail; /* as of a um_uncertainty_posterior */
  bool sound;             /* quantiles can be stated */
  double *quantile;       /* [UM_DIAGNOSIS_QUANTILES][nfitted] */
  double *band;           /* [UM_DIAGNOSIS_BAND][nobservation] of the model, linear unit */
};

/* "area:wing factor" */
void um_diagnosis_fitted_text(const struct um_diagnosis_fitted *fitted, char out[160]);
/* "area:wing factor and albedo_level factor cannot be told apart (correlation -0.994): what is
 * known is their product, 0.83 +- 0.01" */
void um_diagnosis_tie_text(const struct um_diagnosis_fitted *fitted,
                           const struct um_diagnosis_tie *tie, char out[640]);

#endif
