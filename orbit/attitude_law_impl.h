/* What an attitude law must state. Private to orbit/. */
#ifndef UMBRA_ORBIT_ATTITUDE_LAW_IMPL_H
#define UMBRA_ORBIT_ATTITUDE_LAW_IMPL_H

#include "base/core/context.h"
#include "orbit/attitude_law.h"

/* Makes axes and quaternion unit. UM_ERR_INPUT: what no law of its kind has; a tumble's inertia and
 * rates are for um_orbit_tumble_make to refuse, a table's file for its reader. */
enum um_status um_orbit_attitude_law_check(struct um_context *context,
                                           struct um_orbit_attitude_law *law);

#endif
