/* A study's surrogate while it is made. Private to study/stand_in.c and study/grow.c. */
#ifndef UMBRA_STUDY_STAND_IN_IMPL_H
#define UMBRA_STUDY_STAND_IN_IMPL_H

#include "study/study_impl.h"

struct stand_in {
  const struct um_study *study;
  struct um_batch *batch;
  struct um_study_result *r;
  size_t *order;             /* [npoint] */
  double *parameter, *place; /* [npoint][d] of the points in that order */
  size_t taken, solved;      /* points of the design so far, and all */
};

/* What solved points leave of the asked error for the surrogate; the result has their own. */
double um_study_left(const struct um_study_result *result, size_t quantity);
/* The surrogate of all quantities, into the result. UM_ERR_REFUSED: one of its points failed.
 * Errors of um_uncertainty_surrogate_create. */
enum um_status um_study_grow(struct um_context *context, struct stand_in *s);

#endif
