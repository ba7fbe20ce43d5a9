/* One number of a curve per point. */
#ifndef UMBRA_STUDY_PER_POINT_H
#define UMBRA_STUDY_PER_POINT_H

#include "study/statistics.h"

enum um_study_statistic {
  UM_STUDY_MEAN,    /* over the instants at which it has a value */
  UM_STUDY_LARGEST, /* of magnitudes the smallest, the brightest */
  UM_STUDY_STATISTICS
};
/* "mean", "largest", "brightest"; of a single value "value". */
const char *um_study_statistic_word(const struct um_study_quantity *quantity,
                                    enum um_study_statistic statistic);

/* Of values [quantity->count]; NaN where there is none. A single value is itself. */
double um_study_statistic_of(const struct um_study_quantity *quantity, const double *value,
                             enum um_study_statistic statistic);

/* Of every point, out [npoint]. */
void um_study_per_point(const struct um_study_result *result,
                        const struct um_study_quantity *quantity, enum um_study_statistic statistic,
                        double *out);

/* Its spread over the points. weight [npoint] or NULL. UM_ERR_MEMORY. */
struct um_study_summary {
  double nominal, mean, deviation, quantile[UM_STUDY_QUANTILES];
};
enum um_status um_study_summarise(struct um_context *context, const struct um_study_result *result,
                                  const struct um_study_quantity *quantity,
                                  enum um_study_statistic statistic, const double *weight,
                                  struct um_study_summary *out);

#endif
