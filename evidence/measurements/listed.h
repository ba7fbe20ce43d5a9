/* The measurements that a scenario lists, a set each. */
#ifndef UMBRA_COMPARE_LISTED_H
#define UMBRA_COMPARE_LISTED_H

#include "evidence/measurements/set.h"

struct um_scenario;
/* Read and join measurements.sets of a scenario, by the names they have there; rows before from_utc
 * or behind to_utc are flagged, and so left out. UM_ERR_INPUT naming file and line: no sets, a name
 * with '@' or that another has, to_utc before from_utc, no row between them; errors of
 * um_compare_measurements_read. The caller destroys. */
enum um_status um_compare_measurements_listed(struct um_context *context,
                                              const struct um_scenario *scenario,
                                              struct um_compare_measurements **out);

#endif
