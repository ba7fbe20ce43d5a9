/* A light curve folded with its period, its trends taken out. */
#ifndef UMBRA_COMPARE_FOLD_H
#define UMBRA_COMPARE_FOLD_H

#include "evidence/inversion/period.h"

/* Fold a series with the period that was found in it and bin it: y = trend + profile(phase), the
 * trends of um_compare_period_search, and about the mean of the trends. bins >= 1, out: shape
 * [bins]. UM_ERR_MEMORY. Tested by unit_compare_fold. */
enum um_status um_compare_fold(struct um_context *context, const struct um_compare_series *series,
                               const struct um_compare_period *period, size_t bins,
                               struct um_compare_fold_bin *out);

#endif
