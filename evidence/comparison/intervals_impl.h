/* Where in time a channel is worst. Private to evidence/comparison/. */
#ifndef UMBRA_COMPARE_INTERVALS_IMPL_H
#define UMBRA_COMPARE_INTERVALS_IMPL_H

#include "evidence/comparison/comparison.h"

/* The worst intervals of a channel, with their shares. */
enum um_status um_compare_intervals_find(struct um_context *context,
                                         const struct um_compare_comparison *comparison,
                                         struct um_compare_channel_comparison *channel);

#endif
