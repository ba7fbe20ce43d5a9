/* The period of every light curve of a set. */
#ifndef UMBRA_COMPARE_PERIOD_REPORT_H
#define UMBRA_COMPARE_PERIOD_REPORT_H

#include "evidence/inversion/period.h"

#define UM_COMPARE_FOLD_BINS 40

struct um_compare_period_entry {
  size_t channel; /* of the measurements */
  struct um_compare_period *period;
  struct um_compare_fold_bin bin[UM_COMPARE_FOLD_BINS]; /* folded at it, phase 0 a maximum */
};
struct um_compare_period_report {
  const struct um_compare_measurements *measurements; /* borrowed */
  size_t count;
  struct um_compare_period_entry *entry; /* [count], in the order of the channels */
};

/* um_compare_period_search on every channel of light (all tracks together), or only on those whose
 * `of` is given (NULL: all). UM_ERR_INPUT: no such channel, or what the search refuses. The caller
 * destroys. */
enum um_status um_compare_period_report_create(struct um_context *context,
                                               const struct um_compare_measurements *measurements,
                                               const char *of,
                                               const struct um_compare_period_options *options,
                                               struct um_compare_period_report **out);
void um_compare_period_report_destroy(struct um_context *context,
                                      struct um_compare_period_report **report);
#endif
