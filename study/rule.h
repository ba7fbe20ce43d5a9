/* Which parameter rules which times of a curve. */
#ifndef UMBRA_STUDY_RULE_H
#define UMBRA_STUDY_RULE_H

#include "study/statistics.h"

#define UM_STUDY_RULED_BY_NONE     ((size_t)-1)
#define UM_STUDY_RULED_BY_WITHHELD ((size_t)-2) /* it varies, and no share of it is said */

/* A stretch of the curve whose largest index is one parameter's. Instants count halfway to their
 * neighbours. */
struct um_study_stretch {
  double from, to;  /* t_tai [s] */
  size_t parameter; /* UM_STUDY_RULED_BY_NONE: the curve does not vary there; _WITHHELD */
  double share;     /* mean of the parameter's index over the stretch */
};

/* Stretches of a curve (count ntime), in order of time, without gaps; the caller frees. An instant
 * does not vary where its standard deviation is below a thousandth of the curve's largest.
 * Stretches shorter than a hundredth of the whole join the one before. UM_ERR_MEMORY. */
enum um_status um_study_stretches(struct um_context *context, const struct um_study_result *result,
                                  const struct um_study_statistics *statistics,
                                  const struct um_study_quantity *quantity,
                                  struct um_study_stretch **out, size_t *n);

/* One sentence of a curve, "lwir: power_W of bus causes 98 % of the variance in 8.2 of 10.4 minutes
 * (0 to 5.1, 7.3 to 10.4); .." or of a single value. The caller frees. UM_ERR_MEMORY. */
enum um_status um_study_sentence(struct um_context *context, const struct um_study_result *result,
                                 const struct um_study_statistics *statistics,
                                 const struct um_study_quantity *quantity, char **out);

#endif
