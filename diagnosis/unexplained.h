/* A residual that no effect of the catalogue explains: the physical coordinate it lives in, and the
 * heat that would explain it, per place, with start, energy and history. */
#ifndef UMBRA_DIAGNOSIS_UNEXPLAINED_H
#define UMBRA_DIAGNOSIS_UNEXPLAINED_H

#include "diagnosis/forward.h"

/* Missing heat of one place. */
struct um_diagnosis_heat {
  char *place;           /* "bus.+y", "bus.interior" */
  double chi2_explained; /* by the best pulse; falls along the list */
  double start, stop;    /* t_tai of the best pulse [s] */
  double start_sigma;    /* [s] from the chi-square of its neighbours */
  double power, energy;  /* [W], [J] of the best pulse */
  double energy_sigma;   /* [J] */
  /* regularised history: second differences damped until chi-square meets its expectation */
  size_t nbin;
  double *t;     /* [nbin + 1] edges, t_tai [s] */
  double *heat;  /* [nbin] [W] */
  double *sigma; /* [nbin] [W] */
};
struct um_diagnosis_unexplained {
  char *coordinate; /* the coordinate the residual goes with most, "time_s"; NULL: none */
  char *channel;    /* "temperature body.+y" where the residual is worst */
  double p;         /* of that correlation */
  size_t nheat;
  struct um_diagnosis_heat *heat; /* [nheat] by chi2_explained, falling */
  double chi2_before, chi2_after; /* with the best pulse of heat[0] */
  bool found; /* the best pulse is significant (1 % over all places and times) */
};

/* value: [nrow] model values of the rows with the additions. nuisance columns as in score.h,
 * whitened. */
enum um_status um_diagnosis_unexplained_create(struct um_context *context,
                                               struct um_diagnosis_forward *forward,
                                               const struct um_diagnosis_addition *addition,
                                               size_t naddition, const double *value,
                                               const double *nuisance, size_t nnuisance,
                                               struct um_diagnosis_unexplained **out);
void um_diagnosis_unexplained_destroy(struct um_context *context,
                                      struct um_diagnosis_unexplained **unexplained);

#endif
