/* Steps of a comparison. Private to compare/. */
#ifndef UMBRA_COMPARE_COMPARE_IMPL_H
#define UMBRA_COMPARE_COMPARE_IMPL_H

#include "compare/compare.h"

/* r / sigma of a row, r where it has no sigma. */
double um_compare_normalised(const struct um_compare_comparison *comparison, size_t row);
/* The worst intervals of a channel, with their shares (intervals.c). */
enum um_status um_compare_intervals_find(struct um_context *context,
                                         const struct um_compare_comparison *comparison,
                                         struct um_compare_channel_comparison *channel);

#endif
